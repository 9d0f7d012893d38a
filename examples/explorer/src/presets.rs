//! An initial beam of each family, near those of the standard case.

use crate::state::{BeamState, ContactState, Dragged, Parameter, Shown, State, ViewState};
use beamgap::curve::{Curve, Hermite};
use beamgap::equations::StandardCase;
use beamgap::nalgebra::{SVector, Vector3};
use beamgap::pair::Contact;
use beamgap::test_beam::Family;
use std::collections::BTreeMap;

/// The directions cycle through these numbers.
const DIRECTIONS: [f64; 13] = [0.1, -0.2, 0.3, 0.05, 0.4, -0.3, 0.2, -0.1, 0.25, -0.4, 0.15, 0.35, -0.25];

impl Default for State {
    /// The standard case.
    fn default() -> Self {
        let StandardCase { pair, q, dq, linear_dq } = StandardCase::default();
        let beam = |q: &SVector<f64, 12>, dq: &SVector<f64, 12>, linear_dq: &SVector<f64, 12>| BeamState {
            family: Family::Hermite.name().to_owned(),
            curve: BTreeMap::new(),
            q: q.as_slice().to_vec(),
            dq: dq.as_slice().to_vec(),
            linear_dq: linear_dq.as_slice().to_vec(),
        };
        let Contact { radius, radius_bar, xi_0, xi_bar_0 } = pair.contact;
        Self {
            beam: beam(&q.beam, &dq.beam, &linear_dq.beam),
            bar: beam(&q.bar, &dq.bar, &linear_dq.bar),
            contact: ContactState { radius, radius_bar, xi_0, xi_bar_0 },
            view: ViewState { azimuth: 14.0, elevation: 18.0, scale: 165.0 },
            shown: Shown::Gap,
            order: 1,
            fault: None,
            step: 0.25,
            along_linear: false,
            minimum: 0,
            dragged: Dragged::Q,
            equations: true,
            refused: None,
        }
    }
}

/// A beam of the family near the beam of the standard case, or near the bar beam.
pub fn preset(family: Family, bar: bool) -> BeamState {
    let standard = State::default();
    let standard = if bar { standard.bar } else { standard.beam };
    if family == Family::Hermite {
        return standard;
    }
    let hermite = SVector::<f64, 12>::from_column_slice(&standard.q);
    let at = |xi: f64| Hermite::new().position(&hermite, xi);
    let points = |at_parameters: &[f64]| -> Vec<f64> {
        at_parameters.iter().flat_map(|&xi| at(xi).data.0[0]).map(rounded).collect()
    };
    let one = |name: &str, value: f64| BTreeMap::from([(name.to_owned(), Parameter::One(value))]);
    let many = |name: &str, values: &[f64]| (name.to_owned(), Parameter::Many(values.to_vec()));
    // The centre is the middle of the beam, and the axes are along it and upwards.
    let centre = (at(-1.0) + at(1.0)) * 0.5;
    let turn = if bar { std::f64::consts::FRAC_PI_3 } else { 0.0 };
    let (curve, q) = match family {
        Family::Segment => (BTreeMap::new(), points(&[-1.0, 1.0])),
        Family::Quadratic => (BTreeMap::new(), points(&[-1.0, 0.0, 1.0])),
        Family::Cubic => (BTreeMap::new(), points(&[-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0])),
        Family::Bezier => (BTreeMap::new(), points(&[-1.0, -0.6, -0.2, 0.2, 0.6, 1.0])),
        Family::BSpline => (
            BTreeMap::from([many("knots", &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0])]),
            points(&[-1.8, -0.6, 0.6, 1.8]),
        ),
        Family::Nurbs => (
            BTreeMap::from([many("knots", &[0.0, 1.0, 2.0, 3.0]), many("weights", &[1.0, 1.5, 1.0])]),
            points(&[-1.5, 0.0, 1.5]),
        ),
        Family::NurbsWeighted => {
            let points = points(&[-1.8, -0.6, 0.6, 1.8]);
            let weighted = points.chunks(3).zip([1.0, 1.4, 0.8, 1.0]);
            let q = weighted.flat_map(|(point, weight)| [point, &[weight]].concat()).collect();
            (BTreeMap::from([many("knots", &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0])]), q)
        }
        Family::Arc => (one("half_angle", 1.2), winding(&centre, turn, bar, false)),
        Family::Helix => (one("half_angle", 2.5), winding(&centre, turn, bar, true)),
        Family::HermiteScaled | Family::Hermite => {
            let tangents = |start: usize| (3..6).map(move |i| hermite[start + i] / 1.5);
            let nodes = |start: usize| (0..3).map(move |i| hermite[start + i]).chain(tangents(start));
            (one("length", 1.5), nodes(0).chain(nodes(6)).map(rounded).collect())
        }
    };
    let direction =
        |offset: usize| (0..q.len()).map(|i| DIRECTIONS[(i + offset) % DIRECTIONS.len()]).collect();
    let (dq, linear_dq) = if bar { (direction(7), direction(11)) } else { (direction(0), direction(4)) };
    BeamState { family: family.name().to_owned(), curve, q, dq, linear_dq }
}

/// The dofs of an arc or a helix in a vertical plane. That of the bar beam is rotated about the vertical axis.
fn winding(centre: &Vector3<f64>, turn: f64, bar: bool, helix: bool) -> Vec<f64> {
    // The circle lies in the plane of x and z: it is rotated about x by a right angle, then about z.
    let (half, quarter) = (0.5 * turn, std::f64::consts::FRAC_PI_4);
    let (sin, cos) = half.sin_cos();
    let (sin_x, cos_x) = quarter.sin_cos();
    let quaternion = [cos * cos_x, cos * sin_x, sin * sin_x, sin * cos_x];
    let radius = if helix { 0.4 } else { 1.3 };
    // The middle of the arc is its highest point for the bar beam, and its lowest point for the other beam.
    let phase = if bar { std::f64::consts::FRAC_PI_2 } else { -std::f64::consts::FRAC_PI_2 };
    let down = if helix { 0.0 } else { radius * phase.sin() };
    let centre = [centre.x, centre.y, centre.z - down];
    let all: Vec<f64> = if helix {
        [&centre[..], &quaternion, &[radius, 2.4, phase]].concat()
    } else {
        [&centre[..], &[radius], &quaternion, &[phase]].concat()
    };
    all.into_iter().map(rounded).collect()
}

/// The number rounded to three decimals.
fn rounded(x: f64) -> f64 {
    (x * 1000.0).round() / 1000.0
}
