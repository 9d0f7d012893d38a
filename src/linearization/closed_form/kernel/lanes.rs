//! Sums of products of four pairs side by side, with the vectors of AVX2, on machines that have it.

use super::arithmetic::{Arithmetic, Dofs, reach};
use crate::number::Lanes;
use fearless_simd::prelude::*;
use fearless_simd::{f64x4, x86::Avx2};

/// One dof of four pairs at a time, with fused products and sums.
///
/// The compiler makes vectors of [`Lanes`] by itself too, but not in loops of unknown length.
#[derive(Clone, Copy)]
pub(super) struct LanesArithmetic(pub(super) Avx2);

/// Four numbers, one for each pair.
type Four = f64x4<Avx2>;

impl LanesArithmetic {
    #[inline(always)]
    fn load(self, x: &Lanes) -> Four {
        f64x4::load_array_ref(self.0, &x.0)
    }

    #[inline(always)]
    fn store(x: Four) -> Lanes {
        Lanes(x.into())
    }

    /// Sets the dofs of one control vector.
    #[inline(always)]
    fn set_control_vector<const L: usize, const G: usize, const J: usize, const K: usize>(
        self,
        a: usize,
        to: &mut [Lanes],
        from: &[(Lanes, &[Lanes]); G],
        spread: &[(&Dofs<Lanes, L>, [Four; 3]); J],
        sum: &[(Lanes, &Dofs<Lanes, L>); K],
    ) {
        for axis in 0..3 {
            let i = 3 * a + axis;
            let mut total = f64x4::splat(self.0, 0.0);
            for (n, (factor, v)) in from.iter().enumerate() {
                let (factor, v) = (self.load(factor), self.load(&v[i]));
                total = if n == 0 { factor * v } else { factor.mul_add(v, total) };
            }
            for (j, (shapes, v)) in spread.iter().enumerate() {
                let shape = self.load(&shapes[i]);
                total = if G + j == 0 { shape * v[axis] } else { shape.mul_add(v[axis], total) };
            }
            for (k, (factor, v)) in sum.iter().enumerate() {
                let (factor, v) = (self.load(factor), self.load(&v[i]));
                total = if G + J + k == 0 { factor * v } else { factor.mul_add(v, total) };
            }
            total.store_array(&mut to[i].0);
        }
    }
}

impl Arithmetic<Lanes> for LanesArithmetic {
    type Vector = [Four; 3];
    type Tile = [Four; 3];

    #[inline(always)]
    fn mul_add(self, a: Lanes, b: Lanes, c: Lanes) -> Lanes {
        Self::store(self.load(&a).mul_add(self.load(&b), self.load(&c)))
    }

    #[inline(always)]
    fn vector(self, [x, y, z]: [Lanes; 3]) -> [Four; 3] {
        [self.load(&x), self.load(&y), self.load(&z)]
    }

    #[inline(always)]
    fn control_vector<const L: usize>(self, q: &[Lanes; L], a: usize) -> [Four; 3] {
        self.vector([q[3 * a], q[3 * a + 1], q[3 * a + 2]])
    }

    #[inline(always)]
    fn components(self, [x, y, z]: [Four; 3]) -> [Lanes; 3] {
        [Self::store(x), Self::store(y), Self::store(z)]
    }

    #[inline(always)]
    fn times(self, factor: Lanes, [x, y, z]: [Four; 3]) -> [Four; 3] {
        let factor = self.load(&factor);
        [factor * x, factor * y, factor * z]
    }

    #[inline(always)]
    fn times_plus(self, factor: Lanes, [x, y, z]: [Four; 3], sum: [Four; 3]) -> [Four; 3] {
        let f = self.load(&factor);
        [f.mul_add(x, sum[0]), f.mul_add(y, sum[1]), f.mul_add(z, sum[2])]
    }

    #[inline(always)]
    fn dot(self, u: [Four; 3], v: [Four; 3]) -> Lanes {
        Self::store(u[2].mul_add(v[2], u[1].mul_add(v[1], u[0] * v[0])))
    }

    #[inline(always)]
    fn cross(self, u: [Four; 3], v: [Four; 3]) -> [Four; 3] {
        [u[1].mul_sub(v[2], u[2] * v[1]), u[2].mul_sub(v[0], u[0] * v[2]), u[0].mul_sub(v[1], u[1] * v[0])]
    }

    #[inline(always)]
    fn tile(self, v: [Four; 3]) -> [Four; 3] {
        v
    }

    #[inline(always)]
    fn spread<const L: usize>(self, shapes: &[Lanes], sign: Lanes) -> Dofs<Lanes, L> {
        let mut spread = Dofs::zeros();
        for (to, shape) in spread.chunks_exact_mut(3).zip(shapes) {
            to.fill(Self::store(self.load(&sign) * self.load(shape)));
        }
        spread
    }

    /// The first control vectors are unrolled, because most beams have no more and most rows end among them.
    #[inline(always)]
    fn set_from<const L: usize, const G: usize, const J: usize, const K: usize>(
        self,
        to: &mut [Lanes],
        from: [(Lanes, &[Lanes]); G],
        spread: [(&Dofs<Lanes, L>, [Four; 3]); J],
        sum: [(Lanes, &Dofs<Lanes, L>); K],
    ) {
        let reach = reach::<Lanes, L, G>(to, &from);
        if reach >= 3 {
            self.set_control_vector(0, to, &from, &spread, &sum);
        }
        if reach >= 6 {
            self.set_control_vector(1, to, &from, &spread, &sum);
        }
        if reach >= 9 {
            self.set_control_vector(2, to, &from, &spread, &sum);
        }
        if reach >= 12 {
            self.set_control_vector(3, to, &from, &spread, &sum);
        }
        for a in 4..reach / 3 {
            self.set_control_vector(a, to, &from, &spread, &sum);
        }
    }
}
