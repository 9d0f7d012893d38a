//! Random cases.

use super::{Outcome, Vector};
use crate::check::draw::Case;
use crate::check::{Coverage, ElementData, Regime, Symmetry};
use crate::contact::Work;
use crate::test_beam::Family;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// How often a case is drawn again.
const TRIES: u64 = 16;
/// The distance of the seeds of these draws.
const AGAIN: u64 = 0x9e37_79b9_7f4a_7c15;

/// The cases that are drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// The seed.
    pub seed: u64,
    /// The regimes, not empty.
    pub regimes: Vec<Regime>,
    /// The families; all ordered pairs of them alternate.
    pub families: Vec<Family>,
    /// The number of cases of each regime.
    pub cases: u64,
    /// Whether the radii are so large that the surfaces penetrate in all cases. Otherwise they do in about half the cases of
    /// each regime.
    pub penetrating: bool,
    /// Whether each case has a contact element, with parameters and history. All its states alternate.
    pub elements: bool,
    /// Whether these cases also have two earlier steps, from which their history follows.
    pub steps: bool,
    /// The work of all elements, if it does not alternate.
    pub work: Option<Work>,
}

impl Drawing {
    /// The number of cases.
    pub fn count(&self) -> u64 {
        self.cases * self.regimes.len() as u64
    }

    /// The sides of the symmetries that no closest point of the cases is on, in words.
    ///
    /// Sides that no number of cases would show are left out: of curves without curvature or torsion, and the open gap if
    /// all surfaces penetrate.
    pub fn unseen(&self, seen: &Coverage) -> Vec<&'static str> {
        let is_possible = |symmetry: Symmetry| {
            self.families.iter().any(|&family| symmetry.has_sign_with(family))
                && !(symmetry == Symmetry::Gap && self.penetrating)
        };
        seen.unseen()
            .into_iter()
            .filter(|(symmetry, _)| is_possible(*symmetry))
            .map(|(_, side)| side)
            .collect()
    }

    /// A case, by its number. Regimes alternate, and so do pairs of families within each regime, and open and closed gaps.
    ///
    /// A case whose closest point cannot be compared is drawn again, because it would be left out.
    pub fn vector(&self, number: u64) -> Vector {
        let first = self.drawn(number, 0);
        if first.outcome() == Outcome::Valid {
            return first;
        }
        let others = (1..=TRIES).map(|again| self.drawn(number, again));
        others.into_iter().find(|vector| vector.outcome() == Outcome::Valid).unwrap_or(first)
    }

    /// A case, drawn for the first time or again.
    fn drawn(&self, number: u64, again: u64) -> Vector {
        let seed = self.seed.wrapping_add(again.wrapping_mul(AGAIN));
        let (regimes, families) = (self.regimes.len() as u64, self.families.len() as u64);
        let of = |i: u64| usize::try_from(i).unwrap_or(0);
        let regime = self.regimes[of(number % regimes)];
        let (place, shift) = (number / regimes, number % regimes);
        // All ordered pairs in turn. Each regime begins with another pair, and beam and bar beam change from case to case.
        let turn = place + shift;
        let pair = [families / 2 + turn + turn / families, turn].map(|i| self.families[of(i % families)]);
        let mut vector = Vector {
            id: number.to_string(),
            regime: regime.name().to_owned(),
            case: Case::of(seed, number, regime, pair).data(),
            element: None,
            steps: Vec::new(),
            point: None,
            place: None,
        };
        if let Ok(point) = vector.closest_point() {
            vector.point = Some((point.xi, point.xi_bar));
            // Gaps alternate for each pair of families, and from regime to regime.
            let is_closed =
                self.penetrating || (shift + place + place / families + place / families / families) % 2 == 1;
            let contact = &mut vector.case.contact;
            if is_closed != (point.distance < contact.radius + contact.radius_bar) || self.penetrating {
                // The ratio of the radii stays, and so does which beam is thicker.
                // With the same share of the distance in all cases some terms of a tangent could not be told apart.
                let [least, range] = if is_closed { [1.1, 0.3] } else { [0.3, 0.4] };
                let sum = (least + range * share_of(number)) * point.distance;
                let factor = sum / (contact.radius + contact.radius_bar);
                (contact.radius, contact.radius_bar) = (contact.radius * factor, contact.radius_bar * factor);
            }
        }
        // The parameters are as exact as those of the check.
        if let Ok(at) = vector.evaluated(|evaluation| (evaluation.at.0.value, evaluation.at.1.value)) {
            vector.point = Some(at);
        }
        if self.elements {
            let mut contact = vector.case.contact;
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            rng.set_stream(number);
            // Each regime begins with another situation.
            let turn = place + 5 * shift;
            let element = vector.evaluated(|evaluation| {
                let at = (evaluation.at.0.value, evaluation.at.1.value);
                ElementData::draw(
                    turn,
                    &evaluation.points(),
                    at,
                    evaluation.held,
                    false,
                    &mut contact,
                    &mut rng,
                )
            });
            (vector.element, vector.case.contact) = (element.ok(), contact);
            if let Some((element, work)) = vector.element.as_mut().zip(self.work) {
                element.parameters.work = work;
            }
            if self.steps {
                vector.go_through_steps(turn);
            }
        }
        vector
    }
}

/// A share between 0 and 1 that differs from case to case: the fraction of multiples of the golden ratio.
#[expect(clippy::cast_precision_loss, reason = "the number of a case is small")]
fn share_of(number: u64) -> f64 {
    (number as f64 * 0.618_033_988_749_894_8).fract()
}
