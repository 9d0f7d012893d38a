//! The slip along the tangent, (14), against the arc length, (12).

use crate::closest_point::Centroid;
use crate::test_beam::Family;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The slips in the parameter for which both are computed: a slip and half of it.
const SLIPS: [f64; 2] = [0.1, 0.05];

/// The difference of (14) and (12) for the curves of one family.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Arc {
    /// The family.
    pub family: String,
    /// The slip in the parameter.
    pub slip: f64,
    /// The largest difference over the arc length, to two digits.
    pub error: f64,
    /// The median ratio of the differences for the whole and for half the slip; 4 if the leading term is quadratic.
    pub ratio: Option<f64>,
}

impl Arc {
    /// Whether the difference is rounding: the length of the tangent is constant along these curves.
    pub fn is_exact(&self) -> bool {
        self.error < 1e-9
    }
}

/// The errors of one beam, for both slips.
pub(super) struct Measured {
    family: Family,
    /// The difference, and its size over the arc length.
    differences: [f64; 2],
    error: f64,
}

/// Compares t (xi_C - xi_C0) with the arc length. The slip starts at the middle of the beam.
pub(super) fn measure(family: Family, beam: &dyn Centroid, xi: f64) -> Measured {
    let length = |xi: f64| beam.geometry(xi).t.norm();
    let lengths = SLIPS.map(|slip| {
        let slip = slip.copysign(xi);
        (length(xi) * slip, integral(length, xi - slip, xi))
    });
    let differences = lengths.map(|(along, arc)| (along - arc).abs());
    Measured { family, differences, error: differences[0] / lengths[0].1.abs() }
}

/// Gauss-Legendre quadrature with five points on each of four panels.
fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let root = 2.0 * (10.0_f64 / 7.0).sqrt();
    let [near, far] = [(5.0 - root).sqrt() / 3.0, (5.0 + root).sqrt() / 3.0];
    let irrational = 13.0 * 70.0_f64.sqrt();
    let [heavy, light] = [(322.0 + irrational) / 900.0, (322.0 - irrational) / 900.0];
    let rule = [(0.0, 128.0 / 225.0), (near, heavy), (-near, heavy), (far, light), (-far, light)];
    let half = (to - from) / 8.0;
    let test_points =
        |centre: f64| rule.map(|(x, weight)| weight * f(centre + half * x)).iter().sum::<f64>() * half;
    [1.0, 3.0, 5.0, 7.0].map(|i| test_points(from + i * half)).iter().sum()
}

/// Errors by family.
#[derive(Default)]
pub(super) struct Arcs(BTreeMap<Family, Vec<Measured>>);

impl Arcs {
    pub(super) fn add(&mut self, beam: Measured) {
        self.0.entry(beam.family).or_default().push(beam);
    }

    /// Family by family.
    pub(super) fn found(self) -> Vec<Arc> {
        let digits = |x: f64, n: usize| format!("{x:.n$e}").parse().unwrap_or(f64::INFINITY);
        let of = |(family, beams): (Family, Vec<Measured>)| {
            let error = digits(beams.iter().map(|beam| beam.error).fold(0.0, f64::max), 1);
            let mut ratios: Vec<f64> =
                beams.iter().map(|beam| beam.differences[0] / beam.differences[1]).collect();
            ratios.sort_by(f64::total_cmp);
            let arc = Arc { family: family.name().to_owned(), slip: SLIPS[0], error, ratio: None };
            let ratio = (!arc.is_exact()).then(|| digits(ratios[ratios.len() / 2], 1));
            Arc { ratio, ..arc }
        };
        self.0.into_iter().map(of).collect()
    }
}
