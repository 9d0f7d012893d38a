//! A closest point at which both linearizations are evaluated, in every scalar that the check asks for.

use super::verdict::Inconclusive;
use super::witness;
use crate::closest_point::{Active, ClosestPoint, Degeneracy};
use crate::linearization::ad::{Chord, evaluate};
use crate::linearization::closed_form::{Form, Frozen, Points, Projection, Sound, variations_with};
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
    /// The formulas under check: those that the library takes here, unless it is told others.
    pub(crate) form: Form,
    /// The parameters, refined in double-double and rounded, with bounds on how far they are from the exact closest
    /// point.
    pub(crate) at: (Bounded, Bounded),
    /// The same with bounds as far as `f64` can tell: for those who solve for the closest point in `f64` again.
    loose: (Bounded, Bounded),
    moments: [Moment; 3],
}

/// Which parameters: those of the closest point, those of the step before, and the former with loose bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum When {
    /// At the closest point.
    Now,
    /// A step before.
    Before,
    /// At the closest point, known as far as `f64` can tell.
    Loosely,
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
        let site = Self {
            beams,
            contact,
            active: point.active(),
            form: Form::default(),
            at,
            loose: at,
            moments: Default::default(),
        };
        let Some(refined) = site.refined() else { return Ok(site.formed()) };
        let at = refined.map(Refined::rounded);
        let loose = [0, 1].map(|i| {
            let was = refined[i].within;
            Bounded::new(at[i].value, was.bound + (at[i].value - was.value).abs() * (1.0 + f64::EPSILON))
        });
        Ok(Self { at: at.into(), loose: loose.into(), ..site }.formed())
    }

    /// With the formulas that the library takes here.
    fn formed(self) -> Self {
        let form = Form::at(&self.points(), self.active);
        self.in_form(form)
    }

    /// With these formulas.
    pub(crate) fn in_form(self, form: Form) -> Self {
        Self { form, ..self }
    }

    /// The points of both beams.
    pub(crate) fn points(&self) -> Points<f64> {
        let [beam, bar] = self.frozen(When::Now);
        Points::new(&beam.geometry, &bar.geometry)
    }

    pub(crate) fn parameters(&self, when: When) -> (Bounded, Bounded) {
        match when {
            When::Now => self.at,
            When::Before => before(self.at),
            When::Loosely => self.loose,
        }
    }

    /// Both beams, frozen.
    pub(crate) fn frozen(&self, when: When) -> [Frozen<f64>; 2] {
        let ([beam, bar], (xi, xi_bar)) = (self.beams, self.parameters(when));
        let frozen = || [beam.frozen_plain(xi.value), bar.frozen_plain(xi_bar.value)];
        *self.moments[when as usize].plain.get_or_init(frozen)
    }

    /// Both beams, frozen, with bounds on their errors.
    pub(crate) fn bounded(&self, when: When) -> [Frozen<Bounded>; 2] {
        let ([beam, bar], (xi, xi_bar)) = (self.beams, self.parameters(when));
        *self.moments[when as usize].bounded.get_or_init(|| [beam.frozen(xi), bar.frozen(xi_bar)])
    }

    fn padded(&self, when: When) -> &[PaddedBeam<Bounded>; 2] {
        let ([beam, bar], (xi, xi_bar)) = (self.beams, self.parameters(when));
        self.moments[when as usize].padded.get_or_init(|| [beam.padded(xi), bar.padded(xi_bar)])
    }

    /// The closed form.
    pub(crate) fn plain(&self, subject: &Subject) -> [Varied<f64>; COMPONENTS] {
        let frozen = [When::Now, When::Before].map(|when| self.frozen(when));
        self.variations(subject, frozen, (self.at.0.value, self.at.1.value))
    }

    /// The closed form with the directions exchanged.
    pub(super) fn exchanged(&self, subject: &Subject) -> [Varied<f64>; COMPONENTS] {
        let frozen = [When::Now, When::Before].map(|when| self.frozen(when).map(Frozen::exchanged));
        self.variations(subject, frozen, (self.at.0.value, self.at.1.value))
    }

    /// The closed form, with a bound on its error.
    pub(crate) fn closed(&self, subject: &Subject, when: When) -> [Varied<Bounded>; COMPONENTS] {
        let frozen = [when, When::Before].map(|when| self.bounded(when));
        self.variations(subject, frozen, self.parameters(when))
    }

    /// The closed form with the size of its terms.
    pub(super) fn scales(&self, subject: &Subject) -> [Varied<Magnitude>; COMPONENTS] {
        let at = (Magnitude::parameter(self.at.0.value), Magnitude::parameter(self.at.1.value));
        // A position has the size of the curve at least: where the origin is says nothing of rounding.
        let sized = |frozen: Frozen<f64>| {
            let mut sizes = frozen.map(Magnitude::vector);
            let of_curve = sizes.geometry.t.map(|t| t.scale).min();
            for x in &mut sizes.geometry.x {
                x.scale = x.scale.max(of_curve);
            }
            sizes
        };
        let size = |when| self.frozen(when).map(sized);
        self.variations(subject, [When::Now, When::Before].map(size), at)
    }

    /// Of the beams now and before.
    fn variations<T: Real>(
        &self,
        subject: &Subject,
        [now, before]: [[Frozen<T>; 2]; 2],
        at: (T, T),
    ) -> [Varied<T>; COMPONENTS] {
        subject.variations(&now, || before, at, self.form, self.contact)
    }

    /// Gradients and Hessians of the scalars, contracted with the directions, with bounds on their errors.
    pub(super) fn matrices(&self, subject: &Subject) -> [[Bounded; 3]; SCALARS] {
        let before = || self.padded(When::Before).clone();
        subject.matrices(self.padded(When::Now), before, self.at, self.form, self.contact)
    }

    /// Automatic differentiation in our own hyper-dual numbers, with a bound on its error.
    pub(super) fn chord(&self, when: When) -> [Varied<Bounded>; COMPONENTS] {
        let Self { beams: [beam, bar], contact, active, .. } = *self;
        let at = self.parameters(when);
        let chord = Chord::<Bounded>::new(beam, bar, at, active);
        let lifted = chord.lift_by_orders(beam, bar, at);
        evaluate::<HyperDual<Bounded>>(beam, bar, lifted, contact).map(Varied::from).components()
    }

    /// The closed form in double-double, at the closest point refined there: what its errors are measured against.
    ///
    /// Nothing if Newton's method does not settle within the bounds of the parameters.
    pub(super) fn precise(&self) -> Option<[Varied<DoubleDouble>; COMPONENTS]> {
        let Self { beams: [beam, bar], contact, form, .. } = *self;
        let [xi, xi_bar] = self.refined()?.map(|refined| refined.value);
        let frozen = [beam.frozen_precise(xi), bar.frozen_precise(xi_bar)];
        Some(variations_with(&Sound, &frozen[0], &frozen[1], (xi, xi_bar), form, contact).components())
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
