//! Faults in every operation of the closed form, one at a time, over the prime field.
//!
//! The code under test is that of the library, over a scalar that counts its operations. A fault changes the result of an
//! operation: its sign is wrong, it is lost, it is doubled, or it is one too large. Or the result of the same operation in
//! another run replaces it: with the directions or the beams exchanged, with the beam in place of the bar beam, or at other
//! parameters. A fault is detected if it changes some output. The proof compares these outputs with
//! automatic differentiation by `==`, so it detects the fault too.

mod place;
mod reason;

use crate::check::serialized::{Name, name};
use crate::number::{Bits, Change, PrimeField, Traced, counted, locate, operations, with_operation};
use crate::parallel;
use crate::test_beam::Family;
use crate::variant::Kind;
use place::Place;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
pub use reason::Lost;
use reason::reason;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Code that is run with its operands, or with other values in their place. It returns all outputs.
type Code<'a> = dyn Fn(Option<Kind>) -> Vec<u64> + Sync + 'a;

/// The results for the faults of one code in one place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Operations {
    /// The code.
    pub code: String,
    /// The place of the run: the formulation, and the ends at which a parameter is held.
    #[serde(deserialize_with = "name")]
    pub place: Name,
    /// The number of its operations.
    pub operations: usize,
    /// The number of faults that change the result of their operation.
    pub faults: usize,
    /// The number of these faults that change an output.
    pub detected: usize,
    /// Operations none of whose faults changes an output, and undetected faults of operations with other detected faults.
    pub undetected: Vec<Undetected>,
}

impl Operations {
    /// Whether every fault is detected, except those with a reason.
    pub fn is_whole(&self) -> bool {
        self.faults > 0 && self.undetected.iter().all(|undetected| undetected.reason.is_some())
    }
}

/// Operations that do not affect any output, equal in everything except their number.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Undetected {
    /// The line of the source, and the line that calls it; empty if the build has no line numbers.
    pub at: String,
    /// The first named term that is computed after them.
    pub term: Option<String>,
    /// The fault.
    #[serde(deserialize_with = "name")]
    pub wrong: Name,
    /// Why no output depends on them.
    pub lost: Lost,
    /// The reason why that is correct, if it is known.
    pub reason: Option<String>,
    /// The number of operations.
    pub operations: usize,
}

/// The faults of an operation that need no other run.
const ALONE: [(&str, Change); 4] = [
    ("sign", Change::Times(-1.0)),
    ("lost", Change::Times(0.0)),
    ("doubled", Change::Times(2.0)),
    ("plus one", Change::PlusOne),
];

/// All operations of the equations, the matrices, the contact element, the kernel in every layout, and the jets of all
/// families.
pub fn all_operations(seed: u64) -> Vec<Operations> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let places = Place::all(&mut rng);
    let mut all = Vec::new();
    for place in &places {
        for (code, kinds, run) in place.codes() {
            all.push(examined(code.to_owned(), place.name, kinds, &*run));
        }
    }
    for family in Family::ALL {
        let model = family.model(&mut rng);
        let mut random = || Traced::from(PrimeField::new(rng.random()));
        let (jets, now, before) = (model.jets(&mut random), random(), random());
        let run = |kind: Option<Kind>| jets(if kind.is_some() { before } else { now });
        all.push(examined(format!("jet of {}", family.name()), "-", &[Kind::Stale], &run));
    }
    all
}

pub(super) fn examined(code: String, place: &'static str, kinds: &[Kind], run: &Code<'_>) -> Operations {
    let (unmodified, count) = counted(|| run(None));
    let own = operations(|| run(None));
    let others: Vec<_> = kinds.iter().map(|&kind| (kind.name(), operations(|| run(Some(kind))))).collect();
    let of_operation = |k: usize| {
        let alone = ALONE.into_iter();
        let mistaken =
            others.iter().filter_map(|(name, other)| Some((*name, Change::Instead(*other.get(k)?))));
        let changes =
            alone.chain(mistaken).filter(|(_, change)| change.of(Traced::from_bits(own[k])).bits() != own[k]);
        let is_detected = |change| with_operation(k, change, || run(None)) != unmodified;
        changes.map(|(name, change)| (name, is_detected(change))).collect::<Vec<_>>()
    };
    let found = parallel::indices(count, of_operation);
    let mut all =
        Operations { code, place, operations: count, faults: 0, detected: 0, undetected: Vec::new() };
    let mut counts: BTreeMap<_, usize> = BTreeMap::new();
    for (operation, faults) in found.into_iter().enumerate() {
        let detected = faults.iter().filter(|(_, is_detected)| *is_detected).count();
        (all.faults, all.detected) = (all.faults + faults.len(), all.detected + detected);
        let undetected = |wrong| {
            let (at, term) = locate(operation, || run(None));
            let lost = Lost::of(operation, || run(None));
            let reason = reason(lost, &all.code, place, &at);
            let at = at.iter().take(2).map(String::as_str).collect::<Vec<_>>().join(" from ");
            (at, term.map(|term| term.to_string()), wrong, lost, reason)
        };
        let missed = faults.iter().filter(|(_, is_detected)| !is_detected).map(|(wrong, _)| *wrong);
        let missed =
            if detected == 0 { missed.take(1).map(|_| "any").collect() } else { missed.collect::<Vec<_>>() };
        for key in missed.into_iter().map(undetected) {
            *counts.entry(key).or_default() += 1;
        }
    }
    all.undetected = counts
        .into_iter()
        .map(|((at, term, wrong, lost, reason), operations)| {
            let reason = reason.map(str::to_owned);
            Undetected { at, term, wrong, lost, reason, operations }
        })
        .collect();
    all
}

#[cfg(test)]
mod tests {
    use super::{Kind, Lost, Place, examined};
    use crate::number::{Bits, Faulty, PrimeField, Real, Traced};
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use std::collections::BTreeSet;

    #[test]
    fn an_operation_that_nothing_depends_on_is_found() {
        // x y + z, a product that is dropped, one that is multiplied by zero, and one that cancels.
        let run = |kind: Option<Kind>| {
            let [x, y, z] = if kind.is_some() { [3, 2, 7] } else { [2, 3, 5] };
            let [x, y, z, zero] = [x, y, z, 0].map(|n| Faulty(Traced::from(PrimeField::new(n))));
            let _ = x * z;
            let twice = z + z;
            let cancels = x + z;
            vec![(x * y + z + twice * zero + (cancels - cancels)).0.bits()]
        };
        let found = examined("code".to_owned(), "place", &[Kind::Swapped], &run);
        let lost: BTreeSet<_> =
            found.undetected.iter().map(|of| (of.lost, of.wrong, of.operations)).collect();
        let expected = [Lost::Unused, Lost::TimesZero, Lost::Cancels];
        assert_eq!(lost, expected.map(|lost| (lost, "any", 1)).into());
        // The product of 2 and 3 is that of 3 and 2: the exchange is not a fault. A zero has one fault, plus one.
        assert_eq!((found.operations, found.faults, found.detected), (9, 36, 21));
        assert!(!found.is_whole());
    }

    #[test]
    fn no_fault_of_the_equations_is_missed_inside_both_beams() {
        let places = Place::all(&mut ChaCha8Rng::seed_from_u64(1));
        for place in places.iter().filter(|place| !place.name.contains("end")) {
            let (code, kinds, run) = place.codes().swap_remove(0);
            let found = examined(code.to_owned(), place.name, kinds, &*run);
            assert!(
                found.operations > 400 && found.detected == found.faults && found.is_whole(),
                "{found:?}"
            );
        }
        let root = |x: u64| Faulty(PrimeField::new(x)).sqrt().0.value();
        assert_eq!((root(4) * root(4), root(PrimeField::PRIME - 4)), (4, PrimeField::PRIME - 4));
    }
}
