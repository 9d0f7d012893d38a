//! The arithmetic of sums of products. Only its implementations depend on the vector units of a machine.

use crate::number::Real;
use std::ops::{Deref, DerefMut};

/// A vector over the dofs of a beam, aligned for vector units.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(super) struct Dofs<T, const L: usize>([T; L]);

impl<T: Real, const L: usize> Dofs<T, L> {
    #[inline(always)]
    pub(super) fn zeros() -> Self {
        Self([T::zero(); L])
    }
}

impl<T, const L: usize> Deref for Dofs<T, L> {
    type Target = [T];

    #[inline(always)]
    fn deref(&self) -> &[T] {
        &self.0
    }
}

impl<T, const L: usize> DerefMut for Dofs<T, L> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.0
    }
}

/// Sums of products over the scalar `T`: of vectors in space, and of vectors over the dofs of a beam.
///
/// The dofs of a beam are the three coordinates of one control vector after the other. A shape function "spread"
/// over its dofs, times a vector in space, therefore has the components of that vector in turn.
pub(super) trait Arithmetic<T: Real>: Copy {
    /// A vector in space.
    type Vector: Copy;

    /// A vector in space, repeated for the dofs of a beam.
    type Tile: Copy;

    /// a b + c.
    fn mul_add(self, a: T, b: T, c: T) -> T;

    /// The vector of three components.
    fn vector(self, v: [T; 3]) -> Self::Vector;

    /// The control vector `a` among the dofs of a beam.
    fn control_vector<const L: usize>(self, q: &[T; L], a: usize) -> Self::Vector;

    /// The components of a vector.
    fn components(self, v: Self::Vector) -> [T; 3];

    /// factor v.
    fn times(self, factor: T, v: Self::Vector) -> Self::Vector;

    /// factor v + sum.
    fn times_plus(self, factor: T, v: Self::Vector, sum: Self::Vector) -> Self::Vector;

    /// The scalar product.
    fn dot(self, u: Self::Vector, v: Self::Vector) -> T;

    /// The vector product.
    fn cross(self, u: Self::Vector, v: Self::Vector) -> Self::Vector;

    /// Repeats a vector.
    fn tile(self, v: Self::Vector) -> Self::Tile;

    /// Shape functions, each times `sign`, spread over their dofs.
    fn spread<const L: usize>(self, shapes: &[T], sign: T) -> Dofs<T, L>;

    /// Sets `to`, up to its length, to the sum of the shape functions times vectors in `spread` and of the factors
    /// times vectors over the dofs in `sum`.
    #[inline(always)]
    fn set<const L: usize, const J: usize, const K: usize>(
        self,
        to: &mut [T],
        spread: [(&Dofs<T, L>, Self::Tile); J],
        sum: [(T, &Dofs<T, L>); K],
    ) {
        self.set_from(to, [], spread, sum);
    }

    /// The same sum, plus the factors times rows in `from`. These rows are as long as `to`.
    fn set_from<const L: usize, const G: usize, const J: usize, const K: usize>(
        self,
        to: &mut [T],
        from: [(T, &[T]); G],
        spread: [(&Dofs<T, L>, Self::Tile); J],
        sum: [(T, &Dofs<T, L>); K],
    );

    /// Sets `to` to the sum of the factors times vectors over the dofs in `sum`, and of the shape functions times the factor
    /// in the dofs along one axis.
    #[inline(always)]
    fn set_along<const L: usize, const K: usize>(
        self,
        to: &mut Dofs<T, L>,
        (shapes, axis, factor): (&Dofs<T, L>, usize, T),
        sum: [(T, &Dofs<T, L>); K],
    ) {
        self.set(to, [], sum);
        let ((to, _), (shapes, _)) = (to.as_chunks_mut::<3>(), shapes.as_chunks::<3>());
        for (to, shapes) in to.iter_mut().zip(shapes) {
            to[axis % 3] = self.mul_add(factor, shapes[axis % 3], to[axis % 3]);
        }
    }

    /// The same sums for all dofs of a beam.
    #[inline(always)]
    fn dofs<const L: usize, const J: usize, const K: usize>(
        self,
        spread: [(&Dofs<T, L>, Self::Tile); J],
        sum: [(T, &Dofs<T, L>); K],
    ) -> Dofs<T, L> {
        let mut dofs = Dofs::zeros();
        self.set(&mut dofs.0, spread, sum);
        dofs
    }

    /// Calls `f` with every control vector of a beam of `L` dofs.
    #[inline(always)]
    fn each_vector<const L: usize>(self, mut f: impl FnMut(usize)) {
        for a in 0..L / 3 {
            f(a);
        }
    }

    /// The sum of factor * vector over all `terms`.
    #[inline(always)]
    fn combined<const K: usize>(self, terms: [(T, Self::Vector); K]) -> Self::Vector {
        let mut sum = self.times(terms[0].0, terms[0].1);
        for &(factor, v) in &terms[1..] {
            sum = self.times_plus(factor, v, sum);
        }
        sum
    }

    /// The unit vector along an axis, times `factor`.
    #[inline(always)]
    fn along(self, axis: usize, factor: T) -> Self::Vector {
        self.times(factor, self.vector(unit(axis)))
    }
}

/// The unit vector along an axis.
#[inline(always)]
pub(super) fn unit<T: Real>(axis: usize) -> [T; 3] {
    let mut unit = [T::zero(); 3];
    unit[axis] = T::one();
    unit
}

/// The number of dofs that all parts of a sum over `L` dofs contain.
#[inline(always)]
pub(super) fn reach<T, const L: usize, const G: usize>(to: &[T], from: &[(T, &[T]); G]) -> usize {
    let mut reach = to.len().min(L);
    for (_, v) in from {
        reach = reach.min(v.len());
    }
    reach
}

/// One value for each axis.
#[inline(always)]
pub(super) fn by_axis<W>(of: impl Fn(usize) -> W) -> (W, W, W) {
    (of(0), of(1), of(2))
}

/// One dof at a time.
#[derive(Clone, Copy)]
pub(super) struct ScalarArithmetic;

impl<T: Real> Arithmetic<T> for ScalarArithmetic {
    type Vector = [T; 3];
    type Tile = [T; 3];

    #[inline(always)]
    fn mul_add(self, a: T, b: T, c: T) -> T {
        a * b + c
    }

    #[inline(always)]
    fn vector(self, v: [T; 3]) -> [T; 3] {
        v
    }

    #[inline(always)]
    fn control_vector<const L: usize>(self, q: &[T; L], a: usize) -> [T; 3] {
        [q[3 * a], q[3 * a + 1], q[3 * a + 2]]
    }

    #[inline(always)]
    fn components(self, v: [T; 3]) -> [T; 3] {
        v
    }

    #[inline(always)]
    fn times(self, factor: T, [x, y, z]: [T; 3]) -> [T; 3] {
        [factor * x, factor * y, factor * z]
    }

    #[inline(always)]
    fn times_plus(self, factor: T, [x, y, z]: [T; 3], sum: [T; 3]) -> [T; 3] {
        [factor * x + sum[0], factor * y + sum[1], factor * z + sum[2]]
    }

    #[inline(always)]
    fn dot(self, u: [T; 3], v: [T; 3]) -> T {
        u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
    }

    #[inline(always)]
    fn cross(self, u: [T; 3], v: [T; 3]) -> [T; 3] {
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    }

    #[inline(always)]
    fn tile(self, v: [T; 3]) -> [T; 3] {
        v
    }

    #[inline(always)]
    fn spread<const L: usize>(self, shapes: &[T], sign: T) -> Dofs<T, L> {
        let mut spread = Dofs::zeros();
        for (to, &shape) in spread.chunks_exact_mut(3).zip(shapes) {
            to.fill(sign * shape);
        }
        spread
    }

    // Not inlined, because it is the largest part of the compiled code.
    #[inline(never)]
    fn set_from<const L: usize, const G: usize, const J: usize, const K: usize>(
        self,
        to: &mut [T],
        from: [(T, &[T]); G],
        spread: [(&Dofs<T, L>, [T; 3]); J],
        sum: [(T, &Dofs<T, L>); K],
    ) {
        let mut axis = 0;
        for i in 0..reach::<T, L, G>(to, &from) {
            let mut total = T::zero();
            for (n, (factor, v)) in from.iter().enumerate() {
                total = if n == 0 { *factor * v[i] } else { *factor * v[i] + total };
            }
            for (j, (shapes, v)) in spread.iter().enumerate() {
                total = if G + j == 0 { shapes[i] * v[axis] } else { shapes[i] * v[axis] + total };
            }
            for (k, (factor, v)) in sum.iter().enumerate() {
                total = if G + J + k == 0 { *factor * v[i] } else { *factor * v[i] + total };
            }
            to[i] = total;
            axis = if axis == 2 { 0 } else { axis + 1 };
        }
    }
}
