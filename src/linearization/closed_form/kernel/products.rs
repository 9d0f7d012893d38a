//! The products of a pair that its quantities share.

use super::arithmetic::Arithmetic;
use super::side::Point;
use crate::linearization::closed_form::formulation::Squares;
use crate::number::Real;

/// d, and the products of d and the tangents that the formulas share.
#[derive(Clone, Copy)]
pub(super) struct Products<T, V> {
    /// The vector d.
    pub(super) d: V,
    /// t·t, t̄·t̄ and t·t̄.
    pub(super) tangents: [T; 3],
    /// c = t × t̄ with c·c and c·d: along the normal of both tangents.
    pub(super) c: V,
    pub(super) c2: T,
    pub(super) c_d: T,
}

impl<T: Real, V: Copy> Products<T, V> {
    #[inline(always)]
    pub(super) fn new<A: Arithmetic<T, Vector = V>>(f: A, (beam, bar): (&Point<V>, &Point<V>)) -> Self {
        let d = f.times_plus(-T::one(), bar.x, beam.x);
        let tangents = [f.dot(beam.t, beam.t), f.dot(bar.t, bar.t), f.dot(beam.t, bar.t)];
        let c = f.cross(beam.t, bar.t);
        Self { d, tangents, c, c2: f.dot(c, c), c_d: f.dot(c, d) }
    }

    /// The products that decide between the formulations.
    #[inline(always)]
    pub(super) fn squares<A: Arithmetic<T, Vector = V>>(
        &self,
        f: A,
        (beam, bar): (&Point<V>, &Point<V>),
    ) -> Squares<T> {
        let [t2, t_bar2, _] = self.tangents;
        let t_xi2 = [f.dot(beam.t_xi, beam.t_xi), f.dot(bar.t_xi, bar.t_xi)];
        Squares { t2: [t2, t_bar2], t_xi2, c2: self.c2, c_d: self.c_d }
    }
}
