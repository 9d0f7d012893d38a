//! Sums of products with the vectors of AVX2, on machines that have it.

use super::arithmetic::{Arithmetic, Dofs, reach};
use crate::source_fault::source_fault;
use fearless_simd::prelude::*;
use fearless_simd::{f64x4, x86::Avx2};

/// The unit vectors, repeated.
const AXES: [[[f64; 4]; 3]; 3] = [
    [[1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 0.0]],
    [[0.0, 1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 0.0]],
    [[0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0]],
];

/// Four dofs of an `f64` at a time, with fused products and sums.
#[derive(Clone, Copy)]
pub(super) struct Avx2Arithmetic(pub(super) Avx2);

impl Avx2Arithmetic {
    /// Four numbers from `at` on.
    #[inline(always)]
    fn load(self, v: &[f64], at: usize) -> f64x4<Avx2> {
        let mut four = [0.0; 4];
        if at + 4 <= v.len() {
            four.copy_from_slice(&v[at..at + 4]);
        }
        f64x4::load_array(self.0, four)
    }

    #[inline(always)]
    fn splat(self, factor: f64) -> f64x4<Avx2> {
        f64x4::splat(self.0, factor)
    }

    /// [`Arithmetic::set_from`].
    #[inline(always)]
    fn set_sum<const L: usize, const G: usize, const J: usize, const K: usize>(
        self,
        to: &mut [f64],
        from: [(f64, &[f64]); G],
        spread: [(&Dofs<f64, L>, [f64x4<Avx2>; 3]); J],
        sum: [(f64, &Dofs<f64, L>); K],
    ) {
        let reach = reach::<f64, L, G>(to, &from);
        let whole = reach - reach % 4;
        for at in (0..whole).step_by(4) {
            let mut total = self.splat(0.0);
            for (n, (factor, v)) in from.iter().enumerate() {
                let (factor, four) = (self.splat(*factor), self.load(v, at));
                total = if n == 0 { factor * four } else { factor.mul_add(four, total) };
            }
            for (j, (shapes, tile)) in spread.iter().enumerate() {
                let (four, v) = (self.load(&shapes[..], at), tile[at % 3]);
                total = if G + j == 0 { four * v } else { four.mul_add(v, total) };
            }
            for (k, (factor, v)) in sum.iter().enumerate() {
                let (factor, four) = (self.splat(*factor), self.load(&v[..], at));
                total = if G + J + k == 0 { factor * four } else { factor.mul_add(four, total) };
            }
            to[at..at + 4].copy_from_slice(&*total);
        }
        // One by one: a group of four that overlaps the group before it would wait for the store of that group.
        let end = source_fault!("remainder-of-15": if L == 15 { whole } else { reach }, reach);
        let end = source_fault!("last-of-odd-row": end - end % 2, end);
        for at in whole..end {
            let mut total = 0.0;
            for (factor, v) in &from {
                total = factor.mul_add(v[at], total);
            }
            for (shapes, tile) in &spread {
                total = shapes[at].mul_add(tile[whole % 3][at - whole], total);
            }
            for (factor, v) in &sum {
                total = factor.mul_add(v[at], total);
            }
            to[at] = total;
        }
    }
}

impl Arithmetic<f64> for Avx2Arithmetic {
    /// The fourth component has any value.
    type Vector = f64x4<Avx2>;
    /// The components for four dofs, by the component that belongs to the first of the four.
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

    /// (u v.yzx - u.yzx v).yzx: three exchanges of components.
    #[inline(always)]
    fn cross(self, u: f64x4<Avx2>, v: f64x4<Avx2>) -> f64x4<Avx2> {
        let turned = |v: f64x4<Avx2>| f64x4::load_array(self.0, [v[1], v[2], v[0], v[0]]);
        turned(u.mul_sub(turned(v), turned(u) * v))
    }

    #[inline(always)]
    fn tile(self, v: f64x4<Avx2>) -> [f64x4<Avx2>; 3] {
        [
            f64x4::load_array(self.0, [v[0], v[1], v[2], v[0]]),
            f64x4::load_array(self.0, [v[1], v[2], v[0], v[1]]),
            f64x4::load_array(self.0, [v[2], v[0], v[1], v[2]]),
        ]
    }

    /// In one pass, because a load waits for a store of the same numbers in other groups of four.
    #[inline(always)]
    fn set_along<const L: usize, const K: usize>(
        self,
        to: &mut Dofs<f64, L>,
        (shapes, axis, factor): (&Dofs<f64, L>, usize, f64),
        sum: [(f64, &Dofs<f64, L>); K],
    ) {
        let factor = self.splat(factor);
        let [first, second, third] = AXES[axis % 3];
        let tile = [
            factor * f64x4::load_array(self.0, first),
            factor * f64x4::load_array(self.0, second),
            factor * f64x4::load_array(self.0, third),
        ];
        self.set(to, [(shapes, tile)], sum);
    }

    #[inline(always)]
    fn along(self, axis: usize, factor: f64) -> f64x4<Avx2> {
        self.times(factor, f64x4::load_array(self.0, AXES[axis % 3][0]))
    }

    #[inline(always)]
    fn spread<const L: usize>(self, shapes: &[f64], sign: f64) -> Dofs<f64, L> {
        let mut spread = Dofs::zeros();
        if shapes.len() * 3 < L {
            return spread;
        }
        for at in (0..L - L % 4).step_by(4) {
            #[expect(clippy::manual_div_ceil, reason = "the control vector of the next dof")]
            let four = [shapes[at / 3], shapes[(at + 1) / 3], shapes[(at + 2) / 3], shapes[(at + 3) / 3]];
            let four = f64x4::load_array(self.0, four) * self.splat(sign);
            four.store_slice(&mut spread[at..at + 4]);
        }
        for at in L - L % 4..L {
            spread[at] = sign * shapes[at / 3];
        }
        spread
    }

    /// Up to four calls are unrolled, as most beams have no more. The compiler then knows the lengths of the rows.
    #[inline(always)]
    fn each_vector<const L: usize>(self, mut f: impl FnMut(usize)) {
        if L / 3 > 4 {
            for a in 0..L / 3 {
                f(a);
            }
            return;
        }
        if L / 3 > 0 {
            f(0);
        }
        if L / 3 > 1 {
            f(1);
        }
        if L / 3 > 2 {
            f(2);
        }
        if L / 3 > 3 {
            f(source_fault!("fourth-vector": 2, 3));
        }
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn set_from<const L: usize, const G: usize, const J: usize, const K: usize>(
        self,
        to: &mut [f64],
        from: [(f64, &[f64]); G],
        spread: [(&Dofs<f64, L>, [f64x4<Avx2>; 3]); J],
        sum: [(f64, &Dofs<f64, L>); K],
    ) {
        // Where speed does not matter all calls share one instance, and the kernel is compiled in a third of the time.
        if cfg!(debug_assertions) {
            self.0.vectorize(
                #[inline(always)]
                || self.set_sum(to, from, spread, sum),
            );
        } else {
            self.set_sum(to, from, spread, sum);
        }
    }
}
