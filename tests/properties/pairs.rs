//! Pairs of beams at a closest point: drawn at random, made stationary, with directions of variation.

use crate::strategies::{arc, helix, parameter, vector, weighted_points};
use beamgap::closest_point::{Centroid, ClosestPoint, Held, SquaredDistance};
use beamgap::curve::{Arc, Curve, Helix, Hermite, Jet, NurbsWeighted, Quadratic, Segment};
use beamgap::pair::{Contact, DofVector, Pair};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;

/// A pair at a point that is stationary in the free parameters.
#[derive(Clone, Debug)]
pub(crate) struct Contacting<A, B, const N: usize, const M: usize> {
    pub(crate) pair: Pair<A, B, N, M>,
    pub(crate) q: DofVector<f64, N, M>,
    pub(crate) point: ClosestPoint,
    pub(crate) dq: DofVector<f64, N, M>,
    pub(crate) linear_dq: DofVector<f64, N, M>,
}

/// A curve whose dofs contain points, with the translation of these points.
pub(crate) trait Movable<const N: usize>: Curve<N> + Copy + std::fmt::Debug + 'static {
    /// The indices in the dofs at which the points start.
    const POINTS: &'static [usize];

    fn moved(q: &SVector<f64, N>, by: &Vector3<f64>) -> SVector<f64, N> {
        let mut q = *q;
        for &start in Self::POINTS {
            for c in 0..3 {
                q[start + c] += by[c];
            }
        }
        q
    }
}

impl Movable<6> for Segment {
    const POINTS: &'static [usize] = &[0, 3];
}
impl Movable<9> for Quadratic {
    const POINTS: &'static [usize] = &[0, 3, 6];
}
impl Movable<12> for Hermite {
    const POINTS: &'static [usize] = &[0, 6];
}
impl Movable<12> for NurbsWeighted<3> {
    const POINTS: &'static [usize] = &[0, 4, 8];
}
impl Movable<9> for Arc {
    const POINTS: &'static [usize] = &[0];
}
impl Movable<10> for Helix {
    const POINTS: &'static [usize] = &[0];
}

pub(crate) fn segment() -> impl Strategy<Value = (Segment, SVector<f64, 6>)> {
    vector().prop_map(|q| (Segment::new(), q))
}
pub(crate) fn quadratic() -> impl Strategy<Value = (Quadratic, SVector<f64, 9>)> {
    vector().prop_map(|q| (Quadratic::new(), q))
}
pub(crate) fn hermite() -> impl Strategy<Value = (Hermite, SVector<f64, 12>)> {
    vector().prop_map(|q| (Hermite::new(), q))
}
pub(crate) fn nurbs() -> impl Strategy<Value = (NurbsWeighted<3>, SVector<f64, 12>)> {
    let curve = NurbsWeighted::new(&[0.0, 0.2, 1.0, 1.5]).unwrap();
    weighted_points::<3, 12>().prop_map(move |q| (curve, q))
}
pub(crate) fn any_arc() -> impl Strategy<Value = (Arc, SVector<f64, 9>)> {
    (0.2..2.5, arc()).prop_map(|(half_angle, q)| (Arc::new(half_angle), q))
}
pub(crate) fn any_helix() -> impl Strategy<Value = (Helix, SVector<f64, 10>)> {
    (0.2..2.5, helix()).prop_map(|(half_angle, q)| (Helix::new(half_angle), q))
}

fn geometry<C: Curve<N>, const N: usize>(curve: &C, q: &SVector<f64, N>, xi: f64) -> [Vector3<f64>; 2] {
    let jet: Jet<f64, _> = curve.jet(q, xi);
    [jet.geometry.x, jet.geometry.t]
}

/// Pairs of two families, stationary at interior parameters, or with a parameter held at an end.
///
/// The bar beam is moved so that d is normal to the tangents of all free parameters. The variations do not depend on
/// whether the point is a minimum, a saddle or a maximum.
pub(crate) fn contacting<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    beam: impl Strategy<Value = (A, SVector<f64, N>)>,
    bar: impl Strategy<Value = (B, SVector<f64, M>)>,
) -> impl Strategy<Value = Contacting<A, B, N, M>> {
    let held = prop_oneof![4 => Just((false, false)), 1 => Just((true, false)), 1 => Just((false, true)),
        1 => Just((true, true))];
    let directions = (vector::<N>(), vector::<M>(), vector::<N>(), vector::<M>());
    let contact = (0.0..0.5, 0.0..0.5, parameter(), parameter())
        .prop_map(|(radius, radius_bar, xi_0, xi_bar_0)| Contact { radius, radius_bar, xi_0, xi_bar_0 });
    (beam, bar, (-0.95..0.95, -0.95..0.95), held, vector::<3>(), directions, contact).prop_filter_map(
        "regular and not too ill-conditioned",
        |((curve, q), (curve_bar, q_bar), at, held, offset, directions, contact)| {
            let end = |held: bool, xi: f64| if held { 1.0_f64.copysign(xi) } else { xi };
            let at = (end(held.0, at.0), end(held.1, at.1));
            let [x, t] = geometry(&curve, &q, at.0);
            let [x_bar, t_bar] = geometry(&curve_bar, &q_bar, at.1);
            // The part of the offset that is normal to the tangents of the free parameters.
            let d = match held {
                (false, false) => t.cross(&t_bar).normalize() * offset.x,
                (true, false) => offset - t_bar * (offset.dot(&t_bar) / t_bar.norm_squared()),
                (false, true) => offset - t * (offset.dot(&t) / t.norm_squared()),
                (true, true) => offset,
            };
            let q = DofVector { beam: A::moved(&q, &(d - (x - x_bar))), bar: q_bar };
            let pair = Pair { curve, curve_bar, contact };
            let held = Held { xi: held.0, xi_bar: held.1 };
            let point = refined(&pair, &q, at, held)?;
            let lengths = [t.norm(), t_bar.norm(), point.distance];
            let is_clear = least_eigenvalue(&pair, &q, &point) > 0.1;
            let regular = is_clear && lengths.iter().all(|length| *length > 0.2);
            let (dq, dq_bar, linear_dq, linear_dq_bar) = directions;
            regular.then_some(Contacting {
                pair,
                q,
                point,
                dq: DofVector { beam: dq, bar: dq_bar },
                linear_dq: DofVector { beam: linear_dq, bar: linear_dq_bar },
            })
        },
    )
}

/// The size of the eigenvalue of least size, for unit tangents.
///
/// At a saddle it is not [`ClosestPoint::conditioning`], which is the lowest eigenvalue. At a fold, where a saddle and a
/// minimum meet, it vanishes.
pub(crate) fn least_eigenvalue<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
) -> f64 {
    let low = point.conditioning.abs();
    if !point.is_interior() {
        return low;
    }
    let (x, x_bar) = pair.centroids(q);
    let (x, x_bar) = (x.geometry(point.xi), x_bar.geometry(point.xi_bar));
    let at = SquaredDistance::new(&x, &x_bar);
    // The product of both eigenvalues.
    let det = at.determinant() / x.t.norm_squared() / x_bar.t.norm_squared();
    low.min((det / low).abs())
}

/// The stationary point near `at`.
pub(crate) fn refined<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    at: (f64, f64),
    held: Held,
) -> Option<ClosestPoint> {
    pair.refine(q, at, held).ok()
}

#[test]
fn pairs_are_stationary_and_cover_all_ends() {
    use proptest::{strategy::ValueTree, test_runner::TestRunner};
    let mut runner = TestRunner::deterministic();
    let strategy = contacting(hermite(), any_helix());
    let mut counts = [0; 4];
    for _ in 0..200 {
        let Contacting { pair, q, point, .. } = strategy.new_tree(&mut runner).unwrap().current();
        let held = point.held();
        counts[usize::from(held.xi) + 2 * usize::from(held.xi_bar)] += 1;
        let [x, t] = geometry(&pair.curve, &q.beam, point.xi);
        let [x_bar, t_bar] = geometry(&pair.curve_bar, &q.bar, point.xi_bar);
        let d = x - x_bar;
        assert!(held.xi || d.dot(&t).abs() < 1e-12 * x.norm().max(1.0) * t.norm());
        assert!(held.xi_bar || d.dot(&t_bar).abs() < 1e-12 * x.norm().max(1.0) * t_bar.norm());
    }
    assert!(counts.iter().all(|&count| count > 10), "{counts:?}");
}
