//! The pairs that finite differences need: both beams moved along the directions, at their closest points.

use crate::closest_point::{ClosestPoint, refine};
use crate::linearization::closed_form::PartialVariations;
use crate::test_beam::TestBeam;
use crate::variant::Step;

/// The steps of pyadjoint.
pub(super) const TAYLOR: [f64; 4] = [0.01, 0.005, 0.0025, 0.00125];
/// The steps of the others, forwards and backwards: torch, jax, and scipy forwards.
pub(super) const STEPS: [f64; 5] = [1e-6, -1e-6, 5e-5, -5e-5, 1.490_116_119_384_765_6e-8];

/// Both moved beams at their closest point, and the values that replace operands there.
pub(super) type Moved = Option<((f64, f64), [[PartialVariations<f64>; 2]; 3])>;

/// All points at which the tools evaluate the closed form.
pub(super) struct Steps {
    /// The largest entries of delta q and Delta q.
    pub(super) units: [f64; 2],
    /// The unmoved beams, with delta q as both directions.
    pub(super) twice: Moved,
    /// The beams moved along delta q and along Delta q.
    pub(super) moved: [[Moved; STEPS.len()]; 2],
    /// The beams moved along delta q.
    pub(super) taylor: [Moved; TAYLOR.len()],
}

impl Steps {
    pub(super) fn new(test_beams: &[TestBeam; 2], point: &ClosestPoint) -> Self {
        let largest = |of: fn(&TestBeam) -> &Vec<f64>| {
            let entries = test_beams.iter().flat_map(|test_beam| of(test_beam).iter());
            entries.fold(0.0_f64, |largest, entry| largest.max(entry.abs()))
        };
        let units = [largest(|test_beam| &test_beam.dq), largest(|test_beam| &test_beam.linear_dq)];
        let moved = |direction: usize, step: f64| {
            let along = |test_beam: &TestBeam| {
                let by = if direction == 0 { &test_beam.dq } else { &test_beam.linear_dq };
                let moved = test_beam.q.iter().zip(by).map(|(q, by)| q + step / units[direction] * by);
                TestBeam { q: moved.collect(), ..test_beam.clone() }
            };
            solved(&test_beams.each_ref().map(along), point)
        };
        let twice = test_beams
            .each_ref()
            .map(|test_beam| TestBeam { linear_dq: test_beam.dq.clone(), ..(*test_beam).clone() });
        Self {
            units,
            twice: solved(&twice, point),
            moved: [0, 1].map(|direction| STEPS.map(|step| moved(direction, step))),
            taylor: TAYLOR.map(|step| moved(0, step)),
        }
    }
}

/// The closest point of moved beams, near that of the original beams.
fn solved(test_beams: &[TestBeam; 2], point: &ClosestPoint) -> Moved {
    let [beam, bar] = test_beams.each_ref().map(|test_beam| test_beam.beam().ok());
    let (beam, bar) = (beam?, bar?);
    let found = refine(&*beam, &*bar, (point.xi, point.xi_bar), point.held()).ok()?;
    let at = (found.xi, found.xi_bar);
    let partial = |step: Step| {
        let ([beam, bar], (xi, xi_bar)) = step.place([&*beam, &*bar], at);
        [beam.partial_variations_plain(xi), bar.partial_variations_plain(xi_bar)]
    };
    Some((at, Step::ALL.map(partial)))
}
