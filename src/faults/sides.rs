//! Faults that act on one side of a symmetry only: whether the cases of the check detect each of them.
//!
//! An element may be wrong only where the crossing is obtuse, or only where the bar beam lies on the other side. Such a
//! fault is a fault of the catalogue times a condition. The cases of `beamgap check` are gone through in their order, in all
//! formulations of the closed form, until each is detected or the default number of cases is reached.

use super::test_points::Sample;
use crate::check::{Case, Selection, Symmetry, geometry};
use crate::check::{Regime, Verdict, judged};
use crate::closest_point::{ClosestPoint, Search, closest_points};
use crate::parallel;
use crate::variant::{Fault, Variant, catalogue};
use serde::{Deserialize, Serialize};

/// The largest number of cases of each regime: the default of `beamgap check`.
const CASES: u64 = 10_000;
/// The number of cases whose closest points are evaluated at a time.
const AT_ONCE: usize = 32;
/// A fault that is not detected on either side of a symmetry after this many points there acts on neither.
const TRIES: u8 = 60;

/// The detections of faults that act on one side only.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct OneSided {
    /// The number of faults, each on either side of each symmetry.
    pub planted: usize,
    /// The number of detected ones.
    pub detected: usize,
    /// The number of cases, over all regimes, after which they are detected.
    pub cases: u64,
    /// Those that are not detected although the same fault is on the other side: the fault, and the side in words.
    pub missed: Vec<(String, String)>,
    /// Those that act on neither side, such as a term that is used only where no parameter is held on a side on which one
    /// is.
    pub neither: usize,
}

impl OneSided {
    /// Whether all are detected that act at all.
    pub fn holds(&self) -> bool {
        self.missed.is_empty() && self.detected > 0 && self.detected + self.neither == self.planted
    }
}

/// Some sides of symmetries: two bits for each symmetry.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Sides(u64);

impl Sides {
    const ALL: Self = Self((1 << (2 * Symmetry::ALL.len())) - 1);

    /// The sides on which a point lies.
    fn of(case: &Case, point: &ClosestPoint) -> Self {
        let at = geometry(case, point);
        let of = |(i, symmetry): (usize, Symmetry)| match symmetry.is_positive(&at, point, &case.contact) {
            Some(is_positive) => 1 << (2 * i + usize::from(!is_positive)),
            None => 0,
        };
        Self(Symmetry::ALL.into_iter().enumerate().map(of).sum())
    }

    fn both(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// Both sides of the symmetry of this number.
    fn of_symmetry(i: usize) -> Self {
        Self(0b11 << (2 * i))
    }

    fn count(self) -> usize {
        self.0.count_ones() as usize
    }

    /// The sides in words.
    fn words(self) -> impl Iterator<Item = &'static str> {
        Symmetry::ALL
            .into_iter()
            .enumerate()
            .flat_map(move |(i, symmetry)| {
                let [_, sides @ ..] = symmetry.sides();
                sides.into_iter().enumerate().filter(move |(side, _)| self.0 >> (2 * i + side) & 1 == 1)
            })
            .map(|(_, side)| side)
    }
}

/// A fault with the sides on which it is not detected yet.
#[derive(Clone, Debug, PartialEq)]
struct Open {
    fault: Fault,
    sides: Sides,
    /// Of these, the ones of symmetries on whose other side it is not detected either.
    neither: Sides,
    /// The number of points at which it was not detected, for each symmetry.
    tries: [u8; Symmetry::ALL.len()],
}

impl Open {
    fn new(fault: Fault) -> Self {
        Self { fault, sides: Sides::ALL, neither: Sides::ALL, tries: [0; Symmetry::ALL.len()] }
    }

    /// The sides that are not given up.
    fn wanted(&self) -> Sides {
        let mut wanted = self.sides;
        for (i, tries) in self.tries.into_iter().enumerate() {
            let both = Sides::of_symmetry(i);
            if tries >= TRIES && self.neither.both(both) == both {
                wanted = wanted.without(both);
            }
        }
        wanted
    }

    /// Removes the sides on which the fault is detected at one of the samples.
    fn close(&mut self, samples: &[(Sides, Sample<'_>)]) {
        let variant = Variant::Faulty(vec![self.fault]);
        for (sides, sample) in samples {
            let asked = self.wanted().both(*sides);
            if asked == Sides::default() {
                continue;
            }
            if matches!(judged(sample.compared(&variant)), Verdict::Mismatch(_)) {
                self.sides = self.sides.without(*sides);
            }
            for (i, tries) in self.tries.iter_mut().enumerate() {
                let both = Sides::of_symmetry(i);
                if self.sides.both(both) != both {
                    self.neither = self.neither.without(both);
                } else if asked.both(both) != Sides::default() {
                    *tries = tries.saturating_add(1);
                }
            }
        }
    }
}

/// Injects every fault on every side, in these regimes.
///
/// The result depends on the seed and the regimes, not on the number of threads.
pub fn one_sided(seed: u64, regimes: &[Regime]) -> OneSided {
    of_faults(seed, regimes, catalogue())
}

fn of_faults(seed: u64, regimes: &[Regime], faults: Vec<Fault>) -> OneSided {
    let numbers = Selection { regimes: regimes.to_vec(), family: None, cases: CASES }.numbers();
    let mut open: Vec<Open> = faults.into_iter().map(Open::new).collect();
    let mut cases = 0;
    for block in numbers.chunks(AT_ONCE) {
        if open.iter().all(|of| of.wanted() == Sides::default()) {
            break;
        }
        let drawn: Vec<Case> = block.iter().map(|&number| Case::draw(seed, number)).collect();
        let samples = parallel::flat_map(&drawn, samples);
        open = parallel::map(&open, |of| {
            let mut of = of.clone();
            of.close(&samples);
            of
        });
        cases += block.len() as u64;
    }
    let count = |of: fn(&Open) -> Sides| open.iter().map(|fault| of(fault).count()).sum::<usize>();
    let missed = open.iter().flat_map(|of| {
        let missed = of.sides.without(of.neither);
        missed.words().map(|side| (of.fault.to_string(), side.to_owned()))
    });
    let planted = count(|_| Sides::ALL);
    OneSided {
        planted,
        detected: planted - count(|of| of.sides),
        cases,
        missed: missed.collect(),
        neither: count(|of| of.sides.both(of.neither)),
    }
}

/// The closest points of a case with their sides, in all formulations in which the check passes there.
fn samples(case: &Case) -> Vec<(Sides, Sample<'_>)> {
    let [beam, bar] = case.beams();
    let minima = closest_points(beam, bar, &Search::default()).map(|found| found.minima).unwrap_or_default();
    let passes =
        |sample: &Sample<'_>| matches!(judged(sample.compared(&Variant::Unmodified)), Verdict::Pass(_));
    let at_point = |point: ClosestPoint| {
        let sides = Sides::of(case, &point);
        let samples = Sample::in_all_forms(case, &point).into_iter().filter(passes);
        samples.map(move |sample| (sides, sample)).collect::<Vec<_>>()
    };
    minima.into_iter().flat_map(at_point).collect()
}

#[cfg(test)]
mod tests {
    use super::{Sides, of_faults};
    use crate::check::{Regime, Symmetry};
    use crate::variant::catalogue;

    #[test]
    fn a_fault_on_one_side_is_detected_on_both() {
        let some: Vec<_> = catalogue().into_iter().step_by(61).collect();
        let count = some.len();
        let found = of_faults(0x5eed, &[Regime::Generic, Regime::NearEnd], some);
        assert_eq!(found.missed, [], "{found:?}");
        assert!(found.holds() && found.planted == 40 * count, "{found:?}");
        // A term that is used only inside the beams acts at no end, so a count of zero would detect what is not there.
        assert!(found.neither > 0 && found.neither <= 4 * count, "{found:?}");
    }

    #[test]
    fn a_side_has_its_words() {
        assert_eq!(Sides::ALL.words().count(), 2 * Symmetry::ALL.len());
        let [_, _, negative] = Symmetry::ALL[1].sides();
        assert_eq!(Sides(0b1000).words().collect::<Vec<_>>(), [negative]);
        let one = Sides::of_symmetry(1);
        assert_eq!((one.count(), Sides::ALL.without(one).both(one)), (2, Sides::default()));
    }
}
