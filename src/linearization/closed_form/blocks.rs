//! The matrices once more, for speed.

mod arithmetic;
mod distance;
mod frame;
mod lengths;
mod parameters;
mod second_order;
mod side;
mod target;

pub use target::{Full, Target};

use crate::closest_point::ClosestPoint;
use crate::curve::Curve;
use crate::pair::{DofVector, Pair};
use arithmetic::{Arithmetic, ByFour, ByOne, Separate};
use fearless_simd::{Level, Simd};
use frame::Frame;
use side::Side;

/// The quantities of a pair that are not slips.
#[derive(Debug)]
pub struct Targets<'a, W> {
    /// d.
    pub d: &'a mut W,
    /// xi.
    pub xi: &'a mut W,
    /// xi_bar.
    pub xi_bar: &'a mut W,
    /// t.
    pub t: &'a mut W,
    /// t_bar.
    pub t_bar: &'a mut W,
}

/// all.
pub fn write_all<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut Targets<impl Target<f64, N, M>>,
) {
    if let Some(avx2) = Level::new().as_avx2() {
        avx2.vectorize(
            #[inline(always)]
            || all(ByFour(avx2), pair, q, point, to),
        );
    } else {
        all(ByOne(Separate), pair, q, point, to);
    }
}
#[inline(always)]
fn all<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    f: impl Arithmetic<f64>,
    pair: &Pair<A, B>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut Targets<impl Target<f64, N, M>>,
) {
    let jet = pair.curve.jet(&q.beam, point.xi);
    let jet_bar = pair.curve_bar.jet(&q.bar, point.xi_bar);
    let (Some(beam), Some(bar)) = (Side::new(f, &jet.dofs, &q.beam, 1.0), Side::new(f, &jet_bar.dofs, &q.bar, -1.0)) else { return };
    let frame = Frame::new(f, beam, bar, point.active());
    frame.write_d(f, to.d);
    frame.write_xi(f, point.xi, to.xi, to.t);
    frame.write_xi_bar(f, point.xi_bar, to.xi_bar, to.t_bar);
}

/// d.
pub fn write_d<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut impl Target<f64, N, M>,
) {
    if let Some(avx2) = Level::new().as_avx2() {
        avx2.vectorize(
            #[inline(always)]
            || d(ByFour(avx2), pair, q, point, to),
        );
    } else {
        d(ByOne(Separate), pair, q, point, to);
    }
}

#[inline(always)]
fn d<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    f: impl Arithmetic<f64>,
    pair: &Pair<A, B>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut impl Target<f64, N, M>,
) {
    let jet = pair.curve.jet(&q.beam, point.xi);
    let jet_bar = pair.curve_bar.jet(&q.bar, point.xi_bar);
    let (Some(beam), Some(bar)) = (Side::new(f, &jet.dofs, &q.beam, 1.0), Side::new(f, &jet_bar.dofs, &q.bar, -1.0)) else { return };
    Frame::new(f, beam, bar, point.active()).write_d(f, to);
}
