//! The linearization in closed form: the formulas of the paper, with misprints corrected and missing terms added.
//!
//! The [`derivation`] has all formulas. [`paper`] has one function for each of the paper's equations. [`variations()`]
//! evaluates them in two directions. [`Matrices`] has gradients and Hessians in all dofs, for every curve. [`kernel`]
//! has the same numbers in vector arithmetic; [`Pair::linearize`] uses it. The three check each other: a matrix
//! contracted with directions equals the variation, and the kernel equals the matrices.
//!
//! Two parts are added throughout: the terms Delta_u delta_u u, which the paper drops, and closest points at an end of
//! a beam, where the parameter is held. The variations of d and the solution of the two-by-two system have two forms,
//! the paper's and one that keeps its digits at small gaps and angles: see [`Formulation`].

use crate::closest_point::ClosestPoint;
use crate::curve::{Curve, Jet};
use crate::linearization::{Linearization, Linearized, Quantities, Varied};
use crate::number::Real;
use crate::pair::{Contact, DofVector, Pair};
use crate::source_fault::source_fault;
use kernel::WithSlips;

#[doc = include_str!("closed_form/derivation.md")]
pub mod derivation {}
mod contact_points;
pub mod formulation;
#[cfg_attr(
    not(target_arch = "x86_64"),
    allow(unused, reason = "other processors run the kernel in scalar arithmetic, without lanes")
)]
pub mod kernel;
mod matrices;
pub mod paper;
mod partial_variations;
mod projection;
mod sums;
pub mod variations;

pub use contact_points::Points;
pub use formulation::Formulation;
pub use matrices::{Matrices, VectorQuantity};
pub use partial_variations::PartialVariations;
pub use projection::Projection;
pub use variations::{variations, variations_in};

impl<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize> Pair<A, B, N, M> {
    /// All scalar quantities with gradients and Hessians, at a closest point of the pair. The kernel computes them by
    /// the formulas that lose the fewest digits there ([`Formulation::at`]).
    ///
    /// Where the centroids cross inside both beams, d = 0 and d as a length has no derivatives. The results are then of
    /// the signed distance along n = t × t_bar/|t × t_bar|. Its sign, and that of n, is arbitrary. Elsewhere n
    /// points from the bar beam to the beam, and d is positive.
    ///
    /// # Example
    /// See the crate's front page.
    #[must_use]
    pub fn linearize(&self, q: &DofVector<f64, N, M>, point: &ClosestPoint) -> Linearized<N, M> {
        Linearized::written(|to| self.linearize_into(q, point, to))
    }

    /// The same results, written over `to`.
    #[inline]
    pub fn linearize_into(
        &self,
        q: &DofVector<f64, N, M>,
        point: &ClosestPoint,
        to: &mut Linearization<f64, N, M>,
    ) {
        let Linearization { d, t, t_bar, xi, xi_bar, g_t, g_t_bar, radii } = to;
        let Contact { radius, radius_bar, .. } = self.contact;
        *radii = radius + source_fault!("radius-twice": radius, radius_bar);
        self.write(q, point, WithSlips { d, xi, xi_bar, t, t_bar, g_t, g_t_bar });
    }
}

/// All quantities with their variations along `dq` (delta) and `linear_dq` (Delta), at a closest point of the pair, by
/// the formulas that [`Pair::linearize`] uses.
pub fn vary<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    dq: &DofVector<f64, N, M>,
    linear_dq: &DofVector<f64, N, M>,
) -> Quantities<Varied<f64>> {
    let at = (point.xi, point.xi_bar);
    let (jet, jet_bar) = jets(pair, q, at);
    let beam = PartialVariations::new(&jet, &dq.beam, &linear_dq.beam);
    let bar = PartialVariations::new(&jet_bar, &dq.bar, &linear_dq.bar);
    let form = Formulation::at(&Points::new(&jet.geometry, &jet_bar.geometry), point.held());
    variations_in(form, &beam, &bar, at, &pair.contact)
}

/// The jets of both curves.
#[expect(clippy::type_complexity, reason = "a pair of jets has no shorter name")]
pub fn jets<T: Real, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<T, N, M>,
    (xi, xi_bar): (T, T),
) -> (Jet<T, A::Dofs<T>>, Jet<T, B::Dofs<T>>) {
    (pair.curve.jet(&q.beam, xi), pair.curve_bar.jet(&q.bar, xi_bar))
}
