//! The record of the benchmarks, `beamgap-benchmark/7`.

use crate::criterion::{Verdict, Verdicts, rounds, samples};
use crate::{BenchmarkError, Instructions, Peers, Rounds, Task, spread};
use beamgap::report::number::{number, rounded};
use beamgap::report::{Environment, Record, ReportError};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The method whose time is the denominator of the ratios in a group.
pub const CLOSED_FORM: &str = "closed form";

/// All measurements, and their environment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Benchmark {
    /// `beamgap-benchmark/7`.
    pub schema: String,
    /// The environment of the measurements.
    pub environment: Environment,
    /// The scenarios, group by group.
    pub scenarios: Vec<Measured>,
    /// The counts of instructions, if they exist.
    pub instructions: Option<Instructions>,
    /// Other programs, if they were measured.
    pub peers: Option<Peers>,
}

/// The measurement of one method for one task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// The task.
    pub task: String,
    /// The family of both beams.
    pub family: String,
    /// The dofs of both beams together.
    pub dofs: usize,
    /// The method.
    pub method: String,
    /// The number of pairs in a run. All times are those of one pair.
    pub pairs: usize,
    /// The median time in nanoseconds.
    pub median: f64,
    /// The 95 % interval of the median.
    pub interval: [f64; 2],
    /// The time over that of the closed form, round by round, if there is one for the same task and beams. For four
    /// pairs at once, the denominator is the time one by one.
    pub ratio_to_closed_form: Option<Ratio>,
    /// The largest error, relative to the largest number of its kind. It is measured before the time.
    pub error: f64,
    /// The largest error over the tolerance for rounding and any truncation. The method is correct if it is at most one.
    pub share: f64,
    /// The interleaved times: with the closed form, if there is one; with the roofline, if the arithmetic is counted; with
    /// one thread, if the method has more.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rounds: Vec<Rounds>,
    /// All samples, in nanoseconds for each pair, in the order of measurement.
    pub samples: Vec<f64>,
}

/// A ratio of two times from interleaved rounds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ratio {
    /// The median of the ratios of the rounds.
    pub value: f64,
    /// Its 95 % interval.
    pub interval: [f64; 2],
}

impl Ratio {
    /// Whether the measurement distinguishes the two times.
    pub fn is_different(&self) -> bool {
        !(self.interval[0]..=self.interval[1]).contains(&1.0)
    }

    fn rounded(self) -> Self {
        let Self { value, interval } = self;
        Self { value: rounded(value, 5), interval: interval.map(|end| rounded(end, 5)) }
    }
}

impl Record for Benchmark {
    const SCHEMA: &'static str = "beamgap-benchmark/7";

    fn schema(&self) -> &str {
        &self.schema
    }

    /// One scenario on each line.
    fn to_json(&self) -> Result<String, ReportError> {
        let format = |source| ReportError::Format { what: Self::SCHEMA.to_owned(), source };
        let environment = serde_json::to_string(&self.environment).map_err(format)?;
        let instructions = serde_json::to_string(&self.instructions).map_err(format)?;
        let peers = serde_json::to_string(&self.peers).map_err(format)?;
        let scenarios: Result<Vec<_>, _> = self.scenarios.iter().map(serde_json::to_string).collect();
        let scenarios = scenarios.map_err(format)?.join(",\n");
        Ok(format!(
            "{{\n\"schema\": \"{}\",\n\"environment\": {environment},\n\
             \"scenarios\": [\n{scenarios}\n],\n\"instructions\": {instructions},\n\"peers\": {peers}\n}}\n",
            self.schema
        ))
    }
}

impl Benchmark {
    /// Combines the files of criterion and of the benches in a directory. The counts and the peers have other sources.
    ///
    /// # Errors
    /// The error of that name, unless every scenario was verified, is correct, and was timed after the verification.
    pub fn read(directory: &Path) -> Result<Self, BenchmarkError> {
        let found = samples(directory)?;
        let (verdicts, verified) = Verdicts::read(directory)?;
        let mut rounds = rounds(directory, verified)?;
        let mut scenarios: Vec<Measured> = Vec::new();
        for verdict in verdicts.scenarios {
            let group = verdict.group();
            let scenario = || format!("{group}, {}", verdict.method);
            if !verdict.is_right() {
                return Err(BenchmarkError::Wrong { scenario: scenario(), share: verdict.share });
            }
            let key = (group.clone(), verdict.method.clone());
            let timed = found.get(&key);
            let Some(timed) = timed.filter(|timed| timed.written >= verified) else {
                return Err(BenchmarkError::NotTimed { scenario: scenario() });
            };
            let pairs = number(verdict.pairs);
            let samples: Vec<f64> = timed.times.iter().map(|&time| rounded(time / pairs, 5)).collect();
            let Some(spread) = spread(&samples) else {
                return Err(BenchmarkError::NotTimed { scenario: scenario() });
            };
            let Verdict { task, family, dofs, method, pairs, error, share } = verdict;
            let mut measured = Measured {
                task,
                family,
                dofs,
                method,
                pairs,
                median: rounded(spread.median, 5),
                interval: spread.interval,
                ratio_to_closed_form: None,
                error: rounded(error, 3),
                share: rounded(share, 3),
                rounds: rounds.remove(&key).into_iter().flatten().map(Rounds::rounded).collect(),
                samples,
            };
            measured.ratio_to_closed_form = measured.over_closed_form().map(Ratio::rounded);
            scenarios.push(measured);
        }
        Ok(Self {
            schema: Self::SCHEMA.to_owned(),
            environment: verdicts.environment,
            scenarios,
            instructions: None,
            peers: None,
        })
    }

    /// The scenarios of a task, in the order of the record.
    pub(crate) fn of(&self, task: Task) -> impl Iterator<Item = &Measured> {
        self.scenarios.iter().filter(move |measured| measured.task == task.name())
    }
}

impl Measured {
    /// The number of stored entries of a Hessian: all, those of a triangle, or the blocks of both beams, which are alike,
    /// and the block between the beams.
    pub(crate) fn stored(&self) -> usize {
        let all = self.dofs * self.dofs;
        match self.method.split(", ").nth(1) {
            Some("in full") => all,
            Some("packed" | "four at once") => self.dofs * (self.dofs + 1) / 2,
            _ => all - all / 4,
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::{Measured, Rounds};

    /// A method with the standard pair.
    pub(crate) fn measured(method: &str, rounds: Vec<Rounds>) -> Measured {
        Measured {
            task: "all but the slips".to_owned(),
            family: "hermite".to_owned(),
            dofs: 24,
            method: method.to_owned(),
            pairs: 1,
            median: 100.0,
            interval: [90.0, 110.0],
            ratio_to_closed_form: None,
            error: 0.0,
            share: 0.0,
            rounds,
            samples: vec![100.0],
        }
    }
}
