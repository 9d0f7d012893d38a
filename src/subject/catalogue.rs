//! The catalogue of faults: every term of the closed form, made wrong in every way that makes a difference.
//!
//! No list is kept: the terms are those that the code names when it runs, and whether a change of one is a fault is
//! decided over the prime field. A change after which every result is the same number is none, and two changes of one
//! term with the same results are one fault.

use super::{Fault, Kind, SCALARS, Subject, UnknownFault, before};
use crate::closest_point::Active;
use crate::linearization::closed_form::{Frozen, Label, Matrices, Terms, variations_with};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::Residue;
use crate::pair::Contact;
use crate::specimen::{Family, PaddedBeam, stationary};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use std::cell::RefCell;
use std::ops::Mul;

/// Neither radii nor reference parameters are nought, and no two are equal.
const CONTACT: Contact = Contact { radius: 0.125, radius_bar: 0.25, xi_0: 0.5, xi_bar_0: -0.75 };

/// All faults, in the order in which their terms are evaluated.
pub fn catalogue() -> Vec<Fault> {
    // Curves that are not linear in their dofs, so that no term vanishes, inside and at ends.
    let end = |xi, xi_bar| Active { xi, xi_bar };
    let points = [
        Point::new([Family::NurbsWeighted, Family::Helix], end(false, false)),
        Point::new([Family::Arc, Family::NurbsWeighted], end(false, false)),
        Point::new([Family::NurbsWeighted, Family::Helix], end(true, false)),
        Point::new([Family::Arc, Family::NurbsWeighted], end(false, true)),
    ];
    let labels = labels(&points);
    let of_label = |&label: &Label| {
        let mut known: Vec<_> = vec![results(&Subject::Sound, &points)];
        let mut faults = Vec::new();
        for kind in Kind::ALL {
            let fault = Fault { label, kind };
            let results = results(&Subject::Faulty(vec![fault]), &points);
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

/// Two beams over the prime field at a stationary point, now and at the parameters before.
struct Point {
    at: (Residue, Residue),
    active: Active,
    frozen: [[Frozen<Residue>; 2]; 2],
    padded: [[PaddedBeam<Residue>; 2]; 2],
}

impl Point {
    fn new(families: [Family; 2], active: Active) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(0);
        let models = families.map(|family| family.model(&mut rng));
        let ([beam, bar], at) = stationary(&models, active, &mut rng);
        let moments = [at, before(at)];
        let frozen = moments.map(|at| [beam.frozen(at.0), bar.frozen(at.1)]);
        Self { at, active, frozen, padded: moments.map(|at| [beam.padded(at.0), bar.padded(at.1)]) }
    }
}

type Results = Vec<([Varied<Residue>; COMPONENTS], [[Residue; 3]; SCALARS])>;

/// All that the closed form yields at the points.
fn results(subject: &Subject, points: &[Point]) -> Results {
    let at =
        |Point { at, active, frozen: [frozen, frozen_before], padded: [padded, padded_before] }: &Point| {
            (
                subject.variations(frozen, || *frozen_before, *at, *active, &CONTACT),
                subject.matrices(padded, || padded_before.clone(), *at, *active, &CONTACT),
            )
        };
    points.iter().map(at).collect()
}

/// The names of all terms, in the order of their first use.
fn labels(points: &[Point]) -> Vec<Label> {
    let seen = Recorder::default();
    for Point { at, active, frozen: [[beam, bar], _], padded: [[(jet, _), (jet_bar, _)], _] } in points {
        variations_with(&&seen, beam, bar, *at, *active, &CONTACT);
        Matrices::with(&seen, jet, jet_bar, *active).all(*at, &CONTACT);
    }
    seen.labels.into_inner()
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
