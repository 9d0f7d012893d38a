//! The way without derivatives: central differences of values, each at the closest point of the moved beams.

use crate::pairs::Problem;
use beamgap::closest_point::{Beam, refine};
use beamgap::curve::Curve;
use beamgap::linearization::ad::{Perturbed, evaluate};
use beamgap::linearization::{Expansion, Quantities};

/// The step: the fourth root of epsilon, about the best for second differences of lengths near 1.
const STEP: f64 = 1.0 / 8192.0;

/// Gradients and Hessians of the quantities that `pick` picks.
pub(crate) fn expand<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize, const K: usize>(
    problem: &Problem<A, B, N, M>,
    pick: impl Fn(Quantities<f64>) -> [f64; K],
) -> [Expansion<f64, N, M>; K] {
    let Problem { pair, q, point, .. } = problem;
    let at = |moves: &[(usize, f64)]| {
        let mut moved = *q;
        for &(i, step) in moves {
            moved.set(i, moved.entry(i) + step);
        }
        let beam = Beam { curve: &pair.curve, q: &moved.beam };
        let bar = Beam { curve: &pair.curve_bar, q: &moved.bar };
        let found = refine(&beam, &bar, (point.xi, point.xi_bar), point.active()).expect("a small move");
        let beam = Perturbed { curve: &pair.curve, q: moved.beam };
        let bar = Perturbed { curve: &pair.curve_bar, q: moved.bar };
        pick(evaluate(&beam, &bar, (found.xi, found.xi_bar), &pair.contact))
    };
    let centre = at(&[]);
    let mut expansions = centre.map(|value| Expansion { value, ..Expansion::zero() });
    for j in 0..N + M {
        let (plus, minus) = (at(&[(j, STEP)]), at(&[(j, -STEP)]));
        for (k, expansion) in expansions.iter_mut().enumerate() {
            expansion.gradient.set(j, (plus[k] - minus[k]) / (2.0 * STEP));
            expansion.hessian.set(j, j, (plus[k] - 2.0 * centre[k] + minus[k]) / (STEP * STEP));
        }
        for i in 0..j {
            let [pp, pm, mp, mm] = [(STEP, STEP), (STEP, -STEP), (-STEP, STEP), (-STEP, -STEP)]
                .map(|(one, other)| at(&[(i, one), (j, other)]));
            for (k, expansion) in expansions.iter_mut().enumerate() {
                expansion.hessian.set(i, j, (pp[k] - pm[k] - mp[k] + mm[k]) / (4.0 * STEP * STEP));
            }
        }
    }
    expansions
}
