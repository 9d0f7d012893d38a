//! The equilibrium of two beams that are pushed into each other, by Newton's method.

use super::contact::{Tangent, contact};
use super::elastic::{Beam, DOFS, FREE, Material};
use crate::closest_point::{ClosestPoint, ProjectionError};
use crate::curve::Hermite;
use crate::pair::{Contact, DofVector, Pair};
use nalgebra::{SMatrix, SVector};

/// The unknowns: the dofs of the two free ends.
const UNKNOWNS: usize = 2 * FREE;

/// Two cantilevers that just touch while they are straight. The clamp of the bar beam is then pushed down in steps.
///
/// The contact stays closed: the same penalty pulls back an iterate that separates the beams. At
/// equilibrium the beams press, and no switch between open and closed disturbs the iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// The beam and the bar beam.
    pub beams: [Beam; 2],
    /// The penalty eps, a force over a length.
    pub penalty: f64,
    /// The total displacement of the clamp of the bar beam, a length.
    pub push: f64,
    /// The number of steps.
    pub steps: usize,
    /// The ratio of the residual to the first residual of a step at which the iteration ends.
    pub tolerance: f64,
    /// The maximum number of iterations in a step.
    pub iterations: usize,
}

/// One iterate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Iterate {
    /// The length of the residual over that of the first residual.
    pub residual: f64,
    /// The gap g_N.
    pub gap: f64,
    /// The parameters of the closest point.
    pub at: (f64, f64),
}

/// The end of the iteration.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// The iterates, starting from the straight beams.
    pub iterates: Vec<Iterate>,
    /// The dofs of the last iterate.
    pub q: DofVector<f64, DOFS, DOFS>,
    /// The reason why it ended before the tolerance was reached, if it did.
    pub stopped: Option<String>,
}

impl Equilibrium {
    /// Whether the tolerance was reached.
    pub fn converged(&self) -> bool {
        self.stopped.is_none()
    }

    /// The number of solved linear systems.
    pub fn iterations(&self) -> usize {
        self.iterates.len().saturating_sub(1)
    }
}

impl Default for Problem {
    /// Two crossing beams of length 2, thick and soft, so that the change of the tangents matters.
    fn default() -> Self {
        let material = Material { axial: 100.0, bending: 1.0, radius: 0.4 };
        let beam = Beam::between([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], material);
        let bar = Beam::between([0.1, -1.1, 0.8], [0.6, 0.9, 0.8], material);
        Self { beams: [beam, bar], penalty: 10.0, push: 0.8, steps: 8, tolerance: 1e-12, iterations: 60 }
    }
}

impl Problem {
    /// The pair of curves with the radii of the beams.
    pub fn pair(&self) -> Pair<Hermite, Hermite, DOFS, DOFS> {
        let [radius, radius_bar] = self.beams.each_ref().map(|beam| beam.material.radius);
        let contact = Contact { radius, radius_bar, ..Contact::default() };
        Pair::new(Hermite::new(), Hermite::new()).with_contact(contact)
    }

    /// The straight beams.
    pub fn start(&self) -> DofVector<f64, DOFS, DOFS> {
        let [beam, bar] = self.beams.each_ref().map(|beam| beam.reference);
        DofVector { beam, bar }
    }

    /// Solves all steps except the last with the exact tangent, and the last step with this tangent.
    pub fn solve(&self, tangent: Tangent) -> Equilibrium {
        let mut q = self.start();
        for _ in 1..self.steps {
            let found = self.step(q, Tangent::Exact);
            if !found.converged() {
                return found;
            }
            q = found.q;
        }
        self.step(q, tangent)
    }

    /// One step from an equilibrium. The clamp is moved. Then Newton's method iterates until the residual is small, the
    /// iteration fails, or the limit of iterations is reached.
    pub fn step(&self, mut q: DofVector<f64, DOFS, DOFS>, tangent: Tangent) -> Equilibrium {
        let pair = self.pair();
        q.bar[2] -= self.push / count(self.steps);
        let mut found = Equilibrium { iterates: Vec::new(), q, stopped: None };
        let mut first = None;
        loop {
            let point = match Self::closest(&pair, &found) {
                Ok(point) => point,
                Err(error) => return Equilibrium { stopped: Some(error.to_string()), ..found },
            };
            // mark: newton
            let (residual, stiffness, gap) = self.system(&pair, &found.q, &point, tangent);
            let scale = *first.get_or_insert(residual.norm());
            let relative = residual.norm() / scale;
            found.iterates.push(Iterate { residual: relative, gap, at: (point.xi, point.xi_bar) });
            if relative <= self.tolerance {
                return found;
            }
            let step = stiffness.lu().solve(&-residual);
            // end: newton
            let stopped = match &step {
                None => Some("the tangent is singular".to_owned()),
                _ if found.iterations() < self.iterations => None,
                _ => Some(format!("the residual is not small after {} iterations", self.iterations)),
            };
            let (Some(step), None) = (step, &stopped) else { return Equilibrium { stopped, ..found } };
            for i in 0..FREE {
                found.q.beam[DOFS - FREE + i] += step[i];
                found.q.bar[DOFS - FREE + i] += step[FREE + i];
            }
        }
    }

    /// The nearest closest point inside both beams.
    fn closest(
        pair: &Pair<Hermite, Hermite, DOFS, DOFS>,
        found: &Equilibrium,
    ) -> Result<ClosestPoint, ProjectionError> {
        Ok(*pair.closest_points(&found.q)?.interior()?)
    }

    /// The residual of the free dofs, its tangent, and the gap.
    pub fn system(
        &self,
        pair: &Pair<Hermite, Hermite, DOFS, DOFS>,
        q: &DofVector<f64, DOFS, DOFS>,
        point: &ClosestPoint,
        tangent: Tangent,
    ) -> (SVector<f64, UNKNOWNS>, SMatrix<f64, UNKNOWNS, UNKNOWNS>, f64) {
        let [beam, bar] = &self.beams;
        let elastic = [beam.forces(&q.beam), bar.forces(&q.bar)];
        let added = contact(pair, q, point, self.penalty, tangent);
        let dof = |i: usize| if i < FREE { DOFS - FREE + i } else { DOFS + i };
        let residual = SVector::from_fn(|i, _| {
            let own = if i < FREE { elastic[0][dof(i)] } else { elastic[1][dof(i) - DOFS] };
            own + added.force.entry(dof(i))
        });
        let stiffness = SMatrix::from_fn(|i, j| {
            let own = match (i < FREE, j < FREE) {
                (true, true) => beam.stiffness()[(dof(i), dof(j))],
                (false, false) => bar.stiffness()[(dof(i) - DOFS, dof(j) - DOFS)],
                _ => 0.0,
            };
            own + added.stiffness.entry(dof(i), dof(j))
        });
        (residual, stiffness, added.gap)
    }
}

/// A small count as a number.
#[expect(clippy::cast_precision_loss, reason = "a number of steps, far below 2^53")]
fn count(n: usize) -> f64 {
    n as f64
}
