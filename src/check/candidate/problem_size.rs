//! The size of a problem.

use crate::linearization::{COMPONENTS, Quantity};
use crate::test_beam::TestBeam;

/// The size of a problem. A number that is exactly zero has no size of its own.
#[derive(Clone, Copy, Debug)]
pub(in crate::check) struct ProblemSize {
    /// The largest dof.
    pub(in crate::check) length: f64,
    /// The largest entries of the directions.
    pub(in crate::check) directions: [f64; 2],
    /// The stiffness of a contact element.
    pub(in crate::check) stiffness: f64,
}

impl ProblemSize {
    pub(super) fn new(test_beams: &[TestBeam; 2]) -> Self {
        let largest = |read: fn(&TestBeam) -> &[f64]| {
            let all = test_beams.iter().flat_map(read);
            all.fold(0.0_f64, |largest, number| largest.max(number.abs()))
        };
        let directions = [largest(|beam| &beam.dq), largest(|beam| &beam.linear_dq)];
        Self { length: largest(|beam| &beam.q), directions, stiffness: 1.0 }
    }

    /// The size of part k of an item.
    pub(super) fn of(&self, [item, k]: [usize; 2]) -> f64 {
        let is_parameter = [Quantity::Xi, Quantity::XiBar].map(Quantity::component).contains(&item);
        let size = match item {
            _ if is_parameter => 1.0,
            ..COMPONENTS => self.length,
            COMPONENTS => self.stiffness * self.length * self.length,
            // The forces of a contact element.
            _ => self.stiffness * self.length,
        };
        let [delta, linear] = self.directions.map(|direction| direction / self.length);
        size * [1.0, delta, linear, delta * linear][k]
    }
}
