//! Runs of Newton's method over all steps of a beam problem.

use crate::teaching::chains::{Problem, quadratic_factor};
use crate::teaching::terms::Tangent;
use serde::{Deserialize, Serialize};

/// The iterations with one tangent.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Iterations {
    /// The tangent, or the term that it lacks.
    pub tangent: String,
    /// The steps with contact: of the problem with the exact tangent.
    pub steps: usize,
    /// The iterations in each of them that converged.
    pub iterations: Vec<usize>,
    /// Why the next step did not converge.
    pub stopped: Option<String>,
    /// The largest increment over the square of the one before it, one over a length; none if there is no such pair.
    pub quadratic_factor: Option<f64>,
}

/// Increments below this length tell whether convergence is quadratic.
pub(super) const NEAR: f64 = 1e-2;

impl Iterations {
    /// Solves a problem whose first `open` steps are without contact.
    pub(super) fn of(problem: &Problem, open: usize, name: &str, tangent: Tangent) -> Self {
        let mut steps = Vec::new();
        let (mut factor, mut smallest): (f64, f64) = (0.0, f64::INFINITY);
        let solved = problem.solve_each(tangent, |step, _| {
            steps.push((step.residuals.len(), step.converged));
            smallest = step.residuals.iter().copied().fold(f64::INFINITY, f64::min);
            factor = factor.max(quadratic_factor(std::slice::from_ref(step), NEAR, problem.rounding));
        });
        let stopped = match (solved, steps.last()) {
            (Err(error), _) => Some(error.to_string()),
            (Ok(()), Some((iterations, false))) => Some(format!(
                "no convergence in {iterations} iterations; the smallest residual is {smallest:.1e}"
            )),
            _ => None,
        };
        let iterations =
            steps.iter().skip(open).filter(|(_, converged)| *converged).map(|(n, _)| *n).collect();
        // Two significant digits: the others depend on the machine.
        let quadratic_factor = format!("{factor:.1e}").parse().ok().filter(|&factor: &f64| factor > 0.0);
        let steps = problem.moves.len() - open;
        Self { tangent: name.to_owned(), steps, iterations, stopped, quadratic_factor }
    }

    /// The iterations in each step, and none where it did not converge.
    pub(super) fn cells(&self) -> [String; 2] {
        let mut all: Vec<String> = self.iterations.iter().map(ToString::to_string).collect();
        if self.stopped.is_some() {
            all.push("none".to_owned());
        }
        let sum = if self.stopped.is_some() { "none".to_owned() } else { self.sum().to_string() };
        [all.join(" "), sum]
    }

    /// The iterations of all steps.
    pub(super) fn sum(&self) -> usize {
        self.iterations.iter().sum()
    }

    /// The most iterations of a step.
    pub(super) fn most(&self) -> usize {
        self.iterations.iter().copied().max().unwrap_or(0)
    }
}
