//! Errors of the curves: the same wrong vectors in all equations.

mod control_vectors;
mod iteration;
mod parameters;
mod polynomials;
mod shapes;
mod vectors;

use super::equations::{CLOSEST_POINT, Equation};
use super::judgement::judged;
use super::point::Point;
use super::sample::Sample;
use super::terms::Beam;
use crate::number::RunningError;
use crate::parallel;
pub(super) use iteration::error_by_beam;
use nalgebra::Vector3;
pub(super) use polynomials::{Derivative, derivatives};

/// The vectors of a sample: x, t, t,xi and t,xixi by beam, and the variations by direction, beam and derivative.
pub(super) type Vectors = ([[Vector3<RunningError>; 4]; 2], [[[Vector3<RunningError>; 3]; 2]; 2]);

/// A change of the vectors of a sample.
type Change = Box<dyn Fn(&Sample, &mut Vectors) + Send + Sync>;

/// A possible error of the curves.
pub(super) struct Input {
    pub(super) words: String,
    change: Change,
}

impl Input {
    fn new(words: String, change: impl Fn(&Sample, &mut Vectors) + Send + Sync + 'static) -> Self {
        Self { words, change: Box::new(change) }
    }

    /// The vectors of a sample with the error.
    pub(super) fn vectors(&self, sample: &Sample) -> Vectors {
        let mut vectors = (sample.geometry, sample.moved);
        (self.change)(sample, &mut vectors);
        vectors
    }

    /// The sample with the error.
    fn point<'a>(&self, sample: &'a Sample) -> Point<'a> {
        let (geometry, moved) = self.vectors(sample);
        Point::with(sample, &geometry, &moved)
    }
}

/// All errors that are told by their words alone.
fn all(samples: &[Sample]) -> Vec<Input> {
    let all = [
        vectors::inputs(),
        parameters::inputs(samples),
        control_vectors::inputs(samples),
        shapes::inputs(samples),
    ];
    all.into_iter().flatten().collect()
}

/// The same, and those of one derivative of a shape function.
pub(super) fn with_single_derivatives(samples: &[Sample]) -> Vec<Input> {
    all(samples).into_iter().chain(polynomials::inputs(samples)).collect()
}

/// The beams that an error may be in.
const BEAMS: [(&[Beam], &str); 3] = [(&[0, 1], "both beams"), (&[0], "the beam"), (&[1], "the bar beam")];

/// The factor of a wrong term less one, in words.
const FACTORS: [(f64, &str); 4] =
    [(-2.0, "has the wrong sign"), (-1.0, "is missing"), (1.0, "counts twice"), (-0.5, "is halved")];

/// The derivatives of a shape function or a curve.
const ORDERS: [&str; 4] =
    ["", "the first derivative of ", "the second derivative of ", "the third derivative of "];

/// Which vectors are made of shape functions that are wrong.
#[derive(Clone, Copy, PartialEq)]
enum Of {
    Both,
    Curve,
    Variations,
}

/// All of them, in words.
const OF: [(Of, &str); 3] =
    [(Of::Both, ""), (Of::Curve, ", in the curve alone"), (Of::Variations, ", in the variations alone")];

/// Adds to the derivative of this order of a beam a factor times vectors: those of the curve and of both variations.
fn add(vectors: &mut Vectors, (beam, order): (Beam, usize), factor: f64, by: [Vector3<f64>; 3], of: Of) {
    let add = |to: &mut Vector3<RunningError>, by: Vector3<f64>| {
        *to += by.map(|c| RunningError { value: c * factor, bound: 4.0 * f64::EPSILON * (c * factor).abs() });
    };
    let [curve, delta, linear] = by;
    if of != Of::Variations {
        add(&mut vectors.0[beam][order], curve);
    }
    if of != Of::Curve && order < 3 {
        add(&mut vectors.1[0][beam][order], delta);
        add(&mut vectors.1[1][beam][order], linear);
    }
}

/// The samples of some of these cases.
fn some<'a>(samples: &'a [Sample], cases: &[usize], count: usize) -> Vec<&'a Sample> {
    let step = (cases.len() / count).max(1);
    let chosen: Vec<usize> = cases.iter().step_by(step).take(count).copied().collect();
    samples.iter().filter(|sample| chosen.contains(&sample.case)).collect()
}

/// The errors of the curves that leave only rounding in all equations, in words.
///
/// The equations of the closest point are left out. A program with wrong curves may take the point from the case, or find
/// it by an iteration with a wrong matrix.
pub(super) fn found(equations: &[Equation], samples: &[Sample], wrong: &[usize]) -> Vec<String> {
    let is_used = |e: &usize| equations[*e].number != CLOSEST_POINT;
    let wrong: Vec<usize> = wrong.iter().copied().filter(is_used).collect();
    let Some(&first) = wrong.first() else { return Vec::new() };
    let points: Vec<Point> = samples.iter().map(Point::new).collect();
    let (cases, _) = judged(&equations[first], &points);
    let shapes = shapes::found(equations, samples, &wrong, &cases);
    if !shapes.is_empty() {
        return shapes;
    }
    let few = some(samples, &cases, 4);
    let every: Vec<&Sample> = samples.iter().collect();
    let others: Vec<usize> = (0..equations.len()).filter(is_used).collect();
    let holds = |input: &Input, samples: &[&Sample], which: &[usize]| {
        let points: Vec<Point> = samples.iter().map(|sample| input.point(sample)).collect();
        which.iter().all(|e| judged(&equations[*e], &points).0.is_empty())
    };
    let is_found = |input: &Input| {
        // Most fail at the first samples.
        [2, 8].iter().all(|count| holds(input, &few[..few.len().min(*count)], &[first]))
            && holds(input, &few, &wrong)
            && holds(input, &every, &others)
    };
    parallel::filter_map(&all(samples), |input| is_found(input).then(|| input.words.clone()))
}
