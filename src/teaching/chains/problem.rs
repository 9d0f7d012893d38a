//! Beam problems with reference values.

use super::{Chain, Gauss, Model, ModelError, State, Step, order};
use crate::contact::{Law, Parameters};
use crate::teaching::Material;
use crate::teaching::terms::Tangent;
use nalgebra::{DVector, Vector3};

/// A model and the way in which given dofs are moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// The model.
    pub model: Model,
    /// The increments of given dofs in each step.
    pub moves: Vec<Vec<(usize, f64)>>,
    /// The displacement of a node, a length, up to which increments of Newton's method are rounding.
    pub rounding: f64,
}

impl Problem {
    /// Crossed beams. A beam along y, clamped at both ends, is lifted by a bar beam along x that is clamped at its far end.
    /// The clamp is moved by (0.03, 0, 0.3) in each of six steps, from below. Contact begins in step 3.
    ///
    /// Units are free, for instance N and m: E = 1e8, A = 4e-2, I = 2e-4, radii 0.2, penalties 1e4.
    pub fn crossed_beams(mu: f64) -> Self {
        let material = Material { axial: 1e8 * 4e-2, bending: 1e8 * 2e-4, radius: 0.2 };
        let rule = Gauss::Three;
        let beam = Chain {
            start: Vector3::new(4.0, 0.0, 1.0),
            end: Vector3::new(4.0, 10.0, 1.0),
            elements: 20,
            material,
            rule,
            first: 0,
        };
        let bar = Chain {
            start: Vector3::new(0.0, 5.0, 0.0),
            end: Vector3::new(14.0, 5.0, 0.0),
            elements: 28,
            first: beam.dofs(),
            ..beam
        };
        let mut given = Vec::new();
        for (clamp, along) in [(beam.node(0), 1), (beam.node(20), 1), (bar.node(28), 0)] {
            given.extend(clamped(clamp, along));
        }
        let clamp = bar.node(28);
        let parameters = Parameters::with_friction(Law::Linear { eps: 1e4 }, 1e4, mu);
        let model = Model {
            chains: [beam, bar],
            parameters,
            given,
            tolerance: 5e-7,
            precision: 1e-11,
            iterations: 40,
        };
        let moves = vec![vec![(clamp, 0.03), (clamp + 2, 0.3)]; 6];
        Self { model, moves, rounding: 1e-13 }
    }

    /// Crossing centroids. A rigid bar is pressed across a thin cantilever, so far that the centroids pass through each other.
    /// Contact begins in step 4 of 5.
    pub fn crossing_centroids(elements: usize) -> Self {
        let inertia: f64 = 8.333_333_333_3e-18;
        let material = Material {
            axial: 1e9 * 1e-8,
            bending: 1e9 * inertia,
            radius: (4.0 * inertia / std::f64::consts::PI).powf(0.25),
        };
        let beam = Chain {
            start: Vector3::zeros(),
            end: Vector3::new(1.0, 0.0, 0.0),
            elements,
            material,
            rule: Gauss::Six,
            first: 0,
        };
        let bar = Chain {
            start: Vector3::new(0.4, 0.1, -0.5),
            end: Vector3::new(0.4, 0.1, 0.5),
            elements: 1,
            first: beam.dofs(),
            ..beam
        };
        let mut given: Vec<usize> = clamped(beam.node(0), 0).collect();
        for node in 1..=elements {
            given.extend([beam.node(node) + 2, beam.node(node) + 5]);
        }
        given.extend(bar.first..bar.first + bar.dofs());
        let mut parameters = Parameters::frictionless(Law::Linear { eps: 1e-5 });
        // The bar passes through the beam within a step: the side is known from before.
        parameters.normal_memory = f64::INFINITY;
        let model = Model {
            chains: [beam, bar],
            parameters,
            given,
            tolerance: 2e-13,
            precision: 1e-11,
            iterations: 40,
        };
        let moves = vec![vec![(bar.node(0) + 1, -0.031), (bar.node(1) + 1, -0.031)]; 5];
        Self { model, moves, rounding: 1e-10 }
    }

    /// The order of convergence of each step, from its last three norms in double-double.
    ///
    /// # Errors
    /// Those of [`Model::step`].
    pub fn orders(&self) -> Result<Vec<Option<f64>>, ModelError> {
        let mut state = self.model.reference();
        let of_step = |moves: &Vec<(usize, f64)>| {
            let before = state.clone();
            let step = self.model.step(&mut state, moves, Tangent::EXACT)?;
            // Two more have twice and four times the digits of f64: the last one is rounding.
            let norms = self.model.precise_norms(&before, moves, step.increments.len() + 1)?;
            Ok(order(&norms))
        };
        self.moves.iter().map(of_step).collect()
    }

    /// Solves all steps and returns them with the last dofs. A step that does not converge is the last one.
    ///
    /// # Errors
    /// Those of [`Model::step`].
    pub fn solve(&self, tangent: Tangent) -> Result<(Vec<Step>, DVector<f64>), ModelError> {
        let (mut steps, mut last) = (Vec::new(), self.model.reference().u);
        self.solve_each(tangent, |step, state| {
            steps.push(step.clone());
            last.clone_from(&state.u);
        })?;
        Ok((steps, last))
    }

    /// Solves all steps and calls `each` with every step and the last equilibrium. A step that does not converge is the last
    /// one.
    ///
    /// # Errors
    /// Those of [`Model::step`].
    pub fn solve_each(
        &self,
        tangent: Tangent,
        mut each: impl FnMut(&Step, &State),
    ) -> Result<(), ModelError> {
        let mut state = self.model.reference();
        for moves in &self.moves {
            let step = self.model.step(&mut state, moves, tangent)?;
            each(&step, &state);
            if !step.converged {
                break;
            }
        }
        Ok(())
    }
}

/// The given dofs of a clamp: the point, and the tangent across the beam's direction. The tangent may stretch.
fn clamped(node: usize, along: usize) -> impl Iterator<Item = usize> {
    (0..6).filter(move |&i| i != 3 + along).map(move |i| node + i)
}
