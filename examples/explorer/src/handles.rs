//! The handles by which the user moves the points and tangents of a beam, and the directions.

use crate::state::{Dragged, State};
use crate::view::View;
use beamgap::check::CaseData;
use beamgap::nalgebra::Vector3;
use beamgap::test_beam::{Family, TestBeam, Unit};

/// The fraction of a tangent that is drawn.
const TANGENT: f64 = 0.5;

/// Three dofs that are moved together.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Handle {
    /// The beam is 0, the bar beam is 1.
    pub(crate) beam: usize,
    /// The index of its first dof.
    pub(crate) start: usize,
    /// The distance that the handle moves in space if the dofs grow by one.
    pub(crate) factor: f64,
    /// The position in the picture.
    pub(crate) at: [f64; 2],
    /// The start of the rod in the picture.
    pub(crate) from: [f64; 2],
    /// Whether the handle has a rod.
    pub(crate) is_rod: bool,
    /// Its name.
    pub(crate) name: String,
    /// Its dofs.
    pub(crate) value: [f64; 3],
}

/// Three dofs of a beam as a vector in space.
struct Triple {
    start: usize,
    /// The start of the vector.
    base: Vector3<f64>,
    /// The length at which a unit vector is drawn.
    factor: f64,
    is_point: bool,
    name: String,
}

/// All handles of both beams.
pub(crate) fn handles(case: &CaseData, state: &State, view: &View) -> Vec<Handle> {
    let mut all = Vec::new();
    for (beam, test_beam) in case.test_beams.iter().enumerate() {
        let (numbers, direction) = match state.dragged {
            Dragged::Q => (&test_beam.q, None),
            Dragged::Dq => (&test_beam.dq, Some("δq")),
            Dragged::LinearDq => (&test_beam.linear_dq, Some("Δq")),
        };
        for triple in triples(test_beam, ["beam", "bar beam"][beam]) {
            let value = vector(numbers, triple.start);
            let place = triple.base + vector(&test_beam.q, triple.start) * triple.factor;
            let (from, to) = match direction {
                Some(_) => (place, place + value * triple.factor),
                // Points have no rod.
                None if triple.is_point => (place, place),
                None => (triple.base, place),
            };
            let name = direction.map_or_else(|| triple.name.clone(), |of| format!("{of} of {}", triple.name));
            let is_rod = from != to;
            let [at, from] = [to, from].map(|x| view.at(&x));
            let Triple { start, factor, .. } = triple;
            all.push(Handle { beam, start, factor, at, from, is_rod, name, value: value.into() });
        }
    }
    all
}

fn vector(numbers: &[f64], start: usize) -> Vector3<f64> {
    Vector3::from_fn(|c, _| numbers[start + c])
}

/// The points, and the tangents of Hermite beams.
fn triples(test_beam: &TestBeam, beam: &str) -> Vec<Triple> {
    let units = test_beam.family.units();
    let points: Vec<usize> = (0..units.len()).filter(|&i| units[i] == Unit::Point).step_by(3).collect();
    let tangent = match test_beam.family {
        Family::Hermite => Some(1.0),
        Family::HermiteScaled => test_beam.parameters.first().copied(),
        _ => None,
    };
    let mut triples = Vec::new();
    for (i, &start) in points.iter().enumerate() {
        let what = match test_beam.family {
            Family::Arc | Family::Helix => "centre".to_owned(),
            _ => format!("point {}", i + 1),
        };
        triples.push(Triple {
            start,
            base: Vector3::zeros(),
            factor: 1.0,
            is_point: true,
            name: format!("{what} of the {beam}"),
        });
        if let Some(length) = tangent {
            triples.push(Triple {
                start: start + 3,
                base: vector(&test_beam.q, start),
                factor: TANGENT * length,
                is_point: false,
                name: format!("tangent {} of the {beam}", i + 1),
            });
        }
    }
    triples
}
