//! The record of the beam problems, `beamgap-beam-problems/1`.

use super::newton::Iterations;
use super::{Environment, Record, ReportError};
use crate::contact::State;
use crate::teaching::chains::{self, Chain, Problem};
use crate::teaching::terms::{Tangent, Term};
use nalgebra::DVector;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Newton's method in beam problems, with the exact tangent and without single terms.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BeamProblems {
    /// `beamgap-beam-problems/1`.
    pub schema: String,
    /// The environment of the run.
    pub environment: Environment,
    /// The problems.
    pub problems: Vec<BeamProblem>,
}

/// A beam problem.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BeamProblem {
    /// Its name.
    pub name: String,
    /// The coefficient of friction.
    pub mu: f64,
    /// EA/EI of the beams, one over a length squared.
    pub stiffness: f64,
    /// Whether the beam is above the bar beam where they are in contact.
    pub beam_is_above: bool,
    /// The steps with the exact tangent.
    pub steps: Vec<BeamStep>,
    /// The least order of convergence of a step.
    pub order: Option<f64>,
    /// The displacement of the tip of the beam, lengths, if it is free.
    pub tip: Option<[f64; 3]>,
    /// The iterations with the exact tangent, and without single terms.
    pub runs: Vec<Iterations>,
    /// One step that begins at the exact equilibrium before it, with each tangent.
    pub convergence: Vec<Convergence>,
    /// Drawn states.
    pub shapes: Vec<Shape>,
}

/// A step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BeamStep {
    /// The state of the contact.
    pub state: String,
    /// F_N, a force.
    pub f_n: f64,
    /// |T|/F_N; 0 if open.
    pub friction: f64,
    /// The elements of both beams in contact.
    pub owner: [usize; 2],
    /// The order of convergence, if there are enough iterations.
    pub order: Option<f64>,
    /// The length of the residual of each iterate, a force.
    pub residuals: Vec<f64>,
}

/// Newton's method in one step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Convergence {
    /// The step, counted from 1.
    pub step: usize,
    /// The term that the tangent lacks.
    pub left_out: String,
    /// The length of the residual of each iterate, a force.
    pub residuals: Vec<f64>,
}

/// Both centroids after a step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// The step; 0 is the reference.
    pub step: usize,
    /// Points along both beams.
    pub beams: [Vec<[f64; 3]>; 2],
}

impl Record for BeamProblems {
    const SCHEMA: &'static str = "beamgap-beam-problems/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

/// The name of the tangent that lacks nothing.
pub(super) const NOTHING: &str = "nothing";

impl BeamProblems {
    /// Solves the problems.
    ///
    /// # Errors
    /// [`ReportError::Unsolved`] if the exact tangent does not solve one.
    pub fn new(environment: Environment) -> Result<Self, ReportError> {
        let problems = [
            BeamProblem::new("Crossed beams", &Problem::crossed_beams(0.0), None, &[])?,
            BeamProblem::new("Crossed beams with friction", &Problem::crossed_beams(0.3), Some(6), &[0, 6])?,
            BeamProblem::new("Crossing centroids", &Problem::crossing_centroids(10), None, &[])?,
            BeamProblem::new("Dragged beam", &Problem::dragged_beam(0.3), Some(20), &[2, 4, 27])?,
        ];
        Ok(Self { schema: Self::SCHEMA.to_owned(), environment, problems: problems.to_vec() })
    }
}

impl BeamProblem {
    /// Solves a problem. `compared` is the step in which tangents are compared, and `drawn` are the steps that are drawn.
    fn new(
        name: &str,
        problem: &Problem,
        compared: Option<usize>,
        drawn: &[usize],
    ) -> Result<Self, ReportError> {
        let unsolved = |what: String| ReportError::Unsolved { problem: name.to_owned(), what };
        let (mut steps, mut states) = (Vec::new(), vec![problem.model.reference()]);
        let solved = problem.solve_each(Tangent::EXACT, |step, state| {
            steps.push(step.clone());
            states.push(state.clone());
        });
        solved.map_err(|error| unsolved(error.to_string()))?;
        if steps.iter().any(|step| !step.converged) {
            return Err(unsolved(format!("no convergence in step {}", steps.len())));
        }
        let orders = problem.orders().map_err(|error| unsolved(error.to_string()))?;
        let open = steps.iter().take_while(|step| step.outcome.state == State::Open).count();
        let tangents = || {
            let left_out =
                Term::of_rate().filter(|term| problem.model.parameters.mu > 0.0 || !term.is_of_friction());
            let without = left_out.map(|term| (term.name(), Tangent::EXACT.without(term)));
            std::iter::once((NOTHING, Tangent::EXACT)).chain(without)
        };
        let runs = tangents().map(|(name, tangent)| Iterations::of(problem, open, name, tangent)).collect();
        let convergence = compared.into_iter().flat_map(|step| {
            let states = &states;
            tangents().filter_map(move |(name, tangent)| {
                let mut state = states[step - 1].clone();
                // A step that ends with an error has no residuals.
                let found = problem.model.step(&mut state, &problem.moves[step - 1], tangent).ok()?;
                Some(Convergence { step, left_out: name.to_owned(), residuals: found.residuals })
            })
        });
        let convergence = convergence.collect();
        let beam = &problem.model.chains[0];
        let last = &states[states.len() - 1].u;
        let tip_node = beam.node(beam.elements);
        let tip = (last.fixed_rows::<3>(tip_node) - beam.end).into();
        let is_free = !problem.model.given.contains(&tip_node);
        let shape = |&step: &usize| Shape {
            step,
            beams: problem.model.chains.each_ref().map(|chain| points(chain, &states[step].u)),
        };
        Ok(Self {
            name: name.to_owned(),
            mu: problem.model.parameters.mu,
            beam_is_above: steps.last().is_some_and(|step| step.outcome.values.normal.z > 0.0),
            stiffness: beam.material.axial / beam.material.bending,
            order: orders.iter().copied().flatten().min_by(f64::total_cmp),
            steps: steps.iter().zip(orders).map(|(step, order)| BeamStep::new(step, order)).collect(),
            tip: is_free.then_some(tip),
            runs,
            convergence,
            shapes: drawn.iter().map(shape).collect(),
        })
    }
}

impl BeamStep {
    fn new(step: &chains::Step, order: Option<f64>) -> Self {
        let values = &step.outcome.values;
        Self {
            state: format!("{:?}", step.outcome.state).to_lowercase(),
            f_n: values.f_n,
            friction: if values.f_n > 0.0 { values.traction.norm() / values.f_n } else { 0.0 },
            owner: step.place.owner,
            order,
            residuals: step.residuals.clone(),
        }
    }
}

/// Points along a beam, four in each element, to three decimals.
fn points(chain: &Chain, u: &DVector<f64>) -> Vec<[f64; 3]> {
    let at = |element, xi| {
        let x = chain.geometry(u, element, xi).x;
        [x.x, x.y, x.z].map(|x| (1e3 * x).round() / 1e3)
    };
    let inner = |element| [-1.0, -0.5, 0.0, 0.5].map(|xi| at(element, xi));
    let last = at(chain.elements - 1, 1.0);
    (0..chain.elements).flat_map(inner).chain([last]).collect()
}

/// Solves the beam problems, and writes `beam-problems.json`, `beam-problems.md` and its pictures into the directory `to`.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written, and those of [`BeamProblems::new`].
pub fn beam_problems(to: &Path, command: &str) -> Result<BeamProblems, ReportError> {
    let json = BeamProblems::new(Environment::here(command))?.to_json()?;
    let record = BeamProblems::from_json(&json)?;
    super::write(to, "beam-problems.json", &json)?;
    super::write(to, "beam-problems.md", &record.page().to_markdown())?;
    for (name, svg) in record.pictures() {
        super::write(to, &name, &svg)?;
    }
    Ok(record)
}
