//! Compares a jet with the derivatives of the position.

use crate::curve::{Curve, DofDerivatives, Geometry};
use crate::linearization::ad::PositionAt;
use crate::linearization::closed_form::PartialVariations;
use crate::number::{Dual, HyperDual};
use crate::test_beam::{AnyBeam, Drawn, RunningError2};
use nalgebra::{SVector, Vector3};
use std::fmt;

type Lifted = Dual<HyperDual<RunningError2>>;
type Vector = Vector3<RunningError2>;

/// The variations by the derivatives in ξ.
const VARIATIONS: [&str; 3] = [
    "variation of x (k = 0), against the derivative of the position",
    "variation of x,xi (k = 1), against the derivative of the position",
    "variation of x,xixi (k = 2), against the derivative of the position",
];

/// A wrong number of a jet.
#[derive(Clone, Debug, PartialEq)]
pub struct JetFinding {
    /// The name of the number.
    pub part: &'static str,
    /// The jet's number.
    pub jet: f64,
    /// The expected number.
    pub other: f64,
    /// The largest difference that rounding explains.
    pub tolerance: f64,
    /// The parameter.
    pub xi: f64,
    /// The dofs.
    pub q: Vec<f64>,
}

impl fmt::Display for JetFinding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { part, jet, other, tolerance, xi, q } = self;
        write!(
            f,
            "{part}: {jet:e}, not {other:e}; rounding explains {tolerance:.1e}\n  at xi = {xi:?} of q = {q:?}"
        )
    }
}

/// The numbers of the jet of a curve that differ from the derivatives of its position beyond rounding.
///
/// At the parameter `xi` of a beam with the dofs `q`, varied along the two `directions`; Jacobians, gradients and Hessians
/// are compared with the variations, the last two for the vector `w`. [`curve`](super::curve) does this at many points.
pub fn jet<C, const N: usize>(
    curve: &C,
    q: &SVector<f64, N>,
    directions: [&SVector<f64, N>; 2],
    w: &Vector3<f64>,
    xi: f64,
) -> Vec<JetFinding>
where
    C: Curve<N> + Clone + fmt::Debug + Send + Sync + 'static,
{
    let [dq, linear_dq] = directions.map(|direction| *direction);
    findings(&Drawn { curve: curve.clone(), q: *q, dq, linear_dq, points: Vec::new() }, w, xi)
}

/// The wrong numbers of the jet of a beam at a parameter.
pub(super) fn findings<C, const N: usize>(beam: &Drawn<C, N>, w: &Vector3<f64>, xi: f64) -> Vec<JetFinding>
where
    C: Curve<N> + Clone + fmt::Debug + Send + Sync + 'static,
{
    let at = RunningError2::from(xi);
    let (zero, one) = (RunningError2::from(0.0), RunningError2::from(1.0));
    let number = |value, first| HyperDual::new(value, first, zero, zero);
    let lifted = |value: HyperDual<RunningError2>| Lifted::new(value, number(one, zero));
    let still = |dq, linear_dq| Drawn { dq, linear_dq, ..beam.clone() };
    let none = SVector::zeros();
    // Nilpotents along ξ, once, twice and three times; dofs unchanged, or varied along one direction, or along both.
    let along = still(none, none).position_at(lifted(HyperDual::new(at, one, one, zero)));
    let vary = |dq| still(none, dq).position_at(lifted(number(at, one)));
    let (delta, linear) = (vary(beam.dq), vary(beam.linear_dq));
    let both: Vector3<Lifted> = beam.position_at(lifted(number(at, zero)));
    let second = |x: &Vector3<Lifted>| [x.map(|x| x.re.eps1eps2), x.map(|x| x.eps.eps1eps2)];
    let first =
        |x: &Vector3<Lifted>| [x.map(|x| x.re.eps2), x.map(|x| x.re.eps1eps2), x.map(|x| x.eps.eps1eps2)];

    let PartialVariations { geometry, delta_u, linear_u, second_u } = AnyBeam::partial_variations(beam, at);
    let Geometry { x, t, t_xi, t_xixi } = geometry;
    let [x_xixi, x_xixixi] = second(&along);
    let mut pairs: Vec<(&'static str, Vector, Vector)> = vec![
        ("x of the jet, against the position", x, along.map(|x| x.re.re)),
        ("t = x,xi of the jet, against the derivative of the position", t, along.map(|x| x.re.eps1)),
        ("t,xi = x,xixi of the jet, against the derivative of the position", t_xi, x_xixi),
        ("t,xixi = x,xixixi of the jet, against the derivative of the position", t_xixi, x_xixixi),
    ];
    for k in 0..3 {
        pairs.push((VARIATIONS[k], delta_u[k], first(&delta)[k]));
        pairs.push((VARIATIONS[k], linear_u[k], first(&linear)[k]));
    }
    let [of_x, of_t] = second(&both);
    pairs.push(("second_variation of x (k = 0), against the derivative of the position", second_u[0], of_x));
    pairs.push((
        "second_variation of x,xi (k = 1), against the derivative of the position",
        second_u[1],
        of_t,
    ));
    pairs.extend(consistent(beam, &w.map(RunningError2::from), at));
    let wrong = |(part, jet, other): (&'static str, Vector, Vector)| {
        let finding = |(jet, other): (&RunningError2, &RunningError2)| {
            let tolerance = jet.bound[0] + other.bound[0];
            let is_apart =
                (jet.value - other.value).abs() > tolerance || jet.value.is_nan() != other.value.is_nan();
            let q = beam.q.iter().copied().collect();
            is_apart.then_some(JetFinding { part, jet: jet.value, other: other.value, tolerance, xi, q })
        };
        jet.iter().zip(&other).find_map(finding)
    };
    pairs.into_iter().filter_map(wrong).collect()
}

/// The same finding at numbers with few digits, if it occurs there: they are easier to read and to repeat.
pub(super) fn rounder<C, const N: usize>(
    beam: &Drawn<C, N>,
    w: &Vector3<f64>,
    finding: JetFinding,
) -> JetFinding
where
    C: Curve<N> + Clone + fmt::Debug + Send + Sync + 'static,
{
    let largest = beam.q.amax();
    let at = |digits: i32| {
        let round = |v: &SVector<f64, N>| SVector::from_vec(rounded(v.as_slice(), largest, digits));
        let [q, dq, linear_dq] = [&beam.q, &beam.dq, &beam.linear_dq].map(round);
        let beam = Drawn { q, dq, linear_dq, ..beam.clone() };
        let same = |other: &JetFinding| other.part == finding.part;
        let plain = |number: f64| rounded(&[number], 1.0, digits)[0];
        findings(&beam, &w.map(plain), plain(finding.xi)).into_iter().find(same)
    };
    (0..4).find_map(at).unwrap_or(finding)
}

/// The numbers with this number of digits after the first of the largest dof, for any unit of length.
pub(super) fn rounded(numbers: &[f64], largest: f64, digits: i32) -> Vec<f64> {
    #[expect(clippy::cast_possible_truncation, reason = "an exponent of f64 is below 1100")]
    let places = digits - largest.max(f64::MIN_POSITIVE).log10().floor() as i32;
    let round = |&number: &f64| match usize::try_from(places) {
        // Parsed from its digits, it is written with as few digits again.
        Ok(places) => format!("{number:.places$}").parse().unwrap_or(number),
        Err(_) => (number * 10.0_f64.powi(places)).round() * 10.0_f64.powi(-places),
    };
    // Avoids a minus sign in front of zero.
    numbers.iter().map(|number| round(number) + 0.0).collect()
}

/// The consistency of the derivatives: Jacobians, gradients and Hessians against the variations, and the shape
/// functions, if there are any, against the points.
fn consistent<C: Curve<N>, const N: usize>(
    beam: &Drawn<C, N>,
    w: &Vector,
    at: RunningError2,
) -> Vec<(&'static str, Vector, Vector)> {
    let [q, dq, linear_dq] = [beam.q, beam.dq, beam.linear_dq].map(|v| v.map(RunningError2::from));
    let jet = beam.curve.jet(&q, at);
    let alone =
        |number: RunningError2| Vector::new(number, RunningError2::from(0.0), RunningError2::from(0.0));
    let mut pairs = Vec::new();
    for k in 0..3 {
        let variation = jet.dofs.variation(k, &dq);
        pairs.push(("jacobian, against the variation", jet.dofs.jacobian(k) * dq, variation));
        let gradient = jet.dofs.gradient(k, w).dot(&dq);
        pairs.push(("gradient, against the variation", alone(gradient), alone(w.dot(&variation))));
    }
    for k in 0..2 {
        let hessian = dq.dot(&(jet.dofs.hessian(k, w) * linear_dq));
        let second = w.dot(&jet.dofs.second_variation(k, &dq, &linear_dq));
        pairs.push(("hessian, against the second_variation", alone(hessian), alone(second)));
    }
    let Geometry { x, t, t_xi, t_xixi } = jet.geometry;
    for (k, point) in [x, t, t_xi, t_xixi].into_iter().enumerate() {
        let Some(shapes) = jet.dofs.shapes(k) else { break };
        let sum = Vector::from_fn(|c, _| {
            let terms = shapes.iter().enumerate().map(|(a, &shape)| shape * q[3 * a + c]);
            terms.fold(RunningError2::from(0.0), |sum, term| sum + term)
        });
        pairs.push(("shapes, times the control vectors against the jet", sum, point));
    }
    pairs
}
