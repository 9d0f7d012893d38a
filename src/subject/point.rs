//! Stationary points over the prime field at which no term of the closed form vanishes.

use super::{SCALARS, Subject, before};
use crate::closest_point::Active;
use crate::linearization::closed_form::{Form, Frozen};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::Residue;
use crate::pair::Contact;
use crate::specimen::{ExactBeam, Family, PaddedBeam, apart, stationary};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Neither radii nor reference parameters are nought, and no two are equal.
pub(crate) const CONTACT: Contact = Contact { radius: 0.125, radius_bar: 0.25, xi_0: 0.5, xi_bar_0: -0.75 };

/// Two beams over the prime field at a stationary point, now and at the parameters before.
pub(crate) struct Point {
    pub(crate) beams: [Box<dyn ExactBeam<Residue>>; 2],
    pub(crate) at: (Residue, Residue),
    pub(crate) form: Form,
    pub(super) frozen: [[Frozen<Residue>; 2]; 2],
    pub(super) padded: [[PaddedBeam<Residue>; 2]; 2],
}

impl Point {
    /// Curves that are not linear in their dofs, inside and at ends; inside in both forms.
    pub(crate) fn all() -> Vec<Self> {
        let end = |xi, xi_bar| Active { xi, xi_bar };
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

    fn new(families: [Family; 2], active: Active, is_apart: bool) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(0);
        let models = families.map(|family| family.model(&mut rng));
        let (beams, at) = stationary(&models, active, &mut rng);
        let form = if is_apart { apart(&beams, at, active) } else { Form::paper(active) };
        let [beam, bar] = beams;
        let moments = [at, before(at)];
        let frozen = moments.map(|at| [beam.frozen(at.0), bar.frozen(at.1)]);
        let padded = moments.map(|at| [beam.padded(at.0), bar.padded(at.1)]);
        Self { beams: [beam, bar], at, form, frozen, padded }
    }

    /// All that the closed form yields.
    pub(crate) fn results(&self, subject: &Subject) -> Results {
        let Self { at, form, frozen: [frozen, frozen_before], padded: [padded, padded_before], .. } = self;
        (
            subject.variations(frozen, || *frozen_before, *at, *form, &CONTACT),
            subject.matrices(padded, || padded_before.clone(), *at, *form, &CONTACT),
        )
    }
}

/// The variations, and the matrices contracted.
pub(crate) type Results = ([Varied<Residue>; COMPONENTS], [[Residue; 3]; SCALARS]);
