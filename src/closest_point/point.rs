//! One closest (or otherwise stationary) point: its parameters, its kind and its conditioning.

use super::SquaredDistance;
use super::held::{Held, WEAK};
use crate::number::Which;

/// From this scaled eigenvalue on, the gradients of the parameters keep most of their digits.
const CLEAR: f64 = 1e-3;
/// From this relative error of these gradients on, a point is ill-conditioned.
const TOO_LARGE: f64 = 1e-6;
/// Where rounding moves a parameter farther than this, Newton's method ends with steps of this size.
const SETTLED: f64 = 1e-7;
/// The parameters of a minimum of fourth order are accurate to the fourth root of the rounding of d².
const FOURTH_ORDER: f64 = 1.7e-4;

/// A stationary point of the distance over the square of the two parameters, or over one of its edges or corners.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ClosestPoint {
    /// xi, the parameter on the first curve.
    pub xi: f64,
    /// xi_bar, the parameter on the bar beam.
    #[doc(alias = "eta")]
    pub xi_bar: f64,
    /// The end of the first beam at which xi is held, if it is held.
    pub end: Option<End>,
    /// The end of the bar beam at which xi_bar is held, if it is held.
    pub end_bar: Option<End>,
    /// The kind of stationary point within the square.
    pub kind: Kind,
    /// d = ‖x - x_bar‖, in the user's unit of length.
    pub distance: f64,
    /// The largest |cos| of the angle between d and the tangent over the free parameters; 0 if the centroids cross.
    pub residual: f64,
    /// The smallest eigenvalue of the Hessian of d²/2 for unit tangents, over the free parameters.
    ///
    /// It is 1 - |cos θ| for straight beams at the angle θ, infinite if no parameter is free, and zero if the tangent of
    /// a free parameter has no length.
    pub conditioning: f64,
    degeneracy: Option<Degeneracy>,
    /// The possible errors of xi and xi_bar, if they exceed a few digits.
    pub(super) uncertainty: [f64; 2],
}

/// The kind of a stationary point of the distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A local minimum.
    Minimum,
    /// Neither a minimum nor a maximum.
    Saddle,
    /// A local maximum.
    Maximum,
}

/// The end of a beam at which a parameter is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Which end.
    pub side: Side,
    /// Whether the multiplier is clearly not zero. If it is not, only one-sided derivatives exist.
    pub strict: bool,
    /// The cosine of the angle between d and the tangent, positive where leaving the end would increase the distance.
    ///
    /// If the tangent has no length, the first derivative that does not vanish takes its place.
    pub multiplier: f64,
}

/// The two ends of a beam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// xi = -1.
    Lower,
    /// xi = 1.
    Upper,
}

/// The reasons why the derivatives at a point are unreliable.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Degeneracy {
    /// A tangent has no length: its norm, and slips, have no derivative.
    ZeroTangent {
        /// The beam of the tangent.
        which: Which,
    },
    /// D = 0 up to rounding: the parameters have no derivative.
    Singular {
        /// The scaled eigenvalue of the Hessian that is smallest in size.
        conditioning: f64,
    },
    /// A parameter is about to leave its end, or is at an end without being held: only one-sided derivatives exist.
    WeakEnd {
        /// The scaled multiplier.
        multiplier: f64,
    },
    /// The centroids cross, d = 0: the parameters have derivatives, the distance has none.
    Crossing,
    /// D is so near 0 that rounding destroys most digits of the parameters' derivatives, but not those of the distance.
    IllConditioned {
        /// The scaled eigenvalue of the Hessian that is smallest in size.
        conditioning: f64,
        /// The relative error of the gradients of xi and xi_bar, about rounding / conditioning² at a fold.
        gradient_error: f64,
    },
}

impl ClosestPoint {
    /// Describes the point at the parameters (`xi`, `xi_bar`), with the `held` ones held.
    pub(super) fn new((xi, xi_bar): (f64, f64), p: &SquaredDistance, held: Held) -> Self {
        let end = held.xi.then(|| End::new(p, 0, xi));
        let end_bar = held.xi_bar.then(|| End::new(p, 1, xi_bar));
        let [low, high] = p.eigenvalues(held);
        let (conditioning, smallest) = (low, low.abs().min(high.abs()));
        let still = [p.stands_still(0), p.stands_still(1)];
        let degeneracy = if still[0] || still[1] {
            Some(Degeneracy::ZeroTangent { which: if still[0] { Which::Beam } else { Which::Bar } })
        } else if p.rounds_to_zero(smallest, held) {
            Some(Degeneracy::Singular { conditioning: smallest })
        } else if let Some(end) = [end, end_bar].into_iter().flatten().find(|end| !end.strict) {
            Some(Degeneracy::WeakEnd { multiplier: end.multiplier })
        } else if let Some(end) = released(p, 0, held.xi, xi).or(released(p, 1, held.xi_bar, xi_bar)) {
            Some(Degeneracy::WeakEnd { multiplier: end.multiplier })
        } else if p.is_crossing() {
            Some(Degeneracy::Crossing)
        } else {
            let gradient_error = if smallest < CLEAR { p.gradient_error(low, held) } else { 0.0 };
            (gradient_error > TOO_LARGE)
                .then_some(Degeneracy::IllConditioned { conditioning: smallest, gradient_error })
        };
        let uncertainty = if p.is_unlike() {
            let of = |i: usize, held: bool| {
                if held { 0.0 } else { 4.0 * p.uncertainty(i, smallest.min(1.0)) + SETTLED }
            };
            [of(0, held.xi), of(1, held.xi_bar)]
        } else if smallest < CLEAR {
            [0, 1].map(|i| p.uncertainty(i, smallest).min(FOURTH_ORDER))
        } else {
            [0.0; 2]
        };
        Self {
            uncertainty,
            xi,
            xi_bar,
            end,
            end_bar,
            kind: Kind::new(p, end, end_bar),
            distance: p.distance,
            residual: p.residual(held),
            conditioning,
            degeneracy,
        }
    }

    /// Frees these parameters: their ends are those of an element within a longer beam.
    pub(crate) fn free(&mut self, which: Held) {
        self.end = self.end.filter(|_| !which.xi);
        self.end_bar = self.end_bar.filter(|_| !which.xi_bar);
        if which != Held::default() && matches!(self.degeneracy, Some(Degeneracy::WeakEnd { .. })) {
            self.degeneracy = None;
        }
    }

    /// Which parameters are held at an end.
    pub fn held(&self) -> Held {
        Held { xi: self.end.is_some(), xi_bar: self.end_bar.is_some() }
    }

    /// Whether both parameters lie inside their beams.
    pub fn is_interior(&self) -> bool {
        self.held() == Held::default()
    }

    /// Whether two points are equal up to rounding.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        let near = |i: usize, difference: f64| {
            difference.abs() < (self.uncertainty[i] + other.uncertainty[i]).max(1e-9)
        };
        self.held() == other.held() && near(0, self.xi - other.xi) && near(1, self.xi_bar - other.xi_bar)
    }

    /// The point of curves whose lengths were divided by `unit`.
    pub(super) fn in_unit(self, unit: f64) -> Self {
        Self { distance: self.distance * unit, ..self }
    }

    /// Whether the distance decreases from an end into a beam.
    pub(super) fn leads_inward(&self) -> bool {
        [self.end, self.end_bar].into_iter().flatten().any(End::leads_inward)
    }

    /// Whether every held parameter is strictly held.
    pub fn is_strict(&self) -> bool {
        [self.end, self.end_bar].into_iter().flatten().all(|end| end.strict)
    }

    /// The most severe reason why derivatives at this point are unreliable, if there is one.
    pub fn degeneracy(&self) -> Option<Degeneracy> {
        self.degeneracy
    }
}

impl End {
    /// Whether the distance clearly decreases from the end into the beam.
    fn leads_inward(self) -> bool {
        self.strict && self.multiplier < 0.0
    }

    fn new(p: &SquaredDistance, i: usize, at: f64) -> Self {
        let side = Side::nearest(at);
        if p.stands_still(i) {
            let multiplier = p.cosine_into(i, side.parameter());
            return Self { side, strict: multiplier.abs() > WEAK, multiplier };
        }
        Self { side, strict: !p.is_weak(i), multiplier: 0.0 - side.parameter() * p.cosine(i) }
    }
}

/// The end at which a parameter is that is not held. It may leave the end in one direction only.
fn released(p: &SquaredDistance, i: usize, held: bool, at: f64) -> Option<End> {
    (!held && at.abs() >= 1.0).then(|| End::new(p, i, at))
}

impl Side {
    /// The end nearest to a parameter.
    pub(super) fn nearest(at: f64) -> Self {
        if at < 0.0 { Self::Lower } else { Self::Upper }
    }

    /// The parameter of this end.
    pub fn parameter(self) -> f64 {
        match self {
            Self::Lower => -1.0,
            Self::Upper => 1.0,
        }
    }
}

impl Kind {
    /// The kind of a stationary point: the sign of the Hessian over the parameters that are not strictly held.
    fn new(p: &SquaredDistance, end: Option<End>, end_bar: Option<End>) -> Self {
        let strict = |end: Option<End>| end.is_some_and(|end| end.strict);
        if [end, end_bar].into_iter().flatten().any(End::leads_inward) {
            return Self::Saddle;
        }
        let held = Held { xi: strict(end), xi_bar: strict(end_bar) };
        if let (Some(end), Some(end_bar), false, false) = (end, end_bar, held.xi, held.xi_bar) {
            // In a corner both parameters can only move into the square, so the Hessian only has to be copositive.
            let b = if end.side == end_bar.side { -p.b } else { p.b };
            if p.a > 0.0 && p.a_bar < 0.0 && b >= 0.0 {
                return Self::Minimum;
            }
        }
        if p.is_convex(held) {
            Self::Minimum
        } else if held == Held::default() && p.a < 0.0 && p.det > 0.0 {
            Self::Maximum
        } else {
            Self::Saddle
        }
    }
}

#[cfg(test)]
mod tests;
