//! What the quantities share: a pair at its closest point, and the gradients of its parameters.

use super::arithmetic::{Arithmetic, Dofs};
use super::choice::Chosen;
use super::side::{Side, Spread};
use crate::linearization::closed_form::form::Squares;
use crate::linearization::closed_form::{Points, Projection, Sound};
use crate::number::Real;

/// A pair at its closest point.
///
/// What is as long as the dofs is referred to: a vector over them that is moved costs as much as one that is computed.
pub(super) struct Frame<'a, T, V, const N: usize, const M: usize> {
    pub(super) beam: &'a Side<'a, T, V, N>,
    pub(super) bar: &'a Side<'a, T, V, M>,
    /// Along the dofs of the beam, and of the bar beam.
    pub(super) g: Gradients<'a, T, N>,
    pub(super) g_bar: Gradients<'a, T, M>,
    pub(super) products: Products<T, V>,
    /// 1/c·c, if the distance is varied along c.
    pub(super) over_c2: T,
    pub(super) chosen: Chosen<T>,
    /// p, q and q_bar: the inverse of the projection's matrix is [[p, q], [-q, q_bar]].
    pub(super) inverse: [T; 3],
    /// The coefficients of u_hat in delta xi and in -delta xi_bar.
    pub(super) u: V,
    pub(super) u_bar: V,
}

/// The gradients of the parameters along the dofs of one beam.
#[derive(Clone, Copy)]
pub(super) struct Gradients<'a, T, const L: usize> {
    pub(super) xi: &'a Dofs<T, L>,
    pub(super) xi_bar: &'a Dofs<T, L>,
}

/// d, and the products of it and the tangents that the formulas share.
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
    pub(super) fn new<A: Arithmetic<T, Vector = V>, const N: usize, const M: usize>(
        f: A,
        beam: &Side<'_, T, V, N>,
        bar: &Side<'_, T, V, M>,
    ) -> Self {
        let d = f.times_plus(-T::one(), bar.x, beam.x);
        let tangents = [f.dot(beam.t, beam.t), f.dot(bar.t, bar.t), f.dot(beam.t, bar.t)];
        let c = f.cross(beam.t, bar.t);
        Self { d, tangents, c, c2: f.dot(c, c), c_d: f.dot(c, d) }
    }

    /// What decides between the forms.
    #[inline(always)]
    pub(super) fn squares<A: Arithmetic<T, Vector = V>, const N: usize, const M: usize>(
        &self,
        f: A,
        beam: &Side<'_, T, V, N>,
        bar: &Side<'_, T, V, M>,
    ) -> Squares<T> {
        let [t2, t_bar2, _] = self.tangents;
        let t_xi2 = [f.dot(beam.t_xi, beam.t_xi), f.dot(bar.t_xi, bar.t_xi)];
        Squares { t2: [t2, t_bar2], t_xi2, c2: self.c2, c_d: self.c_d }
    }
}

/// The first variations of the parameters, in terms of those of the curves.
pub(super) struct Variations<T, V> {
    pub(super) over_c2: T,
    pub(super) inverse: [T; 3],
    pub(super) u: V,
    pub(super) u_bar: V,
}

impl<T: Real, V: Copy> Variations<T, V> {
    #[inline(always)]
    pub(super) fn new<A: Arithmetic<T, Vector = V>, const N: usize, const M: usize>(
        f: A,
        (beam, bar): (&Side<'_, T, V, N>, &Side<'_, T, V, M>),
        products: &Products<T, V>,
        chosen: Chosen<T>,
    ) -> Self {
        let (zero, one) = (T::zero(), T::one());
        let Products { d, tangents: [t2, t_bar2, b], c2, .. } = *products;
        let active = chosen.form.active;
        // Eq. (50), (51): a = t·t + d·t,ξ   b = t·t̄   ā = −t̄·t̄ + d·t̄,ξ̄
        let a = t2 + f.dot(d, beam.t_xi);
        let a_bar = f.dot(d, bar.t_xi) - t_bar2;
        let mut over_c2 = zero;
        let mut inverse = match (active.xi, active.xi_bar) {
            // Eq. (52): [[p, q], [−q, q̄]] = [[ā, b], [−b, a]]/D, with one division.
            (false, false) => {
                let det = f.mul_add(a, a_bar, b * b);
                let scale = if chosen.form.sign().is_some() {
                    let over_both = one / (c2 * det);
                    over_c2 = det * over_both;
                    c2 * over_both
                } else {
                    one / det
                };
                [a_bar * scale, b * scale, a * scale]
            }
            // An end holds one parameter: the other row alone remains.
            (true, false) => [zero, zero, one / a_bar],
            (false, true) => [one / a, zero, zero],
            (true, true) => [zero; 3],
        };
        // Eq. (50), (52): with R = −δᵤû·t − δᵤu,ξ·d and its twin, δξ = u·δᵤû − p d·δᵤu,ξ − q d·δᵤū,ξ̄
        // and δξ̄ = −ū·δᵤû + q d·δᵤu,ξ − q̄ d·δᵤū,ξ̄ where u = −(p t + q t̄), ū = q̄ t̄ − q t
        let [p, q, q_bar] = inverse;
        let mut u = f.combined([(-p, beam.t), (-q, bar.t)]);
        let mut u_bar = f.combined([(q_bar, bar.t), (-q, beam.t)]);
        if chosen.form.is_crossed() {
            (inverse, u, u_bar) = crossed(f, &points(f, beam, bar), chosen);
            if chosen.form.sign().is_some() {
                // The determinant of the products may be zero here.
                over_c2 = one / c2;
            }
        }
        Self { over_c2, inverse, u, u_bar }
    }
}

/// The gradients of xi and xi_bar along the dofs of one beam, in whose u,xi they have these multiples of d.
#[inline(always)]
pub(super) fn along<T: Real, A: Arithmetic<T>, const L: usize>(
    f: A,
    side: &Side<'_, T, A::Vector, L>,
    (u, u_bar): (A::Vector, A::Vector),
    ([by_d, bar_by_d], d): ([T; 2], A::Vector),
) -> (Dofs<T, L>, Dofs<T, L>) {
    let Spread { n, n_xi, .. } = side.shapes;
    let minus_u_bar = f.times(-T::one(), u_bar);
    let xi = [(n, f.tile(u)), (n_xi, f.tile(f.times(by_d, d)))];
    let xi_bar = [(n, f.tile(minus_u_bar)), (n_xi, f.tile(f.times(bar_by_d, d)))];
    (f.dofs(xi, []), f.dofs(xi_bar, []))
}

/// Both beams at their contact points.
#[inline(always)]
pub(super) fn points<T: Real, A: Arithmetic<T>, const N: usize, const M: usize>(
    f: A,
    beam: &Side<'_, T, A::Vector, N>,
    bar: &Side<'_, T, A::Vector, M>,
) -> Points<T> {
    Points::new(&beam.geometry(f), &bar.geometry(f))
}

/// p, q and q_bar, u and u_bar without products that cancel.
#[inline]
fn crossed<T: Real, A: Arithmetic<T>>(
    f: A,
    points: &Points<T>,
    chosen: Chosen<T>,
) -> ([T; 3], A::Vector, A::Vector) {
    let projection = Projection::with(&Sound, points, chosen.form);
    let [[p, q], [_, q_bar]] = projection.inverse();
    let [u, minus_u_bar] = projection.crossed.map_or([points.d; 2], |crossed| crossed.u);
    ([p, q, q_bar], f.vector(u.into()), f.vector((-minus_u_bar).into()))
}
