//! What is checked: the closed form as it is, with faults planted in it, or with a formula written another way.
//!
//! A check that was never seen to fail proves nothing. So every check takes a [`Subject`], runs the library's own code
//! through it, and can be shown to turn red for each fault of the [`catalogue`] and to stay green for each [`Rewrite`].

mod catalogue;
mod fault;
mod invariance;
mod planted;
mod point;
mod rewrite;
mod rewrites;

pub(crate) use catalogue::terms;
pub use catalogue::{catalogue, with_faults};
pub use fault::{Fault, Kind, UnknownFault};
pub use rewrite::Rewrite;

pub(crate) use invariance::by_invariance;
pub(crate) use point::{CONTACT, Point};

use planted::{Change, Planted, Stale};

use crate::linearization::closed_form::{self, Form, Frozen, Label, Matrices, variations_with};
use crate::linearization::{COMPONENTS, Linearization, Quantities, Varied};
use crate::number::Real;
use crate::pair::{Contact, DofVector};
use crate::specimen::{DOFS, PaddedBeam};

/// How far the parameters of a stale point lag behind.
const LAG: f64 = 1.0 / 128.0;

/// The number of scalar quantities that the matrices are made for.
pub(crate) const SCALARS: usize = 7;

/// The components (of the variations) that the matrices are made for.
pub(crate) const SCALAR_COMPONENTS: [usize; SCALARS] = [15, 16, 17, 18, 19, 21, 22];

/// The closed form under check.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Subject {
    /// As it is.
    #[default]
    Sound,
    /// With all of these faults at once.
    Faulty(Vec<Fault>),
    /// With one formula replaced by another that is equal to it.
    Rewritten(Rewrite),
    /// With one term multiplied.
    Weighted(Label, f64),
}

impl Subject {
    /// All quantities with their variations, of frozen beams; `before` are these at the [parameters before](before).
    pub(crate) fn quantities<T: Real>(
        &self,
        [beam, bar]: &[Frozen<T>; 2],
        before: impl FnOnce() -> [Frozen<T>; 2],
        at: (T, T),
        form: Form,
        contact: &Contact,
    ) -> Quantities<Varied<T>> {
        match self {
            Self::Sound => variations_with(&closed_form::Sound, beam, bar, at, form, contact),
            Self::Faulty(faults) => {
                let stale = is_stale(faults).then(before);
                let stale = stale.as_ref().map_or(Stale::Unused, Stale::Frozen);
                let planted = Planted::<T, DOFS> { changes: &Change::of(faults), stale };
                variations_with(&planted, beam, bar, at, form, contact)
            }
            Self::Weighted(label, factor) => {
                let changes = [(*label, Change::Factor(T::from(*factor)))];
                let planted = Planted::<T, DOFS> { changes: &changes, stale: Stale::Unused };
                variations_with(&planted, beam, bar, at, form, contact)
            }
            Self::Rewritten(rewrite) => rewrite.variations([beam, bar], at, form, contact),
        }
    }

    /// Their components.
    pub(crate) fn variations<T: Real>(
        &self,
        frozen: &[Frozen<T>; 2],
        before: impl FnOnce() -> [Frozen<T>; 2],
        at: (T, T),
        form: Form,
        contact: &Contact,
    ) -> [Varied<T>; COMPONENTS] {
        self.quantities(frozen, before, at, form, contact).components()
    }

    /// Gradients (along both directions) and Hessians of the scalars, contracted, of beams filled up.
    pub(crate) fn matrices<T: Real, const D: usize>(
        &self,
        [(jet, [dq, linear_dq]), (jet_bar, [dq_bar, linear_dq_bar])]: &[PaddedBeam<T, D>; 2],
        before: impl FnOnce() -> [PaddedBeam<T, D>; 2],
        at: (T, T),
        form: Form,
        contact: &Contact,
    ) -> [[T; 3]; SCALARS] {
        let mut all = Linearization::zeros();
        match self {
            Self::Sound | Self::Rewritten(_) => {
                Matrices::with(closed_form::Sound, jet, jet_bar, form).write_all(at, contact, &mut all);
            }
            Self::Faulty(faults) => {
                let stale = is_stale(faults).then(|| before().map(|(jet, _)| jet));
                let stale = stale.as_ref().map_or(Stale::Unused, Stale::Jets);
                let planted = Planted { changes: &Change::of(faults), stale };
                Matrices::with(planted, jet, jet_bar, form).write_all(at, contact, &mut all);
            }
            Self::Weighted(label, factor) => {
                let changes = [(*label, Change::Factor(T::from(*factor)))];
                let planted = Planted::<T, D> { changes: &changes, stale: Stale::Unused };
                Matrices::with(planted, jet, jet_bar, form).write_all(at, contact, &mut all);
            }
        }
        let dq = DofVector { beam: *dq, bar: *dq_bar };
        let linear_dq = DofVector { beam: *linear_dq, bar: *linear_dq_bar };
        [&all.d, &all.t, &all.t_bar, &all.xi, &all.xi_bar, &all.g_t, &all.g_t_bar]
            .map(|e| [e.gradient.along(&dq), e.gradient.along(&linear_dq), e.hessian.along(&dq, &linear_dq)])
    }
}

fn is_stale(faults: &[Fault]) -> bool {
    faults.iter().any(|fault| fault.kind == Kind::Stale)
}

/// The parameters of the step before.
pub(crate) fn before<T: Real>((xi, xi_bar): (T, T)) -> (T, T) {
    (xi - T::from(LAG), xi_bar - T::from(LAG))
}
