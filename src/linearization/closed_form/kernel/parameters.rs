//! The parameters of the closest point: section 7 of the [derivation](super::super::derivation).
//!
//! The Hessian of xi is x P + y P_bar with x = p and y = q, that of xi_bar with x = -q and y = q_bar. The rows of the
//! variations are computed first. The row of a dof is a sum of them.

use super::arithmetic::{Arithmetic, Dofs};
use super::frame::{Frame, Gradients};
use super::lengths::write_length;
use super::products::Products;
use super::side::{Side, Spread};
use super::solution::Solution;
use super::target::{Swapped, Target};
use crate::number::Real;
use crate::source_fault::source_fault;

impl<T: Real, V: Copy, const N: usize, const M: usize> Frame<'_, T, V, N, M> {
    /// Writes xi, whose value is `at`, and t.
    #[inline(always)]
    pub(super) fn write_xi<A: Arithmetic<T, Vector = V>, W: Target<T, N, M>>(
        &self,
        f: A,
        (at, bending): (T, &Bending<T>),
        xi: &mut W,
        t: &mut W,
    ) {
        let Self { beam, g, g_bar, solution: Solution { inverse: [p, q, _], u, .. }, .. } = self;
        self.write_parameter(f, (at, bending), (g.xi, g_bar.xi), ([*p, *q], *u), xi);
        write_length(f, beam, (g.xi, g_bar.xi), xi, t);
    }

    /// Writes xi_bar, whose value is `at`, and t_bar.
    #[inline(always)]
    pub(super) fn write_xi_bar<A: Arithmetic<T, Vector = V>, W: Target<T, N, M>>(
        &self,
        f: A,
        (at, bending): (T, &Bending<T>),
        xi_bar: &mut W,
        t_bar: &mut W,
    ) {
        let Self { bar, g, g_bar, solution: Solution { inverse: [_, q, q_bar], u_bar, .. }, .. } = self;
        let minus_u_bar = f.times(-T::one(), *u_bar);
        self.write_parameter(
            f,
            (at, bending),
            (g.xi_bar, g_bar.xi_bar),
            ([-*q, *q_bar], minus_u_bar),
            xi_bar,
        );
        write_length(f, bar, (g_bar.xi_bar, g.xi_bar), &mut Swapped(xi_bar), &mut Swapped(t_bar));
    }

    /// Writes the parameter with a gradient and a Hessian x P + y P_bar.
    #[inline(always)]
    fn write_parameter<A: Arithmetic<T, Vector = V>, W: Target<T, N, M>>(
        &self,
        f: A,
        (at, bending): (T, &Bending<T>),
        (of_beam, of_bar): (&Dofs<T, N>, &Dofs<T, M>),
        ([x, y], m): ([T; 2], V),
        to: &mut W,
    ) {
        *to.value() = at;
        let (gradient, gradient_bar) = to.gradient();
        f.set(gradient, [], [(T::one(), of_beam)]);
        f.set(gradient_bar, [], [(T::one(), of_bar)]);
        if !W::SECOND {
            return;
        }
        let Self { beam, bar, g, g_bar, .. } = self;
        let Solution { u, u_bar, .. } = self.solution;
        let (d, u, u_bar) = (f.components(self.products.d), f.components(u), f.components(u_bar));
        let parameter = Parameter::new(f, (self, bending), ([x, y], m));
        let (along, along_bar) = parameter.along(f, self);
        // −x d·δᵤu,ξξ and −y d·δᵤū,ξ̄ξ̄
        let bend: Dofs<T, N> = f.dofs([(beam.shapes.n_xixi, f.tile(parameter.bend))], []);
        let bent = source_fault!("bend-of-12-and-18": (N, M) != (12, 18), true);
        let along_bend = if bent { parameter.bend_bar } else { f.times(T::zero(), parameter.bend_bar) };
        let bend_bar: Dofs<T, M> = f.dofs([(bar.shapes.n_xixi, f.tile(along_bend))], []);
        let (mut rows, mut rows_bar) = (Rows::zeros(), Rows::zeros());
        for i in 0..3 {
            let components = [d[i], u[i], u_bar[i]];
            parameter.set(f, &mut rows, (i, components), (beam, g), &along, -x);
            parameter.set(f, &mut rows_bar, (i, components), (bar, g_bar), &along_bar, -y);
            f.each_vector::<N>(
                #[inline(always)]
                |a| {
                    let r = 3 * a + i;
                    let [s, s_xi, bend] = [beam.shapes.n[r], beam.shapes.n_xi[r], bend[r]];
                    let (row, row_bar) = to.row(a, i);
                    f.set(row, [], [(s, &rows.hat), (s_xi, &rows.xi), (bend, g.xi)]);
                    f.set(row_bar, [], [(s, &rows_bar.hat), (s_xi, &rows_bar.xi), (bend, g_bar.xi)]);
                },
            );
            f.each_vector::<M>(
                #[inline(always)]
                |a| {
                    let r = 3 * a + i;
                    let [s, s_xi, bend] = [bar.shapes.n[r], bar.shapes.n_xi[r], bend_bar[r]];
                    let (row, row_bar) = to.row_bar(a, i);
                    f.set(row, [], [(s, &rows.hat), (s_xi, &rows.xi_bar), (bend, g.xi_bar)]);
                    f.set(row_bar, [], [(s, &rows_bar.hat), (s_xi, &rows_bar.xi_bar), (bend, g_bar.xi_bar)]);
                },
            );
        }
    }
}

/// The terms from the bending of the beams, for both parameters.
pub(super) struct Bending<T> {
    /// t·t,ξ + d·t,ξξ/2 and −t̄·t̄,ξ̄ + d·t̄,ξ̄ξ̄/2.
    own: T,
    own_bar: T,
    /// t̄·t,ξ and t·t̄,ξ̄.
    other: T,
    other_bar: T,
}

impl<T: Real> Bending<T> {
    #[inline(always)]
    pub(super) fn new<A: Arithmetic<T>, const N: usize, const M: usize>(
        f: A,
        frame: &Frame<'_, T, A::Vector, N, M>,
    ) -> Self {
        let Frame { beam, bar, products: Products { d, .. }, .. } = frame;
        let half = <T as From<f64>>::from(0.5);
        let own = f.mul_add(half, f.dot(*d, beam.at.t_xixi), f.dot(beam.at.t, beam.at.t_xi));
        let own_bar = f.mul_add(half, f.dot(*d, bar.at.t_xixi), -f.dot(bar.at.t, bar.at.t_xi));
        Self { own, own_bar, other: f.dot(bar.at.t, beam.at.t_xi), other_bar: f.dot(beam.at.t, bar.at.t_xi) }
    }
}

/// The Hessian of a parameter, x P + y P_bar.
struct Parameter<T, V> {
    x: T,
    y: T,
    /// w and w_bar along u_hat, u,xi and u_bar,xi, and their components.
    w: [V; 3],
    w_bar: [V; 3],
    components: [[T; 3]; 3],
    components_bar: [[T; 3]; 3],
    /// −x d and −y d: w along u,xixi and w_bar along u_bar,xixi.
    ///
    /// The row of a dof of the beam also has this multiple of g, that of a dof of the bar beam this multiple of g_bar.
    bend: V,
    bend_bar: V,
}

/// w, w_bar, v = −p w + q w̄ and v_bar = −q w − q̄ w̄ along the dofs of one beam.
struct Along<T, const L: usize> {
    w: Dofs<T, L>,
    w_bar: Dofs<T, L>,
    v: Dofs<T, L>,
    v_bar: Dofs<T, L>,
}

impl<T: Real, const L: usize> Along<T, L> {
    /// Computes all four from w and w_bar.
    #[inline(always)]
    fn new<A: Arithmetic<T>, const J: usize, const K: usize>(
        f: A,
        [p, q, q_bar]: [T; 3],
        w: [(&Dofs<T, L>, A::Tile); J],
        w_bar: [(&Dofs<T, L>, A::Tile); K],
    ) -> Self {
        let (w, w_bar) = (f.dofs(w, []), f.dofs(w_bar, []));
        let v = f.dofs([], [(-p, &w), (q, &w_bar)]);
        let v_bar = f.dofs([], [(-q, &w), (-q_bar, &w_bar)]);
        Self { w, w_bar, v, v_bar }
    }
}

/// The rows of u_hat, u,xi and u_bar,xi along one axis, in the columns of one beam.
struct Rows<T, const L: usize> {
    hat: Dofs<T, L>,
    xi: Dofs<T, L>,
    xi_bar: Dofs<T, L>,
}

impl<T: Real, const L: usize> Rows<T, L> {
    #[inline(always)]
    fn zeros() -> Self {
        Self { hat: Dofs::zeros(), xi: Dofs::zeros(), xi_bar: Dofs::zeros() }
    }
}

impl<T: Real, V: Copy> Parameter<T, V> {
    #[inline(always)]
    fn new<A: Arithmetic<T, Vector = V>, const N: usize, const M: usize>(
        f: A,
        (frame, bending): (&Frame<'_, T, V, N, M>, &Bending<T>),
        ([x, y], m): ([T; 2], V),
    ) -> Self {
        let Frame { beam, bar, products: Products { d, .. }, .. } = *frame;
        let Solution { inverse: [p, q, q_bar], u, u_bar, .. } = frame.solution;
        let half = <T as From<f64>>::from(0.5);
        let Bending { own, own_bar, other, other_bar } = *bending;
        // The multiples of g and ḡ in w and w̄ are those in α, β, ᾱ and β̄.
        let g = f.mul_add(half, f.dot(m, beam.at.t_xi), -(x * own));
        let bar_g_bar = -f.mul_add(half, f.dot(m, bar.at.t_xi), y * own_bar);
        let (g_bar, bar_g) = (x * other, -(y * other_bar));
        let (in_beam, in_bar) = (f.mul_add(g_bar, q, -(g * p)), -f.mul_add(g_bar, q_bar, g * q));
        let w = [
            f.combined([(-x, beam.at.t_xi), (g, u), (-g_bar, u_bar)]),
            f.times_plus(in_beam, d, f.times_plus(-x, beam.at.t, m)),
            f.combined([(-y, beam.at.t), (in_bar, d)]),
        ];
        let (in_beam, in_bar) =
            (f.mul_add(bar_g_bar, q, -(bar_g * p)), -f.mul_add(bar_g_bar, q_bar, bar_g * q));
        let w_bar = [
            f.combined([(-y, bar.at.t_xi), (bar_g, u), (-bar_g_bar, u_bar)]),
            f.combined([(x, bar.at.t), (in_beam, d)]),
            f.times_plus(in_bar, d, f.times_plus(-T::one(), m, f.times(y, bar.at.t))),
        ];
        let components = [f.components(w[0]), f.components(w[1]), f.components(w[2])];
        let components_bar = [f.components(w_bar[0]), f.components(w_bar[1]), f.components(w_bar[2])];
        let (bend, bend_bar) = (f.times(-x, d), f.times(-y, d));
        Self { x, y, w, w_bar, components, components_bar, bend, bend_bar }
    }

    /// w and w_bar along the dofs of the beam, and of the bar beam.
    #[inline(always)]
    fn along<A: Arithmetic<T, Vector = V>, const N: usize, const M: usize>(
        &self,
        f: A,
        frame: &Frame<'_, T, V, N, M>,
    ) -> (Along<T, N>, Along<T, M>) {
        let (hat, hat_bar) = (f.tile(self.w[0]), f.tile(self.w_bar[0]));
        let (xi, bar_xi) = (f.tile(self.w[1]), f.tile(self.w_bar[1]));
        let (xi_bar, bar_xi_bar) = (f.tile(self.w[2]), f.tile(self.w_bar[2]));
        let (bend, bend_bar) = (f.tile(self.bend), f.tile(self.bend_bar));
        let Spread { n, n_xi, n_xixi } = frame.beam.shapes;
        let w = [(n, hat), (n_xi, xi), (n_xixi, bend)];
        let along = Along::new(f, frame.solution.inverse, w, [(n, hat_bar), (n_xi, bar_xi)]);
        let Spread { n, n_xi, n_xixi } = frame.bar.shapes;
        let w_bar = [(n, hat_bar), (n_xi, bar_xi_bar), (n_xixi, bend_bar)];
        (along, Along::new(f, frame.solution.inverse, [(n, hat), (n_xi, xi_bar)], w_bar))
    }

    /// Sets the rows to those along axis i, for these components of d, u and u_bar. `along_tangent` couples u_hat and
    /// its first derivatives in C and C_bar.
    #[inline(always)]
    fn set<A: Arithmetic<T, Vector = V>, const L: usize>(
        &self,
        f: A,
        rows: &mut Rows<T, L>,
        (i, [d, u, u_bar]): (usize, [T; 3]),
        (side, g): (&Side<'_, T, V, L>, &Gradients<'_, T, L>),
        along: &Along<T, L>,
        along_tangent: T,
    ) {
        let Spread { n: s, n_xi: s_xi, .. } = side.shapes;
        let Gradients { xi: g, xi_bar: g_bar } = *g;
        let (w, w_bar) = (&self.components, &self.components_bar);
        let hat = [(u, &along.w), (-u_bar, &along.w_bar), (w[0][i], g), (w_bar[0][i], g_bar)];
        let xi = [(d, &along.v), (w[1][i], g), (w_bar[1][i], g_bar)];
        let xi_bar = [(d, &along.v_bar), (w[2][i], g), (w_bar[2][i], g_bar)];
        f.set_along(&mut rows.hat, (s_xi, i, along_tangent), hat);
        f.set_along(&mut rows.xi, (s, i, -self.x), xi);
        f.set_along(&mut rows.xi_bar, (s, i, -self.y), xi_bar);
    }
}
