//! The layouts that the kernel writes, in one type.

use super::read::Read;
use crate::linearization::Derivatives;
use crate::linearization::closed_form::kernel::{Full, Packed, Target};
use crate::number::Real;

/// Memory in any layout with a Hessian. One instance of the kernel, a large function, writes them all.
///
/// `S` is `N` + `M`, and `H` is `S` (`S` + 1)/2.
pub(crate) enum Second<T, const N: usize, const M: usize, const S: usize, const H: usize> {
    Blocks(Box<Derivatives<T, N, M>>),
    Full(Box<Full<T, S>>),
    Packed(Box<Packed<T, S, H>>),
}

impl<T: Real, const N: usize, const M: usize, const S: usize, const H: usize> Second<T, N, M, S, H> {
    /// In all layouts.
    pub(crate) const ALL: [fn() -> Self; 3] = [
        || Self::Blocks(Box::new(Derivatives::zero())),
        || Self::Full(Box::new(Full::zeros())),
        || Self::Packed(Box::new(Packed::zeros())),
    ];

    fn memory(&mut self) -> &mut dyn Rows<T, N, M> {
        match self {
            Self::Blocks(of) => &mut **of,
            Self::Full(of) => &mut **of,
            Self::Packed(of) => &mut **of,
        }
    }

    fn read(&self) -> &dyn Read<T> {
        match self {
            Self::Blocks(of) => &**of,
            Self::Full(of) => &**of,
            Self::Packed(of) => &**of,
        }
    }
}

/// A layout, as [`Target`] defines it, as a trait object.
trait Rows<T, const N: usize, const M: usize> {
    fn value(&mut self) -> &mut T;
    fn gradient(&mut self) -> (&mut [T], &mut [T]);
    fn row(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]);
    fn row_bar(&mut self, a: usize, i: usize) -> (&mut [T], &mut [T]);
}

impl<T, W: Target<T, N, M>, const N: usize, const M: usize> Rows<T, N, M> for W {
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

impl<T: Real, const N: usize, const M: usize, const S: usize, const H: usize> Target<T, N, M>
    for Second<T, N, M, S, H>
{
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

impl<T: Real, const N: usize, const M: usize, const S: usize, const H: usize> Read<T>
    for Second<T, N, M, S, H>
{
    fn value(&self) -> T {
        self.read().value()
    }

    fn first(&self, i: usize) -> T {
        self.read().first(i)
    }

    fn second(&self, i: usize, j: usize) -> Option<T> {
        self.read().second(i, j)
    }

    fn row(&self, i: usize, to: &mut [T]) {
        self.read().row(i, to);
    }
}
