//! The readings of an equation as a table, and its numbers and counts.

use crate::equations::{Counts, EquationRow, Run, Symmetry};
use crate::report::number::{count, error};
use crate::report::page::Block;

/// The rows of an equation's readings.
pub(super) fn readings(entry: &EquationRow, shown: impl Fn(&Run) -> bool) -> Block {
    let mut rows = Vec::new();
    for part in &entry.parts {
        for run in part.runs.iter().filter(|run| shown(run)) {
            let counts = |counts: Counts| [count(counts.equal), count(counts.refuted)];
            let names = [part.name.clone(), run.name()];
            let draws = [counts(run.score.linear), counts(run.score.nonlinear)].into_iter().flatten();
            let symmetric = run.symmetry().map_or("", Symmetry::words).to_owned();
            rows.push(
                names
                    .into_iter()
                    .chain(draws)
                    .chain(run.score.errors.map(error))
                    .chain([symmetric])
                    .collect(),
            );
        }
    }
    let head = [
        "part",
        "reading",
        "#dofs linear: equal",
        "#refuted",
        "#nonlinear: equal",
        "#refuted",
        "#error: dofs linear",
        "#nonlinear",
        "symmetric",
    ];
    Block::table(&head, rows)
}

/// The numbers of equations, as printed in the paper.
pub(super) fn numbers(entries: &[&EquationRow]) -> String {
    entries.iter().map(|entry| format!("({})", entry.number)).collect::<Vec<_>>().join(", ")
}

/// Refuted draws of all draws.
pub(super) fn refuted(counts: [Counts; 2]) -> String {
    if counts.iter().all(|counts| counts.total() == 0) {
        return String::new();
    }
    counts.map(|counts| count(counts.refuted)).join(", ")
}
