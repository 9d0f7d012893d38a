//! Faults of the gate itself: whether it compares everything, at every closest point, and within narrow tolerances.
//!
//! The first cases of a regime, one for each pair of families, are compared as in `beamgap check`. The comparisons are
//! counted by kind and held against the numbers that belong to a closest point. Then each term is changed a little: by a
//! few times the smallest error that the tolerances of its entries leave undetected. The gate must reject the change, and
//! these errors must be small. A gate that multiplies its tolerances is thus detected.

use super::limit::{Limit, of_terms};
use super::test_points::{Sample, test_points};
use crate::check::serialized::by_name;
use crate::check::{
    Case, CheckConfig, Comparison, ELEMENT_ENTRIES, Order, Regime, Selection, Verdict, compare,
    compares_routes, judged,
};
use crate::closest_point::{Search, closest_points};
use crate::linearization::COMPONENTS;
use crate::number::Label;
use crate::parallel;
use crate::test_beam::{AnyBeam, Family};
use crate::variant::{ROUTE_ENTRIES, SCALARS, Variant, kernel_entries};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The cases of a regime: one for each pair of families.
const CASES: u64 = 121;
/// The change of a term over the smallest detected one.
const ABOVE: f64 = 4.0;
/// The largest median of the smallest detected errors. It is a thousand times what the tolerances are.
const LARGEST_MEDIAN: f64 = 1e-9;

enumeration! {
    /// What the gate compares.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Compared {
        /// The closest points that the search finds.
        Minima => "closest points",
        /// The values, with three routes of automatic differentiation.
        Values => "values",
        /// The first variations.
        First => "first variations",
        /// The second variations.
        Second => "second variations",
        /// The second variations with the directions exchanged.
        Symmetry => "symmetry",
        /// Gradients and Hessians.
        Matrices => "gradients and Hessians",
        /// What the functions of the library return.
        Functions => "functions",
    }
}

by_name!(Compared);

/// The gate in a regime.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gate {
    /// The regime.
    pub regime: Regime,
    /// What was compared, and what there is to compare.
    pub counts: BTreeMap<Compared, [usize; 2]>,
    /// The terms that were changed a little.
    pub terms: usize,
    /// Of these, the ones whose change was rejected.
    pub rejected: usize,
    /// The median of the smallest errors of terms that exceed a tolerance.
    pub median: Limit,
}

impl Gate {
    /// Whether everything is compared, within narrow tolerances.
    pub fn holds(&self) -> bool {
        let is_compared = |of: &Compared| self.counts.get(of).is_some_and(|[found, wanted]| found == wanted);
        Compared::ALL.iter().all(is_compared)
            && self.terms > 0
            && self.rejected == self.terms
            && self.median.0 <= LARGEST_MEDIAN
    }
}

/// Examines the gate in these regimes.
pub fn gate(seed: u64, regimes: &[Regime]) -> Vec<Gate> {
    regimes.iter().map(|&regime| of_regime(seed, regime)).collect()
}

fn of_regime(seed: u64, regime: Regime) -> Gate {
    let numbers = Selection { regimes: vec![regime], family: None, cases: CASES }.numbers();
    let of_case = |number: &u64| counts(&Case::draw(seed, *number));
    let all = parallel::map(&numbers, of_case);
    let mut counts: BTreeMap<Compared, [usize; 2]> = BTreeMap::new();
    for (of, [found, wanted]) in all.into_iter().flatten() {
        let sum = counts.entry(of).or_default();
        *sum = [sum[0] + found, sum[1] + wanted];
    }
    let points = test_points(seed, regime);
    let samples: Vec<_> = points.iter().flat_map(|(case, point)| Sample::in_all_forms(case, point)).collect();
    // A term that has no share in any number at these points has no limit.
    let limits: Vec<_> = of_terms(&samples).into_iter().filter(|(_, limit, _)| limit.0 < 0.1).collect();
    let is_rejected = |&&(term, Limit(limit), i): &&(Label, Limit, usize)| {
        let changed = Variant::Weighted(term, 1.0 + ABOVE * limit);
        matches!(judged(samples[i].compared(&changed)), Verdict::Mismatch(_))
    };
    let rejected = limits.iter().filter(is_rejected).count();
    let mut sorted: Vec<f64> = limits.iter().map(|(_, limit, _)| limit.0).collect();
    sorted.sort_by(f64::total_cmp);
    let median = Limit(sorted.get(sorted.len() / 2).copied().unwrap_or(f64::INFINITY));
    Gate { regime, counts, terms: limits.len(), rejected, median }
}

/// What is compared in a case, and what there is to compare.
fn counts(case: &Case) -> Vec<(Compared, [usize; 2])> {
    let [beam, bar] = case.beams();
    let config = CheckConfig::default();
    let minima = closest_points(beam, bar, &Search::default()).map_or(0, |found| found.minima.len());
    let verdicts = compare(&config, case);
    let at_points: Vec<_> = verdicts.iter().filter(|(point, _)| point.is_some()).collect();
    let mut counts = vec![(Compared::Minima, [at_points.len(), minima])];
    let is_linear = case.families.into_iter().all(Family::is_linear);
    let kernel = if is_linear { kernel_entries([beam, bar].map(AnyBeam::dofs)) } else { 0 };
    let routes = if compares_routes(case.number) { ROUTE_ENTRIES + ELEMENT_ENTRIES } else { 0 };
    for (_, verdict) in at_points {
        let (Verdict::Pass(entries) | Verdict::Mismatch(entries)) = verdict else { continue };
        let mut found = BTreeMap::new();
        for entry in entries {
            *found.entry(kind(entry)).or_insert(0) += 1;
        }
        let each = 3 * COMPONENTS;
        let wanted = [each, 2 * each, each, COMPONENTS, 3 * SCALARS, kernel + routes];
        let kinds = Compared::ALL.into_iter().skip(1).zip(wanted);
        counts.extend(kinds.map(|(of, wanted)| (of, [found.get(&Some(of)).copied().unwrap_or(0), wanted])));
    }
    counts
}

/// The kind of a comparison; none for the differences, which are computed only where they are needed, and for elements with
/// d = 0, which not every pair allows.
fn kind(entry: &Comparison) -> Option<Compared> {
    if entry.is_by_differences() || entry.is_with_crossing() {
        return None;
    }
    Some(match entry.order {
        Order::Symmetry => Compared::Symmetry,
        Order::Matrix => Compared::Matrices,
        Order::Function => Compared::Functions,
        Order::Value => Compared::Values,
        Order::First => Compared::First,
        Order::Second => Compared::Second,
    })
}

#[cfg(test)]
mod tests {
    use super::{Compared, gate};
    use crate::check::Regime;

    #[test]
    fn the_gate_compares_everything_within_narrow_tolerances() {
        for gate in gate(0x5eed, &[Regime::Generic, Regime::NearEnd]) {
            assert!(gate.holds(), "{gate:?}");
            assert!(gate.counts[&Compared::Minima][0] >= 121 && gate.terms > 180, "{gate:?}");
        }
    }

    #[test]
    fn a_gate_that_leaves_something_out_does_not_hold() {
        let whole = gate(1, &[Regime::Generic]).remove(0);
        assert!(whole.holds(), "{whole:?}");
        for of in Compared::ALL {
            let mut less = whole.clone();
            less.counts.entry(of).and_modify(|[found, _]| *found -= 1);
            assert!(!less.holds(), "{of:?}");
        }
        let mut wide = whole.clone();
        wide.median.0 *= 1e6;
        let mut deaf = whole;
        deaf.rejected -= 1;
        assert!(!wide.holds() && !deaf.holds());
    }
}
