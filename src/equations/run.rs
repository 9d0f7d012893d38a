//! Runs all draws and all cases, and makes the record.

use super::claim::claims;
use super::record::{EquationRow, EquationTable, Part, Run};
use super::source::{Place, places};
use super::table::{Equation, Order};
use super::tally::{Tallied, Tally};
use super::verdict::Verdict;
use super::{field, list, plain};
use crate::parallel;
use crate::test_beam::Family;
use std::collections::BTreeMap;

/// The default number of draws for each ordered pair of families.
pub const DRAWS: u64 = 16;
/// The cases of each regime in `f64`: each ordered pair of families once.
pub const CASES: u64 = 121;

/// Runs all equations, `draws` times for each ordered pair of families and at closest points of `cases` cases of each
/// regime.
///
/// The result depends on the arguments only, except the last digits of errors in `f64`.
pub fn equation_table(seed: u64, draws: u64, cases: u64) -> EquationTable {
    let pairs: Vec<[Family; 2]> =
        Family::ALL.into_iter().flat_map(|one| Family::ALL.map(|other| [one, other])).collect();
    let exact = parallel::map(&pairs, |&pair| {
        (0..draws).map(|draw| field::draw(seed, pair, draw)).fold(Tally::default(), Tally::merge)
    });
    let (plain, arcs) = plain::cases(seed, cases);
    let points = plain.points;
    let tally = exact.into_iter().fold(plain, Tally::merge);

    let mut equations = entries(&tally);
    if let Some(slip) = equations.iter_mut().find(|entry| entry.number == 14) {
        slip.arcs = arcs;
    }
    for entry in &mut equations {
        entry.verdict = entry.judged();
    }
    // (1) is run in every draw.
    let linear = equations.first().map_or(0, |entry| entry.as_printed.linear.total()) / draws.max(1);
    EquationTable {
        seed,
        draws,
        pairs: [linear, pairs.len() as u64 - linear],
        points,
        claims: claims(&equations),
        equations,
    }
}

/// Combines the words from the table, the numbers from the tally, and the places from the source.
fn entries(tally: &Tally) -> Vec<EquationRow> {
    let mut lines = tally.lines.iter();
    let mut places: BTreeMap<u8, Vec<Place>> = places();
    let entry = |(equation, [printed, corrected]): (Equation<_>, &[Tallied; 2])| {
        let parts = equation.parts.iter().map(|part| Part {
            name: part.name.to_owned(),
            order: part.order,
            runs: (part.lines.iter().zip(lines.by_ref()))
                .map(|(line, counted)| Run {
                    reading: line.reading,
                    words: line.words.to_owned(),
                    score: counted.score.score(),
                    symmetric: (part.order == Order::Second).then_some(counted.symmetric),
                })
                .collect(),
        });
        EquationRow {
            number: equation.number,
            says: equation.says.to_owned(),
            kind: equation.kind,
            verdict: Verdict::Refuted,
            printed: equation.printed.to_owned(),
            corrected: equation.corrected.map(str::to_owned),
            remark: equation.remark.to_owned(),
            as_printed: printed.score(),
            as_corrected: corrected.score(),
            parts: parts.collect(),
            omitted: list::omitted(equation.number, equation.printed),
            arcs: Vec::new(),
            places: places.remove(&equation.number).unwrap_or_default(),
        }
    };
    field::words().equations.into_iter().zip(&tally.equations).map(entry).collect()
}
