//! The search finds all minima. It is tested with brute force on strongly curved pairs, and with transformed pairs.

use crate::centroids::Cubic;
use beamgap::closest_point::{
    Centroid, ClosestPoint, ClosestPoints, Search, SquaredDistance, closest_points,
};
use nalgebra::Vector3;
use proptest::prelude::*;

fn vector(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-size..size).prop_map(Vector3::from)
}

/// Cubics that turn back on themselves, so that a pair has five or more minima.
fn cubic() -> impl Strategy<Value = Cubic> {
    (vector(0.5), vector(1.0), vector(1.0), vector(2.0)).prop_map(|(c0, c1, c2, c3)| Cubic([c0, c1, c2, c3]))
}

/// Cubics with few digits, so that pairs of them have ties, points at ends and zeros.
fn coarse_cubic() -> impl Strategy<Value = Cubic> {
    let component = || (-4..=4_i32).prop_map(|i| 0.5 * f64::from(i));
    prop::array::uniform4(prop::array::uniform3(component()).prop_map(Vector3::from)).prop_map(Cubic)
}

fn search(x: &Cubic, bar: &Cubic) -> ClosestPoints {
    closest_points(x, bar, &Search::default()).unwrap()
}

fn squared_distance(x: &Cubic, bar: &Cubic, at: [f64; 2]) -> f64 {
    (x.geometry(at[0]).x - bar.geometry(at[1]).x).norm_squared()
}

/// The points of a grid at most as distant as their neighbours, each improved by descent.
fn brute_force(x: &Cubic, bar: &Cubic, count: usize) -> Vec<[f64; 2]> {
    #[expect(clippy::cast_precision_loss, reason = "a grid has few points")]
    let parameter = |i: usize| -1.0 + 2.0 * (i as f64) / (count as f64);
    let points: Vec<_> = (0..=count).map(|i| x.geometry(parameter(i)).x).collect();
    let points_bar: Vec<_> = (0..=count).map(|i| bar.geometry(parameter(i)).x).collect();
    let value = |i: usize, j: usize| (points[i] - points_bar[j]).norm_squared();
    let around = |i: usize| i.saturating_sub(1)..=(i + 1).min(count);
    let mut minima = Vec::new();
    for i in 0..=count {
        for j in 0..=count {
            let here = value(i, j);
            if around(i).all(|k| around(j).all(|l| value(k, l) >= here)) {
                minima.extend(descend(x, bar, [parameter(i), parameter(j)], 2.0 / 400.0));
            }
        }
    }
    minima
}

fn descend(x: &Cubic, bar: &Cubic, mut at: [f64; 2], mut step: f64) -> Option<[f64; 2]> {
    let mut value = squared_distance(x, bar, at);
    // In a curved valley with a flat floor descent would be too slow. Such points are not compared.
    for _ in 0..5000 {
        if step < 1e-9 {
            return Some(at);
        }
        let mut moved = false;
        for turn in 0..32 {
            let (sin, cos) = (f64::from(turn) * std::f64::consts::PI / 16.0).sin_cos();
            let next = [(at[0] + step * cos).clamp(-1.0, 1.0), (at[1] + step * sin).clamp(-1.0, 1.0)];
            let there = squared_distance(x, bar, next);
            if there < value {
                (at, value, moved) = (next, there, true);
            }
        }
        step = if moved { (2.0 * step).min(0.005) } else { 0.5 * step };
    }
    None
}

fn is_near(point: &ClosestPoint, at: [f64; 2], tolerance: f64) -> bool {
    (point.xi - at[0]).abs() < tolerance && (point.xi_bar - at[1]).abs() < tolerance
}

/// Whether both lists contain the same points, after `map` of those of the second.
fn same(p: &[ClosestPoint], q: &[ClosestPoint], map: impl Fn(&ClosestPoint) -> [f64; 2]) -> bool {
    p.len() == q.len()
        && q.iter()
            .all(|q| p.iter().any(|p| is_near(p, map(q), 1e-12 / q.conditioning.abs().min(1.0).powi(2))))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn brute_force_finds_no_other_minimum(x in cubic(), bar in cubic()) {
        let found = search(&x, &bar);
        prop_assert!(found.is_complete(), "{:?}", found);
        for at in brute_force(&x, &bar, 200) {
            prop_assert!(found.minima.iter().any(|point| is_near(point, at, 1e-4)), "{:?} not in {:?}", at, found.minima);
        }
        for point in &found.minima {
            let at = descend(&x, &bar, [point.xi, point.xi_bar], 1e-5);
            prop_assert!(at.is_some_and(|at| is_near(point, at, 1e-4)), "{:?} leads down to {:?}", point, at);
        }
        prop_assert!(found.minima.is_sorted_by(|p, q| p.distance <= q.distance));
    }

    #[test]
    fn brute_force_finds_no_other_minimum_of_coarse_pairs(x in coarse_cubic(), bar in coarse_cubic()) {
        if let Ok(found) = closest_points(&x, &bar, &Search::default()) {
            for at in brute_force(&x, &bar, 100) {
                let open = found.unresolved.iter().any(|region| {
                    [region.xi, region.xi_bar].iter().zip(at).all(|(extent, at)| extent[0] - 1e-3 <= at && at <= extent[1] + 1e-3)
                });
                let known = found.minima.iter().any(|point| is_near(point, at, 1e-3));
                // Where descent is slow it may end at a saddle.
                let saddle = found.stationary.iter().any(|point| point.conditioning < 0.0 && is_near(point, at, 1e-3));
                prop_assert!(open || known || saddle, "{:?} not in {:?}", at, found);
            }
        }
    }

    #[test]
    fn the_unit_of_length_does_not_matter(x in cubic(), bar in cubic(), exponent in prop_oneof![-40..=40_i32, -480..=480_i32]) {
        let factor = 2.0_f64.powi(exponent);
        let (found, scaled) = (search(&x, &bar), search(&x.times(factor), &bar.times(factor)));
        let all = |found: &ClosestPoints| [found.minima.clone(), found.stationary.clone()].concat();
        for (p, q) in all(&found).iter().zip(&all(&scaled)) {
            let mut expected = *p;
            expected.distance *= factor;
            prop_assert_eq!(&expected, q);
        }
        prop_assert_eq!(found.statistics, scaled.statistics);
        prop_assert_eq!(all(&found).len(), all(&scaled).len());
    }

    #[test]
    fn swapping_the_beams_swaps_the_points(x in cubic(), bar in cubic()) {
        let (found, swapped) = (search(&x, &bar), search(&bar, &x));
        let swap = |point: &ClosestPoint| [point.xi_bar, point.xi];
        prop_assert!(same(&found.minima, &swapped.minima, swap), "{:?} {:?}", found, swapped);
        prop_assert!(same(&found.stationary, &swapped.stationary, swap), "{:?} {:?}", found, swapped);
    }

    #[test]
    fn residuals_are_rounding(x in cubic(), bar in cubic()) {
        let found = search(&x, &bar);
        for point in found.minima.iter().chain(&found.stationary) {
            let p = SquaredDistance::new(&x.geometry(point.xi), &bar.geometry(point.xi_bar));
            let rounding = 1e-15 * (p.a.abs() + p.b.abs() + p.a_bar.abs() + 2.0 * p.distance);
            let free = [point.end.is_none(), point.end_bar.is_none()];
            prop_assert!((0..2).all(|i| !free[i] || p.gradient[i].abs() < rounding), "{:?}", point);
        }
    }
}
