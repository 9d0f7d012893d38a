//! Stationary points over the prime field at which no term of the closed form vanishes.

use super::planted::Step;
use super::{SCALARS, Variant, contracted};
use crate::closest_point::Held;
use crate::linearization::closed_form::{Formulation, PartialVariations, variations_in};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::{Faulty, Label, PrimeField, recorded_terms};
use crate::pair::Contact;
use crate::test_beam::{ExactBeam, Family, PaddedBeam, map_padded, robust, stationary};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Neither radii nor reference parameters are zero, and no two are equal.
pub(crate) const CONTACT: Contact = Contact { radius: 0.125, radius_bar: 0.25, xi_0: 0.5, xi_bar_0: -0.75 };

/// Two beams over the prime field at a stationary point, with all replacements of operands.
pub(crate) struct Point {
    pub(crate) beams: [Box<dyn ExactBeam<PrimeField>>; 2],
    pub(crate) at: (PrimeField, PrimeField),
    pub(crate) form: Formulation,
    partial: [[PartialVariations<PrimeField>; 2]; 3],
    padded: [[PaddedBeam<PrimeField>; 2]; 3],
    /// The terms of the variations, and of the matrices.
    labels: [Vec<Label>; 2],
    /// The results of the unmodified closed form.
    unmodified: Results,
}

impl Point {
    /// Curves that are not linear in their dofs, inside and at ends; inside in both formulations.
    pub(crate) fn all() -> Vec<Self> {
        let end = |xi, xi_bar| Held { xi, xi_bar };
        let (families, others) =
            ([Family::NurbsWeighted, Family::Helix], [Family::Arc, Family::NurbsWeighted]);
        vec![
            Self::new(families, end(false, false), false),
            Self::new(others, end(false, false), false),
            Self::new(families, end(true, false), false),
            Self::new(others, end(false, true), false),
            Self::new(families, end(false, false), true),
            Self::new(others, end(false, false), true),
        ]
    }

    fn new(families: [Family; 2], held: Held, is_robust: bool) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(0);
        let models = families.map(|family| family.model(&mut rng));
        let (beams, at) = stationary(&models, held, &mut rng);
        let form = if is_robust { robust(&beams, at, held) } else { Formulation::paper(held) };
        let [beam, bar] = beams;
        let placed = |step: Step| step.place([&*beam, &*bar], at);
        let partial = Step::ALL
            .map(placed)
            .map(|([x, y], at)| [x.partial_variations(at.0), y.partial_variations(at.1)]);
        let padded = Step::ALL.map(placed).map(|([x, y], at)| [x.padded(at.0), y.padded(at.1)]);
        let [x, y] = &partial[Step::Now as usize];
        let unmodified = (
            variations_in(form, x, y, at, &CONTACT).components(),
            contracted(&padded[Step::Now as usize], at, form, &CONTACT),
        );
        let mut point =
            Self { beams: [beam, bar], at, form, partial, padded, labels: Default::default(), unmodified };
        point.labels = point.named();
        point
    }

    /// All results of the closed form.
    pub(crate) fn results(&self, variant: &Variant) -> Results {
        let Self { at, form, labels: [of_variations, of_matrices], .. } = self;
        let (mut variations, mut matrices) = self.unmodified;
        if variant.changes(of_variations) {
            let partial = |step: Step| self.partial[step as usize];
            variations = variant.quantities(partial, *at, *form, &CONTACT).components();
        }
        if variant.changes(of_matrices) {
            let faulty = |step: Step| self.faulty(step);
            matrices = variant.matrices(faulty, *at, *form, &CONTACT).unwrap_or(matrices);
        }
        (variations, matrices)
    }

    /// The names of all terms of the variations, and of the matrices.
    pub(super) fn labels(&self) -> &[Vec<Label>; 2] {
        &self.labels
    }

    fn named(&self) -> [Vec<Label>; 2] {
        let Self { at: (xi, xi_bar), form, .. } = self;
        let at = (Faulty(*xi), Faulty(*xi_bar));
        let [beam, bar] = self.partial[Step::Now as usize].map(|partial| partial.map(|v| v.map(Faulty)));
        let varied = recorded_terms(|| variations_in(*form, &beam, &bar, at, &CONTACT));
        let beams = self.faulty(Step::Now);
        let expanded = recorded_terms(|| contracted(&beams, at, *form, &CONTACT));
        [varied.0, expanded.0]
    }

    fn faulty(&self, step: Step) -> [PaddedBeam<Faulty<PrimeField>>; 2] {
        self.padded[step as usize].each_ref().map(|beam| map_padded(beam, Faulty))
    }
}

/// The variations, and the matrices contracted.
pub(crate) type Results = ([Varied<PrimeField>; COMPONENTS], [[PrimeField; 3]; SCALARS]);
