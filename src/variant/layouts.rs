//! The layouts that the kernel writes, which can be read and contracted with two directions.

use crate::linearization::Derivatives;
use crate::linearization::closed_form::kernel::{Full, Gradient, Packed, Target};
use crate::number::Real;
use crate::pair::DofVector;
use crate::test_beam::DOFS;

/// The dofs of both beams.
pub(super) const BOTH: usize = 2 * DOFS;
/// The entries of a triangle of the Hessian.
const HALF: usize = BOTH * (BOTH + 1) / 2;

/// Memory of the kernel that can be read.
pub(crate) trait Memory<T: Real>: Target<T, DOFS, DOFS> {
    fn contracted(&self, directions: &[DofVector<T, DOFS, DOFS>; 2]) -> [Option<T>; 4];
}

/// Memory in any layout with a Hessian. One instance of the kernel, a large function, writes them all.
///
/// `S` is 2 `D`, and `H` is `S` (`S` + 1)/2.
pub(crate) enum Second<T, const D: usize = DOFS, const S: usize = BOTH, const H: usize = HALF> {
    Blocks(Box<Derivatives<T, D, D>>),
    Full(Box<Full<T, S>>),
    Packed(Box<Packed<T, S, H>>),
}

impl<T: Real, const D: usize, const S: usize, const H: usize> Second<T, D, S, H> {
    /// In all layouts.
    pub(crate) const ALL: [fn() -> Self; 3] = [
        || Self::Blocks(Box::new(Derivatives::zero())),
        || Self::Full(Box::new(Full::zeros())),
        || Self::Packed(Box::new(Packed::zeros())),
    ];

    fn memory(&mut self) -> &mut dyn Rows<T, D> {
        match self {
            Self::Blocks(of) => &mut **of,
            Self::Full(of) => &mut **of,
            Self::Packed(of) => &mut **of,
        }
    }
}

/// A layout, as [`Target`] defines it, without its size.
trait Rows<T, const D: usize> {
    fn value(&mut self) -> &mut T;
    fn gradient(&mut self) -> (&mut [T], &mut [T]);
    fn row(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]);
    fn row_bar(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]);
}

impl<T, W: Target<T, D, D>, const D: usize> Rows<T, D> for W {
    fn value(&mut self) -> &mut T {
        Target::value(self)
    }

    fn gradient(&mut self) -> (&mut [T], &mut [T]) {
        Target::gradient(self)
    }

    fn row(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        Target::row(self, a, i)
    }

    fn row_bar(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        Target::row_bar(self, a, i)
    }
}

impl<T: Real, const D: usize, const S: usize, const H: usize> Target<T, D, D> for Second<T, D, S, H> {
    const SECOND: bool = true;

    #[inline(never)]
    fn value(&mut self) -> &mut T {
        self.memory().value()
    }

    #[inline(never)]
    fn gradient(&mut self) -> (&mut [T], &mut [T]) {
        self.memory().gradient()
    }

    #[inline(never)]
    fn row(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        self.memory().row(a, i)
    }

    #[inline(never)]
    fn row_bar(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]) {
        self.memory().row_bar(a, i)
    }
}

impl<T: Real> Memory<T> for Second<T> {
    fn contracted(&self, directions: &[DofVector<T, DOFS, DOFS>; 2]) -> [Option<T>; 4] {
        match self {
            Self::Blocks(of) => {
                let hessian = |i, j| of.hessian.entry(i, j);
                along(of.value, &|i| of.gradient.entry(i), Some(&hessian), directions)
            }
            Self::Full(of) => {
                let hessian = |i: usize, j: usize| of.hessian[i][j];
                along(of.value, &|i| of.gradient[i], Some(&hessian), directions)
            }
            Self::Packed(of) => {
                let hessian = |i, j| of.entry(i, j);
                along(of.value, &|i| of.gradient[i], Some(&hessian), directions)
            }
        }
    }
}

impl<T: Real> Memory<T> for Gradient<T, BOTH> {
    fn contracted(&self, directions: &[DofVector<T, DOFS, DOFS>; 2]) -> [Option<T>; 4] {
        along(self.value, &|i| self.gradient[i], None, directions)
    }
}

/// Along the directions. Every layout uses the same sums, so that one bound on their rounding applies to all.
fn along<T: Real>(
    value: T,
    gradient: &dyn Fn(usize) -> T,
    hessian: Option<&dyn Fn(usize, usize) -> T>,
    [dq, linear_dq]: &[DofVector<T, DOFS, DOFS>; 2],
) -> [Option<T>; 4] {
    let sum = |of: &dyn Fn(usize) -> T| (0..BOTH).fold(T::zero(), |sum, i| sum + of(i));
    let second = |hessian: &dyn Fn(usize, usize) -> T| {
        sum(&|i| dq.entry(i) * sum(&|j| hessian(i, j) * linear_dq.entry(j)))
    };
    [
        Some(value),
        Some(sum(&|i| gradient(i) * dq.entry(i))),
        Some(sum(&|i| gradient(i) * linear_dq.entry(i))),
        hessian.map(second),
    ]
}
