//! The digits that each formulation of the closed form keeps, over the gap and over the angle between the beams.
//!
//! Second variations in `f64`, at the closest point rounded to it, are compared with those in double-double at the closest
//! point refined there. Each level shows the median over many random pairs: of beams of all families over the gap, of
//! straight beams over the angle. The curvature of curved beams is known to rounding only, and no formula can correct
//! its effect on nearly parallel beams.

use super::draw::crossing;
use super::regime::{Draw, Regime};
use crate::closest_point::Held;
use crate::linearization::closed_form::{Formulation, PartialVariations, Points, Projection, variations_in};
use crate::linearization::{Quantities, Varied};
use crate::number::{DoubleDouble, Real};
use crate::pair::Contact;
use crate::parallel;
use crate::test_beam::{AnyBeam, Family, TestBeam};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize, Serializer};

/// Gaps, in lengths of a beam, are 1, 0.1, .. down to this power of ten.
const GAPS: i32 = 12;
/// Angles, in radians, are 1, 0.1, .. down to this power of ten.
const ANGLES: i32 = 8;
/// The maximum number of steps of Newton's method in double-double.
const STEPS: usize = 8;

/// The results of the measurement.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Accuracy {
    /// Over the gap, in lengths of a beam: pairs of all families.
    pub gaps: Vec<Level>,
    /// Over the angle, in radians: pairs of straight beams.
    pub angles: Vec<Level>,
}

/// The results at one gap or angle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Level {
    /// The gap or the angle.
    pub at: f64,
    /// The number of pairs with a closest point near the intended crossing.
    pub pairs: usize,
    /// The number of pairs for which the choice is the distance along the normal.
    pub normal: usize,
    /// The number of pairs for which the choice is the system by cross products.
    pub cross_products: usize,
    /// The errors of Delta-delta d.
    pub d: Errors,
    /// The errors of Delta-delta xi.
    pub xi: Errors,
}

/// Medians of relative errors; none if nothing was measured, or if it is not finite. Records have two digits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// The error of the paper's formulation.
    #[serde(serialize_with = "two_digits")]
    pub paper: Option<f64>,
    /// The error of the formulation along the normal and by cross products.
    #[serde(serialize_with = "two_digits")]
    pub robust: Option<f64>,
    /// The error of the chosen formulation.
    #[serde(serialize_with = "two_digits")]
    pub chosen: Option<f64>,
}

#[expect(clippy::ref_option, reason = "the signature is serde's")]
fn two_digits<S: Serializer>(error: &Option<f64>, to: S) -> Result<S::Ok, S::Error> {
    error.map(|error| format!("{error:.1e}").parse().unwrap_or(error)).serialize(to)
}

impl Errors {
    /// The loss of the choice over the loss of the better formulation, which is at least a rounding unit.
    fn of_choice(&self) -> f64 {
        let [paper, robust, chosen] =
            [self.paper, self.robust, self.chosen].map(|x| x.unwrap_or(f64::INFINITY));
        chosen / paper.min(robust).max(0.5 * f64::EPSILON)
    }
}

impl Accuracy {
    /// The largest ratio of the loss of the choice to the loss of the better formulation, over all rows and quantities;
    /// infinite if something was not measured.
    pub fn worst_choice(&self) -> f64 {
        let rows = self.gaps.iter().chain(&self.angles);
        rows.flat_map(|row| [row.d, row.xi]).map(|errors| errors.of_choice()).fold(0.0, f64::max)
    }
}

/// Measures both formulations, and the choice between them, with this number of pairs at each level.
///
/// The result depends on the seed and the number of pairs, not on the number of threads.
pub fn accuracy(seed: u64, pairs: usize) -> Accuracy {
    let levels = |last: i32| (0..=last).map(|k| (k, 10_f64.powi(-k)));
    let stream =
        |sweep: u64, k: i32, pair: usize| (sweep * 64 + u64::from(k.unsigned_abs())) << 32 | pair as u64;
    Accuracy {
        gaps: levels(GAPS)
            .map(|(k, gap)| {
                Level::new(gap, pairs, |i| {
                    let family = |i: usize| Family::ALL[i % Family::ALL.len()];
                    let families = [family(i / Family::ALL.len()), family(i)];
                    measure(seed, stream(0, k, i), families, |draw| Draw { gap, ..draw })
                })
            })
            .collect(),
        angles: levels(ANGLES)
            .map(|(k, angle)| {
                Level::new(angle, pairs, |i| {
                    measure(seed, stream(1, k, i), [Family::Segment; 2], |draw| Draw {
                        angle,
                        bend: [0.0; 2],
                        ..draw
                    })
                })
            })
            .collect(),
    }
}

impl Level {
    fn new(at: f64, pairs: usize, pair: impl Fn(usize) -> Option<Measured> + Send + Sync) -> Self {
        let measured: Vec<_> = parallel::indices(pairs, pair).into_iter().flatten().collect();
        let errors = |of: fn(&Measured) -> [f64; 3]| {
            let [paper, robust, chosen] =
                [0, 1, 2].map(|k| median(measured.iter().map(|pair| of(pair)[k]).collect()));
            Errors { paper, robust, chosen }
        };
        Self {
            at,
            pairs: measured.len(),
            normal: measured.iter().filter(|pair| pair.choice.sign().is_some()).count(),
            cross_products: measured.iter().filter(|pair| pair.choice.uses_cross_products()).count(),
            d: errors(|pair| pair.d),
            xi: errors(|pair| pair.xi),
        }
    }
}

/// The errors at one closest point, of the paper's formulation, of the other one, and of the choice.
struct Measured {
    choice: Formulation,
    d: [f64; 3],
    xi: [f64; 3],
}

/// Draws a pair and measures it; nothing if no closest point is found near the intended crossing.
fn measure(seed: u64, stream: u64, families: [Family; 2], change: impl Fn(Draw) -> Draw) -> Option<Measured> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(stream);
    let draw = change(Regime::Generic.draw(&mut rng));
    let test_beams = crossing(families, &draw, &mut rng);
    let [beam, bar] = test_beams.each_ref().map(TestBeam::drawn);
    let at = refined([&*beam, &*bar], draw.at)?;
    let rounded = at.map(DoubleDouble::value);
    let partial = [beam.partial_variations_plain(rounded[0]), bar.partial_variations_plain(rounded[1])];
    let points = Points::new(&partial[0].geometry, &partial[1].geometry);
    let inside = Held::default();
    let (paper, robust, choice) =
        (Formulation::paper(inside), Formulation::robust(&points, inside), Formulation::at(&points, inside));
    let exact =
        varied(&[beam.partial_variations_precise(at[0]), bar.partial_variations_precise(at[1])], robust);
    let found = [paper, robust, choice].map(|form| varied(&partial, form));
    let error = |found: f64, exact: DoubleDouble| ((DoubleDouble::from(found) - exact) / exact).abs().value();
    Some(Measured {
        choice,
        d: found.map(|found| error(found.d.second, exact.d.second)),
        xi: found.map(|found| error(found.xi.second, exact.xi.second)),
    })
}

fn varied<T: Real>([beam, bar]: &[PartialVariations<T>; 2], form: Formulation) -> Quantities<Varied<T>> {
    variations_in(form, beam, bar, (T::zero(), T::zero()), &Contact::default())
}

/// The closest point in double-double, by Newton's method.
fn refined([beam, bar]: [&dyn AnyBeam; 2], near: [f64; 2]) -> Option<[DoubleDouble; 2]> {
    let mut at = near.map(DoubleDouble::from);
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let Points { beam: x, bar: x_bar, d } = Points::new(
            &beam.partial_variations_precise(at[0]).geometry,
            &bar.partial_variations_precise(at[1]).geometry,
        );
        let projection = Projection::new(&x, &x_bar, Held::default());
        let (step, step_bar) = projection.solve(-d.dot(&x.t), -d.dot(&x_bar.t));
        at = [at[0] + step, at[1] + step_bar];
        last = step.value().abs().max(step_bar.value().abs());
    }
    (last < 1e-20).then_some(at)
}

fn median(mut of: Vec<f64>) -> Option<f64> {
    of.sort_by(f64::total_cmp);
    of.get(of.len() / 2).copied().filter(|median| median.is_finite())
}
