//! What is asked for of a pair, and where it goes.

use super::arithmetic::Arithmetic;
use super::frame::Frame;
use super::parameters::Bending;
use super::target::{Target, copy};
use crate::curve::DofDerivatives;
use crate::linearization::Linearization;
use crate::linearization::closed_form::Matrices;
use crate::number::Real;
use crate::pair::Contact;

/// Quantities, with the memory for them.
pub(super) trait Request<T: Real, const N: usize, const M: usize> {
    /// Writes them, at the parameters `at`.
    fn write<A: Arithmetic<T>>(&mut self, f: A, frame: &Frame<'_, T, A::Vector, N, M>, at: (T, T));

    /// Writes what the matrices say they are.
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

/// Memory for all scalar quantities of a pair but the slips.
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
        let Linearization { d, xi, xi_bar, t, t_bar, .. } = matrices.all(at, contact);
        copy(&d, self.d);
        copy(&xi, self.xi);
        copy(&xi_bar, self.xi_bar);
        copy(&t, self.t);
        copy(&t_bar, self.t_bar);
    }
}
