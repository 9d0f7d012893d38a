//! The pairs of beams that are timed: one of each size, always the same, at its closest point.

use beamgap::closest_point::{Beam, ClosestPoint, Search, closest_points};
use beamgap::curve::{Curve, Hermite, Quadratic, Segment};
use beamgap::pair::{Contact, DofVector, Pair};
use nalgebra::SVector;

/// A pair with its dofs, two directions of variation and its closest point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Problem<A, B, const N: usize, const M: usize> {
    pub(crate) pair: Pair<A, B>,
    pub(crate) q: DofVector<f64, N, M>,
    pub(crate) dq: DofVector<f64, N, M>,
    pub(crate) linear_dq: DofVector<f64, N, M>,
    pub(crate) point: ClosestPoint,
}

impl<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize> Problem<A, B, N, M> {
    fn new(curve: A, beam: [f64; N], curve_bar: B, bar: [f64; M]) -> Self {
        let q = DofVector { beam: SVector::from(beam), bar: SVector::from(bar) };
        let (at, at_bar) = (Beam { curve: &curve, q: &q.beam }, Beam { curve: &curve_bar, q: &q.bar });
        let found = closest_points(&at, &at_bar, &Search::default()).expect("the pairs are regular");
        let point = *found.interior().expect("the pairs cross inside both beams");
        let contact = Contact { radius: 0.1, radius_bar: 0.05, xi_0: -0.2, xi_bar_0: 0.3 };
        let [dq, linear_dq] = [1.0, 2.0].map(direction);
        Self { pair: Pair { curve, curve_bar, contact }, q, dq, linear_dq, point }
    }
}

/// A direction in which no dof stands still and no two go alike.
#[expect(clippy::cast_precision_loss, reason = "counts dofs")]
fn direction<const N: usize, const M: usize>(frequency: f64) -> DofVector<f64, N, M> {
    let wave = |i: usize| (frequency * (i + 1) as f64).sin();
    DofVector { beam: SVector::from_fn(|i, _| wave(i)), bar: SVector::from_fn(|i, _| wave(N + i)) }
}

/// Two straight segments, 12 dofs.
pub(crate) fn segments() -> Problem<Segment, Segment, 6, 6> {
    Problem::new(
        Segment::new(),
        [-1.0, -0.1, 0.3, 1.2, 0.2, 0.4],
        Segment::new(),
        [-0.3, -1.1, 0.0, 0.4, 0.9, 0.1],
    )
}

/// Two parabolas through three nodes, 18 dofs.
pub(crate) fn quadratics() -> Problem<Quadratic, Quadratic, 9, 9> {
    Problem::new(
        Quadratic::new(),
        [-1.0, -0.1, 0.5, 0.1, 0.0, 0.3, 1.2, 0.2, 0.6],
        Quadratic::new(),
        [-0.3, -1.1, -0.2, 0.1, -0.1, 0.0, 0.4, 0.9, -0.1],
    )
}

/// Two cubic Hermite curves, 24 dofs.
pub(crate) fn hermites() -> Problem<Hermite, Hermite, 12, 12> {
    Problem::new(
        Hermite::new(),
        [-1.0, -0.1, 0.5, 1.1, 0.2, -0.3, 1.2, 0.2, 0.6, 1.0, -0.1, 0.4],
        Hermite::new(),
        [-0.3, -1.1, -0.2, 0.2, 1.0, 0.3, 0.4, 0.9, -0.1, 0.3, 1.1, -0.2],
    )
}
