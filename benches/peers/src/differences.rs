//! Central differences of values and of gradients, as candidates.

use crate::candidates::{Quantity, all, candidate, d_only, write};
use crate::cases::{Case, PAIR};
use beamgap::closest_point::Held;
use beamgap::curve::DofDerivatives;
use beamgap::linearization::Quantities;
use beamgap::linearization::ad::{Perturbed, evaluate};
use beamgap::linearization::closed_form::{Projection, jets};
use beamgap::pair::DofVector;

/// The step of second differences: the fourth root of epsilon, nearly optimal for lengths near 1.
const STEP: f64 = 1.0 / 8192.0;
/// The step of first differences: its cube root.
const FIRST_STEP: f64 = 1.0 / 131_072.0;

/// The pair after some dofs have moved, and its new closest point.
fn moved(case: &Case, moves: &[(usize, f64)]) -> (DofVector<f64, 12, 12>, (f64, f64)) {
    let mut q = case.q;
    for &(i, step) in moves {
        q.set(i, q.entry(i) + step);
    }
    let at = (case.point.xi, case.point.xi_bar);
    let found = PAIR.refine(&q, at, Held::default()).map_or((f64::NAN, f64::NAN), |p| (p.xi, p.xi_bar));
    (q, found)
}

/// Central differences of values, 1153 closest points.
fn differences<const K: usize>(case: &Case, pick: fn(Quantities<f64>) -> [f64; K], to: &mut [Quantity; K]) {
    let at = |moves: &[(usize, f64)]| {
        let (q, at) = moved(case, moves);
        let beam = Perturbed { curve: &PAIR.curve, q: q.beam };
        let bar = Perturbed { curve: &PAIR.curve_bar, q: q.bar };
        pick(evaluate(&beam, &bar, at, &PAIR.contact))
    };
    let (step, square) = (STEP, STEP * STEP);
    let centre = at(&[]);
    for j in 0..24 {
        let (plus, minus) = (at(&[(j, step)]), at(&[(j, -step)]));
        for (k, to) in to.iter_mut().enumerate() {
            to.value = centre[k];
            to.gradient.set(j, (plus[k] - minus[k]) / (2.0 * step));
            to.hessian.set(j, j, (plus[k] - 2.0 * centre[k] + minus[k]) / square);
        }
        for i in 0..j {
            let [pp, pm, mp, mm] = [(step, step), (step, -step), (-step, step), (-step, -step)]
                .map(|(one, other)| at(&[(i, one), (j, other)]));
            for (k, to) in to.iter_mut().enumerate() {
                to.hessian.set(i, j, (pp[k] - pm[k] - mp[k] + mm[k]) / (4.0 * square));
            }
        }
    }
}

candidate!(values_d, values_d_read: [Quantity; 1], |case, to| differences(case, d_only, to),
    |d, full| write(&d.each_ref(), full));
candidate!(values_all, values_all_read: [Quantity; 5], |case, to| differences(case, all, to),
    |all, full| write(&all.each_ref(), full));

/// Values and gradients of d, xi, xi_bar, t and t_bar in closed form; the first `K` of them are used.
fn gradients<const K: usize>(q: &DofVector<f64, 12, 12>, at: (f64, f64)) -> [(f64, DofVector<f64, 12, 12>); K] {
    let (jet, jet_bar) = jets(&PAIR, q, at);
    let (x, y) = (jet.geometry, jet_bar.geometry);
    let d = x.x - y.x;
    let distance = d.norm();
    let n = d / distance;
    let of_d = DofVector { beam: jet.dofs.gradient(0, &n), bar: -jet_bar.dofs.gradient(0, &n) };
    let mut all = [(distance, of_d); 5];
    if K > 1 {
        let [[p, q], [r, s]] = Projection::new(&x, &y, Held::default()).inverse();
        let right = DofVector {
            beam: -jet.dofs.gradient(0, &x.t) - jet.dofs.gradient(1, &d),
            bar: jet_bar.dofs.gradient(0, &x.t),
        };
        let right_bar = DofVector {
            beam: -jet.dofs.gradient(0, &y.t),
            bar: jet_bar.dofs.gradient(0, &y.t) - jet_bar.dofs.gradient(1, &d),
        };
        let (g, g_bar) = (right.times(p).plus(q, &right_bar), right.times(r).plus(s, &right_bar));
        let (length, length_bar) = (x.t.norm(), y.t.norm());
        let (w, w_bar) = (x.t / length, y.t / length_bar);
        let of_t = DofVector::of_beam(jet.dofs.gradient(1, &w)).plus(w.dot(&x.t_xi), &g);
        let of_t_bar = DofVector::of_bar(jet_bar.dofs.gradient(1, &w_bar)).plus(w_bar.dot(&y.t_xi), &g_bar);
        all = [(distance, of_d), (at.0, g), (at.1, g_bar), (length, of_t), (length_bar, of_t_bar)];
    }
    std::array::from_fn(|k| all[k])
}

/// Central differences of gradients, 48 closest points and the one of the pair.
fn differences_of_gradients<const K: usize>(case: &Case, to: &mut [Quantity; K]) {
    let centre = gradients::<K>(&case.q, (case.point.xi, case.point.xi_bar));
    for (to, (value, gradient)) in to.iter_mut().zip(centre) {
        (to.value, to.gradient) = (value, gradient);
    }
    for j in 0..24 {
        let [plus, minus] = [FIRST_STEP, -FIRST_STEP].map(|step| {
            let (q, at) = moved(case, &[(j, step)]);
            gradients::<K>(&q, at)
        });
        for ((to, (_, plus)), (_, minus)) in to.iter_mut().zip(plus).zip(minus) {
            for i in 0..=j {
                to.hessian.set(i, j, (plus.entry(i) - minus.entry(i)) / (2.0 * FIRST_STEP));
            }
        }
    }
}

candidate!(gradients_d, gradients_d_read: [Quantity; 1], |case, to| differences_of_gradients(case, to),
    |d, full| write(&d.each_ref(), full));
candidate!(gradients_all, gradients_all_read: [Quantity; 5], |case, to| differences_of_gradients(case, to),
    |all, full| write(&all.each_ref(), full));
