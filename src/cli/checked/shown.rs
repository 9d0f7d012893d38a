//! The result of a run with its shrunk mismatches, for people and as JSON.

use super::Checked;
use crate::cli::arguments::program;
use crate::cli::outcome::Outcome;
use crate::cli::{case_file, disagreements, human, json};
use beamgap::check::{LikelyCause, Moved, Shrunk};
use serde::Serialize;
use serde_json::{Value, json};

/// A result with its shrunk mismatches.
pub(in crate::cli) struct Shown {
    pub(in crate::cli) checked: Checked,
    pub(in crate::cli) outcome: Outcome,
    pub(in crate::cli) shrunk: Vec<Shrunk>,
    /// The likely cause of the mismatches, if it is known.
    pub(in crate::cli) cause: Option<LikelyCause>,
    /// Whether people see all tables even if the run fails.
    pub(in crate::cli) all: bool,
}

impl Shown {
    /// The result for people.
    pub(in crate::cli) fn human(&self) -> String {
        human::document(self)
    }

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
