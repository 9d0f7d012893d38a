//! The varied state: the exact gap there, and the gaps that the linearization predicts.

use crate::points::Found;
use crate::state::State;
use beamgap::check::CaseData;
use beamgap::closest_point::{Centroid, ClosestPoint, refine};
use beamgap::curve::Geometry;
use beamgap::linearization::Quantity;
use beamgap::test_beam::TestBeam;
use beamgap::variant::Variant;

/// The number of measured steps: powers of two from 1 downwards.
const STEPS: i32 = 18;
/// The largest step for the rate. Longer steps may not show it.
const SHORT: f64 = 0.125;
/// Errors below this number of units in the last place are rounding errors.
const ROUNDING: f64 = 1e3;
/// The minimum rate of convergence in the Taylor test: the mean of the rates 2 and 3.
const RATE: f64 = 2.5;

/// The state at the step.
pub(crate) struct Varied {
    /// Both centroids.
    pub(crate) centroids: [Box<dyn Centroid>; 2],
    /// The new closest point; nothing if a step does not find it.
    pub(crate) point: Option<ClosestPoint>,
}

impl Varied {
    /// Both beams at the new closest point.
    pub(crate) fn geometry(&self) -> Option<[Geometry<f64>; 2]> {
        let point = self.point.as_ref()?;
        let [beam, bar] = &self.centroids;
        Some([beam.geometry(point.xi), bar.geometry(point.xi_bar)])
    }
}

impl std::fmt::Debug for Varied {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Varied").field("point", &self.point).finish_non_exhaustive()
    }
}

/// One step, the gap there, and the predictions by the variations of first and of second order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    pub(crate) step: f64,
    pub(crate) gap: f64,
    pub(crate) predicted: [f64; 2],
}

/// Predictions along one direction.
#[derive(Clone, Debug)]
pub(crate) struct Prediction {
    /// The gap and its variations: of first order, and of second order with two equal directions.
    pub(crate) derivatives: [f64; 3],
    /// The samples at steps from small to large, as far as the closest point could be followed.
    pub(crate) samples: Vec<Sample>,
    /// The sample at the step of the state.
    pub(crate) here: Option<Sample>,
}

/// The beams moved along the direction.
fn moved(case: &CaseData, state: &State, step: f64) -> Option<[Box<dyn Centroid>; 2]> {
    let moved = |test_beam: &TestBeam| {
        let along = if state.along_linear { &test_beam.linear_dq } else { &test_beam.dq };
        let q = test_beam.q.iter().zip(along).map(|(q, along)| q + step * along).collect();
        TestBeam { q, ..test_beam.clone() }.centroid().ok()
    };
    let [beam, bar] = &case.test_beams;
    Some([moved(beam)?, moved(bar)?])
}

/// Follows the closest point to the state at the step; nothing if the step is zero.
pub(crate) fn varied(case: &CaseData, state: &State, found: &Found) -> Option<Varied> {
    if state.step == 0.0 {
        return None;
    }
    let mut at = (found.point.xi, found.point.xi_bar);
    let mut point = None;
    // Eight steps are used, so that a large variation does not lead to another point.
    for part in 1..=8 {
        let centroids = moved(case, state, state.step * f64::from(part) / 8.0)?;
        point = refine(&*centroids[0], &*centroids[1], at, found.point.held()).ok();
        match point {
            Some(point) => at = (point.xi, point.xi_bar),
            None => break,
        }
    }
    Some(Varied { centroids: moved(case, state, state.step)?, point })
}

/// The case with both directions alike: the one along which the beams are varied.
pub(crate) fn alike(case: &CaseData, state: &State) -> CaseData {
    let mut alike = case.clone();
    for test_beam in &mut alike.test_beams {
        if state.along_linear {
            test_beam.dq.clone_from(&test_beam.linear_dq);
        } else {
            test_beam.linear_dq.clone_from(&test_beam.dq);
        }
    }
    alike
}

/// Compares the gap with its predictions; nothing if the gap has no derivatives.
pub(crate) fn predict(
    case: &CaseData,
    state: &State,
    variant: &Variant,
    found: &Found,
    varied: Option<&Varied>,
) -> Option<Prediction> {
    let components = alike(case, state).vary(variant, &found.point).ok()?.ok()?;
    let place = (0..components.len()).find(|&i| Quantity::of_component(i) == Quantity::GN)?;
    let of = components[place];
    let radii = case.contact.radius + case.contact.radius_bar;
    let gap = found.point.distance - radii;
    let sample = |step: f64, point: &ClosestPoint| {
        let first = gap + step * of.delta;
        Sample {
            step,
            gap: point.distance - radii,
            predicted: [first, first + 0.5 * step * step * of.second],
        }
    };
    let mut at = (found.point.xi, found.point.xi_bar);
    let mut samples = Vec::new();
    for step in (0..STEPS).rev().map(|power| 0.5_f64.powi(power)) {
        let Some(point) = moved(case, state, step)
            .and_then(|[beam, bar]| refine(&*beam, &*bar, at, found.point.held()).ok())
        else {
            break;
        };
        at = (point.xi, point.xi_bar);
        samples.push(sample(step, &point));
    }
    let here = varied.and_then(|varied| varied.point.as_ref()).map(|point| sample(state.step, point));
    Some(Prediction { derivatives: [gap, of.delta, of.second], samples, here })
}

impl Sample {
    /// The errors of both predictions.
    pub(crate) fn errors(&self) -> [f64; 2] {
        self.predicted.map(|predicted| (predicted - self.gap).abs())
    }
}

impl Prediction {
    /// The order of the error of a prediction in the step; nothing if the error is rounding.
    pub(crate) fn rate(&self, order: usize) -> Option<f64> {
        let size =
            self.samples.iter().fold(self.derivatives[0].abs(), |size, sample| size.max(sample.gap.abs()));
        let clear = |sample: &&Sample| {
            sample.step <= SHORT && sample.errors()[order] > ROUNDING * f64::EPSILON * size
        };
        // The smallest steps whose error is more than rounding.
        let mut clear = self.samples.iter().filter(clear).take(4);
        let first = clear.next()?;
        let last = clear.last()?;
        let ratio = last.errors()[order] / first.errors()[order];
        Some(ratio.log2() / (last.step / first.step).log2())
    }

    /// Whether the errors of the second-order prediction decrease at the required rate.
    pub(crate) fn passes(&self) -> bool {
        self.rate(1).is_none_or(|rate| rate > RATE)
    }
}
