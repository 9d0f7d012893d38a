//! The contact element in `f64`: it checks the input, decides the state, and writes residual, tangent and next history.

use super::Values;
use super::closed_form::{self, Contribution};
use super::{ContactError, Decision, History, NormalLaw, Parameters, State};
use crate::closest_point::{ClosestPoint, Degeneracy};
use crate::curve::{Curve, Geometry};
use crate::linearization::closed_form::{Points, jets};
use crate::number::Which;
use crate::pair::{DofVector, Pair};

/// What a contact element returns beside residual and tangent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The state.
    pub state: State,
    /// Forces, gap and slips.
    pub values: Values<f64>,
    /// The gap at which the contact opens less g_N: a length, negative if the contact is open. K jumps at 0 for laws that
    /// have a kink there.
    pub to_opening: f64,
    /// The history of the next step, if this iterate is the converged one.
    pub next: History,
}

impl Outcome {
    /// The distance to the nearest kink of the tangent, if it is below a relative tolerance.
    ///
    /// The distance to the cone is |Phi|/(mu F_N). The distance to opening is relative to r + r_bar.
    pub fn near_kink(&self, radii: f64, tolerance: f64) -> Option<Kink> {
        let cone = self.state.has_friction().then_some(Kink::Cone { yield_ratio: self.values.yield_ratio });
        let cone = cone.filter(|_| self.values.yield_ratio.abs() <= tolerance);
        let opening =
            (self.to_opening.abs() <= tolerance * radii).then_some(Kink::Opening { gap: self.to_opening });
        opening.or(cone)
    }
}

/// A kink of the residual: the tangent there is one-sided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kink {
    /// The trial force is near the cone.
    Cone {
        /// Phi/(mu F_N).
        yield_ratio: f64,
    },
    /// The contact is about to open or to close.
    Opening {
        /// The opening gap less g_N, a length.
        gap: f64,
    },
}

/// The contact element of a pair of beams.
///
/// [`Pair::contact`] has the radii. Its reference parameters are not used: the [`History`] has them.
#[derive(Clone, Copy, Debug)]
pub struct Element<'a, A, B, L, const N: usize, const M: usize> {
    pair: &'a Pair<A, B, N, M>,
    parameters: &'a Parameters<L>,
}

impl<'a, A: Curve<N>, B: Curve<M>, L: NormalLaw, const N: usize, const M: usize> Element<'a, A, B, L, N, M> {
    /// The element of a pair.
    ///
    /// # Errors
    /// [`ContactError::Parameter`] for a parameter or a radius that is out of range.
    pub fn new(pair: &'a Pair<A, B, N, M>, parameters: &'a Parameters<L>) -> Result<Self, ContactError> {
        parameters.check()?;
        for (name, value) in [("r", pair.contact.radius), ("r_bar", pair.contact.radius_bar)] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(ContactError::Parameter { name, value });
            }
        }
        Ok(Self { pair, parameters })
    }

    /// Writes R and K at a closest point over `to`. Nothing is allocated.
    ///
    /// # Errors
    /// [`ContactError`] if the point or the history does not define them; `to` is then unchanged. If R or the
    /// diagonal of K overflows, [`ContactError::Result`]; `to` is then zero.
    pub fn evaluate(
        &self,
        q: &DofVector<f64, N, M>,
        point: &ClosestPoint,
        history: &History,
        to: &mut Contribution<f64, N, M>,
    ) -> Result<Outcome, ContactError> {
        let at = (point.xi, point.xi_bar);
        let (jet, jet_bar) = jets(self.pair, q, at);
        let points = Points::new(&jet.geometry, &jet_bar.geometry);
        let decision = self.decide_at(&points, point, history)?;
        let values = closed_form::write_by_kernel(&decision, (&jet, &jet_bar), q, at, to);
        if let Some((name, value)) = to.not_finite() {
            to.set_zero();
            return Err(ContactError::Result { name, value });
        }
        Ok(self.outcome(&decision, &points, point, values))
    }

    /// The state at a closest point, for [`closed_form::write`] and [`ad`](super::ad) in other scalars.
    ///
    /// # Errors
    /// Those of [`Element::evaluate`].
    pub fn decide(
        &self,
        q: &DofVector<f64, N, M>,
        point: &ClosestPoint,
        history: &History,
    ) -> Result<Decision<'a, L>, ContactError> {
        let (jet, jet_bar) = jets(self.pair, q, (point.xi, point.xi_bar));
        let points = Points::new(&jet.geometry, &jet_bar.geometry);
        self.decide_at(&points, point, history)
    }

    fn decide_at(
        &self,
        points: &Points<f64>,
        point: &ClosestPoint,
        history: &History,
    ) -> Result<Decision<'a, L>, ContactError> {
        history.check()?;
        for (which, geometry) in [(Which::Beam, &points.beam), (Which::Bar, &points.bar)] {
            check_geometry(which, geometry)?;
        }
        let held = point.held();
        match point.degeneracy() {
            Some(Degeneracy::ZeroTangent { which }) => {
                let t = if which == Which::Beam { points.beam.t } else { points.bar.t };
                return Err(ContactError::ZeroTangent { which, length: t.norm() });
            }
            Some(Degeneracy::Singular { conditioning }) => {
                return Err(ContactError::Parallel { conditioning });
            }
            _ => {}
        }
        let distance = points.d.norm();
        if distance == 0.0 && (held.xi || held.xi_bar) {
            return Err(ContactError::NoNormal { distance });
        }
        Decision::new(self.parameters, self.pair.contact, points, (point.xi, point.xi_bar), held, history)
    }

    fn outcome(
        &self,
        decision: &Decision<'_, L>,
        points: &Points<f64>,
        point: &ClosestPoint,
        values: Values<f64>,
    ) -> Outcome {
        let state = decision.state;
        let next = decision.next_history(points, (point.xi, point.xi_bar), &values);
        let to_opening = self.parameters.law.opening_gap() - values.g_n;
        Outcome { state, values, to_opening, next }
    }
}

/// Checks that a beam has finite numbers and a tangent.
fn check_geometry(which: Which, geometry: &Geometry<f64>) -> Result<(), ContactError> {
    let Geometry { x, t, t_xi, t_xixi } = geometry;
    // One sum costs less than twelve tests. It may overflow by itself.
    if !(x + t + t_xi + t_xixi).sum().is_finite() {
        for (name, vector) in [("x", x), ("t", t), ("t,xi", t_xi), ("t,xixi", t_xixi)] {
            if let Some(&value) = vector.iter().find(|value| !value.is_finite()) {
                return Err(ContactError::NotFinite { which, name, value });
            }
        }
    }
    let length = t.norm();
    if length > 0.0 { Ok(()) } else { Err(ContactError::ZeroTangent { which, length }) }
}
