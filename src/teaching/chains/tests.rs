//! Tests of the element, and of the problems against published figures.

use super::{Density, Problem, Step, density, quadratic_factor};
use crate::contact::State;
use crate::number::Real;
use crate::teaching::Material;
use crate::teaching::terms::{Tangent, Term};
use nalgebra::Vector3;
use num_dual::HyperDual64;

/// The energy by its definition: the curvature is a vector, not a square.
fn by_definition<T: Real>(a: &Vector3<T>, b: &Vector3<T>, material: &Material) -> T {
    let length = a.dot(a).sqrt();
    let strain = length - T::one();
    let curvature = a.cross(b) / (length * length);
    let (axial, bending) = (T::from(material.axial), T::from(material.bending));
    (strain * strain * axial + curvature.dot(&curvature) * bending) * T::from(0.5)
}

#[test]
fn gradient_and_hessian_of_the_energy_are_its_derivatives_by_hyper_dual_numbers() {
    let material = Material { axial: 7.0, bending: 3.0, radius: 0.1 };
    let ab = [0.9, 0.4, -0.3, 0.2, -0.7, 0.5];
    let (a, b) = (Vector3::new(ab[0], ab[1], ab[2]), Vector3::new(ab[3], ab[4], ab[5]));
    let Density { value, gradient, hessian } = density(&a, &b, &material);
    for i in 0..6 {
        for j in 0..6 {
            let one = |is: bool| if is { 1.0 } else { 0.0 };
            let number = |k: usize| HyperDual64::new(ab[k], one(k == i), one(k == j), 0.0);
            let [a, b] = [0, 3].map(|k| Vector3::new(number(k), number(k + 1), number(k + 2)));
            let expected = by_definition(&a, &b, &material);
            let near = |one: f64, other: f64| (one - other).abs() < 1e-13 * material.axial;
            assert!(near(value, expected.re));
            assert!(near(gradient[i / 3][i % 3], expected.eps1), "{i}");
            assert!(near(hessian[i / 3][j / 3][(i % 3, j % 3)], expected.eps1eps2), "{i} {j}");
        }
    }
}

/// Newton's method converges with an order of at least 1.9 in each of these steps.
fn assert_quadratic(problem: &Problem, steps: std::ops::RangeFrom<usize>) {
    let orders = problem.orders().unwrap();
    assert!(orders[steps].iter().all(|order| order.is_some_and(|order| order >= 1.9)), "{orders:.2?}");
}

/// The tip of the beam as the solver 4C prints it, to ten digits: 10 elements, 6 Gauss points.
#[test]
fn centroids_that_cross_end_where_another_code_has_them() {
    let problem = Problem::crossing_centroids(10);
    let (steps, u) = problem.solve(Tangent::EXACT).unwrap();
    assert!(steps.iter().all(|step| step.converged));
    assert_quadratic(&problem, 3..);
    let values = &steps[4].outcome.values;
    assert!(values.g_n + 2.0 * problem.model.chains[0].material.radius < 0.0, "the centroids have crossed");
    assert!((u[60] - 1.0 + 1.612_712_684_34e-2).abs() < 1e-12, "{:.12e}", u[60] - 1.0);
    assert!((u[61] + 1.715_218_089_885e-1).abs() < 1e-12, "{:.12e}", u[61]);
}

/// F_N of the elastica of both beams, by `tests/golden/elastica.py`: computed without finite elements.
#[test]
fn crossed_beams_have_the_forces_of_the_elastica() {
    let problem = Problem::crossed_beams(0.0);
    let (steps, _) = problem.solve(Tangent::EXACT).unwrap();
    assert!(steps.iter().all(|step| step.converged));
    for (step, expected) in steps[2..].iter().zip([17.20535, 34.11287, 50.60173, 66.56025]) {
        let f_n = step.outcome.values.f_n;
        assert!((f_n / expected - 1.0).abs() < 1e-5, "{f_n}");
    }
    assert_quadratic(&problem, 2..);
}

/// With friction the beams slip from the step after the first contact on. F_N is that of the elastica, by the same program.
#[test]
fn crossed_beams_slip_with_friction() {
    let problem = Problem::crossed_beams(0.3);
    let (steps, _) = problem.solve(Tangent::EXACT).unwrap();
    assert!(steps.iter().all(|step| step.converged));
    for (step, expected) in steps[3..].iter().zip([33.37449, 49.39758, 64.83582]) {
        let values = &step.outcome.values;
        assert!((values.f_n / expected - 1.0).abs() < 1e-5, "{}", values.f_n);
        assert!((values.f_bar / values.f_n + 0.3).abs() < 1e-6, "{}", values.f_bar);
    }
    assert_quadratic(&problem, 3..);
}

/// The bar beam sticks, slips over four nodes of the arch, sticks when it turns back, and slips again.
#[test]
fn a_dragged_beam_sticks_slips_past_elements_and_turns_back() {
    let problem = Problem::dragged_beam(0.3);
    let (steps, _) = problem.solve(Tangent::EXACT).unwrap();
    assert!(steps.len() == problem.moves.len() && steps.iter().all(|step| step.converged));
    let mut states: Vec<State> = steps.iter().map(|step| step.outcome.state).collect();
    states.dedup();
    let expected = [State::Open, State::Frictionless, State::Stick, State::Slip, State::Stick, State::Slip];
    assert_eq!(states, expected);
    let mut owners: Vec<usize> = steps[4..27].iter().map(|step| step.place.owner[0]).collect();
    owners.dedup();
    assert_eq!(owners, [6, 7, 8, 9, 10]);
    assert_quadratic(&problem, 0..);
    // The cone, and a factor of the squared increment: EA/EI times a unit of length bounds what bending adds to the strain.
    for step in &steps {
        let values = &step.outcome.values;
        assert!(values.traction.norm() <= 0.3 * values.f_n * (1.0 + 1e-9));
    }
    let material = problem.model.chains[0].material;
    let quadratic = |steps: &[Step]| quadratic_factor(steps, 1e-2, problem.rounding);
    assert!(quadratic(&steps) < material.axial / material.bending, "{}", quadratic(&steps));
    // A tangent that misses a term converges linearly.
    let (steps, _) = problem.solve(Tangent::EXACT.without(Term::Stretch)).unwrap();
    assert!(quadratic(&steps) > 1e2 * material.axial / material.bending, "{}", quadratic(&steps));
}
