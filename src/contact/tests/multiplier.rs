//! Rows, columns and tangents are the derivatives, by automatic differentiation.

use super::beams::{Case, HELD, Wish, numbers};
use crate::closest_point::{ClosestPoint, Held};
use crate::contact::multiplier::{Border, Multiplier, friction, write_normal, write_stick};
use crate::contact::{Contribution, Decision, Law, Parameters, State, ad};
use crate::curve::{Hermite, Segment};
use crate::linearization::ad::{Route, expand_by_sweep};
use crate::linearization::closed_form::{Points, jets};
use crate::pair::DofVector;

type Hermites = Case<Hermite, Segment, f64, 12, 6>;
type Dofs = DofVector<f64, 12, 6>;

fn case(held: Held, state: State, seed: u32) -> Hermites {
    let wish = Wish::new(held, state, Law::Linear { eps: 100.0 });
    Case::new(Hermite::new(), Segment::new(), wish, numbers(seed))
}

fn parameters(case: &Hermites, lambda: f64) -> Parameters<Multiplier> {
    let Parameters { eps_t, mu, .. } = case.wish.parameters;
    Parameters::with_friction(Multiplier { lambda, eps: 1.0 }, eps_t, mu)
}

fn decide<'a>(case: &Hermites, parameters: &'a Parameters<Multiplier>) -> Decision<'a, Multiplier> {
    let (jet, jet_bar) = jets(&case.pair, &case.q, case.at);
    let points = Points::new(&jet.geometry, &jet_bar.geometry);
    Decision::new(parameters, case.pair.contact, &points, case.at, case.wish.held, &case.history).unwrap()
}

fn size(v: &Dofs) -> f64 {
    v.beam.amax().max(v.bar.amax())
}

/// The largest difference of two vectors, relative to the second.
fn difference(a: &Dofs, b: &Dofs) -> f64 {
    size(&a.plus(-1.0, b)) / size(b)
}

/// How far the border of lambda is from the derivatives.
fn error_of_lambda(case: &Hermites, lambda: f64, state: State, border: &Border<f64, 12, 6>) -> f64 {
    // R is linear in λ.
    let [low, high] = [lambda, 2.0 * lambda].map(|lambda| {
        let parameters = parameters(case, lambda);
        let decision = decide(case, &parameters).in_state(state, case.at).unwrap();
        ad::residual_and_tangent(&decision, &case.pair, &case.q, case.at).0
    });
    let column = high.plus(-1.0, &low).times(1.0 / lambda);
    let found = case.pair.closest_points(&case.q).unwrap();
    let point = *found
        .minima
        .iter()
        .min_by(|a, b| {
            let way = |p: &&ClosestPoint| (p.xi - case.at.0).hypot(p.xi_bar - case.at.1);
            way(a).total_cmp(&way(b))
        })
        .unwrap();
    let row = if point.held() == case.wish.held {
        let [d] = expand_by_sweep(Route::Newton, &case.pair, &case.q, &point, |of| [of.d]);
        difference(&border.row, &d.gradient.times(-1.0))
    } else {
        0.0
    };
    difference(&border.column, &column).max(row)
}

#[test]
fn the_border_of_lambda_has_the_derivatives() {
    for held in HELD {
        for state in [State::Frictionless, State::Stick, State::Slip] {
            if state.has_friction() && held.xi && held.xi_bar {
                continue;
            }
            let case = case(held, state, 3);
            let lambda = if state == State::Slip { 1.0 } else { 8.0 };
            let parameters = parameters(&case, lambda);
            let decision = decide(&case, &parameters);
            assert_eq!(decision.state, state);
            let mut to = Contribution::<f64, 12, 6>::zeros();
            let (jet, jet_bar) = jets(&case.pair, &case.q, case.at);
            let (values, border) = write_normal(&decision, (&jet, &jet_bar), case.at, &mut to);
            let (residual, tangent) = ad::residual_and_tangent(&decision, &case.pair, &case.q, case.at);
            assert!(difference(&to.residual, &residual) < 1e-13);
            let rest = (to.tangent.to_dense() - tangent.to_dense()).amax();
            assert!(rest < 1e-13 * tangent.to_dense().amax(), "{rest:e}");
            assert!(error_of_lambda(&case, lambda, state, &border) < 1e-12);
            assert_eq!((border.constraint.to_bits(), border.corner), ((-values.g_n).to_bits(), 0.0));
            // In slip the column is not the row: without the part of friction the comparison fails.
            let broken = Border { column: border.row, ..border };
            assert_eq!(error_of_lambda(&case, lambda, state, &broken) > 1e-3, state == State::Slip);
        }
    }
}

#[test]
fn the_borders_of_stick_have_the_derivatives() {
    let case = case(Held::default(), State::Stick, 5);
    let found = case.pair.closest_points(&case.q).unwrap();
    let point = found.interior().unwrap();
    let [d, xi, xi_bar] =
        expand_by_sweep(Route::Newton, &case.pair, &case.q, point, |of| [of.d, of.xi, of.xi_bar]);
    let (lambda, p, p_bar) = (8.0, 0.75, -1.25);
    let parameters = parameters(&case, lambda);
    let decision = decide(&case, &parameters);
    let (jet, jet_bar) = jets(&case.pair, &case.q, case.at);
    let mut to = Contribution::<f64, 12, 6>::zeros();
    let (_, of_lambda, borders) = write_stick(&decision, [p, p_bar], (&jet, &jet_bar), case.at, &mut to);
    let [of_p, of_p_bar] = borders.map(Option::unwrap);
    let residual = d.gradient.times(-lambda).plus(p, &xi.gradient).plus(p_bar, &xi_bar.gradient);
    assert!(difference(&to.residual, &residual) < 1e-12);
    let tangent =
        d.hessian.to_dense() * -lambda + xi.hessian.to_dense() * p + xi_bar.hessian.to_dense() * p_bar;
    let error = |p_bar: f64| {
        let mut to = Contribution::<f64, 12, 6>::zeros();
        write_stick(&decision, [p, p_bar], (&jet, &jet_bar), case.at, &mut to);
        (to.tangent.to_dense() - &tangent).amax() / tangent.amax()
    };
    assert!(error(p_bar) < 1e-12, "{:e}", error(p_bar));
    // A wrong sign of one term is seen.
    assert!(error(-p_bar) > 1e-3);
    assert!(difference(&of_lambda.row, &d.gradient.times(-1.0)) < 1e-12);
    for (border, of, start) in
        [(of_p, &xi, decision.start.unwrap().xi), (of_p_bar, &xi_bar, decision.start.unwrap().xi_bar)]
    {
        assert!(difference(&border.row, &of.gradient) < 1e-12);
        assert_eq!(border.row, border.column);
        assert!((border.constraint - (of.value - start)).abs() < 1e-12);
    }
}

#[test]
fn a_held_parameter_has_no_row_and_an_inactive_contact_has_lambda_alone() {
    for (k, held) in HELD.into_iter().enumerate() {
        let case = case(held, State::Stick, 1);
        let of = |lambda: f64| {
            let parameters = parameters(&case, lambda);
            let decision = decide(&case, &parameters);
            let (jet, jet_bar) = jets(&case.pair, &case.q, case.at);
            let mut to = Contribution::<f64, 12, 6>::zeros();
            let (_, border, rows) = write_stick(&decision, [1.0, 2.0], (&jet, &jet_bar), case.at, &mut to);
            (to, border, rows.map(|row| row.is_some()))
        };
        let (_, _, rows) = of(8.0);
        assert_eq!(rows, if k == 3 { [false; 2] } else { [!held.xi, !held.xi_bar] });
        let (to, border, rows) = of(-8.0);
        let zero = Dofs::zeros();
        assert_eq!((rows, to.residual, border.row, border.column), ([false; 2], zero, zero, zero));
        assert_eq!((border.constraint, border.corner), (-8.0, 1.0));
        assert!(to.tangent.to_dense().iter().all(|entry| entry.abs() < f64::MIN_POSITIVE));
    }
}

#[test]
fn the_size_of_friction_is_that_of_the_vector() {
    // T = a τ − b τ̄ with F = T·τ and F̄ = −T·τ̄.
    let (c, t, t_bar) = (0.6_f64, 2.0, 0.5);
    let (a, b) = (1.5, -0.75);
    let (f, f_bar) = (a - c * b, b - c * a);
    let exact = (a * a + b * b - 2.0 * c * a * b).sqrt();
    assert!((friction(Some(f * t), Some(f_bar * t_bar), (t, t_bar, c)) - exact).abs() < 1e-15);
    assert!((friction(None, Some(-1.0), (t, t_bar, c)) - 2.0).abs() < 1e-15);
}
