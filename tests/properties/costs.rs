//! The cost of the search. A looser bound, a box that could be discarded but is not, or a rejected step changes
//! no result, but it changes the cost.

use crate::centroids::Cubic;
use beamgap::closest_point::{Centroid, ClosestPoint, Held, Search, closest_points, refine};
use beamgap::curve::Geometry;
use nalgebra::Vector3;
use std::cell::Cell;

/// Cubics whose coefficients are multiples of 1/8 in [-1, 1), the same in every run.
fn cubics() -> impl Iterator<Item = Cubic> {
    let mut state = 1_u32;
    let mut eighths = move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 28) / 8.0 - 1.0
    };
    std::iter::repeat_with(move || Cubic([(); 4].map(|()| Vector3::from_fn(|_, _| eighths()))))
}

/// The sums of boxes, intervals and evaluations of the search, and of all evaluations, over pairs of cubics.
fn costs(options: &Search, change: impl Fn(Cubic) -> Cubic) -> [usize; 4] {
    let mut curves = cubics().map(change);
    let mut costs = [0; 4];
    for _ in 0..24 {
        let [x, bar] = [(); 2].map(|()| curves.next().unwrap());
        let [x, bar] = [&x, &bar].map(|curve| OperationCount::new(curve, true));
        let found = closest_points(&x, &bar, options).unwrap();
        assert!(found.stationary.iter().all(ClosestPoint::is_interior), "{:?}", found.stationary);
        let (cost, all) = (found.statistics, x.evaluations.get() + bar.evaluations.get());
        for (sum, cost) in costs.iter_mut().zip([cost.boxes, cost.intervals, cost.evaluations, all]) {
            *sum += cost;
        }
    }
    costs
}

#[test]
fn a_search_looks_at_as_many_boxes_as_it_did() {
    let bent = |factor: f64| move |Cubic([c0, c1, c2, c3]): Cubic| Cubic([c0, c1, c2 * factor, c3 * factor]);
    let all = Search::default();
    let slow = |Cubic([c0, c1, c2, c3]): Cubic| Cubic([c0, c1 * 1e-3, c2, c3]);
    // Nearly parallel beams that bend and turn away from each other a little or not at all.
    let along = |factor: f64| {
        let direction = Vector3::new(1.0, 0.5, 0.25);
        move |Cubic(c): Cubic| Cubic([c[0], direction + c[1] * factor, c[2] * factor, c[3] * factor])
    };
    let found = [
        costs(&all, bent(1.0)),
        costs(&all, bent(4.0)),
        costs(&all, bent(0.125)),
        costs(&all, slow),
        costs(&all.with_boxes(64), bent(4.0)),
        costs(&all.with_resolution(0.125), bent(4.0)),
        costs(&all, along(0.0)),
        costs(&all, along(1e-3)),
    ];
    assert_eq!(
        found,
        [
            [4708, 548, 2088, 2246],
            [9500, 414, 3548, 3740],
            [878, 282, 688, 762],
            [8380, 652, 3136, 3406],
            [1536, 394, 1098, 15664],
            [2752, 370, 816, 26550],
            [24, 96, 144, 2214],
            [1676, 96, 1034, 1242]
        ]
    );
}

/// A curve that counts its evaluations, and may report that it is not a cubic.
struct OperationCount<'a> {
    curve: &'a Cubic,
    is_cubic: bool,
    evaluations: Cell<usize>,
}

impl<'a> OperationCount<'a> {
    fn new(curve: &'a Cubic, is_cubic: bool) -> Self {
        Self { curve, is_cubic, evaluations: Cell::new(0) }
    }
}

impl Centroid for OperationCount<'_> {
    fn geometry(&self, xi: f64) -> Geometry<f64> {
        self.evaluations.set(self.evaluations.get() + 1);
        self.curve.geometry(xi)
    }

    fn third_derivative_bound(&self) -> f64 {
        self.curve.third_derivative_bound()
    }

    fn is_cubic(&self) -> bool {
        self.is_cubic
    }
}

/// The number of evaluations of a curve by Newton's method, started at distance `away` from the closest points.
fn evaluations(are_cubic: [bool; 2], away: f64) -> usize {
    let mut curves = cubics();
    let mut count = 0;
    for _ in 0..24 {
        let [x, bar] = [(); 2].map(|()| curves.next().unwrap());
        for point in closest_points(&x, &bar, &Search::default()).unwrap().minima {
            let [x, bar] = [(&x, are_cubic[0]), (&bar, are_cubic[1])]
                .map(|(curve, is_cubic)| OperationCount::new(curve, is_cubic));
            let held = Held { xi: point.end.is_some(), xi_bar: point.end_bar.is_some() };
            let _ = refine(&x, &bar, (point.xi - away, point.xi_bar + away), held);
            assert_eq!(x.evaluations.get(), bar.evaluations.get());
            count += x.evaluations.get();
        }
    }
    count
}

#[test]
fn of_two_equal_beams_the_first_is_halved_first() {
    // Each curve is paired with its mirror image, translated.
    let costs = cubics().take(8).map(|x| {
        let [c0, c1, c2, c3] = x.0.map(|c| Vector3::new(c.y, c.x, c.z));
        let bar = Cubic([c0 + Vector3::new(0.5, 1.5, 1.0), c1, c2, c3]);
        closest_points(&x, &bar, &Search::default()).unwrap().statistics.boxes
    });
    assert_eq!(costs.collect::<Vec<_>>(), [65, 171, 249, 123, 121, 147, 191, 189]);
}

#[test]
fn newtons_method_evaluates_as_seldom_as_it_did() {
    let count = |are_cubic| [0.0, 1e-9, 1e-6, 1e-3, 0.03, 0.3].map(|away| evaluations(are_cubic, away));
    assert_eq!(
        [count([true, true]), count([true, false]), count([false, false])],
        [[46, 47, 48, 47, 51, 163], [48, 92, 94, 94, 96, 249], [48, 92, 94, 94, 96, 249]]
    );
}
