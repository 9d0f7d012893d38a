//! Every operation of the closed form made wrong, one at a time, over the prime field.
//!
//! The code that is run is the library's own, over a scalar that counts its operations. An operation is made wrong in
//! its result: by its sign, lost, doubled, or one too large; or replaced by the result that the same operation has in a
//! run with the directions exchanged, with the beams exchanged, with the beam in place of the bar beam, or at other
//! parameters. A fault is shown if some number that comes out is another one. The proof, which compares these numbers with
//! automatic differentiation by `==`, shows it too then.

mod place;

use crate::number::{Bits, Change, Residue, counted, locate, operations, with_operation};
use crate::specimen::Family;
use crate::subject::Kind;
use place::Place;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Code that is run with its operands as they are, or mistaken for others; returns all numbers that come out.
type Code<'a> = dyn Fn(Option<Kind>) -> Vec<u64> + Sync + 'a;

/// What became of the faults of one code in one place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Operations {
    /// The code.
    pub code: String,
    /// Where it was run: in which form, and which ends held a parameter.
    pub place: &'static str,
    /// How many operations it has.
    pub operations: usize,
    /// How many of their faults change a result.
    pub faults: usize,
    /// How many of these change a number that comes out.
    pub shown: usize,
    /// Operations of which no fault does, and faults that do not of operations of which others do.
    pub unseen: Vec<Unseen>,
}

impl Operations {
    /// Whether every fault is shown, but for those with a reason.
    pub fn is_whole(&self) -> bool {
        self.faults > 0 && self.unseen.iter().all(|unseen| unseen.reason.is_some())
    }
}

/// What no number that comes out depends on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unseen {
    /// The number of the operation.
    pub operation: usize,
    /// What was wrong with it.
    pub wrong: &'static str,
    /// The lines of the source, if the build knows them, from the operation outwards.
    pub at: Vec<String>,
    /// Why that is right, if it is known.
    pub reason: Option<&'static str>,
}

/// What is wrong with an operation by itself.
const ALONE: [(&str, Change); 4] = [
    ("sign", Change::Times(-1.0)),
    ("lost", Change::Times(0.0)),
    ("doubled", Change::Times(2.0)),
    ("plus one", Change::PlusOne),
];

/// All operations of the equations, the matrices, the kernel in every layout, and the jets of all families.
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
        let mut random = || Residue::new(rng.random());
        let (jets, now, before) = (model.jets(&mut random), random(), random());
        let run = |kind: Option<Kind>| jets(if kind.is_some() { before } else { now });
        all.push(examined(format!("jet of {}", family.name()), "-", &[Kind::Stale], &run));
    }
    all
}

/// Why nothing depends on operations: of codes whose names start so, in places whose names end so, in this file if it is
/// known.
const REASONS: [(&str, &str, &str, &str); 10] = [
    ("", " end", "", "a parameter that an end holds does not vary: what multiplies its variation is lost"),
    ("", " ends", "", "parameters that ends hold do not vary: what multiplies their variations is lost"),
    ("kernel, blocks", "", "blocks/", "of a row that is written further than the layout reaches"),
    ("kernel, packed", "", "blocks/", "of a row that is written further than the layout reaches"),
    ("kernel, gradient", "", "blocks/", "of second order, which a gradient has no use for"),
    ("kernel", "length, products", "", "for the common normal, which this form does not take"),
    ("kernel", " cross", "", "for the form that is not taken"),
    ("matrices", "", "closed_form/form.rs", "t x t_bar enters by its square alone"),
    (
        "jet of nurbs",
        "",
        "curve/",
        "a factor of all basis functions cancels, and the point is moved to the origin",
    ),
    ("jet of", "", "curve/screw", "along unit vectors, of which two components vanish"),
];

fn reason(code: &str, place: &str, at: &[String]) -> Option<&'static str> {
    let is_there = |file: &str| at.is_empty() || at.iter().any(|line| line.contains(file));
    let holds = |(of, on, file, _): &&(&str, &str, &str, &'static str)| {
        code.starts_with(of) && place.ends_with(on) && is_there(file)
    };
    REASONS.iter().find(holds).map(|(.., reason)| *reason)
}

fn examined(code: String, place: &'static str, kinds: &[Kind], run: &Code<'_>) -> Operations {
    let (sound, count) = counted(|| run(None));
    let own = operations(|| run(None));
    let others: Vec<_> = kinds.iter().map(|&kind| (kind.name(), operations(|| run(Some(kind))))).collect();
    let of_operation = |k: usize| {
        let alone = ALONE.into_iter();
        let mistaken =
            others.iter().filter_map(|(name, other)| Some((*name, Change::Instead(*other.get(k)?))));
        let changes = alone
            .chain(mistaken)
            .filter(|(_, change)| change.of(Residue::from_bits(own[k])).bits() != own[k]);
        let is_shown = |change| with_operation(k, change, || run(None)) != sound;
        changes.map(|(name, change)| (name, is_shown(change))).collect::<Vec<_>>()
    };
    let found: Vec<_> = (0..count).into_par_iter().map(of_operation).collect();
    let mut all = Operations { code, place, operations: count, faults: 0, shown: 0, unseen: Vec::new() };
    for (operation, faults) in found.into_iter().enumerate() {
        let shown = faults.iter().filter(|(_, is_shown)| *is_shown).count();
        (all.faults, all.shown) = (all.faults + faults.len(), all.shown + shown);
        let unseen = |wrong| {
            let at = locate(operation, || run(None));
            let reason = reason(&all.code, place, &at);
            Unseen { operation, wrong, at, reason }
        };
        let missed = faults.iter().filter(|(_, is_shown)| !is_shown).map(|(wrong, _)| *wrong);
        let missed =
            if shown == 0 { missed.take(1).map(|_| "any").collect() } else { missed.collect::<Vec<_>>() };
        let missed: Vec<_> = missed.into_iter().map(unseen).collect();
        all.unseen.extend(missed);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::{Kind, Place, examined};
    use crate::number::{Faulty, Real, Residue};
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    #[test]
    fn an_operation_that_nothing_depends_on_is_found() {
        // x y + z, and a product that is dropped.
        let run = |kind: Option<Kind>| {
            let [x, y, z] =
                if kind.is_some() { [3, 2, 7] } else { [2, 3, 5] }.map(|n| Faulty(Residue::new(n)));
            let _ = x * z;
            vec![(x * y + z).0.value()]
        };
        let found = examined("code".to_owned(), "place", &[Kind::Swapped], &run);
        // The product of 2 and 3 is that of 3 and 2: swapped, it is no fault.
        assert_eq!((found.operations, found.faults, found.shown), (3, 14, 9));
        assert_eq!(found.unseen.len(), 1);
        assert_eq!((found.unseen[0].operation, found.unseen[0].wrong), (0, "any"));
        assert!(!found.is_whole());
    }

    #[test]
    fn no_fault_of_the_equations_is_missed_inside_both_beams() {
        let places = Place::all(&mut ChaCha8Rng::seed_from_u64(1));
        for place in places.iter().filter(|place| !place.name.contains("end")) {
            let (code, kinds, run) = place.codes().swap_remove(0);
            let found = examined(code.to_owned(), place.name, kinds, &*run);
            assert!(found.operations > 400 && found.shown == found.faults && found.is_whole(), "{found:?}");
        }
        let root = |x: u64| Faulty(Residue::new(x)).sqrt().0.value();
        assert_eq!((root(4) * root(4), root(Residue::PRIME - 4)), (4, Residue::PRIME - 4));
    }
}
