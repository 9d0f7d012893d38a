//! The verdict on a run.

use super::Checked;
use crate::cli::count::count;
use crate::cli::exit::Exit;
use crate::cli::outcome::{Entry, Outcome, Source, State, Verdict};
use crate::cli::searched;
use crate::cli::terminal::folded;
use beamgap::check::{Cell, Tally};
use std::fmt::Write;

impl Checked {
    /// The verdict on the result.
    pub(in crate::cli) fn verdict(&self) -> Verdict {
        let found = &self.found;
        let tallies = || found.regimes.values();
        let left = tallies().map(Tally::left_out).sum();
        let untrusted = found.mismatches.values().filter_map(|mismatch| mismatch.arbitration);
        let untrusted = untrusted.filter(|who| who.is_untrusted()).count();
        let wrong = tallies().map(|tally| tally.mismatches).sum();
        let verdict = crate::cli::check::in_words(found.compared(), wrong, left, untrusted);
        let mut verdict = verdict.and_search(searched::verdict(self));
        self.hold_against_record(&mut verdict);
        if let (asked, missed @ 1..) = self.asked() {
            let _ = write!(verdict.words, "\nNot reached in time: {missed} of {}.", count(asked, "case"));
        }
        verdict
    }

    /// A run that agrees, but does not compare the points of the record, is not trusted.
    fn hold_against_record(&self, verdict: &mut Verdict) {
        let moved = self.moved();
        let Some(first) = moved.first() else { return };
        let others = match moved.len() - 1 {
            0 => String::new(),
            others => format!(" ({} moved too)", count(others, "other count")),
        };
        let words = folded(&format!("{first}{others}."), "", "  ")
            + &format!("\nIf this is intended, write the record anew:\n{}", searched::recording());
        if verdict.exit == Exit::Agree {
            let words = format!(
                "UNTRUSTED: what is compared is not what the record has.\n{words}\n{}",
                verdict.words
            );
            *verdict = Verdict::new(Exit::Untrusted, "untrusted", words);
        } else {
            let _ = write!(verdict.words, "\nWhat is compared is not what the record has.\n{words}");
        }
    }

    /// The verdict with one entry for each order of each quantity.
    pub(in crate::cli) fn outcome(&self) -> Outcome {
        let entries = self.found.quantities.iter().map(|(&(quantity, order), cell)| {
            let &Cell { scaled_error, over_tolerance, case, entries } = cell;
            let state = State::of(entries, u64::from(over_tolerance > 1.0));
            let numbers = count(entries, "number");
            let differs = if state == State::Differs { "differs beyond rounding: " } else { "" };
            let message = format!(
                "{differs}{numbers}; the largest error is {scaled_error:.1e} of the scale, in case {case}; the largest error / \
                 tolerance is {over_tolerance:.1e}"
            );
            let source = Some(Source::of_formula(order, quantity));
            Entry { group: order.name().to_owned(), name: quantity.name().to_owned(), state, message, source }
        });
        let search = &self.found.search;
        let search = (search.pairs > 0).then(|| searched::entry(search.pairs, search.differing()));
        Outcome { command: "check", verdict: self.verdict(), entries: entries.chain(search).collect() }
    }
}
