//! What the quantities share: a pair at its closest point, and the gradients of its parameters.

use super::arithmetic::Arithmetic;
use super::side::Side;
use crate::closest_point::Active;
use crate::curve::Geometry;
use crate::linearization::closed_form::{Form, Points};
use crate::number::Real;

/// A pair at its closest point.
pub(super) struct Frame<T, V, const N: usize, const M: usize> {
    pub(super) beam: Side<T, V, N>,
    pub(super) bar: Side<T, V, M>,
    /// The vector d, and d·d.
    pub(super) d: V,
    pub(super) d2: T,
    /// p, q and q_bar: the inverse of the projection's matrix is [[p, q], [-q, q_bar]].
    pub(super) inverse: [T; 3],
    /// The coefficients of u_hat in delta xi and in -delta xi_bar.
    pub(super) u: V,
    pub(super) u_bar: V,
    /// Which of two equal formulas are evaluated.
    pub(super) form: Form,
    /// Whether they are those that the choice asks for.
    pub(super) is_fitting: bool,
}

impl<T: Real, V: Copy, const N: usize, const M: usize> Frame<T, V, N, M> {
    #[inline(always)]
    pub(super) fn new<A: Arithmetic<T, Vector = V>>(
        f: A,
        mut beam: Side<T, V, N>,
        mut bar: Side<T, V, M>,
        choice: impl Choice<T>,
    ) -> Self {
        let d = f.times_plus(-T::one(), bar.x, beam.x);
        let squares = [f.dot(beam.t, beam.t), f.dot(bar.t, bar.t), f.dot(beam.t, bar.t), f.dot(d, d)];
        let (form, is_fitting) = choice.form(
            squares,
            #[inline(always)]
            || points(f, &beam, &bar, d),
        );
        // Eq. (50), (52): with R = −δᵤû·t − δᵤu,ξ·d and its twin, δξ = u·δᵤû − p d·δᵤu,ξ − q d·δᵤū,ξ̄
        // and δξ̄ = −ū·δᵤû + q d·δᵤu,ξ − q̄ d·δᵤū,ξ̄
        let ([p, q, q_bar], u, u_bar) = solved(f, (&beam, &bar, d), squares, form);
        let minus_u_bar = f.tile(f.times(-T::one(), u_bar));
        let (by_p, by_q) = (f.tile(f.times(-p, d)), f.tile(f.times(q, d)));
        let (by_minus_q, by_q_bar) = (f.tile(f.times(-q, d)), f.tile(f.times(-q_bar, d)));
        beam.g = f.dofs([(&beam.shapes[0], f.tile(u)), (&beam.shapes[1], by_p)], []);
        bar.g = f.dofs([(&bar.shapes[0], f.tile(u)), (&bar.shapes[1], by_minus_q)], []);
        beam.g_bar = f.dofs([(&beam.shapes[0], minus_u_bar), (&beam.shapes[1], by_q)], []);
        bar.g_bar = f.dofs([(&bar.shapes[0], minus_u_bar), (&bar.shapes[1], by_q_bar)], []);
        Self { beam, bar, d, d2: squares[3], inverse: [p, q, q_bar], u, u_bar, form, is_fitting }
    }
}

/// p, q and q_bar, u and u_bar.
#[inline(always)]
fn solved<T: Real, A: Arithmetic<T>, const N: usize, const M: usize>(
    f: A,
    (beam, bar, d): (&Side<T, A::Vector, N>, &Side<T, A::Vector, M>, A::Vector),
    [t2, t_bar2, b, _]: [T; 4],
    form: Form,
) -> ([T; 3], A::Vector, A::Vector) {
    let (zero, one) = (T::zero(), T::one());
    // Eq. (50), (51): a = t·t + d·t,ξ   b = t·t̄   ā = −t̄·t̄ + d·t̄,ξ̄
    let a = t2 + f.dot(d, beam.t_xi);
    let a_bar = f.dot(d, bar.t_xi) - t_bar2;
    if form.is_crossed() {
        // D u = t̄ × c − (d·t̄,ξ̄) t   −D ū = t × c − (d·t,ξ) t̄   D = −c·c + (d·t,ξ) ā + (d·t̄,ξ̄) t·t   c = t × t̄
        let Points { beam: Geometry { t, .. }, bar: Geometry { t: t_bar, .. }, .. } = points(f, beam, bar, d);
        let (c, bend, bend_bar) = (t.cross(&t_bar), f.dot(d, beam.t_xi), f.dot(d, bar.t_xi));
        let scale = one / (bend * a_bar + bend_bar * t2 - c.dot(&c));
        let u = (t_bar.cross(&c) - t * bend_bar) * scale;
        let u_bar = (t_bar * bend - t.cross(&c)) * scale;
        let inverse = [a_bar * scale, b * scale, a * scale];
        return (inverse, f.vector(u.data.0[0]), f.vector(u_bar.data.0[0]));
    }
    let [p, q, q_bar] = match (form.active.xi, form.active.xi_bar) {
        // Eq. (52): [[p, q], [−q, q̄]] = [[ā, b], [−b, a]]/D, with one division.
        (false, false) => {
            let scale = one / f.mul_add(a, a_bar, b * b);
            [a_bar * scale, b * scale, a * scale]
        }
        (true, false) => [zero, zero, one / a_bar],
        (false, true) => [one / a, zero, zero],
        (true, true) => [zero; 3],
    };
    // u = −(p t + q t̄)   ū = q̄ t̄ − q t
    ([p, q, q_bar], f.combined([(-p, beam.t), (-q, bar.t)]), f.combined([(q_bar, bar.t), (-q, beam.t)]))
}

/// What chooses the form in which a pair is linearized.
pub(super) trait Choice<T> {
    /// From t·t, t̄·t̄, t·t̄ and d·d, and if need be from all.
    fn form(self, squares: [T; 4], points: impl FnOnce() -> Points<T>) -> (Form, bool);
}

/// This one.
pub(super) struct Given(pub(super) Form);

impl<T> Choice<T> for Given {
    #[inline(always)]
    fn form(self, _: [T; 4], _: impl FnOnce() -> Points<T>) -> (Form, bool) {
        (self.0, true)
    }
}

/// The paper's, where it is sure to be the one that loses the fewest digits.
pub(super) struct Plain(pub(super) Active);

impl Choice<f64> for Plain {
    #[inline(always)]
    fn form(self, squares: [f64; 4], _: impl FnOnce() -> Points<f64>) -> (Form, bool) {
        (Form::paper(self.0), Form::is_plain(squares))
    }
}

/// The one that loses the fewest digits.
pub(super) struct Fitting(pub(super) Active);

impl Choice<f64> for Fitting {
    #[inline(always)]
    fn form(self, _: [f64; 4], points: impl FnOnce() -> Points<f64>) -> (Form, bool) {
        (Form::at(&points(), self.0), true)
    }
}

/// Both beams and d, component by component.
#[inline(always)]
pub(super) fn points<T: Real, A: Arithmetic<T>, const N: usize, const M: usize>(
    f: A,
    beam: &Side<T, A::Vector, N>,
    bar: &Side<T, A::Vector, M>,
    d: A::Vector,
) -> Points<T> {
    Points { beam: geometry(f, beam), bar: geometry(f, bar), d: f.components(d).into() }
}

/// The components of a side.
#[inline(always)]
fn geometry<T: Real, A: Arithmetic<T>, const L: usize>(f: A, side: &Side<T, A::Vector, L>) -> Geometry<T> {
    Geometry {
        x: f.components(side.x).into(),
        t: f.components(side.t).into(),
        t_xi: f.components(side.t_xi).into(),
        t_xixi: f.components(side.t_xixi).into(),
    }
}
