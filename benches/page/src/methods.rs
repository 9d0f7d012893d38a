//! The methods of differentiation in plain words. Each is named after its input.

use crate::Task;
use crate::peers::{Peer, Peers};

/// The kind of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    ClosedForm,
    Generated,
    Automatic,
    Differences,
}

impl Kind {
    pub(crate) const ALL: [Self; 4] = [Self::ClosedForm, Self::Generated, Self::Automatic, Self::Differences];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::ClosedForm => "Closed form, derived by hand",
            Self::Generated => "Generated code",
            Self::Automatic => "Automatic differentiation at run time",
            Self::Differences => "Central differences",
        }
    }
}

/// A method of the record of the peers.
pub(crate) struct Method {
    /// Its name in the record.
    record: &'static str,
    pub(crate) kind: Kind,
    /// Its name on the pages.
    pub(crate) name: &'static str,
    /// A name for a label.
    pub(crate) short: &'static str,
}

const fn method(kind: Kind, record: &'static str, name: &'static str, short: &'static str) -> Method {
    Method { record, kind, name, short }
}

use Kind::{Automatic, ClosedForm, Differences, Generated};

/// All methods that compute something.
const METHODS: [Method; 23] = [
    method(ClosedForm, "beamgap, blocks", "beamgap", "beamgap"),
    method(ClosedForm, "beamgap, four pairs in lanes", "beamgap, four pairs at once", "four pairs at once"),
    method(
        ClosedForm,
        "beamgap, linearize into the caller's memory",
        "beamgap, linearize_into, with slips",
        "linearize_into",
    ),
    method(ClosedForm, "beamgap, linearize", "beamgap, linearize, with slips", "linearize"),
    method(ClosedForm, "beamgap, Matrices", "beamgap, term by term (all: with slips)", "term by term"),
    method(ClosedForm, "C++ with AVX2, by hand", "C++ with AVX2", "C++ with AVX2"),
    method(
        ClosedForm,
        "C++ with AVX2, by hand, four pairs in lanes",
        "C++ with AVX2, four pairs at once",
        "C++, four pairs",
    ),
    method(ClosedForm, "plain C, textbook form", "C, textbook formulas", "C, textbook"),
    method(Generated, "CasADi, envelope theorem", "CasADi, given the envelope theorem", "CasADi, envelope"),
    method(
        Generated,
        "CasADi, envelope theorem, four pairs in lanes",
        "CasADi, envelope theorem, four pairs at once",
        "four pairs",
    ),
    method(
        Generated,
        "CasADi, implicit function theorem",
        "CasADi, given the implicit function theorem",
        "CasADi, implicit",
    ),
    method(
        Generated,
        "CasADi, implicit function theorem, four pairs in lanes",
        "CasADi, implicit function theorem, four at once",
        "four pairs",
    ),
    method(Generated, "SymPy with cse", "SymPy, given the envelope theorem", "SymPy"),
    method(Automatic, "JAX, jit(vmap)", "JAX, given the envelope theorem", "JAX"),
    method(
        Automatic,
        "beamgap, rows of hyper-duals, by orders",
        "beamgap's hyper-duals, given the implicit theorem",
        "beamgap's hyper-duals",
    ),
    method(Automatic, "Sacado, SFad, nested", "Sacado, given chord steps", "Sacado"),
    method(Automatic, "Eigen, AutoDiffScalar, nested", "Eigen, given chord steps", "Eigen"),
    method(
        Automatic,
        "num-dual 0.15.1, hyper-dual sweep, chord",
        "num-dual, HyperDual, given chord steps",
        "num-dual, chord steps",
    ),
    method(
        Automatic,
        "num-dual 0.15.1, Dual2SVec64<24>, chord",
        "num-dual, Dual2SVec, given chord steps",
        "num-dual, Dual2SVec",
    ),
    method(
        Automatic,
        "num-dual 0.15.1, hyper-dual sweep, stationary",
        "num-dual, implicit_derivative_sp",
        "num-dual, _sp",
    ),
    method(
        Automatic,
        "num-dual 0.15.1, hyper-dual sweep, Newton",
        "num-dual, implicit_derivative_binary",
        "num-dual, _binary",
    ),
    method(
        Differences,
        "central differences of gradients, 48 closest points",
        "of gradients, 48 closest points",
        "differences of gradients",
    ),
    method(
        Differences,
        "central differences of values, 1153 closest points",
        "of values, 1,153 closest points",
        "differences of values",
    ),
];

/// The inputs of the methods, in words.
pub(crate) const GIVEN: [&str; 6] = [
    "**Envelope theorem**: at the closest point d does not change with xi and xi_bar, to first order. The Hessian of d \
     therefore needs first derivatives of xi and xi_bar only. The user must supply this fact; programs for automatic \
     differentiation do not find it. Quantities other than d use the implicit function theorem.",
    "**Implicit function theorem**: the conditions d.t = 0 and d.t_bar = 0 are differentiated once and twice, and solved for \
     the derivatives of xi and xi_bar.",
    "**Chord steps**: the program differentiates Newton's method with a fixed matrix, started at the closest point: one step \
     for d, two steps for the other quantities.",
    "**implicit_derivative_sp**, **implicit_derivative_binary**: functions of num-dual that differentiate the \
     closest point themselves, from d^2 or from both conditions.",
    "**Closed form**: the equations of the paper, completed to gradients and Hessians.",
    "**Central differences**: the closest point is computed again for each displaced state. Of gradients: first differences of \
     gradients in closed form, at 48 displaced closest points. Of values: second differences of values, at 1,153 displaced \
     closest points.",
];

/// The name of a method on the pages; that of the record if the method is unknown.
pub(crate) fn reader_name(record: &str) -> String {
    let known = METHODS.iter().find(|method| method.record == record);
    known.map_or_else(
        || record.to_owned(),
        |method| match method.kind {
            Differences => format!("central differences {}", method.name),
            _ => method.name.to_owned(),
        },
    )
}

/// The name of a method of this crate on the pages. Records keep their names, so that counts remain comparable.
pub(crate) fn method_name(task: &str, method: &str) -> String {
    // The record has the name of the method that `linearize` used before the kernel.
    let method = if task == Task::WithSlips.name() {
        method.replace("term by term", "linearize")
    } else {
        method.to_owned()
    };
    method.replace("in full", "full")
}

/// The name of a layout on the pages.
pub(crate) fn layout_name(record: &str) -> String {
    record.replace("upper", "blocks").replace("half", "packed")
}

/// The layouts of a Hessian.
pub(crate) const LAYOUTS: &str = "*Blocks*: the three blocks of the Hessian on and above the diagonal, of beam, bar beam and \
                                  both. *Full*: the whole matrix. *Packed*: the entries on and above the diagonal.";

/// One method with its rows for d and for all but the slips. Of several layouts, the rows of the full matrices are used.
pub(crate) struct Timed<'a> {
    pub(crate) method: &'static Method,
    pub(crate) tasks: [Option<&'a Peer>; 2],
}

impl Timed<'_> {
    fn least(&self) -> f64 {
        self.tasks.iter().flatten().map(|of| of.ns_median).fold(f64::INFINITY, f64::min)
    }
}

impl Peers {
    /// The methods by kind, each kind from fast to slow.
    pub(crate) fn timed(&self) -> Vec<Timed<'_>> {
        let of = |method: &Method, task: &str| {
            let is_it = |row: &&Peer| row.method == method.record && row.task == task;
            self.rows.iter().filter(is_it).min_by_key(|row| row.layout != "full")
        };
        let timed =
            METHODS.iter().map(|method| Timed { method, tasks: ["A", "B"].map(|task| of(method, task)) });
        let mut timed: Vec<_> = timed.filter(|timed| timed.tasks.iter().any(Option::is_some)).collect();
        timed.sort_by(|a, b| a.method.kind.cmp(&b.method.kind).then(a.least().total_cmp(&b.least())));
        timed
    }
}
