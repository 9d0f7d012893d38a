//! How sums of products are computed: the one place where the vector units of a machine show.

use crate::number::{Lanes, Real};
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
/// The dofs of a beam are the three coordinates of one control vector after the other, so that a shape function "spread"
/// over its dofs, times a vector in space, has the components of that vector in turn.
pub(super) trait Arithmetic<T: Real>: Copy {
    /// A vector in space.
    type Vector: Copy;

    /// A vector in space as it meets the dofs of a beam, over and over.
    type Tile: Copy;

    /// a b + c.
    fn mul_add(self, a: T, b: T, c: T) -> T;

    /// The vector of three components.
    fn vector(self, v: [T; 3]) -> Self::Vector;

    /// The control vector `a` among the dofs of a beam.
    fn control_vector<const L: usize>(self, q: &[T; L], a: usize) -> Self::Vector;

    /// Its components.
    fn components(self, v: Self::Vector) -> [T; 3];

    /// factor v.
    fn times(self, factor: T, v: Self::Vector) -> Self::Vector;

    /// factor v + sum.
    fn times_plus(self, factor: T, v: Self::Vector, sum: Self::Vector) -> Self::Vector;

    /// The scalar product.
    fn dot(self, u: Self::Vector, v: Self::Vector) -> T;

    /// A vector over and over.
    fn tile(self, v: Self::Vector) -> Self::Tile;

    /// The unit vector along an axis, times `factor`, over and over.
    fn tile_along(self, axis: usize, factor: T) -> Self::Tile;

    /// Shape functions, each times `sign`, spread over their dofs.
    fn spread<const L: usize>(self, shapes: &[T], sign: T) -> Dofs<T, L>;

    /// Sets `to`, as far as all of them reach, to the sum of the shape functions times vectors in `spread` and of the
    /// factors times vectors over the dofs in `sum`.
    fn set<const J: usize, const K: usize>(
        self,
        to: &mut [T],
        spread: [(&[T], Self::Tile); J],
        sum: [(T, &[T]); K],
    );

    /// The same for all dofs of a beam.
    #[inline(always)]
    fn dofs<const L: usize, const J: usize, const K: usize>(
        self,
        spread: [(&[T], Self::Tile); J],
        sum: [(T, &[T]); K],
    ) -> Dofs<T, L> {
        let mut dofs = Dofs::zeros();
        self.set(&mut dofs, spread, sum);
        dofs
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

/// How far all parts of a sum reach.
#[inline(always)]
pub(super) fn reach<T, V, const J: usize, const K: usize>(
    to: &[T],
    spread: &[(&[T], V); J],
    sum: &[(T, &[T]); K],
) -> usize {
    let mut reach = to.len();
    for (shapes, _) in spread {
        reach = reach.min(shapes.len());
    }
    for (_, v) in sum {
        reach = reach.min(v.len());
    }
    reach
}

/// One thing for each axis.
#[inline(always)]
pub(super) fn by_axis<W>(component: impl Fn(usize) -> W) -> [W; 3] {
    [component(0), component(1), component(2)]
}

/// a b + c of a scalar.
pub(super) trait MulAdd<T>: Copy {
    /// a b + c.
    fn mul_add(self, a: T, b: T, c: T) -> T;
}

/// A product and a sum, of any scalar.
#[derive(Clone, Copy)]
pub(super) struct Separate;

impl<T: Real> MulAdd<T> for Separate {
    #[inline(always)]
    fn mul_add(self, a: T, b: T, c: T) -> T {
        a * b + c
    }
}

/// A product and a sum with one rounding, of each lane.
#[derive(Clone, Copy)]
pub(super) struct Fused;

impl MulAdd<Lanes> for Fused {
    #[inline(always)]
    fn mul_add(self, a: Lanes, b: Lanes, c: Lanes) -> Lanes {
        a.mul_add(b, c)
    }
}

/// One dof at a time.
#[derive(Clone, Copy)]
pub(super) struct ByOne<F>(pub(super) F);

impl<T: Real, F: MulAdd<T>> Arithmetic<T> for ByOne<F> {
    type Vector = [T; 3];
    type Tile = [T; 3];

    #[inline(always)]
    fn mul_add(self, a: T, b: T, c: T) -> T {
        self.0.mul_add(a, b, c)
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
        let f = self.0;
        [f.mul_add(factor, x, sum[0]), f.mul_add(factor, y, sum[1]), f.mul_add(factor, z, sum[2])]
    }

    #[inline(always)]
    fn dot(self, u: [T; 3], v: [T; 3]) -> T {
        self.0.mul_add(u[2], v[2], self.0.mul_add(u[1], v[1], u[0] * v[0]))
    }

    #[inline(always)]
    fn tile(self, v: [T; 3]) -> [T; 3] {
        v
    }

    #[inline(always)]
    fn tile_along(self, axis: usize, factor: T) -> [T; 3] {
        let mut v = [T::zero(); 3];
        v[axis] = factor;
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

    #[inline(always)]
    fn set<const J: usize, const K: usize>(
        self,
        to: &mut [T],
        spread: [(&[T], [T; 3]); J],
        sum: [(T, &[T]); K],
    ) {
        let reach = reach(to, &spread, &sum);
        let mut axis = 0;
        for i in 0..reach {
            let mut total = T::zero();
            for (j, (shapes, v)) in spread.iter().enumerate() {
                total = if j == 0 { shapes[i] * v[axis] } else { self.0.mul_add(shapes[i], v[axis], total) };
            }
            for (k, (factor, v)) in sum.iter().enumerate() {
                total = if J + k == 0 { *factor * v[i] } else { self.0.mul_add(*factor, v[i], total) };
            }
            to[i] = total;
            axis = if axis == 2 { 0 } else { axis + 1 };
        }
    }
}
