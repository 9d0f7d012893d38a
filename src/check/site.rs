//! A closest point at which both linearizations are evaluated, in every scalar that the check asks for.

use super::verdict::Inconclusive;
use super::witness;
use crate::closest_point::{Active, ClosestPoint, Degeneracy};
use crate::linearization::ad::{Chord, evaluate};
use crate::linearization::closed_form::{Frozen, Projection, variations};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::{Bounded, DoubleDouble, HyperDual, Magnitude, Real};
use crate::pair::Contact;
use crate::specimen::{AnyBeam, PaddedBeam};
use crate::subject::{SCALARS, Subject, before};
use std::sync::OnceLock;

/// A closest point that has derivatives, and is known well enough.
#[derive(Debug)]
pub(crate) struct Site<'a> {
    pub(crate) beams: [&'a dyn AnyBeam; 2],
    pub(crate) contact: &'a Contact,
    pub(crate) active: Active,
    /// The parameters, with bounds on how far they are from the exact closest point.
    pub(crate) at: (Bounded, Bounded),
    /// The beams at these parameters, and at those before.
    moments: [Moment; 2],
}

/// Both beams at some parameters, in the scalars that the check asks for; evaluated once, when they are asked for.
#[derive(Debug, Default)]
struct Moment {
    plain: OnceLock<[Frozen<f64>; 2]>,
    bounded: OnceLock<[Frozen<Bounded>; 2]>,
    padded: OnceLock<[PaddedBeam<Bounded>; 2]>,
}

impl<'a> Site<'a> {
    /// A closest point of two beams, or why it has no derivatives that can be compared.
    pub(crate) fn new(
        beams: [&'a dyn AnyBeam; 2],
        contact: &'a Contact,
        point: &ClosestPoint,
    ) -> Result<Self, Inconclusive> {
        match point.degeneracy() {
            None => {}
            Some(Degeneracy::Crossing) => return Err(Inconclusive::Crossing),
            Some(Degeneracy::WeakEnd { .. }) => return Err(Inconclusive::WeakEnd),
            Some(Degeneracy::ZeroTangent { .. }) => return Err(Inconclusive::ZeroTangent),
            Some(_) => return Err(Inconclusive::Singular),
        }
        let at = witness::parameters(beams, point).ok_or(Inconclusive::IllConditioned)?;
        Ok(Self { beams, contact, active: point.active(), at, moments: Default::default() })
    }

    /// The parameters, or those before.
    fn parameters(&self, k: usize) -> (Bounded, Bounded) {
        if k == 0 { self.at } else { before(self.at) }
    }

    /// Both beams, frozen.
    pub(crate) fn frozen(&self, k: usize) -> [Frozen<f64>; 2] {
        let ([beam, bar], (xi, xi_bar)) = (self.beams, self.parameters(k));
        *self.moments[k].plain.get_or_init(|| [beam.frozen_plain(xi.value), bar.frozen_plain(xi_bar.value)])
    }

    /// Both beams, frozen, with bounds on their errors.
    pub(crate) fn bounded(&self, k: usize) -> [Frozen<Bounded>; 2] {
        let ([beam, bar], (xi, xi_bar)) = (self.beams, self.parameters(k));
        *self.moments[k].bounded.get_or_init(|| [beam.frozen(xi), bar.frozen(xi_bar)])
    }

    fn padded(&self, k: usize) -> &[PaddedBeam<Bounded>; 2] {
        let ([beam, bar], (xi, xi_bar)) = (self.beams, self.parameters(k));
        self.moments[k].padded.get_or_init(|| [beam.padded(xi), bar.padded(xi_bar)])
    }

    /// The closed form.
    pub(crate) fn plain(&self, subject: &Subject) -> [Varied<f64>; COMPONENTS] {
        self.variations(subject, |k| self.frozen(k), (self.at.0.value, self.at.1.value))
    }

    /// The closed form with the directions exchanged.
    pub(super) fn exchanged(&self, subject: &Subject) -> [Varied<f64>; COMPONENTS] {
        let frozen = |k| self.frozen(k).map(Frozen::exchanged);
        self.variations(subject, frozen, (self.at.0.value, self.at.1.value))
    }

    /// The closed form, with a bound on its error.
    pub(crate) fn closed(&self, subject: &Subject) -> [Varied<Bounded>; COMPONENTS] {
        self.variations(subject, |k| self.bounded(k), self.at)
    }

    /// The closed form with the size of its terms.
    pub(super) fn scales(&self, subject: &Subject) -> [Varied<Magnitude>; COMPONENTS] {
        let at = (Magnitude::parameter(self.at.0.value), Magnitude::parameter(self.at.1.value));
        let sizes = |k| self.frozen(k).map(|frozen| frozen.map(Magnitude::vector));
        self.variations(subject, sizes, at)
    }

    /// By `frozen(0)` at the parameters, and by `frozen(1)` at those before.
    fn variations<T: Real>(
        &self,
        subject: &Subject,
        frozen: impl Fn(usize) -> [Frozen<T>; 2],
        at: (T, T),
    ) -> [Varied<T>; COMPONENTS] {
        subject.variations(&frozen(0), || frozen(1), at, self.active, self.contact)
    }

    /// Gradients and Hessians of the scalars, contracted with the directions, with bounds on their errors.
    pub(super) fn matrices(&self, subject: &Subject) -> [[Bounded; 3]; SCALARS] {
        subject.matrices(self.padded(0), || self.padded(1).clone(), self.at, self.active, self.contact)
    }

    /// Automatic differentiation in our own hyper-dual numbers, with a bound on its error.
    pub(super) fn chord(&self) -> [Varied<Bounded>; COMPONENTS] {
        let Self { beams: [beam, bar], contact, active, at, .. } = *self;
        let chord = Chord::<Bounded>::new(beam, bar, at, active);
        let lifted = chord.lift_by_orders(beam, bar, at);
        evaluate::<HyperDual<Bounded>>(beam, bar, lifted, contact).map(Varied::from).components()
    }

    /// The closed form in double-double, at the closest point refined there: what its errors are measured against.
    ///
    /// Nothing if Newton's method does not settle within the bounds of the parameters.
    pub(super) fn precise(&self) -> Option<[Varied<DoubleDouble>; COMPONENTS]> {
        let Self { beams: [beam, bar], contact, active, at, .. } = *self;
        let (mut xi, mut xi_bar) = (DoubleDouble::from(at.0.value), DoubleDouble::from(at.1.value));
        let mut previous = f64::INFINITY;
        for _ in 0..STEPS {
            let frozen = [beam.frozen_precise(xi), bar.frozen_precise(xi_bar)];
            let [x, x_bar] = frozen.each_ref().map(|frozen| &frozen.geometry);
            let d = x.x - x_bar.x;
            // Eq. (48): d·t = d·t̄ = 0, by the matrix of (50).
            let (step, step_bar) = Projection::new(x, x_bar, active).solve(-d.dot(&x.t), -d.dot(&x_bar.t));
            let size = step.value().abs().max(step_bar.value().abs());
            if size == 0.0 || size >= 0.5 * previous {
                let settled = step.value().abs() <= SETTLED * at.0.bound
                    && step_bar.value().abs() <= SETTLED * at.1.bound;
                let all = || variations(&frozen[0], &frozen[1], (xi, xi_bar), active, contact).components();
                return settled.then(all);
            }
            (xi, xi_bar, previous) = (xi + step, xi_bar + step_bar, size);
        }
        None
    }
}

/// The most steps of Newton's method, which doubles the digits each time.
const STEPS: usize = 12;
/// How little of the parameters' bounds the last step may be.
const SETTLED: f64 = 1e-9;
