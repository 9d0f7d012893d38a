//! A closest point at which both linearizations are evaluated, in every scalar that the check asks for.

use super::draw::Case;
use super::verdict::Inconclusive;
use super::witness;
use crate::closest_point::{Active, ClosestPoint, Degeneracy};
use crate::linearization::ad::{Chord, evaluate};
use crate::linearization::closed_form::{Frozen, Projection, variations};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::{Bounded, DoubleDouble, HyperDual, Magnitude};
use crate::pair::Contact;
use crate::specimen::AnyBeam;

/// A closest point that has derivatives, and is known well enough.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site<'a> {
    pub(super) beams: [&'a dyn AnyBeam; 2],
    pub(super) contact: &'a Contact,
    pub(super) active: Active,
    /// The parameters, refined in double-double and rounded, with bounds on how far they are from the exact closest
    /// point.
    pub(super) at: (Bounded, Bounded),
    /// The same with bounds as far as `f64` can tell: for those who solve for the closest point in `f64` again.
    pub(super) loose: (Bounded, Bounded),
}

impl<'a> Site<'a> {
    /// The closest point of a case, or why it has no derivatives that can be compared.
    pub(super) fn new(case: &'a Case, point: &ClosestPoint) -> Result<Self, Inconclusive> {
        match point.degeneracy() {
            None => {}
            Some(Degeneracy::Crossing) => return Err(Inconclusive::Crossing),
            Some(Degeneracy::WeakEnd { .. }) => return Err(Inconclusive::WeakEnd),
            Some(Degeneracy::ZeroTangent { .. }) => return Err(Inconclusive::ZeroTangent),
            Some(_) => return Err(Inconclusive::Singular),
        }
        let beams = case.beams();
        let at = witness::parameters(beams, point).ok_or(Inconclusive::IllConditioned)?;
        let site = Self { beams, contact: &case.contact, active: point.active(), at, loose: at };
        let Some(refined) = site.refined() else { return Ok(site) };
        let at = refined.map(Refined::rounded);
        let loose = [0, 1].map(|i| {
            let was = refined[i].within;
            Bounded::new(at[i].value, was.bound + (at[i].value - was.value).abs() * (1.0 + f64::EPSILON))
        });
        Ok(Self { at: at.into(), loose: loose.into(), ..site })
    }

    /// The closed form at these parameters, with a bound on its error.
    pub(super) fn closed(&self, at: (Bounded, Bounded)) -> [Varied<Bounded>; COMPONENTS] {
        let Self { beams: [beam, bar], contact, active, .. } = *self;
        variations(&beam.frozen(at.0), &bar.frozen(at.1), at, active, contact).components()
    }

    /// The closed form with the size of its terms.
    pub(super) fn scales(&self, plain: &[Frozen<f64>; 2]) -> [Varied<Magnitude>; COMPONENTS] {
        let sizes = plain.map(|frozen| frozen.map(Magnitude::vector));
        let at = (Magnitude::parameter(self.at.0.value), Magnitude::parameter(self.at.1.value));
        variations(&sizes[0], &sizes[1], at, self.active, self.contact).components()
    }

    /// Automatic differentiation in our own hyper-dual numbers at these parameters, with a bound on its error.
    pub(super) fn chord(&self, at: (Bounded, Bounded)) -> [Varied<Bounded>; COMPONENTS] {
        let Self { beams: [beam, bar], contact, active, .. } = *self;
        let chord = Chord::<Bounded>::new(beam, bar, at, active);
        let lifted = chord.lift_by_orders(beam, bar, at);
        evaluate::<HyperDual<Bounded>>(beam, bar, lifted, contact).map(Varied::from).components()
    }

    /// The closed form in double-double, at the closest point refined there: what its errors are measured against.
    ///
    /// Nothing if Newton's method does not settle within the bounds of the parameters.
    pub(super) fn precise(&self) -> Option<[Varied<DoubleDouble>; COMPONENTS]> {
        let Self { beams: [beam, bar], contact, active, .. } = *self;
        let [xi, xi_bar] = self.refined()?.map(|refined| refined.value);
        let frozen = [beam.frozen_precise(xi), bar.frozen_precise(xi_bar)];
        Some(variations(&frozen[0], &frozen[1], (xi, xi_bar), active, contact).components())
    }

    /// The parameters in double-double, by Newton's method; nothing if it does not settle.
    fn refined(&self) -> Option<[Refined; 2]> {
        let Self { beams: [beam, bar], active, at, .. } = *self;
        let (mut xi, mut xi_bar) = (DoubleDouble::from(at.0.value), DoubleDouble::from(at.1.value));
        let mut previous = f64::INFINITY;
        for _ in 0..STEPS {
            let [x, x_bar] =
                [beam.frozen_precise(xi), bar.frozen_precise(xi_bar)].map(|frozen| frozen.geometry);
            let d = x.x - x_bar.x;
            // Eq. (48): d·t = d·t̄ = 0, by the matrix of (50).
            let (step, step_bar) = Projection::new(&x, &x_bar, active).solve(-d.dot(&x.t), -d.dot(&x_bar.t));
            let [size, size_bar] = [step, step_bar].map(|step| step.value().abs());
            let larger = size.max(size_bar);
            if larger == 0.0 || larger >= 0.5 * previous {
                let end = |value, step: f64, was: Bounded| Refined {
                    value,
                    bound: 2.0 * step + FINER * was.bound,
                    within: was,
                };
                let both = [end(xi, size, at.0), end(xi_bar, size_bar, at.1)];
                return both.iter().all(Refined::is_within).then_some(both);
            }
            (xi, xi_bar, previous) = (xi + step, xi_bar + step_bar, larger);
        }
        None
    }
}

/// A parameter of the closest point in double-double.
#[derive(Clone, Copy)]
struct Refined {
    value: DoubleDouble,
    /// The step that is left, and the rounding of double-double: that part of the rounding of `f64`.
    bound: f64,
    /// Where it is known to be.
    within: Bounded,
}

impl Refined {
    fn is_within(&self) -> bool {
        let moved = (self.value - DoubleDouble::from(self.within.value)).abs().value();
        moved <= self.within.bound && self.bound <= self.within.bound
    }

    /// The nearest `f64`, known to half an ulp or so.
    fn rounded(self) -> Bounded {
        let value = self.value.value();
        let rounding = (self.value - DoubleDouble::from(value)).abs().value();
        Bounded::new(value, (rounding + self.bound) * (1.0 + f64::EPSILON))
    }
}

/// The rounding of double-double over that of `f64`: eight of its units 2^-106 in an operation.
const FINER: f64 = 8.0 * f64::EPSILON / 2.0;
/// The most steps of Newton's method, which doubles the digits each time.
const STEPS: usize = 12;
