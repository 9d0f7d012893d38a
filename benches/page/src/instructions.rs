//! The instructions of the main scenarios, `beamgap-instructions/1`. The load of the machine does not affect the counts.

use beamgap::report::Record;
use serde::{Deserialize, Serialize};
use std::fmt;

/// The maximum relative growth of a count over the recorded count.
const ALLOWED: f64 = 0.03;

/// The counts of one machine and compiler.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Instructions {
    /// `beamgap-instructions/1`.
    pub schema: String,
    /// The compiler. Other compilers generate other instructions from the same source.
    pub rustc: String,
    /// The available instruction sets, of those that are chosen at run time.
    pub target: String,
    /// The command.
    pub command: String,
    /// The counts, scenario by scenario.
    pub rows: Vec<Count>,
}

/// The instructions of a scenario.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Count {
    /// Its group and method.
    pub scenario: String,
    /// The number of instructions of one run.
    pub instructions: u64,
}

impl Record for Instructions {
    const SCHEMA: &'static str = "beamgap-instructions/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

/// A difference of a count from the recorded count that exceeds the tolerance.
#[derive(Clone, Debug, PartialEq)]
pub enum Difference {
    /// The count has grown by this factor: a failure.
    Grown(String, f64),
    /// The scenario is no longer counted: a failure.
    Gone(String),
    /// The count has shrunk by this factor: the record must be renewed.
    Shrunk(String, f64),
    /// The scenario was not recorded: the record must be renewed.
    New(String),
}

impl Difference {
    /// Whether the difference is a failure.
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
    /// Whether the counts of `other` are comparable with these.
    pub fn is_comparable(&self, other: &Self) -> bool {
        (&self.rustc, &self.target) == (&other.rustc, &other.target)
    }

    /// The differences of the counts of `now` from these.
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
