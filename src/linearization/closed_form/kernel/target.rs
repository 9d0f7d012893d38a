//! The caller's memory for results, in one of several layouts.

use crate::linearization::Derivatives;
use crate::number::Real;
use crate::source_fault::source_fault;

/// Memory for a quantity with its derivatives in the `N` dofs of the beam and the `M` dofs of the bar beam.
///
/// A Hessian is written row by row. Of each row, the layout stores some first columns that belong to the beam, and some
/// first columns that belong to the bar beam.
pub trait Target<T, const N: usize, const M: usize> {
    /// Whether there is a Hessian.
    const SECOND: bool;

    /// The value.
    fn value(&mut self) -> &mut T;

    /// The gradient, beam and bar beam.
    fn gradient(&mut self) -> (&mut [T], &mut [T]);

    /// The row of the Hessian that belongs to coordinate `i` of the beam's control vector `a`.
    ///
    /// Its lengths depend on `a` alone. The rows x, y and z of a control vector are requested in this order, again and
    /// again. A row may be written beyond its end, into the memory of later rows, which overwrite these numbers.
    fn row(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]);

    /// The row of the Hessian that belongs to coordinate `i` of the bar beam's control vector `a`.
    fn row_bar(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]);
}

/// The blocks of both beams and the block between them.
impl<T: Real, const N: usize, const M: usize> Target<T, N, M> for Derivatives<T, N, M> {
    const SECOND: bool = true;

    #[inline(always)]
    fn value(&mut self) -> &mut T {
        &mut self.value
    }

    #[inline(always)]
    fn gradient(&mut self) -> (&mut [T], &mut [T]) {
        (&mut self.gradient.beam.data.0[0], &mut self.gradient.bar.data.0[0])
    }

    /// The block between the beams is written with the bar beam's rows, in the order of memory.
    #[inline(always)]
    fn row(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        (&mut self.hessian.beam.data.0[3 * a + i], &mut [])
    }

    #[inline(always)]
    fn row_bar(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        (&mut self.hessian.mixed.data.0[3 * a + i], &mut self.hessian.bar.data.0[3 * a + i])
    }
}

/// The whole Hessian, `S` = N + M rows and columns, beam before bar beam.
///
/// It starts on a cache line, so that no vector store crosses a cache line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Full<T, const S: usize> {
    /// The Hessian: symmetric, except for the rounding of sums in another order.
    pub hessian: [[T; S]; S],
    /// The gradient.
    pub gradient: [T; S],
    /// The value.
    pub value: T,
}

impl<T: Real, const S: usize> Full<T, S> {
    /// Zeros, to be overwritten.
    pub fn zeros() -> Self {
        Self { hessian: [[T::zero(); S]; S], gradient: [T::zero(); S], value: T::zero() }
    }
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
    fn row(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        self.hessian[3 * a + i].split_at_mut(N)
    }

    #[inline(always)]
    fn row_bar(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        self.hessian[N + 3 * a + i].split_at_mut(source_fault!("full-of-unequal": M, N))
    }
}

/// The lower triangle of the Hessian, row by row without gaps: `H` = S (S + 1)/2 entries, those of dofs i >= j at
/// i (i + 1)/2 + j. It is the upper triangle column by column, the packed storage of LAPACK's `uplo = 'U'`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Packed<T, const S: usize, const H: usize> {
    /// The lower triangle of the Hessian.
    pub hessian: [T; H],
    /// The gradient, beam before bar beam.
    pub gradient: [T; S],
    /// The value.
    pub value: T,
}

impl<T: Real, const S: usize, const H: usize> Packed<T, S, H> {
    /// Zeros, to be overwritten.
    pub fn zeros() -> Self {
        Self { hessian: [T::zero(); H], gradient: [T::zero(); S], value: T::zero() }
    }

    /// The entry of two dofs, counted through both beams.
    pub fn entry(&self, i: usize, j: usize) -> T {
        let (i, j) = (i.max(j), i.min(j));
        self.hessian[i * (i + 1) / 2 + j]
    }

    /// The row of coordinate `i` of control vector `a`, of the beam that starts after `dofs` dofs. It ends with the
    /// control vector that contains the diagonal.
    #[inline(always)]
    fn row_after(&mut self, dofs: usize, a: usize, i: usize) -> &mut [T] {
        let first = dofs + 3 * a;
        let r = first + i;
        let start = r * (r + 1) / 2;
        self.hessian.get_mut(start..start + (first + 3).min(S)).unwrap_or_default()
    }
}

impl<T: Real, const N: usize, const M: usize, const S: usize, const H: usize> Target<T, N, M>
    for Packed<T, S, H>
{
    const SECOND: bool = true;

    #[inline(always)]
    fn value(&mut self) -> &mut T {
        &mut self.value
    }

    #[inline(always)]
    fn gradient(&mut self) -> (&mut [T], &mut [T]) {
        const { assert!(S == N + M && H == S * (S + 1) / 2, "one row for each dof of both beams") };
        self.gradient.split_at_mut(N)
    }

    #[inline(always)]
    fn row(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        (self.row_after(0, a, i), &mut [])
    }

    #[inline(always)]
    fn row_bar(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        self.row_after(N, a, i).split_at_mut_checked(N).unwrap_or_default()
    }
}

/// The gradient alone, if only first variations are needed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Gradient<T, const S: usize> {
    /// The gradient, beam before bar beam.
    pub gradient: [T; S],
    /// The value.
    pub value: T,
}

impl<T: Real, const S: usize> Gradient<T, S> {
    /// Zeros, to be overwritten.
    pub fn zeros() -> Self {
        Self { gradient: [T::zero(); S], value: T::zero() }
    }
}

impl<T: Real, const N: usize, const M: usize, const S: usize> Target<T, N, M> for Gradient<T, S> {
    const SECOND: bool = false;

    #[inline(always)]
    fn value(&mut self) -> &mut T {
        &mut self.value
    }

    #[inline(always)]
    fn gradient(&mut self) -> (&mut [T], &mut [T]) {
        const { assert!(S == N + M, "one entry for each dof of both beams") };
        self.gradient.split_at_mut(N)
    }

    #[inline(always)]
    fn row(&mut self, _: usize, _: usize) -> (&mut [T], &mut [T]) {
        Default::default()
    }

    #[inline(always)]
    fn row_bar(&mut self, _: usize, _: usize) -> (&mut [T], &mut [T]) {
        Default::default()
    }
}

/// Memory with the beams exchanged.
pub(super) struct Swapped<'a, W>(pub(super) &'a mut W);

impl<T, W: Target<T, N, M>, const N: usize, const M: usize> Target<T, M, N> for Swapped<'_, W> {
    const SECOND: bool = W::SECOND;

    #[inline(always)]
    fn value(&mut self) -> &mut T {
        self.0.value()
    }

    #[inline(always)]
    fn gradient(&mut self) -> (&mut [T], &mut [T]) {
        let (beam, bar) = self.0.gradient();
        (bar, beam)
    }

    #[inline(always)]
    fn row(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        let (beam, bar) = self.0.row_bar(a, i);
        (bar, beam)
    }

    #[inline(always)]
    fn row_bar(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        let (beam, bar) = self.0.row(a, i);
        (bar, beam)
    }
}

/// Copies a quantity into another layout.
pub(super) fn copy<T: Real, const N: usize, const M: usize>(
    from: &Derivatives<T, N, M>,
    to: &mut impl Target<T, N, M>,
) {
    fill(from, to, |to, from| *to = from);
}

/// Copies a quantity into another layout. `set` writes each number.
pub(super) fn fill<T: Real, W: Real, const N: usize, const M: usize>(
    from: &Derivatives<T, N, M>,
    to: &mut impl Target<W, N, M>,
    set: impl Fn(&mut W, T),
) {
    set(to.value(), from.value);
    let copy = |to: &mut [W], from: &dyn Fn(usize) -> T| {
        for (i, to) in to.iter_mut().enumerate() {
            set(to, from(i));
        }
    };
    let (gradient, gradient_bar) = to.gradient();
    copy(gradient, &|i| from.gradient.beam[i]);
    copy(gradient_bar, &|i| from.gradient.bar[i]);
    let row = |i: usize, (row, row_bar): (&mut [W], &mut [W])| {
        copy(row, &|j| from.hessian.entry(i, j));
        copy(row_bar, &|j| from.hessian.entry(i, N + j));
    };
    for i in 0..N {
        row(i, to.row(i / 3, i % 3));
    }
    for i in 0..M {
        row(N + i, to.row_bar(i / 3, i % 3));
    }
}
