//! The values of the terms in the formulas of the shown quantity. With a fault, a value that it changes has the right one
//! beside it.

use crate::formulas::{Formula, formulas};
use crate::frame::{Frame, number, vector};
use crate::state::State;
use beamgap::check::ByTerm;
use beamgap::linearization::Quantity;
use beamgap::nalgebra::Vector3;
use beamgap::number::{Formula as of, Label};

/// Values of a closed form by name.
struct Values<'a>(&'a ByTerm);

impl Values<'_> {
    /// The values of a term. It is looked for in the list, because few of the terms are visible.
    fn get(&self, label: Label) -> impl Iterator<Item = f64> {
        self.0.terms.iter().filter(move |(of, _)| *of == label).map(|(_, value)| *value)
    }

    /// The value of a term, in words.
    fn of_term(&self, label: Label, (is_vector, which): (bool, usize)) -> Option<String> {
        if is_vector {
            let mut values = self.get(label).skip(3 * which);
            let [x, y, z] = [values.next()?, values.next()?, values.next()?];
            Some(vector(&Vector3::new(x, y, z)))
        } else {
            self.get(label).nth(which).map(number)
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

/// Which formulas are visible, and the values in them. At a point without derivatives they are the paper's, without values.
pub(super) fn write(frame: &mut Frame, state: &State, found: Option<&[ByTerm; 2]>) {
    let group = format!("{}{}", state.shown.name(), state.order);
    let right = found.map(|[_, right]| Values(right));
    // Without a fault both are the same.
    let faulty = found.filter(|_| state.fault.is_some()).map(|[faulty, _]| Values(faulty));
    let has = |formula, term| {
        let label = Label::of_beam(formula, term);
        right.as_ref().is_some_and(|values| values.get(label).next().is_some())
    };
    let (normal, cross) = (has(of::D, "n.d"), has(of::Det, "c.c"));
    let (held, bar_held) = (has(of::XiBarAlone, "R_bar / a_bar"), has(of::XiAlone, "R / a"));
    let solved = right.is_none() || has(of::Xi, "a_bar R");
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
        frame.shown.insert(formula.visible.into(), is_shown);
        if is_shown {
            has_fault |= state.fault.as_ref().is_some_and(|fault| contains(formula, fault));
            write_formula(frame, formula, i, faulty.as_ref(), right.as_ref());
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

/// The values of a formula: those with the fault, and where it changes them the right ones.
fn write_formula(
    frame: &mut Frame,
    formula: &Formula,
    i: usize,
    faulty: Option<&Values<'_>>,
    right: Option<&Values<'_>>,
) {
    let mut write = |name: String, of: &dyn Fn(&Values<'_>) -> Option<String>| {
        let right = right.and_then(of);
        let shown = if faulty.is_some() { faulty.and_then(of) } else { right.clone() };
        let ghost = if shown == right { None } else { right };
        frame.text(format!("right-{name}"), ghost.unwrap_or_default());
        frame.text(name, shown.unwrap_or_default());
    };
    for term in formula.terms() {
        if let Some(value) = term.value {
            write(format!("term{}", term.number), &|values| values.of_term(term.label, value));
        }
    }
    if let Some(result) = formula.result {
        write(format!("result{i}"), &|values| Some(values.of_quantity(result)));
    }
}
