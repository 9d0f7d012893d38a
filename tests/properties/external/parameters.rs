//! Parameters of programs that solve for the closest point themselves.

use super::{drawing, vectors, verified};
use beamgap::check::external::Vector;
use beamgap::check::{Family, Regime};

/// The closest point of two cubic curves by Newton's method in `f64`, with shape functions that are sums of powers.
fn solved(beams: [&[f64]; 2], mut at: [f64; 2]) -> [f64; 2] {
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let sum = |q: &[f64], n: [f64; 4]| [0, 1, 2].map(|c| (0..4).map(|a| n[a] * q[3 * a + c]).sum::<f64>());
    for _ in 0..8 {
        let [[x, t, t_xi], [y, t_bar, t_bar_xi]] = [0, 1].map(|i| {
            let s: f64 = at[i];
            let (s2, s3) = (s * s, s * s * s);
            let shapes = [2.0 - 3.0 * s + s3, 1.0 - s - s2 + s3, 2.0 + 3.0 * s - s3, -1.0 - s + s2 + s3];
            let slopes = [3.0 * s2 - 3.0, 3.0 * s2 - 2.0 * s - 1.0, 3.0 - 3.0 * s2, 3.0 * s2 + 2.0 * s - 1.0];
            let second = [6.0 * s, 6.0 * s - 2.0, -6.0 * s, 6.0 * s + 2.0];
            [shapes, slopes, second].map(|n| sum(beams[i], n.map(|n| n / 4.0)))
        });
        let d = [0, 1, 2].map(|c| x[c] - y[c]);
        let (f, f_bar) = (dot(d, t), -dot(d, t_bar));
        let (a, b, c) = (dot(t, t) + dot(d, t_xi), -dot(t, t_bar), dot(t_bar, t_bar) - dot(d, t_bar_xi));
        let det = a * c - b * b;
        at = [at[0] - (c * f - b * f_bar) / det, at[1] - (a * f_bar - b * f) / det];
    }
    at
}

/// Positions of badly scaled beams cancel, so a program that solves for the closest point finds other parameters.
#[test]
fn parameters_may_be_solved_for_again() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::BadlyScaled], 300));
    let inside: Vec<Vector> = all
        .into_iter()
        .filter(|vector| vector.point.is_some_and(|(xi, xi_bar)| xi.abs() < 1.0 && xi_bar.abs() < 1.0))
        .collect();
    assert!(inside.len() > 50, "{}", inside.len());
    let with = |off: f64| {
        let line = |vector: &Vector| {
            let (xi, xi_bar) = vector.point.unwrap();
            let [beam, bar] = &vector.case.test_beams;
            let [xi, xi_bar] = solved([&beam.q, &bar.q], [xi, xi_bar]);
            format!("{{\"id\":\"{}\",\"xi\":{:?},\"xi_bar\":{xi_bar:?}}}\n", vector.id, xi + off)
        };
        format!("{{\"schema\":\"beamgap-answers/1\"}}\n{}", inside.iter().map(line).collect::<String>())
    };
    let report = verified(&inside, &with(0.0), None).unwrap();
    assert!(report.agrees(), "{:?}", report.first);
    assert!(verified(&inside, &with(1e-6), None).unwrap().wrong > 50);
}
