//! Bad input is an error that names the value.

use crate::contact::{
    ContactError, Contribution, Element, History, Law, NormalLaw, Parameters, Slips, State,
};
use crate::curve::{Hermite, Segment};
use crate::number::Real;
use crate::pair::{Contact, DofVector, Pair};
use nalgebra::Vector3;

type Beams = Pair<Hermite, Segment, 12, 6>;
type Dofs = DofVector<f64, 12, 6>;

fn pair(radius: f64) -> Beams {
    let contact = Contact { radius, radius_bar: 0.1, ..Contact::default() };
    Pair::new(Hermite::new(), Segment::new()).with_contact(contact)
}

/// A straight beam along x, and a bar beam between these ends.
fn dofs(bar: [f64; 6]) -> Dofs {
    ([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0], bar).into()
}

/// Crossing at a distance of 0.15.
const CROSSING: [f64; 6] = [0.1, -1.0, -0.15, 0.2, 1.0, -0.15];

fn slips() -> Slips {
    Slips { xi: 0.15, xi_bar: 0.0, e: 0.005, e_bar: 0.005, ..Slips::default() }
}

fn history(slips: Slips) -> History {
    History { normal: Some(Vector3::z()), slips: Some(slips) }
}

/// The state, or the error in words. Residual and tangent must be finite, and as before after an error.
fn evaluated<L: NormalLaw>(
    radius: f64,
    parameters: &Parameters<L>,
    (q, at): (&Dofs, &Dofs),
    history: &History,
) -> Result<State, String> {
    let pair = pair(radius);
    let found = pair.closest_points(at).unwrap();
    let point = found.minima.first().copied().unwrap_or_else(|| found.unresolved[0].point);
    let mut to = Contribution::zeros();
    to.residual.beam[0] = 7.0;
    let outcome = Element::new(&pair, parameters).and_then(|of| of.evaluate(q, &point, history, &mut to));
    match outcome {
        Ok(outcome) => {
            assert_eq!(to.not_finite(), None);
            Ok(outcome.state)
        }
        Err(error) => {
            let is_after = matches!(error, ContactError::Result { name: "R" | "K", .. });
            assert!(to.residual.beam[0].to_bits() == if is_after { 0.0 } else { 7.0_f64 }.to_bits());
            Err(error.to_string())
        }
    }
}

const LAW: Law = Law::Linear { eps: 1e3 };

fn parameters(eps_t: f64, mu: f64) -> Parameters<Law> {
    Parameters::with_friction(LAW, eps_t, mu)
}

/// An error that is expected: it begins with these words.
fn assert_refused(result: &Result<State, String>, words: &str) {
    assert!(result.as_ref().is_err_and(|error| error.starts_with(words)), "{result:?}, not {words}");
}

#[test]
fn parameters_and_radii_out_of_range_are_named() {
    let q = dofs(CROSSING);
    let with = |parameters: Parameters<Law>| evaluated(0.1, &parameters, (&q, &q), &history(slips()));
    assert_eq!(with(parameters(1e3, 0.3)), Ok(State::Stick));
    assert_refused(&with(parameters(0.0, 0.3)), "the parameter eps_T = 0 is out of range");
    assert_refused(&with(parameters(f64::NAN, 0.3)), "the parameter eps_T = NaN");
    assert_refused(&with(parameters(1e3, -0.5)), "the parameter mu = -0.5");
    assert_refused(&with(parameters(1e3, f64::INFINITY)), "the parameter mu = inf");
    let law = |law| with(Parameters::with_friction(law, 1e3, 0.3));
    assert_refused(&law(Law::Linear { eps: -1.0 }), "the parameter eps_N = -1");
    assert_refused(&law(Law::Lpqp { eps: 1e3, g_0: 0.0 }), "the parameter g_0 = 0");
    assert_refused(&law(Law::Augmented { eps: 1e3, lambda: f64::NAN }), "the parameter lambda = NaN");
    for radius in [-1.0, f64::NAN] {
        let result = evaluated(radius, &parameters(1e3, 0.3), (&q, &q), &History::default());
        assert_refused(&result, &format!("the parameter r = {radius}"));
    }
}

#[test]
fn a_history_out_of_range_is_named() {
    let q = dofs(CROSSING);
    let with = |history: History| evaluated(0.1, &parameters(1e3, 0.3), (&q, &q), &history);
    let of = |change: fn(&mut Slips)| {
        let mut slips = slips();
        change(&mut slips);
        with(history(slips))
    };
    assert_refused(&of(|slips| slips.e = f64::NAN), "the history has e_n = NaN");
    assert_refused(&of(|slips| slips.xi_bar = f64::INFINITY), "the history has xi_bar_n = inf");
    assert_refused(&of(|slips| slips.cosine = 1.5), "the history has c_n = 1.5");
    assert_refused(&of(|slips| slips.held.xi = true), "the history has e_n = 0.005");
    // The length of the trial slip overflows.
    assert_refused(&of(|slips| slips.e = 1e160), "the contact has eps_T gamma = inf");
    let normal = |n: Vector3<f64>| with(History { normal: Some(n), slips: None });
    assert_refused(&normal(Vector3::z() * 2.0), "the history has n.n = 4");
    assert_refused(&normal(Vector3::x()), "the normal has turned too far");
}

#[test]
fn beams_without_a_point_contact_are_named() {
    let crossing = dofs(CROSSING);
    let with = |q: &Dofs, at: &Dofs| evaluated(0.1, &parameters(1e3, 0.3), (q, at), &History::default());
    let mut wrong = crossing;
    wrong.beam[7] = f64::NAN;
    assert_refused(&with(&wrong, &crossing), "the beam has x = NaN");
    let point = dofs([0.1, 0.0, -0.15, 0.1, 0.0, -0.15]);
    assert_refused(&with(&point, &crossing), "the tangent of the bar beam has the length 0");
    let parallel = dofs([-1.0, 0.0, -0.15, 1.0, 0.0, -0.15]);
    assert_refused(&with(&parallel, &parallel), "the beams are parallel");
    // The bar beam ends below the beam, and then on its centroid.
    let (below, end) = (dofs([0.0, 0.0, -0.15, 0.0, 1.0, -0.3]), dofs([0.0, 0.0, 0.0, 0.0, 1.0, -0.15]));
    assert_refused(&with(&end, &below), "the contact at an end of a beam has no normal: d = 0");
    // Two ends are in contact without friction, and a state with friction is refused.
    let corner = dofs([1.1, 0.1, -0.05, 2.0, 1.0, -0.05]);
    assert_eq!(
        evaluated(0.1, &parameters(1e3, 0.3), (&corner, &corner), &History::default()),
        Ok(State::Frictionless)
    );
    let (pair, parameters) = (pair(0.1), parameters(1e3, 0.3));
    let corner_point = pair.closest_points(&corner).unwrap().minima[0];
    let element = Element::new(&pair, &parameters).unwrap();
    let decision = element.decide(&corner, &corner_point, &History::default()).unwrap();
    let error = decision.in_state(State::Stick, (corner_point.xi, corner_point.xi_bar)).unwrap_err();
    assert_eq!(error.to_string(), "a contact of two ends, xi = 1 and xi_bar = -1, has no friction");
}

/// A law of a user with a force that does not depend on the gap.
#[derive(Clone, Copy, Debug)]
struct Constant(f64);

impl NormalLaw for Constant {
    type Piece = ();

    fn piece(&self, g_n: f64) -> Option<()> {
        (g_n < 0.0).then_some(())
    }

    fn force<T: Real>(&self, (): (), _g_n: T) -> T {
        T::from(self.0)
    }

    fn stiffness<T: Real>(&self, (): (), _g_n: T) -> T {
        T::zero()
    }

    fn opening_gap(&self) -> f64 {
        0.0
    }
}

#[test]
fn results_that_are_no_forces_are_named() {
    let q = dofs(CROSSING);
    let of = |force| {
        let parameters = Parameters::with_friction(Constant(force), 1e3, 0.3);
        evaluated(0.1, &parameters, (&q, &q), &history(slips()))
    };
    assert_eq!([of(30.0), of(10.0)], [Ok(State::Stick), Ok(State::Slip)]);
    assert_refused(&of(f64::NAN), "the contact has F_N = NaN");
    assert_refused(&of(-1.0), "the contact has F_N = -1");
    let large = evaluated(1e308, &parameters(1e3, 0.3), (&q, &q), &History::default());
    assert_refused(&large, "the contact has F_N = inf");
    let mut small = q;
    (small.beam, small.bar) = (q.beam * 1e-100, q.bar * 1e-100);
    let result = evaluated(0.1, &parameters(1e3, 0.3), (&small, &q), &History::default());
    assert_refused(&result, "the contact has ");
}
