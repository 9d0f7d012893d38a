//! One draw: two beams at a stationary point, both sides evaluated, and all their entries.

use super::element::Situation;
use super::entry::{Entry, entries};
use super::{Sides, differentiated};
use crate::closest_point::{Held, Side};
use crate::linearization::closed_form::{Formulation, Points};
use crate::number::{Faulty, PrimeField};
use crate::test_beam::{ExactBeam, Family, map_padded, robust, stationary_at};
use crate::variant::{CONTACT, Step, Variant, contracted, every_layout};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

/// Matrices cost ten times as much as the variations, so they are compared in one of this many groups of eight draws.
const MATRICES_EVERY: u64 = 8;

/// One draw with all its compared numbers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Draw {
    /// The families of beam and bar beam.
    pub families: [Family; 2],
    /// Its number. With the seed and the families, it determines all other fields.
    pub number: u64,
    /// Which parameters were held at an end.
    #[serde(serialize_with = "held")]
    pub held: Held,
    /// The compared numbers.
    pub entries: Vec<Entry<PrimeField>>,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it with a reference")]
fn held<S: Serializer>(held: &Held, serializer: S) -> Result<S::Ok, S::Error> {
    let mut parameters = serializer.serialize_struct("Held", 2)?;
    parameters.serialize_field("xi", &held.xi)?;
    parameters.serialize_field("xi_bar", &held.xi_bar)?;
    parameters.end()
}

/// Whether gradients, Hessians and the kernel are compared in this draw.
fn has_matrices(number: u64) -> bool {
    (number / 8).is_multiple_of(MATRICES_EVERY)
}

/// Two beams at a stationary point, and the formulas that are compared there.
struct Place {
    beams: [Box<dyn ExactBeam<PrimeField>>; 2],
    at: (PrimeField, PrimeField),
    form: Formulation,
    rng: ChaCha8Rng,
}

impl Place {
    /// Eight draws go through all combinations of held parameters, and four such eights through both ends of each. Four
    /// draws go through all formulations, whose order changes from eight to eight. The sign of the normal is random.
    fn new(seed: u64, families: [Family; 2], number: u64) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream((number * 256 + families[0] as u64) * 256 + families[1] as u64);
        let eight = number / 8;
        // Also among the draws with matrices, which are every eighth eight.
        let turn = eight + eight / MATRICES_EVERY;
        let end = |is_held: bool, turn: u64| {
            is_held.then_some(if turn.is_multiple_of(2) { Side::Upper } else { Side::Lower })
        };
        let ends = [end(matches!(number % 8, 5 | 7), turn), end(number % 8 >= 6, turn / 2)];
        let held = Held { xi: ends[0].is_some(), xi_bar: ends[1].is_some() };
        let models = families.map(|family| family.model(&mut rng));
        let (beams, at) = stationary_at(&models, ends, &mut rng);
        let (paper, robust) = (Formulation::paper(held), robust(&beams, at, held));
        let (distance, system) = match (number + eight) % 4 {
            0 => (paper.distance, paper.system),
            1 => (robust.distance, robust.system),
            2 => (robust.distance, paper.system),
            _ => (paper.distance, robust.system),
        };
        let form = Formulation { held, distance, system };
        Self { beams, at, form, rng }
    }
}

impl Draw {
    /// Draws, evaluates both sides, and pairs their entries.
    pub fn new(variant: &Variant, seed: u64, families: [Family; 2], number: u64) -> Self {
        let Place { beams, at, form, mut rng } = Place::new(seed, families, number);
        let held = form.held;
        let with_matrices = has_matrices(number);
        let beams = [&*beams[0], &*beams[1]];
        let padded = |step: Step| {
            let ([x, y], at) = step.place(beams, at);
            [x.padded(at.0), y.padded(at.1)]
        };
        let partial = |step: Step| {
            let ([x, y], at) = step.place(beams, at);
            [x.partial_variations(at.0), y.partial_variations(at.1)]
        };
        let faulty = |step: Step| padded(step).each_ref().map(|beam| map_padded(beam, Faulty));
        let matrices = || {
            let planted = variant.matrices(faulty, at, form, &CONTACT);
            planted.unwrap_or_else(|| contracted(&padded(Step::Now), at, form, &CONTACT))
        };
        let dofs = beams.map(ExactBeam::dofs);
        let kernel = || every_layout(&padded(Step::Now), dofs, at, form, &CONTACT);
        let ad = differentiated(beams, at, held, &CONTACT);
        let mut element = || {
            let points = Points::new(&beams[0].geometry(at.0), &beams[1].geometry(at.1));
            Situation::draw(&points, at, held, &mut rng).sides(&padded(Step::Now), at, form, &ad)
        };
        let sides = Sides {
            // Faults are injected into the formulas that the kernel and the element are compared with.
            element: (with_matrices && *variant == Variant::Unmodified).then(&mut element),
            closed: variant.quantities(partial, at, form, &CONTACT).components(),
            ad,
            matrices: with_matrices.then(matrices),
            kernel: if with_matrices && *variant == Variant::Unmodified { kernel() } else { Vec::new() },
        };
        Self { families, number, held, entries: entries(&sides) }
    }

    /// The entries in which the two sides are not equal.
    pub fn unequal(&self) -> impl Iterator<Item = &Entry<PrimeField>> {
        self.entries.iter().filter(|entry| !entry.is_equal())
    }
}

#[cfg(test)]
mod tests;
