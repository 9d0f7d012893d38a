//! The requested quantities of a pair, and the memory for them.

#![expect(private_interfaces, private_bounds, reason = "types of the kernel seal the trait")]

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

/// The wanted quantities, and where they go: [`DistanceAlone`], [`WithoutSlips`] or [`WithSlips`].
pub trait Request<T: Real, const N: usize, const M: usize> {
    /// Writes them, at the parameters `at`.
    #[doc(hidden)]
    fn write<A: Arithmetic<T>>(
        &mut self,
        f: A,
        frame: &Frame<'_, T, A::Vector, N, M>,
        at: (T, T),
        contact: &Contact,
    );

    /// Writes them from the matrices.
    #[doc(hidden)]
    fn copy(
        &mut self,
        matrices: &Matrices<'_, T, impl DofDerivatives<T, N>, impl DofDerivatives<T, M>, N, M>,
        at: (T, T),
        contact: &Contact,
    );
}

/// d alone.
#[derive(Debug)]
pub struct DistanceAlone<'a, W> {
    /// d.
    pub d: &'a mut W,
}

impl<T: Real, W: Target<T, N, M>, const N: usize, const M: usize> Request<T, N, M> for DistanceAlone<'_, W> {
    #[inline(always)]
    fn write<A: Arithmetic<T>>(
        &mut self,
        f: A,
        frame: &Frame<'_, T, A::Vector, N, M>,
        _: (T, T),
        _: &Contact,
    ) {
        frame.write_d(f, self.d);
    }

    fn copy(
        &mut self,
        matrices: &Matrices<'_, T, impl DofDerivatives<T, N>, impl DofDerivatives<T, M>, N, M>,
        _: (T, T),
        _: &Contact,
    ) {
        copy(&matrices.d(), self.d);
    }
}

/// All scalar quantities of a pair except the slips.
#[derive(Debug)]
pub struct WithoutSlips<'a, W> {
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

impl<T: Real, W: Target<T, N, M>, const N: usize, const M: usize> Request<T, N, M> for WithoutSlips<'_, W> {
    #[inline(always)]
    fn write<A: Arithmetic<T>>(
        &mut self,
        f: A,
        frame: &Frame<'_, T, A::Vector, N, M>,
        at: (T, T),
        _: &Contact,
    ) {
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

impl<W> WithoutSlips<'_, W> {
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

/// All scalar quantities of a pair. g_N has the derivatives of d.
#[derive(Debug)]
pub struct WithSlips<'a, W> {
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
    /// g_T.
    pub g_t: &'a mut W,
    /// g_T_bar.
    pub g_t_bar: &'a mut W,
}

impl<W> WithSlips<'_, W> {
    #[inline(always)]
    fn without_slips(&mut self) -> WithoutSlips<'_, W> {
        let Self { d, xi, xi_bar, t, t_bar, .. } = self;
        WithoutSlips { d, xi, xi_bar, t, t_bar }
    }
}

impl<T: Real, W: Target<T, N, M>, const N: usize, const M: usize> Request<T, N, M> for WithSlips<'_, W> {
    #[inline(always)]
    fn write<A: Arithmetic<T>>(
        &mut self,
        f: A,
        frame: &Frame<'_, T, A::Vector, N, M>,
        at: (T, T),
        contact: &Contact,
    ) {
        self.without_slips().write(f, frame, at, contact);
        let Self { xi, xi_bar, t, t_bar, g_t, g_t_bar, .. } = self;
        let Frame { g, g_bar, .. } = frame;
        let (slip, slip_bar) = (at.0 - T::from(contact.xi_0), at.1 - T::from(contact.xi_bar_0));
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
        self.without_slips().copy_from(&all);
        copy(&all.g_t, self.g_t);
        copy(&all.g_t_bar, self.g_t_bar);
    }
}
