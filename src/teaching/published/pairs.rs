//! Random pairs of bent Hermite beams in contact.

use crate::closest_point::{ClosestPoint, Held, Kind};
#[cfg(test)]
use crate::contact::Contribution;
use crate::contact::{Decision, Element, History, Law, Parameters, Slips, State, Work};
use crate::curve::{Curve, DofDerivatives, Geometry, Hermite, Jet};
use crate::linearization::closed_form::jets;
use crate::pair::{Contact, DofVector, Pair};
use crate::teaching::DOFS;
use crate::teaching::terms::{Components, Terms};
use nalgebra::{SMatrix, SVector, Vector3};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Two beams of length 2 in contact, with a history.
#[derive(Clone, Debug)]
pub(super) struct RandomPair {
    pub(super) pair: Pair<Hermite, Hermite, DOFS, DOFS>,
    pub(super) q: DofVector<f64, DOFS, DOFS>,
    pub(super) point: ClosestPoint,
    /// The state that was asked for.
    #[cfg_attr(not(test), expect(dead_code, reason = "for tests"))]
    pub(super) state: State,
    parameters: Parameters,
    history: History,
}

/// The radius of both beams.
const RADIUS: f64 = 0.1;

impl RandomPair {
    /// Draws a pair in this state. The beams cross at 20 to 160 degrees, turn by up to half a right angle, and penetrate by up to
    /// half a radius. The slips of the step are up to a tenth of their length.
    pub(super) fn draw(rng: &mut ChaCha8Rng, state: State) -> Self {
        loop {
            if let Some(pair) = Self::try_draw(rng, state) {
                return pair;
            }
        }
    }

    /// A pair, if it is in the state and its closest point is a minimum.
    fn try_draw(rng: &mut ChaCha8Rng, state: State) -> Option<Self> {
        let mut number = |from: f64, to: f64| rng.random_range(from..to);
        let angle = number(0.35, 2.79);
        let [beam, mut bar] = [0.0, angle].map(|angle: f64| {
            let along = Vector3::new(angle.cos(), angle.sin(), 0.0);
            let mut near = |v: Vector3<f64>| v + Vector3::from_fn(|_, _| number(-0.2, 0.2));
            let nodes = [near(-along), near(along), near(along), near(along)];
            let mut q = SVector::<f64, DOFS>::zeros();
            for (i, node) in nodes.iter().enumerate() {
                q.fixed_rows_mut::<3>(3 * i).copy_from(node);
            }
            q
        });
        let at = [number(-0.8, 0.8), number(-0.8, 0.8)];
        let x = Hermite::new().jet(&beam, at[0]).geometry;
        let y = Hermite::new().jet(&bar, at[1]).geometry;
        let n = x.t.cross(&y.t).normalize();
        // The bar beam is moved so that these points are the closest ones: d is normal to both tangents.
        let gap = -number(0.01, 0.5) * RADIUS;
        let shift = x.x - n * (2.0 * RADIUS + gap) - y.x;
        for node in [0, 6] {
            let mut rows = bar.fixed_rows_mut::<3>(node);
            rows += shift;
        }
        let contact = Contact { radius: RADIUS, radius_bar: RADIUS, ..Contact::default() };
        let pair = Pair::new(Hermite::new(), Hermite::new()).with_contact(contact);
        let q = DofVector { beam, bar };
        let point = pair.refine(&q, (at[0], at[1]), Held::default()).ok()?;
        let (eps, mu) = (number(0.2, 2.0), if state.has_friction() { number(0.1, 0.5) } else { 0.0 });
        let slips = Slips {
            xi: at[0] - number(-0.2, 0.2),
            xi_bar: at[1] - number(-0.2, 0.2),
            e: number(-0.05, 0.05),
            e_bar: number(-0.05, 0.05),
            cosine: x.t.dot(&y.t) / (x.t.norm() * y.t.norm()),
            ..Slips::default()
        };
        // The penalty of the slip at which the trial force is on the cone: less of it sticks, more of it slips.
        let [e, e_bar] =
            [slips.e + x.t.norm() * (at[0] - slips.xi), slips.e_bar + y.t.norm() * (at[1] - slips.xi_bar)];
        let slip = (x.t.normalize() * e - y.t.normalize() * e_bar).norm();
        let on_cone = mu * eps * -gap / slip;
        let eps_t = match state {
            State::Stick => on_cone * number(0.2, 0.9),
            State::Slip => on_cone * number(1.2, 8.0),
            _ => 1.0,
        };
        let parameters = Parameters::with_friction(Law::Linear { eps }, eps_t, mu);
        let history = History { normal: Some(n), slips: Some(slips) };
        let this = Self { pair, q, point, state, parameters, history };
        let is_minimum = point.kind == Kind::Minimum && point.held() == Held::default();
        (is_minimum && this.decision(Work::Rate, |decision| decision.state == state)?).then_some(this)
    }

    /// Calls `with` with the decision of the element.
    fn decision<R>(&self, work: Work, with: impl FnOnce(&Decision<'_, Law>) -> R) -> Option<R> {
        let parameters = Parameters { work, ..self.parameters };
        let element = Element::new(&self.pair, &parameters).ok()?;
        let decision = element.decide(&self.q, &self.point, &self.history).ok()?;
        Some(with(&decision))
    }

    /// Residual and tangent, term by term, in a state.
    pub(super) fn terms(&self, state: State, components: Components, work: Work) -> Terms {
        let at = (self.point.xi, self.point.xi_bar);
        let (jet, jet_bar) = jets(&self.pair, &self.q, at);
        let terms = |decision: &Decision<'_, Law>| {
            let decision = decision.in_state(state, at).expect("both parameters are free");
            Terms::new(&decision, (&jet, &jet_bar), at, components)
        };
        self.decision(work, terms).expect("the element took this pair when it was drawn")
    }

    /// The points, tangents and their derivatives of both beams, and F_N and k of the linear law.
    pub(super) fn normal_contact(&self) -> NormalContact {
        let at = (self.point.xi, self.point.xi_bar);
        let (jet, jet_bar) = jets(&self.pair, &self.q, at);
        let Law::Linear { eps } = self.parameters.law else { unreachable!("pairs have the linear law") };
        let gap = (jet.geometry.x - jet_bar.geometry.x).norm() - 2.0 * RADIUS;
        NormalContact { shapes: [jet, jet_bar].map(|jet| Shapes::of(&jet)), f_n: -eps * gap, k: eps }
    }
}

/// What a penalty element without friction uses.
pub(super) struct NormalContact {
    pub(super) shapes: [Shapes; 2],
    pub(super) f_n: f64,
    pub(super) k: f64,
}

/// A beam at its contact point: t and t,ξ, and the matrices of x and t over the dofs.
pub(super) struct Shapes {
    pub(super) x: Vector3<f64>,
    pub(super) t: Vector3<f64>,
    pub(super) t_xi: Vector3<f64>,
    pub(super) n: SMatrix<f64, 3, DOFS>,
    pub(super) n_xi: SMatrix<f64, 3, DOFS>,
}

impl Shapes {
    fn of(jet: &Jet<f64, impl DofDerivatives<f64, DOFS>>) -> Self {
        let Geometry { x, t, t_xi, .. } = jet.geometry;
        Self { x, t, t_xi, n: jet.dofs.jacobian(0), n_xi: jet.dofs.jacobian(1) }
    }
}

#[cfg(test)]
impl RandomPair {
    /// Writes residual and tangent of the element, and returns its state.
    pub(super) fn element(&self, state: State, work: Work, to: &mut Contribution<f64, DOFS, DOFS>) -> State {
        let mut parameters = Parameters { work, ..self.parameters };
        if state == State::Frictionless {
            parameters.mu = 0.0;
        }
        let element = Element::new(&self.pair, &parameters).unwrap();
        element.evaluate(&self.q, &self.point, &self.history, to).unwrap().state
    }

    /// The pair with one dof moved and its closest point found again.
    pub(super) fn moved(&self, dof: usize, by: f64) -> Self {
        let mut q = self.q;
        q.set(dof, q.entry(dof) + by);
        let point = self.pair.refine(&q, (self.point.xi, self.point.xi_bar), Held::default()).unwrap();
        Self { q, point, ..self.clone() }
    }
}
