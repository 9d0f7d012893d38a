//! The inputs of the formulas at a sample, and the answers of the program.

use super::list::FORMULAS;
use super::tree::Name;
use super::values::Value;
use crate::check::candidate::CAREFUL;
use crate::check::element::ElementAt;
use crate::check::external::answers::Answers;
use crate::check::external::compare::{Demands, half_unit};
use crate::contact::{Law, Piece, State, Work};
use crate::linearization::closed_form::PartialVariations;
use crate::number::RunningError;
use crate::pair::Contact;
use crate::test_beam::RunningError2;
use nalgebra::Vector3;

/// The values of all inputs, and of conditions that are open within rounding.
#[derive(Clone, Debug)]
pub(in crate::check::external::stages) struct Inputs {
    pub(super) values: Vec<Value>,
    pub(super) known: Vec<(Name, Value)>,
    pub(in crate::check::external::stages) state: State,
    pub(in crate::check::external::stages) is_crossed: bool,
    /// State, F_N, F and F_bar of the program, by the names of the formulas.
    pub(super) forces: Vec<(Name, RunningError)>,
}

impl Inputs {
    /// The inputs at a closest point; nothing if it does not define the element.
    pub(in crate::check::external::stages) fn new(
        (element, contact): (&ElementAt, Contact),
        partial: &[PartialVariations<RunningError2>; 2],
        xi: [RunningError2; 2],
        last_tangents: Option<[Vector3<f64>; 2]>,
        (answers, demands): (&Answers, &Demands),
    ) -> Option<Self> {
        let list = &*FORMULAS;
        let mut values = vec![Value::from(0.0); list.inputs];
        let mut set = |name: &str, value: Value| values[list.name(name)] = value;
        for (of, end) in partial.iter().zip(["", "_bar"]) {
            let g = &of.geometry;
            for (name, suffix, v) in [
                ("x", "", g.x),
                ("t", "", g.t),
                ("t", ",xi", g.t_xi),
                ("t", ",xixi", g.t_xixi),
                ("du", "", of.delta_u[0]),
                ("du", ",xi", of.delta_u[1]),
                ("du", ",xixi", of.delta_u[2]),
                ("Du", "", of.linear_u[0]),
                ("Du", ",xi", of.linear_u[1]),
                ("Du", ",xixi", of.linear_u[2]),
                ("Ddu", "", of.second_u[0]),
                ("Ddu", ",xi", of.second_u[1]),
            ] {
                set(&format!("{name}{end}{suffix}"), Value::Vector(v.map(careful)));
            }
        }
        set("xi", Value::Number(careful(xi[0])));
        set("xi_bar", Value::Number(careful(xi[1])));
        set("r", contact.radius.into());
        set("r_bar", contact.radius_bar.into());
        let exact = |v: Vector3<f64>| Value::Vector(v.map(RunningError::from));
        let unknown = Vector3::repeat(f64::NAN);
        // Without an earlier step there is no elastic slip along its tangents.
        let last = last_tangents.unwrap_or([Vector3::zeros(); 2]);
        set("tau_n", exact(last[0]));
        set("tau_bar_n", exact(last[1]));
        let history = element.history();
        set("has_n", history.normal.is_some().into());
        set("n_n", exact(history.normal.unwrap_or(unknown)));
        let (known, state, is_crossed) = element.with(|decision| {
            let held = decision.form.held;
            set("both_free", (!held.xi && !held.xi_bar).into());
            set("free_xi", (!held.xi).into());
            set("free_xi_bar", (!held.xi_bar).into());
            let parameters = decision.parameters;
            set("eps_T", parameters.eps_t.into());
            set("mu", parameters.mu.into());
            set("paper", (parameters.work == Work::Paper).into());
            let (eps, g_0, lambda) = match parameters.law {
                Law::Linear { eps } => (eps, 0.0, 0.0),
                Law::Lpqp { eps, g_0 } => (eps, g_0, 0.0),
                Law::Augmented { eps, lambda } => (eps, 0.0, lambda),
            };
            set("eps_N", eps.into());
            set("g_0", g_0.into());
            set("lambda", lambda.into());
            set("lpqp", matches!(parameters.law, Law::Lpqp { .. }).into());
            if let Some(slips) = history.slips {
                let before = slips.held;
                set("xi_n", slips.xi.into());
                set("xi_bar_n", slips.xi_bar.into());
                set("e_n", slips.e.into());
                set("e_bar_n", slips.e_bar.into());
                set("c_n", slips.cosine.into());
                set("held_changes", (held != before).into());
                set("was_free", (!before.xi && !before.xi_bar).into());
            }
            set("has_slips", history.slips.is_some().into());
            let condition = |name: &str, holds: bool| (list.name(name), Value::from(holds));
            let known = vec![
                condition("curved", decision.piece == Some(Piece::Parabola)),
                condition("active", decision.piece.is_some()),
                condition("friction", decision.state.has_friction()),
                condition("slips", decision.state == State::Slip),
            ];
            (known, decision.state, decision.is_crossed)
        })?;
        Some(Self { values, known, state, is_crossed, forces: forces(answers, demands) })
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
