//! Errors of the two-by-two system in second variations alone: a program may build it twice.

use super::{Error, Increment, Point, Summand, Sums};
use crate::linearization::Quantity;
use crate::linearization::closed_form::Projection;
use crate::number::{Label, Which};

/// The factors of wrong signs, missing terms, and terms that count twice or half.
const FACTORS: [f64; 4] = [-1.0, 0.0, 2.0, 0.5];

/// The names of the entries' terms: in the whole matrix, in its determinant alone, and in the entries of the inverse alone.
const NAMES: [[&str; 3]; 4] = [
    ["a: t.t", "D: t.t in a", "xi: t.t in a"],
    ["a: d.t,xi", "D: d.t,xi in a", "xi: d.t,xi in a"],
    ["b: t.t_bar", "", "xi: b"],
    [
        "a and a_bar: d.t,xi and d.t_bar,xi",
        "D: d.t,xi in a and d.t_bar,xi in a_bar",
        "xi: d.t,xi and d.t_bar,xi",
    ],
];

impl Point {
    /// The wrong systems, each with the change of all components.
    pub(super) fn system_errors(&self) -> Vec<(Summand, Increment)> {
        let [t2, t2_bar] = [0, 1].map(|i| self.t[i].dot(&self.t[i]));
        let [e, e_bar] = [0, 1].map(|i| self.d.dot(&self.t_xi[i]));
        let right = self.projection;
        // P and P̄, by the equations that xi and xi_bar solve.
        let [xi, xi_bar] = Quantity::PARAMETERS.map(|of| self.varied[of.component()].second);
        let p = [right.a * xi - right.b * xi_bar, right.b * xi + right.a_bar * xi_bar];
        let mut all = Vec::new();
        let mut add = |names: [&'static str; 3], which, factor: f64, wrong: Projection<f64>| {
            let det = right.a * right.a_bar + right.b * right.b;
            let wrong_det = wrong.a * wrong.a_bar + wrong.b * wrong.b;
            // The solution has the entries over the determinant.
            for (name, entries, det) in [
                (names[0], wrong, None),
                (names[1], right, Some(det / wrong_det)),
                (names[2], wrong, Some(wrong_det / det)),
            ] {
                if name.is_empty() {
                    continue;
                }
                let (one, two) = entries.solve(p[0], p[1]);
                let scale = det.unwrap_or(1.0);
                let h = [one * scale - xi, two * scale - xi_bar];
                let summand = Summand {
                    label: Label { name, which },
                    count: 1,
                    error: Error::System(factor),
                    mirror: None,
                    transposed: None,
                };
                all.push((summand, self.increment(Sums { h, ..Sums::default() })));
            }
        };
        let [of_t, of_e, of_b, of_both] = NAMES;
        for factor in FACTORS {
            let change = factor - 1.0;
            add(of_t, Which::Beam, factor, Projection { a: right.a + change * t2, ..right });
            add(of_t, Which::Bar, factor, Projection { a_bar: right.a_bar - change * t2_bar, ..right });
            add(of_e, Which::Beam, factor, Projection { a: right.a + change * e, ..right });
            add(of_e, Which::Bar, factor, Projection { a_bar: right.a_bar + change * e_bar, ..right });
            add(of_b, Which::Beam, factor, Projection { b: factor * right.b, ..right });
            let (a, a_bar) = (right.a + change * e, right.a_bar + change * e_bar);
            add(of_both, Which::Beam, factor, Projection { a, a_bar, ..right });
        }
        all
    }
}
