//! How many instructions the main scenarios take, `beamgap-instructions/1`: what a busy machine cannot blur.

use super::Record;
use serde::{Deserialize, Serialize};
use std::fmt;

/// How much a count may grow over the recorded one.
const ALLOWED: f64 = 0.03;

/// The counts of one machine and compiler.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Instructions {
    /// `beamgap-instructions/1`.
    pub schema: String,
    /// The compiler; others make other instructions of the same source.
    pub rustc: String,
    /// Which of the instruction sets there are that are chosen from at run time.
    pub target: String,
    /// What was run.
    pub command: String,
    /// The counts, scenario by scenario.
    pub rows: Vec<Count>,
}

/// The instructions that a scenario takes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Count {
    /// Its group and method.
    pub scenario: String,
    /// How many instructions one run takes.
    pub instructions: u64,
}

impl Record for Instructions {
    const SCHEMA: &'static str = "beamgap-instructions/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

/// How a count differs from the recorded one by more than it may.
#[derive(Clone, Debug, PartialEq)]
pub enum Difference {
    /// It has grown to so many times what it was: a failure.
    Grown(String, f64),
    /// It is not counted any more: a failure.
    Gone(String),
    /// It has shrunk to so many times what it was: the record is to be renewed.
    Shrunk(String, f64),
    /// It was not recorded: the record is to be renewed.
    New(String),
}

impl Difference {
    /// Whether it is one for the worse.
    pub fn is_failure(&self) -> bool {
        matches!(self, Self::Grown(..) | Self::Gone(_))
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Grown(scenario, times) => write!(f, "{scenario}: {times:.3} times as many instructions"),
            Self::Gone(scenario) => write!(f, "{scenario}: recorded, but counted no more"),
            Self::Shrunk(scenario, times) => {
                write!(f, "{scenario}: {times:.3} times as many; renew the record")
            }
            Self::New(scenario) => write!(f, "{scenario}: not in the record; renew it"),
        }
    }
}

impl Instructions {
    /// Whether the counts of `other` mean the same as these.
    pub fn is_comparable(&self, other: &Self) -> bool {
        (&self.rustc, &self.target) == (&other.rustc, &other.target)
    }

    /// How the counts of `now` differ from these.
    pub fn differences(&self, now: &Self) -> Vec<Difference> {
        let of = |all: &Self, scenario: &str| {
            all.rows.iter().find(|row| row.scenario == scenario).map(|row| row.instructions)
        };
        let changed = |row: &Count| {
            let scenario = || row.scenario.clone();
            let Some(counted) = of(now, &row.scenario) else { return Some(Difference::Gone(scenario())) };
            let times = as_number(counted) / as_number(row.instructions);
            match times {
                _ if times > 1.0 + ALLOWED => Some(Difference::Grown(scenario(), times)),
                _ if times < 1.0 - ALLOWED => Some(Difference::Shrunk(scenario(), times)),
                _ => None,
            }
        };
        let new = now.rows.iter().filter(|row| of(self, &row.scenario).is_none());
        let new = new.map(|row| Difference::New(row.scenario.clone()));
        self.rows.iter().filter_map(changed).chain(new).collect()
    }
}

#[expect(clippy::cast_precision_loss, reason = "counts instructions, far below 2^53")]
fn as_number(count: u64) -> f64 {
    count as f64
}
