//! How sums of products are computed: the one place where the vector units of a machine show.

use crate::number::{Lanes, Real};
use fearless_simd::prelude::*;
use fearless_simd::{f64x4, x86::Avx2};

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
    fn spread<const L: usize>(self, shapes: &[T], sign: T) -> [T; L];

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
    ) -> [T; L] {
        let mut dofs = [T::zero(); L];
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
fn unit<T: Real>(axis: usize) -> [T; 3] {
    let mut unit = [T::zero(); 3];
    unit[axis] = T::one();
    unit
}

/// How far all parts of a sum reach.
#[inline(always)]
fn reach<T, V, const J: usize, const K: usize>(
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
    fn spread<const L: usize>(self, shapes: &[T], sign: T) -> [T; L] {
        let mut spread = [T::zero(); L];
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

/// Four dofs of an `f64` at a time, with fused products and sums.
#[derive(Clone, Copy)]
pub(super) struct ByFour(pub(super) Avx2);

impl ByFour {
    /// Four numbers from `at` on.
    #[inline(always)]
    fn load(self, v: &[f64], at: usize) -> f64x4<Avx2> {
        match v.get(at..at + 4) {
            Some(four) => f64x4::from_slice(self.0, four),
            None => f64x4::splat(self.0, 0.0),
        }
    }

    #[inline(always)]
    fn splat(self, factor: f64) -> f64x4<Avx2> {
        f64x4::splat(self.0, factor)
    }
}

impl Arithmetic<f64> for ByFour {
    /// With a fourth component, whatever it is.
    type Vector = f64x4<Avx2>;
    /// The components as they meet four dofs, by the component that the first of the four meets.
    type Tile = [f64x4<Avx2>; 3];

    #[inline(always)]
    fn mul_add(self, a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }

    #[inline(always)]
    fn vector(self, [x, y, z]: [f64; 3]) -> f64x4<Avx2> {
        f64x4::load_array(self.0, [x, y, z, 0.0])
    }

    #[inline(always)]
    fn control_vector<const L: usize>(self, q: &[f64; L], a: usize) -> f64x4<Avx2> {
        if 3 * a + 4 > L {
            let last = self.load(q, L - 4);
            return f64x4::load_array(self.0, [last[1], last[2], last[3], last[3]]);
        }
        self.load(q, 3 * a)
    }

    #[inline(always)]
    fn components(self, v: f64x4<Avx2>) -> [f64; 3] {
        [v[0], v[1], v[2]]
    }

    #[inline(always)]
    fn times(self, factor: f64, v: f64x4<Avx2>) -> f64x4<Avx2> {
        self.splat(factor) * v
    }

    #[inline(always)]
    fn times_plus(self, factor: f64, v: f64x4<Avx2>, sum: f64x4<Avx2>) -> f64x4<Avx2> {
        self.splat(factor).mul_add(v, sum)
    }

    #[inline(always)]
    fn dot(self, u: f64x4<Avx2>, v: f64x4<Avx2>) -> f64 {
        let product = u * v;
        product[0] + product[1] + product[2]
    }

    #[inline(always)]
    fn tile(self, v: f64x4<Avx2>) -> [f64x4<Avx2>; 3] {
        [
            f64x4::load_array(self.0, [v[0], v[1], v[2], v[0]]),
            f64x4::load_array(self.0, [v[1], v[2], v[0], v[1]]),
            f64x4::load_array(self.0, [v[2], v[0], v[1], v[2]]),
        ]
    }

    #[inline(always)]
    fn tile_along(self, axis: usize, factor: f64) -> [f64x4<Avx2>; 3] {
        let ([x, y, z], factor) = (unit(axis), self.splat(factor));
        [
            factor * f64x4::load_array(self.0, [x, y, z, x]),
            factor * f64x4::load_array(self.0, [y, z, x, y]),
            factor * f64x4::load_array(self.0, [z, x, y, z]),
        ]
    }

    #[inline(always)]
    fn spread<const L: usize>(self, shapes: &[f64], sign: f64) -> [f64; L] {
        let mut spread = [0.0; L];
        if shapes.len() * 3 < L {
            return spread;
        }
        for chunk in 0..L.div_ceil(4) {
            let at = (4 * chunk).min(L - 4);
            #[expect(clippy::manual_div_ceil, reason = "the control vector of the next dof")]
            let four = [shapes[at / 3], shapes[(at + 1) / 3], shapes[(at + 2) / 3], shapes[(at + 3) / 3]];
            let four = f64x4::load_array(self.0, four) * self.splat(sign);
            four.store_slice(&mut spread[at..at + 4]);
        }
        spread
    }

    #[inline(always)]
    fn set<const J: usize, const K: usize>(
        self,
        to: &mut [f64],
        spread: [(&[f64], [f64x4<Avx2>; 3]); J],
        sum: [(f64, &[f64]); K],
    ) {
        let reach = reach(to, &spread, &sum);
        if reach < 4 {
            for i in 0..reach {
                to[i] = 0.0;
                for (shapes, tile) in &spread {
                    to[i] = shapes[i].mul_add(tile[0][i], to[i]);
                }
                for (factor, v) in &sum {
                    to[i] = factor.mul_add(v[i], to[i]);
                }
            }
            return;
        }
        for chunk in 0..reach.div_ceil(4) {
            // The last four overlap those before them if the number is no multiple of four.
            let at = (4 * chunk).min(reach - 4);
            let mut total = self.splat(0.0);
            for (j, (shapes, tile)) in spread.iter().enumerate() {
                let (four, v) = (self.load(shapes, at), tile[at % 3]);
                total = if j == 0 { four * v } else { four.mul_add(v, total) };
            }
            for (k, (factor, v)) in sum.iter().enumerate() {
                let (factor, four) = (self.splat(*factor), self.load(v, at));
                total = if J + k == 0 { factor * four } else { factor.mul_add(four, total) };
            }
            if let Some(to) = to.get_mut(at..at + 4) {
                total.store_slice(to);
            }
        }
    }
}
