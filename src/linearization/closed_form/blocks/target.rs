//! Where results are written: the caller's memory, in one of several layouts.

use crate::linearization::Expansion;
use crate::number::Real;

/// Memory for a quantity with its derivatives in the `N` dofs of the beam and the `M` dofs of the bar beam.
///
/// A Hessian is written row by row, and of each row as much as its layout holds: some of its first columns that belong
/// to the beam, and some of its first columns that belong to the bar beam.
pub trait Target<T, const N: usize, const M: usize> {
    /// Whether there is a Hessian.
    const SECOND: bool;

    /// The value.
    fn value(&mut self) -> &mut T;

    /// The gradient, beam and bar beam.
    fn gradient(&mut self) -> (&mut [T], &mut [T]);

    /// The row of the Hessian that belongs to dof `i` of the beam.
    fn row(&mut self, i: usize) -> (&mut [T], &mut [T]);

    /// The row of the Hessian that belongs to dof `i` of the bar beam.
    fn row_bar(&mut self, i: usize) -> (&mut [T], &mut [T]);
}

impl<T: Real, const N: usize, const M: usize> Target<T, N, M> for Expansion<T, N, M> {
    const SECOND: bool = true;

    #[inline(always)]
    fn value(&mut self) -> &mut T {
        &mut self.value
    }

    #[inline(always)]
    fn gradient(&mut self) -> (&mut [T], &mut [T]) {
        (&mut self.gradient.beam.data.0[0], &mut self.gradient.bar.data.0[0])
    }

    /// The block between the beams is written with the bar beam's rows, as it lies in memory.
    #[inline(always)]
    fn row(&mut self, i: usize) -> (&mut [T], &mut [T]) {
        (&mut self.hessian.beam.data.0[i], &mut [])
    }

    #[inline(always)]
    fn row_bar(&mut self, i: usize) -> (&mut [T], &mut [T]) {
        (&mut self.hessian.mixed.data.0[i], &mut self.hessian.bar.data.0[i])
    }
}

/// The whole Hessian, `S` = N + M rows and columns.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Full<T, const S: usize> {
    /// The Hessian: symmetric to the last bit that the order of sums allows.
    pub hessian: [[T; S]; S],
    /// The gradient, beam before bar beam.
    pub gradient: [T; S],
    /// The value.
    pub value: T,
}

impl<T: Real, const N: usize, const M: usize, const S: usize> Target<T, N, M> for Full<T, S> {
    const SECOND: bool = true;

    #[inline(always)]
    fn value(&mut self) -> &mut T {
        &mut self.value
    }

    #[inline(always)]
    fn gradient(&mut self) -> (&mut [T], &mut [T]) {
        const { assert!(S == N + M, "one row for each dof of both beams") };
        self.gradient.split_at_mut(N)
    }

    #[inline(always)]
    fn row(&mut self, i: usize) -> (&mut [T], &mut [T]) {
        self.hessian[i].split_at_mut(N)
    }

    #[inline(always)]
    fn row_bar(&mut self, i: usize) -> (&mut [T], &mut [T]) {
        self.hessian[N + i].split_at_mut(N)
    }
}

/// The dofs of one beam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Half {
    Beam,
    Bar,
}

impl Half {
    /// What belongs to this beam.
    #[inline(always)]
    pub(super) fn of<V>(self, (beam, bar): (V, V)) -> V {
        match self {
            Self::Beam => beam,
            Self::Bar => bar,
        }
    }
}
