//! The Hessians of the closest point's parameters.
//!
//! The vectors and constants are those of the matrices' derivation, sorted by what they multiply: P and P_bar enter the
//! Hessian of xi with the factors p and q, and that of xi_bar with -q and q_bar, here x and y. With sym(u, v) = uvᵀ + vuᵀ,
//!
//! ```text
//! H = x P + y P̄ = sym(g, w) + sym(ḡ, w̄) − x C − y C̄     w = −(x α + y β̄)     w̄ = −(y ᾱ + x β)
//! ```
//!
//! g, g_bar, w and w_bar are linear in the variations u_hat, u,xi, u,xixi, u_bar,xi and u_bar,xixi of the jets, and so is
//! every row of H. The rows of these variations are found first; a dof's row is a sum of them.

use super::arithmetic::{Arithmetic, by_axis};
use super::frame::Frame;
use super::side::Side;
use crate::number::Real;

/// The Hessian of a parameter: its rows that belong to the variations of the jets.
pub(super) struct Parameter<T, const N: usize, const M: usize> {
    pub(super) beam: Rows<T, N>,
    pub(super) bar: Rows<T, M>,
    /// What is left of the row of a beam's dof is this multiple of g, and of a bar beam's dof this multiple of g_bar.
    pub(super) bend: [T; N],
    pub(super) bend_bar: [T; M],
}

/// The columns of one beam.
pub(super) struct Rows<T, const L: usize> {
    /// The rows of u_hat, u,xi and u_bar,xi.
    pub(super) hat: [[T; L]; 3],
    pub(super) xi: [[T; L]; 3],
    pub(super) xi_bar: [[T; L]; 3],
}

/// What w, or w_bar, is along u_hat, u,xi and u_bar,xi.
type Along<V> = [V; 3];

impl<T: Real, const N: usize, const M: usize> Parameter<T, N, M> {
    /// From x, y and m = −(x t + y t̄).
    #[inline(always)]
    pub(super) fn new<V: Copy, A: Arithmetic<T, Vector = V>>(
        f: A,
        frame: &Frame<T, V, N, M>,
        ([x, y], m): ([T; 2], V),
    ) -> Self {
        let Frame { beam, bar, d, inverse: [p, q, q_bar], u, u_bar, .. } = frame;
        let (p, q, q_bar, d, u, u_bar) = (*p, *q, *q_bar, *d, *u, *u_bar);
        let half = <T as From<f64>>::from(0.5);
        // The multiples of g and ḡ in w and w̄: those in α, β, ᾱ and β̄.
        let straight = f.mul_add(half, f.dot(d, beam.t_xixi), f.dot(beam.t, beam.t_xi));
        let straight_bar = f.mul_add(half, f.dot(d, bar.t_xixi), -f.dot(bar.t, bar.t_xi));
        let g = f.mul_add(half, f.dot(m, beam.t_xi), -(x * straight));
        let bar_g_bar = -f.mul_add(half, f.dot(m, bar.t_xi), y * straight_bar);
        let (g_bar, bar_g) = (x * f.dot(bar.t, beam.t_xi), -(y * f.dot(beam.t, bar.t_xi)));
        let (in_beam, in_bar) = (f.mul_add(g_bar, q, -(g * p)), -f.mul_add(g_bar, q_bar, g * q));
        let w = [
            f.combined([(-x, beam.t_xi), (g, u), (-g_bar, u_bar)]),
            f.times_plus(in_beam, d, f.times_plus(-x, beam.t, m)),
            f.combined([(-y, beam.t), (in_bar, d)]),
        ];
        let (in_beam, in_bar) =
            (f.mul_add(bar_g_bar, q, -(bar_g * p)), -f.mul_add(bar_g_bar, q_bar, bar_g * q));
        let w_bar = [
            f.combined([(-y, bar.t_xi), (bar_g, u), (-bar_g_bar, u_bar)]),
            f.combined([(x, bar.t), (in_beam, d)]),
            f.times_plus(in_bar, d, f.times_plus(-T::one(), m, f.times(y, bar.t))),
        ];
        // −x d·Δᵤu,ξξ and −y d·Δᵤū,ξ̄ξ̄, the parts of w and w̄ that belong to one beam only
        let bend: [T; N] = f.dofs([(&beam.shapes[2], f.tile(f.times(-x, d)))], []);
        let bend_bar: [T; M] = f.dofs([(&bar.shapes[2], f.tile(f.times(-y, d)))], []);
        // v = −p w + q w̄   v̄ = −q w − q̄ w̄
        let v = [
            f.combined([(-p, w[0]), (q, w_bar[0])]),
            f.combined([(-p, w[1]), (q, w_bar[1])]),
            f.combined([(-p, w[2]), (q, w_bar[2])]),
        ];
        let v_bar = [
            f.combined([(-q, w[0]), (-q_bar, w_bar[0])]),
            f.combined([(-q, w[1]), (-q_bar, w_bar[1])]),
            f.combined([(-q, w[2]), (-q_bar, w_bar[2])]),
        ];
        let combined = [w, w_bar, v, v_bar];
        Self {
            beam: Rows::new(f, frame, ([x, y], -x), beam, &combined, (1, &bend, [-p, -q])),
            bar: Rows::new(f, frame, ([x, y], -y), bar, &combined, (2, &bend_bar, [q, -q_bar])),
            bend,
            bend_bar,
        }
    }
}

impl<T: Real, const L: usize> Rows<T, L> {
    /// `along_tangent` is what couples u_hat and the first derivatives of this side in C and C_bar. Then come w, w_bar, v and
    /// v_bar along the variations of the jets, which of these the first derivatives of this side are, and the second with
    /// their multiples in v and v_bar.
    #[inline(always)]
    fn new<V: Copy, A: Arithmetic<T, Vector = V>, const N: usize, const M: usize>(
        f: A,
        frame: &Frame<T, V, N, M>,
        ([x, y], along_tangent): ([T; 2], T),
        side: &Side<T, V, L>,
        [w, w_bar, v, v_bar]: &[Along<V>; 4],
        (first, bend, [in_v, in_v_bar]): (usize, &[T; L], [T; 2]),
    ) -> Self {
        let Side { shapes: [s, s_xi, _], g, g_bar, .. } = side;
        let (d, t, t_bar) = (f.components(frame.d), f.components(frame.beam.t), f.components(frame.bar.t));
        let (w_0, w_1, w_2) = (f.components(w[0]), f.components(w[1]), f.components(w[2]));
        let (w_bar_0, w_bar_1, w_bar_2) =
            (f.components(w_bar[0]), f.components(w_bar[1]), f.components(w_bar[2]));
        let of_v = side.along(f, [v[0], v[first]], (in_v, bend));
        let of_v_bar = side.along(f, [v_bar[0], v_bar[first]], (in_v_bar, bend));
        Self {
            hat: by_axis(
                #[inline(always)]
                |i| {
                    // u w − ū w̄ = t v + t̄ v̄
                    let sum = [(t[i], &of_v[..]), (t_bar[i], &of_v_bar), (w_0[i], g), (w_bar_0[i], g_bar)];
                    f.dofs([(s_xi, f.tile_along(i, along_tangent))], sum)
                },
            ),
            xi: by_axis(
                #[inline(always)]
                |i| {
                    let sum = [(d[i], &of_v[..]), (w_1[i], g), (w_bar_1[i], g_bar)];
                    f.dofs([(s, f.tile_along(i, -x))], sum)
                },
            ),
            xi_bar: by_axis(
                #[inline(always)]
                |i| {
                    let sum = [(d[i], &of_v_bar[..]), (w_2[i], g), (w_bar_2[i], g_bar)];
                    f.dofs([(s, f.tile_along(i, -y))], sum)
                },
            ),
        }
    }
}
