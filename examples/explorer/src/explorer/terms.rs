//! The values of the terms in the formulas of the shown quantity. With a fault, a value that it changes has the right one
//! beside it.

use crate::formulas::{Formula, formulas};
use crate::frame::{Frame, number, vector};
use crate::state::State;
use beamgap::check::ByTerm;
use beamgap::linearization::Quantity;
use beamgap::nalgebra::Vector3;

/// Values of a closed form by name.
struct Values<'a>(&'a ByTerm);

impl Values<'_> {
    fn has(&self, name: &str) -> bool {
        self.0.terms.iter().any(|(label, _)| is_called(*label, name))
    }

    /// The value of a term, in words.
    fn of_term(&self, name: &str, (is_vector, which): (bool, usize)) -> Option<String> {
        let mut values = self.0.terms.iter().filter(|(label, _)| is_called(*label, name)).map(|(_, value)| *value);
        if is_vector {
            let numbers: Vec<f64> = values.skip(3 * which).take(3).collect();
            (numbers.len() == 3).then(|| vector(&Vector3::from_row_slice(&numbers)))
        } else {
            values.nth(which).map(number)
        }
    }

    /// A part of a quantity, in words.
    fn of_quantity(&self, (quantity, part): (Quantity, usize)) -> String {
        let component = |i: usize| self.0.components[quantity.component() + i].parts()[part];
        if Quantity::axis_of_component(quantity.component()).is_some() {
            vector(&Vector3::from_fn(|i, _| component(i)))
        } else {
            number(component(0))
        }
    }
}

fn is_called(label: beamgap::number::Label, name: &str) -> bool {
    let is_bar = label.which == beamgap::number::Which::Bar;
    match name.strip_suffix(" (bar)") {
        Some(name) => is_bar && label.name == name,
        None => !is_bar && label.name == name,
    }
}

/// The second variation of the gap along both directions.
pub(super) fn second_of_gap(of: &ByTerm) -> f64 {
    of.components[Quantity::GN.component()].second
}

/// Which formulas are visible, and the values in them. At a point without derivatives they are the paper's, without values.
pub(super) fn write(frame: &mut Frame, state: &State, found: Option<&[ByTerm; 2]>) {
    let group = format!("{}{}", state.shown.name(), state.order);
    let [faulty, right] = found.map_or([None, None], |[faulty, right]| [faulty, right].map(|of| Some(Values(of))));
    let has = |name: &str| right.as_ref().is_some_and(|values| values.has(name));
    let (normal, cross) = (has("|d|: n.d"), has("D: c.c"));
    let (held, bar_held) = (has("xi_bar, xi held: R_bar / a_bar"), has("xi, xi_bar held: R / a"));
    let solved = right.is_none() || has("xi: a_bar R");
    let holds = |when: char| match when {
        'L' => !normal,
        'N' => normal,
        'S' => !cross && solved,
        'C' => cross && solved,
        'P' => !cross,
        'H' => held,
        'B' => bar_held,
        _ => true,
    };
    let mut has_fault = false;
    for (i, formula) in formulas().iter().enumerate() {
        let is_shown = formula.is_shown(&group, holds);
        frame.shown.insert(format!("formula{i}").into(), is_shown);
        if is_shown {
            has_fault |= state.fault.as_ref().is_some_and(|fault| contains(formula, fault));
            write_formula(frame, formula, i, [&faulty, &right]);
        }
    }
    // A fault in a formula of another quantity is said.
    let elsewhere = state.fault.as_ref().filter(|_| !has_fault);
    frame.text("elsewhere", elsewhere.cloned().unwrap_or_default());
    frame.shown.insert("elsewhere".into(), elsewhere.is_some());
    frame.shown.insert("faulty".into(), state.fault.is_some());
    frame.shown.insert("no-fault".into(), state.fault.is_none());
    frame.shown.insert("order3".into(), state.order == 3);
    let has_matrices = !matches!(group.as_str(), "x3" | "d3" | "t3");
    frame.shown.insert("no-matrices".into(), !has_matrices);
}

fn contains(formula: &Formula, fault: &str) -> bool {
    formula.terms().any(|term| fault.split(" = ").next() == Some(term.name))
}

fn write_formula(frame: &mut Frame, formula: &Formula, i: usize, [faulty, right]: [&Option<Values<'_>>; 2]) {
    let mut write = |name: String, [faulty, right]: [Option<String>; 2]| {
        let ghost = right.filter(|right| faulty.as_ref() != Some(right)).unwrap_or_default();
        frame.text(format!("right-{name}"), ghost);
        frame.text(name, faulty.unwrap_or_default());
    };
    for term in formula.terms() {
        let Some(value) = term.value else { continue };
        let of = |values: &Option<Values<'_>>| values.as_ref().and_then(|values| values.of_term(term.name, value));
        write(format!("term{}", term.number), [of(faulty), of(right)]);
    }
    if let Some(result) = formula.result {
        let of = |values: &Option<Values<'_>>| values.as_ref().map(|values| values.of_quantity(result));
        write(format!("result{i}"), [of(faulty), of(right)]);
    }
}
