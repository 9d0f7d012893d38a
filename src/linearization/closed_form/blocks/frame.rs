//! What the quantities share: a pair at its closest point, and the gradients of its parameters.

use super::arithmetic::Arithmetic;
use super::side::Side;
use crate::closest_point::Active;
use crate::linearization::closed_form::Projection;
use crate::number::Real;

/// A pair at its closest point.
pub(super) struct Frame<T, V, const N: usize, const M: usize> {
    pub(super) beam: Side<T, V, N>,
    pub(super) bar: Side<T, V, M>,
    /// d, the vector; d, the distance, and its inverse; n = d/d.
    pub(super) d: V,
    pub(super) distance: T,
    pub(super) curvature: T,
    pub(super) n: V,
    /// p, q and q_bar: the inverse of the projection's matrix is [[p, q], [-q, q_bar]].
    pub(super) inverse: [T; 3],
    /// The coefficients of u_hat in delta xi and in -delta xi_bar.
    pub(super) u: V,
    pub(super) u_bar: V,
}

impl<T: Real, V: Copy, const N: usize, const M: usize> Frame<T, V, N, M> {
    #[inline(always)]
    pub(super) fn new<A: Arithmetic<T, Vector = V>>(
        f: A,
        mut beam: Side<T, V, N>,
        mut bar: Side<T, V, M>,
        active: Active,
    ) -> Self {
        let one = T::one();
        let d = f.times_plus(-one, bar.x, beam.x);
        // Eq. (50), (51): a = t·t + d·t,ξ   b = t·t̄   ā = −t̄·t̄ + d·t̄,ξ̄
        let projection = Projection {
            a: f.dot(beam.t, beam.t) + f.dot(d, beam.t_xi),
            b: f.dot(beam.t, bar.t),
            a_bar: f.dot(d, bar.t_xi) - f.dot(bar.t, bar.t),
            active,
        };
        let [p, q, q_bar] = inverse(&projection);
        let distance = f.dot(d, d).sqrt();
        let curvature = one / distance;
        let n = f.times(curvature, d);
        // Eq. (50), (52): with R = −δᵤû·t − δᵤu,ξ·d and its twin, δξ = u·δᵤû − p d·δᵤu,ξ − q d·δᵤū,ξ̄
        // and δξ̄ = −ū·δᵤû + q d·δᵤu,ξ − q̄ d·δᵤū,ξ̄ where u = −(p t + q t̄), ū = q̄ t̄ − q t
        let u = f.combined([(-p, beam.t), (-q, bar.t)]);
        let u_bar = f.combined([(q_bar, bar.t), (-q, beam.t)]);
        let (minus_u_bar, q_d, minus_q_d) = (f.times(-one, u_bar), f.times(q, d), f.times(-q, d));
        beam.g = f.dofs([(&beam.shapes[0], f.tile(u)), (&beam.shapes[1], f.tile(f.times(-p, d)))], []);
        bar.g = f.dofs([(&bar.shapes[0], f.tile(u)), (&bar.shapes[1], f.tile(minus_q_d))], []);
        beam.g_bar = f.dofs([(&beam.shapes[0], f.tile(minus_u_bar)), (&beam.shapes[1], f.tile(q_d))], []);
        bar.g_bar = f.dofs([(&bar.shapes[0], f.tile(minus_u_bar)), (&bar.shapes[1], f.tile(f.times(-q_bar, d)))], []);
        Self { beam, bar, d, distance, curvature, n, inverse: [p, q, q_bar], u, u_bar }
    }
}

/// p, q and q_bar.
#[inline(always)]
fn inverse<T: Real>(projection: &Projection<T>) -> [T; 3] {
    let Projection { a, b, a_bar, active } = *projection;
    let (zero, one) = (T::zero(), T::one());
    match (active.xi, active.xi_bar) {
        // Eq. (52): [[p, q], [−q, q̄]] = [[ā, b], [−b, a]]/D, with one division.
        (false, false) => {
            let scale = one / projection.det();
            [a_bar * scale, b * scale, a * scale]
        }
        (true, false) => [zero, zero, one / a_bar],
        (false, true) => [one / a, zero, zero],
        (true, true) => [zero; 3],
    }
}
