//! d of many pairs at once: four in the lanes of a vector, by the same source code that evaluates one pair.
//!
//! For all quantities, one pair after another is as fast, because the rows of one pair fill the vectors.

use super::choice::{ALL, Regular};
use super::evaluate;
#[cfg(target_arch = "x86_64")]
use super::lanes::LanesArithmetic;
use super::request::DistanceAlone;
use super::side::{Shapes, shapes};
use super::target::{Target, fill};
use crate::closest_point::{ClosestPoint, Held};
use crate::curve::{Curve, DofDerivatives};
use crate::linearization::Derivatives;
use crate::linearization::dispatch::{dispatch_simd, return_with_vectors};
use crate::number::Lanes;
use crate::pair::{Contact, DofVector, Pair};
use crate::source_fault::source_fault;
use nalgebra::SVector;

/// A pair at a closest point: the result of a search for contacts.
#[derive(Debug)]
pub struct PairAtPoint<'a, A, B, const N: usize, const M: usize> {
    /// The curves.
    pub pair: &'a Pair<A, B, N, M>,
    /// Their dofs.
    pub q: &'a DofVector<f64, N, M>,
    /// A closest point of the two.
    pub point: &'a ClosestPoint,
}

/// d of many pairs, written over `to`. Returns the number of pairs.
///
/// Pair i is written to lane i % 4 of `to[i / 4]`, as far as both exist. The unused ones of the last four lanes are
/// written too, with numbers of no use. Pairs of the same curves should be next to one another: four are computed
/// at once, others one by one, as are single lanes whose points need another [formulation](super::super::Formulation).
///
/// Nothing is allocated. The results of some dozens of pairs stay in the cache until they are assembled, those of
/// thousands do not. It is best to reuse memory of that size. For several threads, call it for chunks of the pairs.
pub fn write_d_batch<A, B, W, const N: usize, const M: usize>(
    of: &[PairAtPoint<'_, A, B, N, M>],
    to: &mut [W],
) -> usize
where
    A: Curve<N> + PartialEq,
    B: Curve<M> + PartialEq,
    W: Target<Lanes, N, M>,
{
    each_four(of, to, |of, to| {
        one_by_one(of, in_lanes(of, to), |lane, PairAtPoint { pair, q, point }| {
            let mut one = Derivatives::zero();
            pair.write(q, point, DistanceAlone { d: &mut one });
            fill(&one, to, |to: &mut Lanes, from| to.0[lane] = from);
        });
    })
}

/// Calls `write` with each of these lanes, given as bits, and its pair.
#[inline(always)]
fn one_by_one<E>(of: &[E], lanes: u8, write: impl FnMut(usize, &E)) {
    if lanes != 0 {
        exceptions(of, lanes, write);
    }
}

#[cold]
#[inline(never)]
fn exceptions<E>(of: &[E], lanes: u8, mut write: impl FnMut(usize, &E)) {
    for (lane, e) in of.iter().enumerate() {
        if lanes & (1 << lane) != 0 {
            write(lane, e);
        }
    }
}

/// Calls `write` with every four pairs and the memory for them. Returns how many pairs have memory.
fn each_four<E, W>(of: &[E], to: &mut [W], mut write: impl FnMut(&[E], &mut W)) -> usize {
    // There is one call, so that the kernel in lanes is compiled once.
    let write: &mut dyn FnMut(&[E], &mut W) = &mut write;
    let count = of.len().min(4 * to.len());
    let written = source_fault!("rest-of-batch": count / 4 * 4, count);
    for (of, to) in of[..written].chunks(4).zip(to) {
        write(of, to);
    }
    count
}

/// Writes at most four pairs of the same curves. Returns the lanes, as bits, that remain to be written one by one.
#[inline]
fn in_lanes<A: Curve<N> + PartialEq, B: Curve<M> + PartialEq, const N: usize, const M: usize>(
    of: &[PairAtPoint<'_, A, B, N, M>],
    to: &mut impl Target<Lanes, N, M>,
) -> u8 {
    let Some(first) = of.first() else { return 0 };
    let alike = |e: &PairAtPoint<'_, A, B, N, M>| {
        e.pair.curve == first.pair.curve && e.pair.curve_bar == first.pair.curve_bar
    };
    if !A::Dofs::<f64>::LINEAR || !B::Dofs::<f64>::LINEAR || !of.iter().all(alike) {
        return ALL;
    }
    let held = of
        .iter()
        .enumerate()
        .fold(0, |held, (lane, e)| held | u8::from(e.point.held() != Held::default()) << lane);
    // Lanes without a pair repeat the first pair.
    let lane = |i| of.get(i).unwrap_or(first);
    let four = [first, lane(1), lane(2), lane(3)];
    if held == ALL { ALL } else { fast(four, to) | held }
}

/// Writes in lanes, if the machine has vectors for them. Returns the lanes, as bits, that need another formulation.
#[inline]
fn fast<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    four: [&PairAtPoint<'_, A, B, N, M>; 4],
    to: &mut impl Target<Lanes, N, M>,
) -> u8 {
    #[cfg(target_arch = "x86_64")]
    {
        let [a, b, c, d] = four;
        let q = gather([a.q, b.q, c.q, d.q]);
        let [a, b, c, d] = [a.point, b.point, c.point, d.point];
        let at = (
            Lanes([a.xi, b.xi, c.xi, source_fault!("parameter-of-lane": c.xi, d.xi)]),
            Lanes([a.xi_bar, b.xi_bar, c.xi_bar, d.xi_bar]),
        );
        let pair = four[0].pair;
        let (dofs, dofs_bar) = (pair.curve.jet(&q.beam, at.0).dofs, pair.curve_bar.jet(&q.bar, at.1).dofs);
        if let (Some(of_beam), Some(of_bar)) = (shapes(&dofs), shapes(&dofs_bar)) {
            return fast_by_shapes((of_beam, of_bar), &q, at, to);
        }
    }
    ALL
}

/// The same, compiled for numbers of dofs and not for families.
#[cfg(target_arch = "x86_64")]
#[inline]
fn fast_by_shapes<const N: usize, const M: usize>(
    shapes: (Shapes<'_, Lanes>, Shapes<'_, Lanes>),
    q: &DofVector<Lanes, N, M>,
    at: (Lanes, Lanes),
    to: &mut impl Target<Lanes, N, M>,
) -> u8 {
    // d does not depend on the contact.
    let (contact, mut request) = (Contact::default(), DistanceAlone { d: to });
    return_with_vectors!(f: LanesArithmetic => {
        evaluate(f, shapes, q, at, Regular, &contact, &mut request).unwrap_or(ALL)
    });
    ALL
}

/// The dofs of four pairs, one pair in each lane.
///
/// A separate function, because the compiler would otherwise continue the kernel with single numbers.
#[inline(never)]
fn gather<const N: usize, const M: usize>(
    [a, b, c, d]: [&DofVector<f64, N, M>; 4],
) -> DofVector<Lanes, N, M> {
    dispatch_simd!(DofVector {
        beam: side_by_side([&a.beam, &b.beam, &c.beam, &d.beam]),
        bar: side_by_side([&a.bar, &b.bar, &c.bar, &d.bar]),
    })
}

#[inline(always)]
fn side_by_side<const L: usize>([a, b, c, d]: [&SVector<f64, L>; 4]) -> SVector<Lanes, L> {
    SVector::from(std::array::from_fn::<_, L, _>(
        #[inline(always)]
        |i| Lanes([a[i], b[i], c[i], d[i]]),
    ))
}
