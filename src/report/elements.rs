//! The record of published elements, `beamgap-elements/1`.

use super::newton::Iterations;
use super::{Environment, Record, ReportError};
use crate::teaching::chains::Problem;
use crate::teaching::published::{self, Published};
use crate::teaching::terms::Tangent;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Published tangents, written anew: their errors, and the iterations of Newton's method with them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Elements {
    /// `beamgap-elements/1`.
    pub schema: String,
    /// The environment of the run.
    pub environment: Environment,
    /// The seed of the pairs.
    pub seed: u64,
    /// The pairs in each state.
    pub pairs: usize,
    /// The elements.
    pub elements: Vec<PublishedElement>,
}

/// A published tangent.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PublishedElement {
    /// Its name.
    pub name: String,
    /// The file and the function of its formulas, and the commit that was read.
    pub source: String,
    /// What its tangent lacks.
    pub lacks: String,
    /// Its errors in each state.
    pub errors: Vec<ElementErrors>,
    /// Newton's method with it, in each problem: the derivative of its own residual, and its tangent.
    pub newton: Vec<ElementRuns>,
}

/// The errors in a state: the median and the largest, relative to the largest entry.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ElementErrors {
    /// The state.
    pub state: String,
    /// Of K, against the derivative of the R of the element.
    pub tangent: [f64; 2],
    /// Of the friction in R, against the mechanics.
    pub residual: [f64; 2],
}

/// Newton's method in a problem.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ElementRuns {
    /// The problem.
    pub problem: String,
    /// With the derivative of the residual of the element.
    pub derivative: Iterations,
    /// With the published tangent.
    pub published: Iterations,
}

impl Record for Elements {
    const SCHEMA: &'static str = "beamgap-elements/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Elements {
    /// Measures the errors, and solves two beam problems.
    pub fn new(seed: u64, pairs: usize, environment: Environment) -> Self {
        let elements = Published::ALL.map(|of| PublishedElement::new(of, seed, pairs)).to_vec();
        Self { schema: Self::SCHEMA.to_owned(), environment, seed, pairs, elements }
    }
}

impl PublishedElement {
    fn new(of: Published, seed: u64, pairs: usize) -> Self {
        let errors = of.states().iter().map(|&state| {
            let published::Errors { tangent, residual, .. } = published::errors(of, state, pairs, seed);
            ElementErrors { state: format!("{state:?}").to_lowercase(), tangent, residual }
        });
        let mu = if of.states().iter().any(|state| state.has_friction()) { 0.3 } else { 0.0 };
        let problems =
            [("crossed beams", Problem::crossed_beams(mu)), ("dragged beam", Problem::dragged_beam(mu))];
        let newton = problems.map(|(name, mut problem)| {
            let (tangent, work) = of.tangent();
            problem.model.parameters.work = work;
            let derivative = Tangent { components: tangent.components, ..Tangent::EXACT };
            // The first two steps of both problems are without contact.
            ElementRuns {
                problem: name.to_owned(),
                derivative: Iterations::of(&problem, OPEN, "derivative of its residual", derivative),
                published: Iterations::of(&problem, OPEN, "as published", tangent),
            }
        });
        Self {
            name: of.name().to_owned(),
            source: of.source().to_owned(),
            lacks: of.lacks().to_owned(),
            errors: errors.collect(),
            newton: newton.to_vec(),
        }
    }
}

/// The steps before contact in both problems.
const OPEN: usize = 2;

/// The pairs in each state.
const PAIRS: usize = 2_000;

/// Measures published elements, and writes `elements.json` and `elements.md` into the directory `to`.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written.
pub fn elements(to: &Path, seed: u64, command: &str) -> Result<Elements, ReportError> {
    let json = Elements::new(seed, PAIRS, Environment::here(command)).to_json()?;
    let record = Elements::from_json(&json)?;
    super::write(to, "elements.json", &json)?;
    super::write(to, "elements.md", &record.page().to_markdown())?;
    Ok(record)
}

#[cfg(test)]
mod tests {
    use super::{OPEN, Problem, Tangent};
    use crate::contact::State;

    #[test]
    fn the_first_steps_are_without_contact() {
        for problem in [Problem::crossed_beams(0.0), Problem::dragged_beam(0.3)] {
            let mut states = Vec::new();
            let mut first = problem;
            first.moves.truncate(OPEN + 1);
            first.solve_each(Tangent::EXACT, |step, _| states.push(step.outcome.state)).unwrap();
            assert_eq!(states, [State::Open, State::Open, State::Frictionless]);
        }
    }
}
