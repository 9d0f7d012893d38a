//! Mismatches that are shrunk, and the result with them as JSON.

use super::{Checked, SHOWN, Shown};
use crate::cli::arguments::program;
use crate::cli::exit::Exit;
use crate::cli::{case_file, disagreements, json};
use beamgap::check::{LikelyCause, Moved, Shrunk, likely_cause, shrink_mismatches};
use serde::Serialize;
use serde_json::{Value, json};
use std::fmt::Write;

impl Checked {
    /// Shrinks the first mismatches. `all`: people see all tables even if the run fails.
    pub(in crate::cli) fn shown(self, all: bool) -> anyhow::Result<Shown> {
        let variant = self.config()?.variant;
        let shrunk = shrink_mismatches(&variant, self.seed, &self.found, SHOWN);
        let mut outcome = self.outcome();
        let wrong: Vec<u64> = self.found.mismatches.keys().copied().collect();
        let is_wrong = outcome.verdict.exit == Exit::Disagree && !wrong.is_empty();
        let cause = is_wrong.then(|| likely_cause(&variant, self.seed, &wrong)).flatten();
        if let Some(cause) = &cause {
            let _ = write!(outcome.verdict.words, "\n{}", disagreements::likely(cause));
        }
        Ok(Shown { outcome, checked: self, shrunk, cause, all })
    }
}

impl Shown {
    /// The result as JSON: the request, the result, and what follows from it.
    pub(in crate::cli) fn json(&self) -> anyhow::Result<String> {
        #[derive(Serialize)]
        struct Document<'a> {
            #[serde(flatten)]
            checked: &'a Checked,
            verdict: &'static str,
            compared: u64,
            not_reached: u64,
            /// The counts that are not those of the record.
            moved: Vec<Moved>,
            /// The command that repeats a mismatch, without the number of the case.
            repeat: String,
            likely_cause: Option<&'a LikelyCause>,
            shrunk: Vec<Value>,
        }
        let Self { checked, outcome, shrunk, cause, .. } = self;
        json::text(&Document {
            checked,
            verdict: outcome.verdict.name,
            compared: checked.found.compared(),
            not_reached: checked.asked().1,
            moved: checked.moved(),
            repeat: format!("{} check --seed {:#x}{} --case", program(), checked.seed, checked.options()),
            likely_cause: cause.as_ref(),
            shrunk: shrunk.iter().map(|shrunk| self.of_shrunk(shrunk)).collect(),
        })
    }

    fn of_shrunk(&self, shrunk: &Shrunk) -> Value {
        let Shrunk { number, case, finding } = shrunk;
        let mut value = json::compared(&finding.entry);
        value["case"] = json!(number);
        value["minimum"] = json!(finding.minimum);
        value["test"] = json!(disagreements::test(shrunk, &self.checked.planted));
        value["repeat"] = json!(case_file::command(case) + &self.checked.options());
        value["shrunk"] = json!(case_file::object(case));
        value
    }
}
