//! Random cases.

use super::{Outcome, Vector};
use crate::check::draw::Case;
use crate::check::{Coverage, ElementData, Regime, Symmetry};
use crate::closest_point::Held;
use crate::contact::Work;
use crate::test_beam::Family;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// How often a case is drawn again.
const TRIES: u64 = 16;
/// The distance of the seeds of these draws.
const AGAIN: u64 = 0x9e37_79b9_7f4a_7c15;

/// The first elements near the ends of beams: each parameter becomes held where the contact sticks, and where it slips. Of few
/// cases that are drawn at random, none may show one of these.
const AT_ENDS: [(Held, u64); 4] = {
    let [xi, xi_bar] = [Held { xi: true, xi_bar: false }, Held { xi: false, xi_bar: true }];
    [
        (xi, ElementData::BECOMES_HELD_IN_STICK),
        (xi_bar, ElementData::BECOMES_HELD_IN_SLIP),
        (xi, ElementData::BECOMES_HELD_IN_SLIP),
        (xi_bar, ElementData::BECOMES_HELD_IN_STICK),
    ]
};

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
        let wanted = self.at_end(number).map(|(held, _)| held);
        let is_wanted = |vector: &Vector| wanted.is_none() || vector.evaluated(|at| at.held).ok() == wanted;
        let all = (0..=TRIES).map(|again| self.drawn(number, again));
        let mut valid = all.filter(|vector| vector.outcome() == Outcome::Valid).peekable();
        let first = valid.peek().cloned();
        valid.find(is_wanted).or(first).unwrap_or_else(|| self.drawn(number, 0))
    }

    /// Which parameter is held at the end of a beam, and the situation of the element, if the case is one of the first near the
    /// ends.
    fn at_end(&self, number: u64) -> Option<(Held, u64)> {
        let regimes = self.regimes.len() as u64;
        let regime = self.regimes[usize::try_from(number % regimes).unwrap_or(0)];
        let place = usize::try_from(number / regimes).ok()?;
        AT_ENDS.get(place).copied().filter(|_| self.elements && regime == Regime::NearEnd)
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
            let turn = self.at_end(number).map_or(place + 5 * shift, |(_, turn)| turn);
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

#[cfg(test)]
mod tests {
    use super::{AT_ENDS, Drawing};
    use crate::check::Regime;
    use crate::contact::State;
    use crate::test_beam::Family;

    /// A wrong start of the slips of such a step is seen by the smallest files that show it.
    #[test]
    fn each_parameter_becomes_held_in_stick_and_in_slip() {
        for seed in 0..8 {
            let drawing = Drawing {
                seed,
                regimes: vec![Regime::Generic, Regime::NearEnd],
                families: vec![Family::Hermite, Family::Segment],
                cases: 4,
                penetrating: false,
                elements: true,
                steps: false,
                work: None,
            };
            for (place, state) in
                [State::Stick, State::Slip, State::Slip, State::Stick].into_iter().enumerate()
            {
                let vector = drawing.vector(2 * place as u64 + 1);
                let held = vector.evaluated(|at| at.held).unwrap();
                let before = vector.element.unwrap().history.slips.unwrap().held;
                assert!(!before.xi && !before.xi_bar, "seed {seed}, {place}: {before:?}");
                assert_eq!((held, vector.state()), (AT_ENDS[place].0, Some(state)), "seed {seed}, {place}");
            }
        }
    }
}
