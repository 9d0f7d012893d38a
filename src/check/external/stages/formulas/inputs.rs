//! The inputs of the formulas at a sample, and the answers of the program.

use super::list::FORMULAS;
use super::tree::Name;
use super::values::Value;
use crate::check::candidate::CAREFUL;
use crate::check::element::ElementAt;
use crate::check::external::answers::Answers;
use crate::check::external::compare::{Demands, half_unit};
use crate::check::external::conventions::Penalty;
use crate::contact::{Law, Piece, State, Work};
use crate::linearization::closed_form::PartialVariations;
use crate::number::RunningError;
use crate::pair::Contact;
use crate::test_beam::RunningError2;
use nalgebra::Vector3;
use std::sync::LazyLock;

/// The names of the inputs of a curve.
struct NamesOfCurve {
    xi: Name,
    /// x, t, t,xi and t,xixi.
    curve: [Name; 4],
    /// The variations of x, t and t,xi at a fixed parameter, along delta and along Delta.
    variations: [[Name; 3]; 2],
}

static NAMES: LazyLock<[NamesOfCurve; 2]> = LazyLock::new(|| {
    ["", "_bar"].map(|end| {
        let name = |name: &str| {
            let (letters, derivative) = name.split_at(name.find(',').unwrap_or(name.len()));
            FORMULAS.name(&format!("{letters}{end}{derivative}"))
        };
        let variations =
            ["du", "Du"].map(|of| ["", ",xi", ",xixi"].map(|order| name(&format!("{of}{order}"))));
        NamesOfCurve { xi: name("xi"), curve: ["x", "t", "t,xi", "t,xixi"].map(name), variations }
    })
});

/// The values of all inputs, and of conditions that are open within rounding.
#[derive(Clone, Debug)]
pub(in crate::check::external::stages) struct Inputs {
    pub(super) values: Vec<Value>,
    pub(super) known: Vec<(Name, Value)>,
    /// Of an element with its own data: its state, and whether the beams have crossed.
    pub(in crate::check::external::stages) decided: Option<(State, bool)>,
    /// State, F_N, F and F_bar of the program, by the names of the formulas.
    pub(super) forces: Vec<(Name, RunningError)>,
}

impl Inputs {
    /// The inputs of the geometry at a closest point.
    pub(in crate::check::external::stages) fn new(
        partial: &[PartialVariations<RunningError2>; 2],
        xi: [RunningError2; 2],
        held: [bool; 2],
        contact: Contact,
    ) -> Self {
        let mut inputs = Self {
            values: vec![Value::from(0.0); FORMULAS.inputs],
            known: Vec::new(),
            decided: None,
            forces: Vec::new(),
        };
        let vector = |v: Vector3<RunningError2>| v.map(careful);
        let geometry = partial.each_ref().map(|of| {
            let g = &of.geometry;
            [g.x, g.t, g.t_xi, g.t_xixi].map(vector)
        });
        let [delta, linear]: [fn(&PartialVariations<RunningError2>) -> _; 2] =
            [|of| of.delta_u, |of| of.linear_u];
        let moved = [delta, linear].map(|read| partial.each_ref().map(|of| read(of).map(vector)));
        inputs.set_curves(xi.map(careful), &geometry, &moved);
        for (of, names) in partial.iter().zip([["Ddu", "Ddu,xi"], ["Ddu_bar", "Ddu_bar,xi"]]) {
            for (name, v) in names.into_iter().zip(of.second_u) {
                inputs.set(name, Value::Vector(vector(v)));
            }
        }
        for (name, number) in [
            ("r", contact.radius),
            ("r_bar", contact.radius_bar),
            ("xi_0", contact.xi_0),
            ("xi_bar_0", contact.xi_bar_0),
        ] {
            inputs.set(name, number.into());
        }
        inputs.hold(held);
        for (vector, unknown) in [("n_n", f64::NAN), ("tau_n", 0.0), ("tau_bar_n", 0.0)] {
            inputs.set(vector, Value::Vector(Vector3::repeat(unknown.into())));
        }
        inputs
    }

    /// Takes other curves and parameters. The vectors are x, t, t,xi and t,xixi by beam, and their variations by direction and
    /// beam.
    pub(in crate::check::external::stages) fn set_curves(
        &mut self,
        xi: [RunningError; 2],
        geometry: &[[Vector3<RunningError>; 4]; 2],
        moved: &[[[Vector3<RunningError>; 3]; 2]; 2],
    ) {
        for (beam, names) in NAMES.iter().enumerate() {
            self.values[names.xi] = Value::Number(xi[beam]);
            for (name, vector) in names.curve.iter().zip(geometry[beam]) {
                self.values[*name] = Value::Vector(vector);
            }
            for (names, moved) in names.variations.iter().zip(moved) {
                for (name, vector) in names.iter().zip(moved[beam]) {
                    self.values[*name] = Value::Vector(vector);
                }
            }
        }
    }

    /// Whether a condition is given that has this name in the formulas.
    pub(in crate::check::external::stages) fn holds(&self, name: &str) -> bool {
        !self.values[FORMULAS.name(name)].is_zero()
    }

    /// Leaves out the forces of the program.
    pub(in crate::check::external::stages) fn leave_forces(&mut self) {
        self.forces.clear();
    }

    fn hold(&mut self, [xi, xi_bar]: [bool; 2]) {
        self.set("both_free", (!xi && !xi_bar).into());
        self.set("free_xi", (!xi).into());
        self.set("free_xi_bar", (!xi_bar).into());
    }

    fn set(&mut self, name: &str, value: Value) {
        self.values[FORMULAS.name(name)] = value;
    }

    /// The penalty of an element without friction. A gap that is closed only within rounding is taken as the exact one is.
    pub(in crate::check::external::stages) fn add_penalty(&mut self, penalty: Penalty, is_closed: bool) {
        self.set("penalty", penalty.stiffness.into());
        self.set("always", penalty.always.into());
        self.known.push((FORMULAS.name("pushes"), Value::from(penalty.always || is_closed)));
    }

    /// Adds the data of an element; leaves the inputs as they are if the point does not define it.
    pub(in crate::check::external::stages) fn add_element(
        &mut self,
        element: &ElementAt,
        last_tangents: Option<[Vector3<f64>; 2]>,
        answers: &Answers,
        demands: &Demands,
    ) {
        let decided = element.with(|decision| {
            let held = decision.form.held;
            self.hold([held.xi, held.xi_bar]);
            let parameters = decision.parameters;
            self.set("eps_T", parameters.eps_t.into());
            self.set("mu", parameters.mu.into());
            self.set("paper", (parameters.work == Work::Paper).into());
            let (eps, g_0, lambda) = match parameters.law {
                Law::Linear { eps } => (eps, 0.0, 0.0),
                Law::Lpqp { eps, g_0 } => (eps, g_0, 0.0),
                Law::Augmented { eps, lambda } => (eps, 0.0, lambda),
            };
            self.set("eps_N", eps.into());
            self.set("g_0", g_0.into());
            self.set("lambda", lambda.into());
            self.set("lpqp", matches!(parameters.law, Law::Lpqp { .. }).into());
            self.set("augmented", matches!(parameters.law, Law::Augmented { .. }).into());
            if let Some(slips) = element.history().slips {
                let before = slips.held;
                self.set("xi_n", slips.xi.into());
                self.set("xi_bar_n", slips.xi_bar.into());
                self.set("e_n", slips.e.into());
                self.set("e_bar_n", slips.e_bar.into());
                self.set("c_n", slips.cosine.into());
                self.set("was_free_xi", (!before.xi).into());
                self.set("was_free_xi_bar", (!before.xi_bar).into());
                self.set("has_slips", true.into());
            }
            let condition = |name: &str, holds: bool| (FORMULAS.name(name), Value::from(holds));
            self.known = vec![
                condition("curved", decision.piece == Some(Piece::Parabola)),
                condition("active", decision.piece.is_some()),
                condition("friction", decision.state.has_friction()),
                condition("slips", decision.state == State::Slip),
            ];
            (decision.state, decision.is_crossed)
        });
        let Some(decided) = decided else { return };
        self.decided = Some(decided);
        let exact = |v: Vector3<f64>| Value::Vector(v.map(RunningError::from));
        // Without an earlier step there is no elastic slip along its tangents.
        if let Some([tau, tau_bar]) = last_tangents {
            self.set("tau_n", exact(tau));
            self.set("tau_bar_n", exact(tau_bar));
        }
        if let Some(normal) = element.history().normal {
            self.set("has_n", true.into());
            self.set("n_n", exact(normal));
        }
        self.forces = forces(answers, demands);
    }
}

/// State and forces of a program in the conventions of the formulas.
fn forces(answers: &Answers, demands: &Demands) -> Vec<(Name, RunningError)> {
    let conventions = demands.conventions.forces;
    let names = if conventions.contravariant {
        ["state", "F_N", "C", "C_bar"]
    } else {
        ["state", "F_N", "F", "F_bar"]
    };
    let is_negative = [
        false,
        conventions.compression_is_negative,
        conventions.on_bar,
        conventions.on_bar != conventions.along_bar_tangent,
    ];
    let half = demands.digits.map_or(0.0, half_unit);
    let of = |((name, answer), is_negative): ((&str, &Option<f64>), bool)| {
        let size: f64 = (*answer)?;
        let value = if is_negative { -size } else { size };
        Some((FORMULAS.name(name), RunningError { value, bound: (4.0 * f64::EPSILON + half) * size.abs() }))
    };
    names.into_iter().zip(&answers.state_and_forces).zip(is_negative).filter_map(of).collect()
}

/// The bound on both kinds of rounding: that of the program may be several times that of this library.
fn careful(number: RunningError2) -> RunningError {
    RunningError { value: number.value, bound: CAREFUL * number.bound[0] + number.bound[1] }
}
