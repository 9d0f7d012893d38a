//! The check of a user's curve.
//!
//! First its jet is compared with the derivatives of its position. Then pairs of it with itself and with the built-in
//! families are compared as in the check, in all regimes.

mod jet;
mod pair;
mod placed;
mod shrink;

use super::compare::{Costly, compare_beams};
use super::config::CheckConfig;
use super::diagnosis::Finding;
use super::regime::Regime;
use super::verdict::{Inconclusive, Verdict};
use crate::curve::Curve;
use crate::parallel;
use nalgebra::Vector3;
use pair::{Pair, varied};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;
use std::fmt;

pub use jet::{JetFinding, jet};

/// The number of points of a jet that are compared for each given beam.
const JETS: u64 = 16;
/// The number of findings that are written out.
const SHOWN: usize = 3;

/// The result of the check of a curve.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OwnCurve {
    /// The parts of the jet that are not the derivative of the position, the first of each kind.
    pub jets: Vec<JetFinding>,
    /// Closest points that were compared.
    pub compared: u64,
    /// Of these, those at which something differs beyond rounding.
    pub mismatches: u64,
    /// The first differences there, one of each kind, with the pair in words, shrunk.
    pub findings: Vec<(String, Finding)>,
    /// Closest points or pairs that were not compared, by reason.
    pub inconclusive: BTreeMap<Inconclusive, u64>,
}

/// Checks a curve: its jet against its position, then `cases` pairs of it in every regime.
///
/// `beams` are dofs of typical beams, at least one. They are varied by a few percent, moved and turned. The meaning of
/// the curve's dofs need not be known. The result depends on the arguments alone.
///
/// ```
/// use beamgap::check;
/// use beamgap::curve::Hermite;
///
/// let beam = [0.0, 0.0, 0.0, 1.0, 0.1, 0.0, 2.0, 0.3, 0.1, 1.0, -0.1, 0.2];
/// let found = check::curve(&Hermite::new(), &[beam], 4);
/// assert!(found.agrees(), "{found}");
/// ```
pub fn curve<C, const N: usize>(curve: &C, beams: &[[f64; N]], cases: u64) -> OwnCurve
where
    C: Curve<N> + Clone + fmt::Debug + Send + Sync + 'static,
{
    let mut found = OwnCurve::default();
    for (i, beam) in (0..).zip(beams) {
        for k in 0..JETS {
            let mut rng = stream(i * JETS + k);
            let drawn = varied(curve, beam, &mut rng);
            // Ends are part of the beam.
            let xi = match k {
                0 => -1.0,
                1 => 1.0,
                _ => rng.random_range(-1.0..1.0),
            };
            let w = Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
            for finding in jet::findings(&drawn, &w, xi) {
                if found.jets.iter().all(|known| known.part != finding.part) {
                    found.jets.push(jet::rounder(&drawn, &w, finding));
                }
            }
        }
    }
    if beams.is_empty() || !found.jets.is_empty() {
        return found;
    }
    let regimes = Regime::ALL.len() as u64;
    let drawn = |number: u64| {
        let mut rng = stream((1 << 32) + number);
        let regime = Regime::ALL[usize::try_from(number % regimes).unwrap_or(0)];
        (regime, Pair::draw(curve, beams, (regime, number / regimes), &mut rng))
    };
    let costly = Costly { differences: false, routes: true };
    let compared = |pair: &Pair| {
        compare_beams(&CheckConfig::default(), costly, pair.beams(), &pair.contact, &|point| {
            pair.functions(point)
        })
    };
    let of_case = |&number: &u64| {
        let compared = compared(&drawn(number).1);
        let mut found = OwnCurve::default();
        for (_, verdict) in &compared {
            match verdict {
                Verdict::Inconclusive(reason, _) => *found.inconclusive.entry(*reason).or_default() += 1,
                Verdict::Pass(_) => found.compared += 1,
                Verdict::Mismatch(_) => {
                    found.compared += 1;
                    found.mismatches += 1;
                }
            }
        }
        (found, Finding::of(&compared).map(|finding| (number, finding)))
    };
    let all = parallel::map(&(0..cases * regimes).collect::<Vec<_>>(), of_case);
    let mut findings: Vec<(u64, Finding)> = Vec::new();
    for (of_case, finding) in all {
        found = found.and(of_case);
        let is_new = |(_, finding): &(u64, Finding)| {
            findings.iter().all(|(_, known)| known.diagnosis != finding.diagnosis)
        };
        findings.extend(finding.filter(is_new));
    }
    let shrunk = |(number, finding): (u64, Finding)| {
        let (regime, pair) = drawn(number);
        let of = |pair: &Pair| Finding::of(&compared(pair));
        let pair = shrink::shrunk(pair, |pair| of(pair).map(|finding| finding.diagnosis));
        (pair.words(regime), of(&pair).unwrap_or(finding))
    };
    found.findings = findings.into_iter().map(shrunk).collect();
    found
}

impl OwnCurve {
    /// Whether closest points were compared, and nothing differs beyond rounding.
    pub fn agrees(&self) -> bool {
        self.compared > 0 && self.jets.is_empty() && self.mismatches == 0
    }

    fn and(mut self, other: Self) -> Self {
        self.compared += other.compared;
        self.mismatches += other.mismatches;
        for (reason, count) in other.inconclusive {
            *self.inconclusive.entry(reason).or_default() += count;
        }
        self
    }
}

impl fmt::Display for OwnCurve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for jet in self.jets.iter().take(SHOWN) {
            writeln!(f, "{jet}")?;
        }
        if !self.jets.is_empty() {
            return write!(f, "DISAGREE: the jet is not the derivative of the position.");
        }
        for (pair, Finding { entry, diagnosis, .. }) in self.findings.iter().take(SHOWN) {
            let axis = entry.axis.map_or_else(String::new, |axis| format!(".{axis}"));
            writeln!(
                f,
                "{pair}\n  first wrong: {} of {}{axis} ({})\n  {:e}, not {:e}; rounding explains {:.1e}\n  compared with {}",
                entry.part,
                entry.quantity.name(),
                entry.order.name(),
                entry.closed,
                entry.other,
                entry.tolerance,
                diagnosis.against.join(",\n    ")
            )?;
        }
        for (reason, count) in &self.inconclusive {
            writeln!(f, "not compared: {count}, {}", reason.reason())?;
        }
        if self.mismatches > 0 {
            return write!(f, "DISAGREE: at {} of {} closest points.", self.mismatches, self.compared);
        }
        if self.compared == 0 {
            return write!(f, "NOTHING COMPARED: no closest point had derivatives.");
        }
        write!(f, "AGREE: at {} closest points nothing differs beyond rounding.", self.compared)
    }
}

/// The generator of this number.
fn stream(number: u64) -> ChaCha8Rng {
    let mut rng = ChaCha8Rng::seed_from_u64(0x5eed);
    rng.set_stream(number);
    rng
}

#[cfg(test)]
mod tests {
    use super::{CheckConfig, Costly, Pair, Regime, Verdict, compare_beams, stream};
    use crate::curve::Bezier;
    use std::collections::BTreeMap;

    /// No family has 15 dofs.
    #[test]
    fn a_curve_is_compared_with_its_own_number_of_dofs() {
        let beam = [0.0, 0.0, 0.0, 0.5, 0.1, 0.0, 1.0, 0.2, 0.1, 1.5, 0.1, 0.1, 2.0, 0.0, 0.2];
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        for regime in Regime::ALL {
            // The fourth family is Hermite.
            let pair = Pair::draw(&Bezier::<5>::new(), &[beam], (regime, 3), &mut stream(regime as u64));
            let costly = Costly { differences: false, routes: false };
            let config = CheckConfig::default();
            let own = |point: &_| pair.functions(point);
            for (_, verdict) in compare_beams(&config, costly, pair.beams(), &pair.contact, &own) {
                let Verdict::Pass(entries) = verdict else { continue };
                for entry in entries.iter().filter(|entry| entry.against.ends_with("of your curve")) {
                    *counts.entry(entry.against).or_default() += 1;
                }
            }
        }
        let points = counts["linearize, of your curve"] / 32;
        assert!(points >= 2, "{counts:?}");
        let expected = [32, 32, 92, 92].map(|each| each * points);
        let functions = ["linearize", "linearize_into", "closed_form::vary", "ad::vary"];
        assert_eq!(functions.map(|name| counts[&*format!("{name}, of your curve")]), expected);
    }
}
