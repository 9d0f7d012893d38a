//! The example of Newton's method: the tangent of the contact force is its derivative; the stated numbers are correct.

use beamgap::linearization::ad::{self, Route};
use beamgap::pair::DofVector;
use beamgap::teaching::{Problem, Tangent, contact};

/// Compares the tangent with the Hessian of the contact energy eps g_N²/2 by hyper-dual numbers, in all 24 dofs.
#[test]
fn the_tangent_of_the_contact_force_is_its_derivative_by_ad() {
    let problem = Problem::default();
    let (pair, q) = (problem.pair(), problem.solve(Tangent::Exact).q);
    let point = *pair.closest_points(&q).unwrap().interior().unwrap();
    let added = |tangent| contact(&pair, &q, &point, problem.penalty, tangent);
    let [exact, others @ ..] = Tangent::ALL.map(added);
    assert!(exact.gap < -0.05, "{}", exact.gap);
    let mut errors = [0.0_f64; 4];
    let scale = exact.stiffness.to_dense().abs().max();
    for i in 0..24 {
        for j in 0..24 {
            let [dq, linear_dq] = [i, j].map(DofVector::unit);
            let g = ad::vary(Route::Newton, &pair, &q, &point, &dq, &linear_dq).g_n;
            let by_ad = problem.penalty * (g.delta * g.linear + g.value * g.second);
            errors[0] = errors[0].max((exact.stiffness.entry(i, j) - by_ad).abs() / scale);
            for (error, other) in errors[1..].iter_mut().zip(&others) {
                *error = error.max((other.stiffness.entry(i, j) - by_ad).abs() / scale);
            }
            let force = problem.penalty * g.value * g.delta;
            assert!((exact.force.entry(i) - force).abs() < 1e-13 * scale, "force {i}");
        }
    }
    assert!(errors[0] < 1e-13, "{errors:?}");
    assert!(errors[1..].iter().all(|&error| error > 1e-4), "wrong tangents are wrong: {errors:?}");
    assert!(others.iter().all(|other| other.force == exact.force), "the force is always right");
}

/// The tangent is the derivative of the residual: elastic forces and contact together.
#[test]
fn the_system_is_consistent() {
    let problem = Problem::default();
    let (pair, q) = (problem.pair(), problem.solve(Tangent::Exact).q);
    let residual = |q: &DofVector<f64, 12, 12>| {
        let point = *pair.closest_points(q).unwrap().interior().unwrap();
        problem.system(&pair, q, &point, Tangent::Exact)
    };
    let (_, stiffness, _) = residual(&q);
    let step = 1e-5;
    for i in 0..12 {
        let unit: DofVector<f64, 12, 12> = DofVector::unit(if i < 6 { 6 + i } else { 12 + i });
        let [up, down] = [step, -step].map(|step| residual(&q.plus(step, &unit)).0);
        let error = ((up - down) / (2.0 * step) - stiffness.column(i)).norm() / stiffness.norm();
        assert!(error < 1e-8, "column {i}: {error:e}");
    }
}

/// Tests the numbers in the prose of the page of the derivation.
#[test]
fn only_the_exact_tangent_converges_quadratically() {
    let problem = Problem::default();
    let runs = Tangent::ALL.map(|tangent| problem.solve(tangent));
    let iterations = runs.each_ref().map(|run| run.converged().then(|| run.iterations()));
    assert_eq!(iterations, [Some(4), Some(13), None, Some(53)]);
    let residuals = |i: usize| runs[i].iterates.iter().map(|iterate| iterate.residual).collect::<Vec<_>>();
    // The logarithm of the residual doubles in each iteration until rounding dominates.
    let exact = residuals(0);
    assert!(exact[2] < exact[1].powf(1.8) && exact[3] < exact[2].powf(1.8), "{exact:?}");
    // Without the curvature terms each iteration reduces the residual by the same factor.
    let rates: Vec<f64> = residuals(1).windows(2).skip(4).map(|pair| pair[1] / pair[0]).collect();
    assert!(rates.iter().all(|rate| (0.13..0.16).contains(rate)), "{rates:?}");
    let end = |i: usize| runs[i].iterates.last().unwrap();
    assert!((end(0).gap - end(1).gap).abs() < 1e-10 && (end(0).gap - end(3).gap).abs() < 1e-10);
    assert!((end(0).gap + 0.0878).abs() < 1e-4, "the beams press: {}", end(0).gap);
}
