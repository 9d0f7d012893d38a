//! The catalogue of faults: every term of the closed form, made wrong in every way that makes a difference.
//!
//! No list is kept: the terms are those that the code names when it runs, and whether a change of one is a fault is
//! decided over the prime field. A change after which every result is the same number is none, and two changes of one
//! term with the same results are one fault.

use super::point::{CONTACT, Point};
use super::{Fault, Kind, Subject, UnknownFault};
use crate::linearization::closed_form::{Label, Matrices, Terms, variations_with};
use crate::number::Residue;
use rayon::prelude::*;
use std::cell::RefCell;
use std::ops::Mul;

/// All faults, in the order in which their terms are evaluated.
pub fn catalogue() -> Vec<Fault> {
    let points = Point::all();
    let [mut labels, expanded] = labels(&points);
    labels.extend(expanded.into_iter().filter(|label| !labels.contains(label)).collect::<Vec<_>>());
    let of_label = |&label: &Label| {
        let results =
            |subject: &Subject| points.iter().map(|point| point.results(subject)).collect::<Vec<_>>();
        let mut known = vec![results(&Subject::Sound)];
        let mut faults = Vec::new();
        for kind in Kind::ALL {
            let fault = Fault { label, kind };
            let results = results(&Subject::Faulty(vec![fault]));
            if !known.contains(&results) {
                known.push(results);
                faults.push(fault);
            }
        }
        faults
    };
    labels.par_iter().flat_map_iter(of_label).collect()
}

/// The closed form with the faults of these names, as [`Fault`] writes them; as it is, if there are none.
///
/// # Errors
/// If a name is none of the catalogue.
pub fn with_faults(names: &[String]) -> Result<Subject, UnknownFault> {
    if names.is_empty() {
        return Ok(Subject::Sound);
    }
    let all = catalogue();
    let find = |name: &String| {
        let found = all.iter().find(|fault| fault.to_string() == *name);
        found.copied().ok_or_else(|| UnknownFault(name.clone()))
    };
    names.iter().map(find).collect::<Result<_, _>>().map(Subject::Faulty)
}

/// The names of the terms of the variations, and of the matrices, in the order of their first use; some are in both.
pub(crate) fn terms() -> [Vec<Label>; 2] {
    labels(&Point::all())
}

fn labels(points: &[Point]) -> [Vec<Label>; 2] {
    let (varied, expanded) = (Recorder::default(), Recorder::default());
    for Point { at, form, frozen: [[beam, bar], _], padded: [[(jet, _), (jet_bar, _)], _], .. } in points {
        variations_with(&&varied, beam, bar, *at, *form, &CONTACT);
        Matrices::with(&expanded, jet, jet_bar, *form).all(*at, &CONTACT);
    }
    [varied, expanded].map(|recorder| recorder.labels.into_inner())
}

/// Evaluates all terms as they are, and notes their names.
#[derive(Default)]
struct Recorder {
    labels: RefCell<Vec<Label>>,
}

impl Recorder {
    fn note(&self, label: Label) {
        let mut labels = self.labels.borrow_mut();
        if !labels.contains(&label) {
            labels.push(label);
        }
    }
}

impl<O> Terms<Residue, O> for &Recorder {
    fn term<V: Mul<Residue, Output = V>>(&self, label: Label, operands: &O, term: impl Fn(&O) -> V) -> V {
        self.note(label);
        term(operands)
    }

    fn product(
        &self,
        label: Label,
        operands: &O,
        orders: (usize, usize),
        mut add: impl FnMut(&O, Residue, (usize, usize)),
    ) {
        self.note(label);
        add(operands, Residue::new(1), orders);
    }
}
