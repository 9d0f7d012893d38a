//! A parameter and the length of its tangent, written row by row.

use super::arithmetic::Arithmetic;
use super::frame::Frame;
use super::lengths::Length;
use super::parameters::Parameter;
use super::target::Target;
use crate::number::Real;

impl<T: Real, V: Copy, const N: usize, const M: usize> Frame<T, V, N, M> {
    /// xi, which is `at`, and t.
    #[inline(always)]
    pub(super) fn write_xi<A: Arithmetic<T, Vector = V>, W: Target<T, N, M>>(
        &self,
        f: A,
        at: T,
        xi: &mut W,
        t: &mut W,
    ) {
        let Self { beam, bar, inverse: [p, q, _], u, .. } = self;
        let length = Length::new(f, beam, (&beam.g, &bar.g), t.gradient());
        let Length { kappa, b, m, m_other, across, .. } = &length;
        (*xi.value(), *t.value()) = (at, length.value);
        let (gradient, gradient_bar) = xi.gradient();
        copy(gradient, &beam.g);
        copy(gradient_bar, &bar.g);
        if !W::SECOND {
            return;
        }
        let Parameter { beam: rows, bar: rows_bar, bend, bend_bar } = Parameter::new(f, self, ([*p, *q], *u));
        for a in 0..N / 3 {
            for (i, across) in across.iter().enumerate() {
                let r = 3 * a + i;
                let [s, s_xi, bend] = [beam.shapes[0][r], beam.shapes[1][r], bend[r]];
                let (row, row_bar) = xi.row(r);
                f.set(row, [], [(s, &rows.hat[i]), (s_xi, &rows.xi[i]), (bend, &beam.g)]);
                f.set(row_bar, [], [(s, &rows_bar.hat[i]), (s_xi, &rows_bar.xi[i]), (bend, &bar.g)]);
                let (to, to_bar) = t.row(r);
                f.set(to, [], [(*kappa, row), (beam.g[r], m), (b[r], &beam.g), (s_xi, across)]);
                f.set(to_bar, [], [(*kappa, row_bar), (m[r], &bar.g)]);
            }
        }
        for a in 0..M / 3 {
            for i in 0..3 {
                let r = 3 * a + i;
                let [s, s_xi, bend] = [bar.shapes[0][r], bar.shapes[1][r], bend_bar[r]];
                let (row, row_bar) = xi.row_bar(r);
                f.set(row, [], [(s, &rows.hat[i]), (s_xi, &rows.xi_bar[i]), (bend, &beam.g_bar)]);
                f.set(row_bar, [], [(s, &rows_bar.hat[i]), (s_xi, &rows_bar.xi_bar[i]), (bend, &bar.g_bar)]);
                let (to, to_bar) = t.row_bar(r);
                f.set(to, [], [(*kappa, row), (bar.g[r], m)]);
                f.set(to_bar, [], [(*kappa, row_bar), (bar.g[r], m_other)]);
            }
        }
    }

    /// xi_bar, which is `at`, and t_bar.
    #[inline(always)]
    pub(super) fn write_xi_bar<A: Arithmetic<T, Vector = V>, W: Target<T, N, M>>(
        &self,
        f: A,
        at: T,
        xi_bar: &mut W,
        t_bar: &mut W,
    ) {
        let Self { beam, bar, inverse: [_, q, q_bar], u_bar, .. } = self;
        let (gradient, gradient_bar) = t_bar.gradient();
        let length = Length::new(f, bar, (&bar.g_bar, &beam.g_bar), (gradient_bar, gradient));
        let Length { kappa, b, m, m_other, across, .. } = &length;
        (*xi_bar.value(), *t_bar.value()) = (at, length.value);
        let (gradient, gradient_bar) = xi_bar.gradient();
        copy(gradient, &beam.g_bar);
        copy(gradient_bar, &bar.g_bar);
        if !W::SECOND {
            return;
        }
        let minus_u_bar = f.times(-T::one(), *u_bar);
        let Parameter { beam: rows, bar: rows_bar, bend, bend_bar } =
            Parameter::new(f, self, ([-*q, *q_bar], minus_u_bar));
        for a in 0..N / 3 {
            for i in 0..3 {
                let r = 3 * a + i;
                let [s, s_xi, bend] = [beam.shapes[0][r], beam.shapes[1][r], bend[r]];
                let (row, row_bar) = xi_bar.row(r);
                f.set(row, [], [(s, &rows.hat[i]), (s_xi, &rows.xi[i]), (bend, &beam.g)]);
                f.set(row_bar, [], [(s, &rows_bar.hat[i]), (s_xi, &rows_bar.xi[i]), (bend, &bar.g)]);
                let (to, to_bar) = t_bar.row(r);
                f.set(to, [], [(*kappa, row), (beam.g_bar[r], m_other)]);
                f.set(to_bar, [], [(*kappa, row_bar), (beam.g_bar[r], m)]);
            }
        }
        for a in 0..M / 3 {
            for (i, across) in across.iter().enumerate() {
                let r = 3 * a + i;
                let [s, s_xi, bend] = [bar.shapes[0][r], bar.shapes[1][r], bend_bar[r]];
                let (row, row_bar) = xi_bar.row_bar(r);
                f.set(row, [], [(s, &rows.hat[i]), (s_xi, &rows.xi_bar[i]), (bend, &beam.g_bar)]);
                f.set(row_bar, [], [(s, &rows_bar.hat[i]), (s_xi, &rows_bar.xi_bar[i]), (bend, &bar.g_bar)]);
                let (to, to_bar) = t_bar.row_bar(r);
                f.set(to, [], [(*kappa, row), (m[r], &beam.g_bar)]);
                f.set(to_bar, [], [(*kappa, row_bar), (bar.g_bar[r], m), (b[r], &bar.g_bar), (s_xi, across)]);
            }
        }
    }
}

/// Copies a vector to where there is room for it.
#[inline(always)]
fn copy<T: Copy>(to: &mut [T], from: &[T]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *from;
    }
}
