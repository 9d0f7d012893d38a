//! Draws the case of a given number with a counter-based generator, so that shards, threads and reruns agree.

use super::case_data::CaseData;
use super::regime::{Draw, Regime, sign};
use super::shard::Shard;
use crate::number::RunningError;
use crate::pair::Contact;
use crate::test_beam::{AnyBeam, Family, Target, TestBeam};
use nalgebra::{Matrix3, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

/// A pair of beams to be checked.
#[derive(Debug)]
pub struct Case {
    /// Its number. With the seed, it determines all other fields.
    pub number: u64,
    /// Its regime.
    pub regime: Regime,
    /// The families of beam and bar beam.
    pub families: [Family; 2],
    /// Radii and reference parameters.
    pub contact: Contact,
    /// Beam and bar beam as numbers.
    pub test_beams: [TestBeam; 2],
    beams: [Box<dyn AnyBeam>; 2],
}

/// The selected cases. All pairs of families in all regimes alternate, so a selection omits the others.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Selection {
    /// The regimes, not empty.
    pub regimes: Vec<Regime>,
    /// If given, beam or bar beam is of this family.
    pub family: Option<Family>,
    /// The number of cases of each regime.
    pub cases: u64,
}

/// The regimes whose cases alternate. The last regime counts its cases from [`BADLY_SCALED`] on, so that the numbers of
/// the other regimes did not change when it was added.
const REGIMES: u64 = Regime::ALL.len() as u64 - 1;
const BADLY_SCALED: u64 = 1 << 40;
const FAMILIES: u64 = Family::ALL.len() as u64;

impl Selection {
    /// The numbers of the cases, regime by regime.
    pub fn numbers(&self) -> Vec<u64> {
        self.regimes.iter().flat_map(|&regime| self.of_regime(regime)).collect()
    }

    /// The numbers of the cases of a shard, from each regime alternately.
    pub fn part(&self, shard: Shard) -> Vec<u64> {
        let mut regimes: Vec<_> = self.regimes.iter().map(|&regime| self.of_regime(regime)).collect();
        let mut numbers = Vec::new();
        for round in 0..self.cases {
            // Each regime is distributed over all shards.
            let of_round = regimes.iter_mut().zip(round..).map(|(regime, place)| (regime.next(), place));
            numbers
                .extend(of_round.filter(|(_, place)| shard.holds(*place)).filter_map(|(number, _)| number));
        }
        numbers
    }

    /// The number of cases of a shard.
    pub fn count(&self, shard: Shard) -> u64 {
        (0..self.regimes.len() as u64).map(|regime| shard.count(regime..regime + self.cases)).sum()
    }

    /// The numbers of the cases of a regime.
    fn of_regime(&self, regime: Regime) -> impl Iterator<Item = u64> + use<> {
        let number = move |place| match regime {
            Regime::BadlyScaled => BADLY_SCALED + place,
            _ => place * REGIMES + regime as u64,
        };
        let family = self.family;
        let of_family = move |&number: &u64| family.is_none_or(|family| families(number).contains(&family));
        (0..).map(number).filter(of_family).take(usize::try_from(self.cases).unwrap_or(usize::MAX))
    }
}

/// The regime of a case.
fn regime(number: u64) -> Regime {
    if number >= BADLY_SCALED {
        return Regime::BadlyScaled;
    }
    Regime::ALL[usize::try_from(number % REGIMES).unwrap_or(0)]
}

/// The index of a case among the cases of its regime.
pub(super) fn place_in_regime(number: u64) -> u64 {
    if number >= BADLY_SCALED { number - BADLY_SCALED } else { number / REGIMES }
}

/// The families of a case: all pairs alternate.
fn families(number: u64) -> [Family; 2] {
    let place = place_in_regime(number);
    [place / FAMILIES, place].map(|i| Family::ALL[usize::try_from(i % FAMILIES).unwrap_or(0)])
}

impl Case {
    /// Beam and bar beam.
    pub(crate) fn beams(&self) -> [&dyn AnyBeam; 2] {
        self.beams.each_ref().map(|beam| &**beam)
    }

    /// The case without the number that drew it.
    pub fn data(&self) -> CaseData {
        CaseData { test_beams: self.test_beams.clone(), contact: self.contact }
    }

    /// Draws the case with this number.
    ///
    /// The crossing of the two beams is a stationary point. The search decides whether it is the minimum.
    pub fn draw(seed: u64, number: u64) -> Self {
        Self::of(seed, number, regime(number), families(number))
    }

    /// Draws a case of this regime and of these families.
    pub(super) fn of(seed: u64, number: u64, regime: Regime, families: [Family; 2]) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream(number);
        let draw = regime.draw(&mut rng);
        let mut test_beams = crossing(families, &draw, &mut rng);
        let mut distance = draw.gap * draw.length;
        if regime == Regime::BadlyScaled {
            for _ in 0..rng.random_range(1..4) {
                let beam = &mut test_beams[rng.random_range(0..2)];
                let factor = 10_f64.powf(rng.random_range(-8.0..8.0)) * sign(&mut rng);
                // Dofs are chosen most often, because directions enter linearly.
                let numbers = match rng.random_range(0..6) {
                    0 => &mut beam.dq,
                    1 => &mut beam.linear_dq,
                    _ => &mut beam.q,
                };
                let dof = rng.random_range(0..numbers.len());
                numbers[dof] *= factor;
            }
            let [x, x_bar] = [0, 1].map(|i| test_beams[i].drawn().geometry(draw.at[i]).x);
            distance = distance.max((x - x_bar).norm());
        }
        let contact = draw.contact(draw.length, distance, &mut rng);
        let beams = test_beams.each_ref().map(TestBeam::drawn);
        Self { number, regime, families, contact, test_beams, beams }
    }
}

/// Two beams that cross at the drawn angle, gap and parameters. The vector d is normal to both tangents
/// there.
pub(super) fn crossing(families: [Family; 2], draw: &Draw, rng: &mut ChaCha8Rng) -> [TestBeam; 2] {
    // The tangents span a plane with d normal to it; beams bend in any direction.
    let frame = orthonormal(rng);
    let [normal, t] = [frame.column(0), frame.column(1)].map(Vector3::from);
    let (sin, cos) = draw.angle.sin_cos();
    let tangents = [t, t * cos + normal.cross(&t) * sin];
    let origin = Vector3::from_fn(|_, _| rng.random_range(-2.0..2.0)) * draw.length;
    let mut beam = |i: usize| {
        let turn: f64 = rng.random_range(0.0..std::f64::consts::TAU);
        let across = normal.cross(&tangents[i]);
        let bending = normal * turn.cos() + across * turn.sin();
        let target = Target {
            point: origin,
            frame: Matrix3::from_columns(&[tangents[i], bending, tangents[i].cross(&bending)]),
            length: draw.length * rng.random_range(0.8..1.25),
            bend: draw.bend[i],
            hand: draw.hand[i],
            xi: draw.at[i],
        };
        families[i].draw(&target, rng)
    };
    let mut test_beams = [beam(0), beam(1)];
    // The drawn curves pass only near their targets, so the first beam is moved by the measured difference.
    let [x, x_bar] = [0, 1].map(|i| test_beams[i].drawn().geometry_at(RunningError::from(draw.at[i])));
    let [x, t, x_bar, t_bar] = [x.x, x.t, x_bar.x, x_bar.t].map(|v| v.map(|c| c.value));
    let across = t.cross(&t_bar).normalize();
    test_beams[0].translate(&(across * (draw.side * draw.gap * draw.length) - (x - x_bar)));
    test_beams
}

/// A random orthonormal frame, right-handed.
pub(super) fn orthonormal(rng: &mut ChaCha8Rng) -> Matrix3<f64> {
    let mut random = || Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
    let (mut u, mut v): (Vector3<f64>, Vector3<f64>) = (random(), random());
    while u.norm() < 0.1 || u.cross(&v).norm() < 0.1 {
        (u, v) = (random(), random());
    }
    let u = u.normalize();
    let w = u.cross(&v).normalize();
    Matrix3::from_columns(&[u, w.cross(&u), w])
}

#[cfg(test)]
mod tests;
