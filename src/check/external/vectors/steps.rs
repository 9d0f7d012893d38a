//! Earlier converged steps of a contact element: a program that keeps its own history goes through them before the case.

use super::{Outcome, Vector, closest_points};
use crate::check::element::ElementData;
use crate::closest_point::{ClosestPoint, Search};
use crate::contact::History;
use crate::linearization::closed_form::Points;
use crate::variant::Variant;
use nalgebra::Vector3;

/// The dofs of the beam and of the bar beam at a converged step.
pub type StepDofs = [Vec<f64>; 2];

/// The number of steps before the case: a first contact without friction, and one with friction.
const STEPS: u32 = 2;
/// The largest share of the direction delta by which a step moves.
const LARGEST: f64 = 0.2;
/// The largest motion of the contact point within a step; a minimum that is farther away is another contact.
const FARTHEST: f64 = 0.5;

impl Vector {
    /// Sets earlier steps, the history that they leave, and mu so that the state is the one of the situation `number`. The contact
    /// is a first one if it is new in this situation, or the beams are not in one contact in all steps.
    pub(super) fn go_through_steps(&mut self, number: u64) {
        let Some(element) = self.element else { return };
        let moved = element.history.slips.and_then(|_| self.after_steps(element, number));
        *self = moved.unwrap_or_else(|| {
            let element = ElementData { history: History::default(), ..element };
            Self { element: Some(element), ..self.clone() }
        });
    }

    /// The same case with steps.
    fn after_steps(&self, element: ElementData, number: u64) -> Option<Self> {
        let motion = self.evaluated(|evaluation| {
            let all = evaluation.plain(&Variant::Unmodified);
            [18, 19].map(|xi: usize| all[xi].delta.abs()).into_iter().fold(1e-3, f64::max)
        });
        let motion = motion.ok()?;
        let share = (ElementData::slip(number) / motion).min(LARGEST);
        let steps: Vec<StepDofs> = (0..STEPS)
            .map(|k| {
                let back = share * f64::from(STEPS - k);
                self.case
                    .test_beams
                    .each_ref()
                    .map(|beam| beam.q.iter().zip(&beam.dq).map(|(q, dq)| q - back * dq).collect())
            })
            .collect();
        let mut moved = Self { steps, ..self.clone() };
        // With any large mu all steps stick.
        let stuck = 1e9;
        let of = |moved: &Self, mu: f64| {
            let mut element = element;
            element.parameters.mu = mu;
            element.history = moved.history_of_steps(&element)?;
            Some(element)
        };
        let mut found = of(&moved, stuck)?;
        if let Some(cone) = ElementData::cone(number) {
            let ratio = moved.evaluated(|evaluation| {
                let element = found.at(&evaluation).ok()?;
                element.with(|decision| {
                    let values = evaluation.element(decision).2;
                    let Points { beam, bar, .. } = evaluation.points();
                    let cosine = beam.t.dot(&bar.t) / (beam.t.norm() * bar.t.norm());
                    let (e, e_bar) = (values.e, values.e_bar);
                    let gamma = (e * e + e_bar * e_bar - 2.0 * cosine * e * e_bar).sqrt();
                    found.parameters.eps_t * gamma / values.f_n
                })
            });
            let ratio = ratio.ok()??;
            let mu = if ratio.is_finite() && ratio > 0.0 { cone * ratio } else { 0.5 };
            found = of(&moved, mu)?;
        } else {
            found = of(&moved, 0.0)?;
        }
        moved.element = Some(found);
        let is_defined = moved.evaluated(|evaluation| moved.element_at(&evaluation).is_ok()) == Ok(true);
        is_defined.then_some(moved)
    }

    /// The history that the steps leave to an element, from a first contact on. Nothing if the contact opens.
    pub(super) fn history_of_steps(&self, element: &ElementData) -> Option<History> {
        let mut at = Self { element: None, steps: Vec::new(), ..self.clone() };
        let (mut history, mut near) = (History::default(), self.point?);
        for step in &self.steps {
            for (beam, q) in at.case.test_beams.iter_mut().zip(step) {
                beam.q.clone_from(q);
            }
            let point = at.nearest(near).ok()?;
            at.point = Some((point.xi, point.xi_bar));
            let data = ElementData { history, ..*element };
            let next = at.evaluated(|evaluation| {
                let xi = (evaluation.at.0.value, evaluation.at.1.value);
                let next = data.at(&evaluation).ok()?.with(|decision| evaluation.next_history(decision))?;
                Some((next, xi))
            });
            (history, near) = next.ok()??;
            history.slips?;
        }
        Some(history)
    }

    /// The unit tangents of both beams at the last converged step, if it is known.
    pub(in crate::check::external) fn last_tangents(&self) -> Option<[Vector3<f64>; 2]> {
        let (last, slips) = (self.steps.last()?, self.element.as_ref()?.history.slips?);
        let mut at = self.case.clone();
        for (beam, q) in at.test_beams.iter_mut().zip(last) {
            beam.q.clone_from(q);
        }
        let beams = at.beams().ok()?;
        Some(
            [(0, slips.xi), (1, slips.xi_bar)]
                .map(|(i, xi): (usize, f64)| beams[i].geometry(xi).t.normalize()),
        )
    }

    /// The only closest point near these parameters.
    fn nearest(&self, near: (f64, f64)) -> Result<ClosestPoint, Outcome> {
        let beams = self.case.beams().map_err(|_| Outcome::NoProjection)?;
        let found =
            closest_points(&*beams[0], &*beams[1], &Search::default()).map_err(|_| Outcome::NoProjection)?;
        let away = |point: &ClosestPoint| (point.xi - near.0).abs().max((point.xi_bar - near.1).abs());
        let mut near = found.minima.into_iter().filter(|point| away(point) <= FARTHEST);
        let first = near.next().ok_or(Outcome::OtherPoint)?;
        near.next().map_or(Ok(first), |_| Err(Outcome::OtherPoint))
    }
}
