//! The record of the page of the derivation: every number on it.

use crate::closest_point::{Held, ProjectionError};
use crate::curve::Segment;
use crate::equations::{StandardCase, Worked};
use crate::linearization::ad::{self, Route};
use crate::linearization::closed_form::{self, Projection, jets};
use crate::pair::{DofVector, Pair};
use crate::report::Record;
use crate::teaching::{Effect, Problem, SELF_CHECKS, SelfCheck, Tangent};
use serde::{Deserialize, Serialize};

/// The numbers of the page of the derivation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Derivation {
    /// `beamgap-derivation/1`.
    pub schema: String,
    /// The command that made it.
    pub command: String,
    /// Every equation in the standard case.
    pub worked: Vec<Worked>,
    /// The pair that is computed by hand.
    pub by_hand: ByHand,
    /// Newton's method with each tangent.
    pub newton: Vec<NewtonRun>,
    /// The effects of the faults of the self-checks.
    pub effects: Vec<Effect>,
    /// Central differences of d in the standard case.
    pub differences: Vec<DifferenceRow>,
    /// The relative differences of delta d and of Delta-delta d between closed form and hyper-dual numbers.
    pub floors: [f64; 2],
}

/// Two segments and the dof z of the end of the beam; all derivatives are in this dof.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ByHand {
    /// xi and xi_bar.
    pub at: [f64; 2],
    /// d.
    pub d: f64,
    /// a, b, a_bar and D.
    pub system: [f64; 4],
    /// The derivatives of xi and xi_bar.
    pub gradients: [f64; 2],
    /// The first and the second derivative of d, in closed form.
    pub derivatives: [f64; 2],
    /// The same by hyper-dual numbers.
    pub by_ad: [f64; 2],
}

/// Newton's method with one tangent.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NewtonRun {
    /// The tangent.
    pub tangent: String,
    /// The residual of each iterate over the first.
    pub residuals: Vec<f64>,
    /// Why it did not converge.
    pub stopped: Option<String>,
}

/// Relative errors of central differences.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct DifferenceRow {
    /// The step.
    pub step: f64,
    /// Of delta d.
    pub first: f64,
    /// Of Delta-delta d.
    pub second: f64,
}

impl Record for Derivation {
    const SCHEMA: &'static str = "beamgap-derivation/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Derivation {
    /// Computes all numbers. `command` is the command that requested them.
    ///
    /// # Errors
    /// None: all closest points exist.
    pub fn compute(command: &str) -> Result<Self, ProjectionError> {
        let case = StandardCase::default();
        let point = case.closest_point()?;
        let StandardCase { pair, q, dq, linear_dq } = &case;
        let exact = ad::vary(Route::Newton, pair, q, &point, dq, linear_dq).d;
        let closed = closed_form::vary(pair, q, &point, dq, linear_dq).d;
        let relative = |x: f64, exact: f64| digits((x - exact).abs() / exact.abs());
        let distance = |delta: f64, linear: f64| -> Result<f64, ProjectionError> {
            let q = case.moved(delta, linear);
            Ok(pair.refine(&q, (point.xi, point.xi_bar), Held::default())?.distance)
        };
        let mut differences = Vec::new();
        for i in 1..=24 {
            let h = 10.0_f64.powf(-f64::from(i) / 3.0);
            let first = (distance(h, 0.0)? - distance(-h, 0.0)?) / (2.0 * h);
            let corners = distance(h, h)? - distance(h, -h)? - distance(-h, h)? + distance(-h, -h)?;
            let row = [relative(first, exact.delta), relative(corners / (4.0 * h * h), exact.second)];
            differences.push(DifferenceRow { step: digits(h), first: row[0], second: row[1] });
        }
        Ok(Self {
            schema: Self::SCHEMA.to_owned(),
            command: command.to_owned(),
            worked: case.worked()?,
            by_hand: ByHand::compute()?,
            newton: Tangent::ALL.map(newton).to_vec(),
            effects: SELF_CHECKS.iter().map(SelfCheck::effect).collect::<Result<_, _>>()?,
            differences,
            floors: [relative(closed.delta, exact.delta), relative(closed.second, exact.second)],
        })
    }
}

/// Two digits, because the others depend on the machine.
fn digits(x: f64) -> f64 {
    format!("{x:.1e}").parse().unwrap_or(f64::INFINITY)
}

fn newton(tangent: Tangent) -> NewtonRun {
    let run = Problem::default().solve(tangent);
    NewtonRun {
        tangent: tangent.name().to_owned(),
        residuals: run.iterates.iter().map(|iterate| digits(iterate.residual)).collect(),
        stopped: run.stopped,
    }
}

impl ByHand {
    /// Two segments, from (-1, 0, 0) to (1, 0, 0) and from (-0.1, -0.8, 0.25) to (1.1, 0.8, 0.25).
    fn compute() -> Result<Self, ProjectionError> {
        let pair = Pair::new(Segment::new(), Segment::new());
        let q: DofVector<f64, 6, 6> =
            ([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0], [-0.1, -0.8, 0.25, 1.1, 0.8, 0.25]).into();
        let point = *pair.closest_points(&q)?.interior()?;
        let (jet, jet_bar) = jets(&pair, &q, (point.xi, point.xi_bar));
        let projection = Projection::new(&jet.geometry, &jet_bar.geometry, point.held());
        let all = pair.linearize(&q, &point);
        // The z of the end of the beam.
        let dof = 5;
        let unit = DofVector::unit(dof);
        let by_ad = ad::vary(Route::Newton, &pair, &q, &point, &unit, &unit).d;
        Ok(Self {
            at: [point.xi, point.xi_bar],
            d: point.distance,
            system: [projection.a, projection.b, projection.a_bar, projection.det()],
            gradients: [all.xi.gradient.entry(dof), all.xi_bar.gradient.entry(dof)],
            derivatives: [all.d.gradient.entry(dof), all.d.hessian.entry(dof, dof)],
            by_ad: [by_ad.delta, by_ad.second],
        })
    }
}
