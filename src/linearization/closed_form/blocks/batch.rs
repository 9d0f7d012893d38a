//! Many pairs at once: four in the lanes of a vector, through the very source that evaluates one.

use super::arithmetic::{ByOne, Fused, Separate};
use super::choice::{Best, Choice, Plain};
use super::request::{DistanceAlone, Request, Targets};
use super::target::{Target, fill};
use super::{evaluate, write_all, write_d};
use crate::closest_point::{Active, ClosestPoint};
use crate::curve::Curve;
use crate::linearization::Expansion;
use crate::number::Lanes;
use crate::pair::{DofVector, Pair};
use nalgebra::SVector;
use std::num::NonZeroUsize;

/// A pair at a closest point: what a search for contacts hands on.
#[derive(Debug)]
pub struct Encounter<'a, A, B, const N: usize, const M: usize> {
    /// The curves.
    pub pair: &'a Pair<A, B>,
    /// Their dofs.
    pub q: &'a DofVector<f64, N, M>,
    /// A closest point of the two.
    pub point: &'a ClosestPoint,
}

/// d of many pairs, written over `to`; returns of how many.
///
/// Pair i is written to lane i % 4 of `to[i / 4]`, as far as there are both. What is left of the last four lanes is
/// written too, with what is of no use. Pairs of the same curves are to stand next to one another: four of them are done
/// at once, others one by one, as are those whose points ask for different [forms](super::super::Form).
///
/// The pairs are shared among so many threads; one allocates nothing.
pub fn write_d_batch<A, B, W, const N: usize, const M: usize>(
    of: &[Encounter<'_, A, B, N, M>],
    to: &mut [W],
    threads: NonZeroUsize,
) -> usize
where
    A: Curve<N> + PartialEq + Sync,
    B: Curve<M> + PartialEq + Sync,
    W: Target<Lanes, N, M> + Send,
{
    share(of, to, threads, |of, to| {
        if in_lanes(of, &mut DistanceAlone(to)).is_none() {
            let mut one = Expansion::zero();
            for (lane, Encounter { pair, q, point }) in of.iter().enumerate() {
                write_d(pair, q, point, &mut one);
                fill(&one, to, |to: &mut Lanes, from| to.0[lane] = from);
            }
        }
    })
}

/// d, xi, xi_bar, t and t_bar of many pairs, written over `to`, and otherwise [`write_d_batch`].
pub fn write_all_batch<A, B, W, const N: usize, const M: usize>(
    of: &[Encounter<'_, A, B, N, M>],
    to: &mut [[W; 5]],
    threads: NonZeroUsize,
) -> usize
where
    A: Curve<N> + PartialEq + Sync,
    B: Curve<M> + PartialEq + Sync,
    W: Target<Lanes, N, M> + Send,
{
    share(of, to, threads, |of, to| {
        if in_lanes(of, &mut targets(to)).is_none() {
            let mut one = [Expansion::zero(); 5];
            for (lane, Encounter { pair, q, point }) in of.iter().enumerate() {
                write_all(pair, q, point, &mut targets(&mut one));
                for (one, to) in one.iter().zip(&mut *to) {
                    fill(one, to, |to: &mut Lanes, from| to.0[lane] = from);
                }
            }
        }
    })
}

fn targets<W>([d, xi, xi_bar, t, t_bar]: &mut [W; 5]) -> Targets<'_, W> {
    Targets { d, xi, xi_bar, t, t_bar }
}

/// Calls `write` with every four pairs and the memory for them.
fn share<E: Sync, W: Send>(
    of: &[E],
    to: &mut [W],
    threads: NonZeroUsize,
    write: impl Fn(&[E], &mut W) + Sync,
) -> usize {
    let count = of.len().min(4 * to.len());
    let write_some = |of: &[E], to: &mut [W]| {
        for (of, to) in of.chunks(4).zip(to) {
            write(of, to);
        }
    };
    let each = count.div_ceil(4).div_ceil(threads.get()).max(1);
    let (own, others) = of[..count].split_at(count.min(4 * each));
    let (to_own, to_others) = to.split_at_mut(each.min(to.len()));
    if others.is_empty() {
        write_some(own, to_own);
        return count;
    }
    std::thread::scope(|scope| {
        for (of, to) in others.chunks(4 * each).zip(to_others.chunks_mut(each)) {
            scope.spawn(|| write_some(of, to));
        }
        write_some(own, to_own);
    });
    count
}

/// At most four pairs of the same curves, inside both beams, at points that ask for the same form.
#[inline]
fn in_lanes<A: Curve<N> + PartialEq, B: Curve<M> + PartialEq, const N: usize, const M: usize>(
    of: &[Encounter<'_, A, B, N, M>],
    request: &mut impl Request<Lanes, N, M>,
) -> Option<()> {
    let first = of.first()?;
    let alike = |e: &Encounter<'_, A, B, N, M>| {
        e.pair.curve == first.pair.curve
            && e.pair.curve_bar == first.pair.curve_bar
            && e.point.active() == Active::default()
    };
    if !of.iter().all(alike) {
        return None;
    }
    // Lanes that no pair is left for repeat the first.
    let [a, b, c, d] = [0, 1, 2, 3].map(|lane| of.get(lane).unwrap_or(first));
    let q = DofVector {
        beam: SVector::from_fn(|i, _| Lanes([a.q.beam[i], b.q.beam[i], c.q.beam[i], d.q.beam[i]])),
        bar: SVector::from_fn(|i, _| Lanes([a.q.bar[i], b.q.bar[i], c.q.bar[i], d.q.bar[i]])),
    };
    let xi = Lanes([a.point.xi, b.point.xi, c.point.xi, d.point.xi]);
    let xi_bar = Lanes([a.point.xi_bar, b.point.xi_bar, c.point.xi_bar, d.point.xi_bar]);
    fast(first.pair, &q, (xi, xi_bar), Plain, request)
        .or_else(|| rarer(first.pair, &q, (xi, xi_bar), request))
}

/// At ends, at small angles and gaps.
#[cold]
#[inline(never)]
fn rarer<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<Lanes, N, M>,
    at: (Lanes, Lanes),
    request: &mut impl Request<Lanes, N, M>,
) -> Option<()> {
    fast(pair, q, at, Best(Active::default()), request)
}

#[inline]
fn fast<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<Lanes, N, M>,
    at: (Lanes, Lanes),
    choice: impl Choice<Lanes>,
    request: &mut impl Request<Lanes, N, M>,
) -> Option<()> {
    with_the_fastest!(f: |_| ByOne(Fused), ByOne(Separate) => evaluate(f, pair, q, at, choice, request))
}
