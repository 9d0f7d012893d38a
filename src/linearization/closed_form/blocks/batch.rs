//! Many pairs at once: four in the lanes of a vector, through the very source that evaluates one.

use super::arithmetic::{ByOne, Fused, Separate};
use super::target::{Target, fill};
use super::{d, is_done, rarer};
use crate::closest_point::{Active, ClosestPoint};
use crate::curve::Curve;
use crate::number::Lanes;
use crate::pair::{DofVector, Pair};

/// d of many pairs of the same two curves, at closest points, written over `to`; returns of how many.
///
/// Pair i is written to lane i % 4 of `to[i / 4]`. Of pairs, points and lanes there are as many written as the shortest of
/// the three has; lanes that are left of the last four are written too, with what is of no use.
///
/// This is for the distance: its Hessian of 24 dofs in four lanes stays in the cache of a core. Those of all quantities do
/// not, and are faster pair by pair.
pub fn write_d_batch<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &[DofVector<f64, N, M>],
    points: &[ClosestPoint],
    to: &mut [impl Target<Lanes, N, M>],
) -> usize {
    let count = q.len().min(points.len()).min(4 * to.len());
    for ((q, points), to) in q[..count].chunks(4).zip(points[..count].chunks(4)).zip(to) {
        write_four(pair, q, points, to);
    }
    count
}

/// At most four pairs.
#[inline]
fn write_four<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &[DofVector<f64, N, M>],
    points: &[ClosestPoint],
    to: &mut impl Target<Lanes, N, M>,
) {
    let inside = points.iter().all(|point| point.active() == Active::default());
    let done = if inside { in_lanes(pair, q, points, to) } else { None };
    let plain = done.is_some_and(|[t2, t_bar2, b, d2]| {
        (0..q.len()).all(|i| is_done(Some([t2.0[i], t_bar2.0[i], b.0[i], d2.0[i]])))
    });
    if !plain {
        for (lane, (q, point)) in q.iter().zip(points).enumerate() {
            fill(&rarer(pair, q, point).d, to, |to: &mut Lanes, from| to.0[lane] = from);
        }
    }
}

/// Pairs inside both beams, with the squares of [`d`].
#[inline]
fn in_lanes<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &[DofVector<f64, N, M>],
    points: &[ClosestPoint],
    to: &mut impl Target<Lanes, N, M>,
) -> Option<[Lanes; 4]> {
    // Lanes that no pair is left for repeat the first.
    let four = |i: usize| if i < q.len() { i } else { 0 };
    let four = [four(0), four(1), four(2), four(3)];
    let lanes = |of: &dyn Fn(usize) -> f64| Lanes([of(four[0]), of(four[1]), of(four[2]), of(four[3])]);
    let dofs = DofVector {
        beam: nalgebra::SVector::from_fn(|i, _| lanes(&|lane| q[lane].beam[i])),
        bar: nalgebra::SVector::from_fn(|i, _| lanes(&|lane| q[lane].bar[i])),
    };
    let at = (lanes(&|lane| points[lane].xi), lanes(&|lane| points[lane].xi_bar));
    four_at_once(pair, &dofs, at, to)
}

#[inline]
fn four_at_once<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<Lanes, N, M>,
    at: (Lanes, Lanes),
    to: &mut impl Target<Lanes, N, M>,
) -> Option<[Lanes; 4]> {
    with_the_fastest!(f: |_| ByOne(Fused), ByOne(Separate) => d(f, pair, q, at, Active::default(), to))
}
