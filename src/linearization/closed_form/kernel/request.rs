//! The requested quantities of a pair, and the memory for them.

use super::arithmetic::Arithmetic;
use super::frame::Frame;
use super::parameters::Bending;
use super::slips::write_slip;
use super::target::{Swapped, Target, copy};
use crate::curve::DofDerivatives;
use crate::linearization::Linearization;
use crate::linearization::closed_form::Matrices;
use crate::number::Real;
use crate::pair::Contact;

/// Quantities, with the memory for them.
pub(super) trait Request<T: Real, const N: usize, const M: usize> {
    /// Writes them, at the parameters `at`.
    fn write<A: Arithmetic<T>>(&mut self, f: A, frame: &Frame<'_, T, A::Vector, N, M>, at: (T, T));

    /// Writes them from the matrices.
    fn copy(
        &mut self,
        matrices: &Matrices<'_, T, impl DofDerivatives<T, N>, impl DofDerivatives<T, M>, N, M>,
        at: (T, T),
        contact: &Contact,
    );
}

/// Memory for d.
pub(super) struct DistanceAlone<'a, W>(pub(super) &'a mut W);

impl<T: Real, W: Target<T, N, M>, const N: usize, const M: usize> Request<T, N, M> for DistanceAlone<'_, W> {
    #[inline(always)]
    fn write<A: Arithmetic<T>>(&mut self, f: A, frame: &Frame<'_, T, A::Vector, N, M>, _: (T, T)) {
        frame.write_d(f, self.0);
    }

    fn copy(
        &mut self,
        matrices: &Matrices<'_, T, impl DofDerivatives<T, N>, impl DofDerivatives<T, M>, N, M>,
        _: (T, T),
        _: &Contact,
    ) {
        copy(&matrices.d(), self.0);
    }
}

/// Memory for all scalar quantities of a pair except the slips.
#[derive(Debug)]
pub struct Targets<'a, W> {
    /// d.
    pub d: &'a mut W,
    /// xi.
    pub xi: &'a mut W,
    /// xi_bar.
    pub xi_bar: &'a mut W,
    /// t.
    pub t: &'a mut W,
    /// t_bar.
    pub t_bar: &'a mut W,
}

impl<T: Real, W: Target<T, N, M>, const N: usize, const M: usize> Request<T, N, M> for Targets<'_, W> {
    #[inline(always)]
    fn write<A: Arithmetic<T>>(&mut self, f: A, frame: &Frame<'_, T, A::Vector, N, M>, at: (T, T)) {
        frame.write_d(f, self.d);
        let bending = Bending::new(f, frame);
        frame.write_xi(f, (at.0, &bending), self.xi, self.t);
        frame.write_xi_bar(f, (at.1, &bending), self.xi_bar, self.t_bar);
    }

    fn copy(
        &mut self,
        matrices: &Matrices<'_, T, impl DofDerivatives<T, N>, impl DofDerivatives<T, M>, N, M>,
        at: (T, T),
        contact: &Contact,
    ) {
        self.copy_from(&matrices.all(at, contact));
    }
}

impl<W> Targets<'_, W> {
    fn copy_from<T: Real, const N: usize, const M: usize>(&mut self, all: &Linearization<T, N, M>)
    where
        W: Target<T, N, M>,
    {
        let Linearization { d, xi, xi_bar, t, t_bar, .. } = all;
        copy(d, self.d);
        copy(xi, self.xi);
        copy(xi_bar, self.xi_bar);
        copy(t, self.t);
        copy(t_bar, self.t_bar);
    }
}

/// Memory for all scalar quantities of a pair, and the reference parameters of the slips.
pub(super) struct WithSlips<'a, 'b, W> {
    pub(super) targets: &'b mut Targets<'a, W>,
    pub(super) slips: [&'b mut W; 2],
    pub(super) origin: (f64, f64),
}

impl<T: Real, W: Target<T, N, M>, const N: usize, const M: usize> Request<T, N, M> for WithSlips<'_, '_, W> {
    #[inline(always)]
    fn write<A: Arithmetic<T>>(&mut self, f: A, frame: &Frame<'_, T, A::Vector, N, M>, at: (T, T)) {
        self.targets.write(f, frame, at);
        let Targets { xi, xi_bar, t, t_bar, .. } = &mut *self.targets;
        let Frame { g, g_bar, .. } = frame;
        let [g_t, g_t_bar] = &mut self.slips;
        let (slip, slip_bar) = (at.0 - T::from(self.origin.0), at.1 - T::from(self.origin.1));
        write_slip(f, slip, (g.xi, g_bar.xi), (*xi, *t), *g_t);
        let (xi_bar, t_bar) = (&mut Swapped(*xi_bar), &mut Swapped(*t_bar));
        write_slip(f, slip_bar, (g_bar.xi_bar, g.xi_bar), (xi_bar, t_bar), &mut Swapped(*g_t_bar));
    }

    fn copy(
        &mut self,
        matrices: &Matrices<'_, T, impl DofDerivatives<T, N>, impl DofDerivatives<T, M>, N, M>,
        at: (T, T),
        contact: &Contact,
    ) {
        let all = matrices.all(at, contact);
        self.targets.copy_from(&all);
        let [g_t, g_t_bar] = &mut self.slips;
        copy(&all.g_t, *g_t);
        copy(&all.g_t_bar, *g_t_bar);
    }
}
