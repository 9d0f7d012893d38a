//! Memory of a linearization, read in any layout and contracted with two directions.

use super::SCALARS;
use crate::linearization::Derivatives;
use crate::linearization::closed_form::kernel::{Full, Gradient, Packed};
use crate::number::Real;

/// Value, gradient along both directions, and Hessian along both, of each scalar; nothing for missing ones.
pub(crate) type Contracted<T> = [[Option<T>; 4]; SCALARS];

/// Derivatives of a scalar in any layout and any number of dofs.
pub(crate) trait Read<T> {
    fn value(&self) -> T;
    fn first(&self, i: usize) -> T;
    /// Nothing if the layout has no Hessian.
    fn second(&self, i: usize, j: usize) -> Option<T>;

    /// Writes row `i` of the Hessian, if there is one. One call a row, because calls of a `dyn` object take time.
    fn row(&self, i: usize, to: &mut [T]) {
        for (j, to) in to.iter_mut().enumerate() {
            if let Some(entry) = self.second(i, j) {
                *to = entry;
            }
        }
    }
}

impl<T: Real, const N: usize, const M: usize> Read<T> for Derivatives<T, N, M> {
    fn value(&self) -> T {
        self.value
    }

    fn first(&self, i: usize) -> T {
        self.gradient.entry(i)
    }

    fn second(&self, i: usize, j: usize) -> Option<T> {
        Some(self.hessian.entry(i, j))
    }
}

impl<T: Real, const S: usize> Read<T> for Full<T, S> {
    fn value(&self) -> T {
        self.value
    }

    fn first(&self, i: usize) -> T {
        self.gradient[i]
    }

    fn second(&self, i: usize, j: usize) -> Option<T> {
        Some(self.hessian[i][j])
    }
}

impl<T: Real, const S: usize, const H: usize> Read<T> for Packed<T, S, H> {
    fn value(&self) -> T {
        self.value
    }

    fn first(&self, i: usize) -> T {
        self.gradient[i]
    }

    fn second(&self, i: usize, j: usize) -> Option<T> {
        Some(self.entry(i, j))
    }
}

impl<T: Real, const S: usize> Read<T> for Gradient<T, S> {
    fn value(&self) -> T {
        self.value
    }

    fn first(&self, i: usize) -> T {
        self.gradient[i]
    }

    fn second(&self, _: usize, _: usize) -> Option<T> {
        None
    }
}

/// Two directions over the dofs of both beams.
pub(crate) type Directions<T> = [Vec<T>; 2];

/// Along the directions. Every layout uses the same sums, so that one bound on their rounding applies to all.
pub(crate) fn along<T: Real>(of: &dyn Read<T>, [dq, linear_dq]: &Directions<T>) -> [Option<T>; 4] {
    let first = |dq: &[T]| dq.iter().enumerate().fold(T::zero(), |sum, (i, &dq)| sum + of.first(i) * dq);
    let mut entries = vec![T::zero(); linear_dq.len()];
    let mut row = |i: usize| {
        of.row(i, &mut entries);
        entries.iter().zip(linear_dq).fold(T::zero(), |sum, (&entry, &linear)| sum + entry * linear)
    };
    let second = || dq.iter().enumerate().fold(T::zero(), |sum, (i, &dq)| sum + dq * row(i));
    let has_hessian = of.second(0, 0).is_some();
    [Some(of.value()), Some(first(dq)), Some(first(linear_dq)), has_hessian.then(second)]
}
