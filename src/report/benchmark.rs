//! The record of the benchmarks, `beamgap-benchmark/1`.

use super::criterion::{Verdicts, samples};
use super::number::{finite, rounded};
use super::record::format;
use super::{Environment, Record, ReportError, spread};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What the other ways of a group are divided by.
pub(super) const DENOMINATOR: &str = "closed form";

/// All that was measured, and where.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Benchmark {
    /// `beamgap-benchmark/1`.
    pub schema: String,
    /// Where and with what it was measured.
    pub environment: Environment,
    /// The scenarios, group by group.
    pub scenarios: Vec<Measured>,
}

/// One way to do one task, measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// The task.
    pub task: String,
    /// The dofs of both beams together.
    pub dofs: String,
    /// The way.
    pub way: String,
    /// The median time in nanoseconds.
    pub median: f64,
    /// The 95 % interval of the median.
    pub interval: [f64; 2],
    /// The ratio to the closed form of the same task and size, if there is one.
    pub ratio_to_closed_form: Option<Ratio>,
    /// The largest error relative to the largest entry; measured before the time was.
    pub error: f64,
    /// The largest error that is accepted.
    pub tolerance: f64,
    /// All samples, in nanoseconds an iteration, in the order they were taken.
    pub samples: Vec<f64>,
}

/// A ratio of two times.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ratio {
    /// The ratio of the medians.
    pub value: f64,
    /// What holds it with 95 % at least.
    pub interval: [f64; 2],
}

impl Ratio {
    /// Whether the measurement tells the two apart.
    pub fn is_different(&self) -> bool {
        !(self.interval[0]..=self.interval[1]).contains(&1.0)
    }

    fn rounded(self) -> Self {
        let Self { value, interval } = self;
        Self { value: rounded(value, 5), interval: interval.map(|end| rounded(end, 5)) }
    }
}

impl Record for Benchmark {
    const SCHEMA: &'static str = "beamgap-benchmark/1";

    fn schema(&self) -> &str {
        &self.schema
    }

    /// One scenario a line.
    fn to_json(&self) -> Result<String, ReportError> {
        let environment = serde_json::to_string(&self.environment).map_err(format::<Self>)?;
        let scenarios: Result<Vec<_>, _> = self.scenarios.iter().map(serde_json::to_string).collect();
        let scenarios = scenarios.map_err(format::<Self>)?.join(",\n");
        Ok(format!(
            "{{\n\"schema\": \"{}\",\n\"environment\": {environment},\n\"scenarios\": [\n{scenarios}\n]\n}}\n",
            self.schema
        ))
    }
}

impl Benchmark {
    /// Puts together what criterion and the benches left in a directory.
    ///
    /// # Errors
    /// Every scenario must be verified, be right, and be timed after that: else the error of that name.
    pub fn read(directory: &Path) -> Result<Self, ReportError> {
        let found = samples(directory)?;
        let (verdicts, verified) = Verdicts::read(directory)?;
        let mut scenarios: Vec<Measured> = Vec::new();
        for verdict in verdicts.scenarios {
            let scenario = || format!("{}, {}", verdict.group, verdict.way);
            if verdict.error > verdict.tolerance || finite(verdict.error).is_none() {
                return Err(ReportError::Wrong { scenario: scenario(), error: verdict.error });
            }
            let timed = found.get(&(verdict.group.clone(), verdict.way.clone()));
            let Some(timed) = timed.filter(|timed| timed.written >= verified) else {
                return Err(ReportError::NotTimed { scenario: scenario() });
            };
            let samples: Vec<f64> = timed.times.iter().map(|&time| rounded(time, 5)).collect();
            let Some(spread) = spread(&samples) else {
                return Err(ReportError::NotTimed { scenario: scenario() });
            };
            let (task, dofs) = verdict.group.split_once('/').unwrap_or((&verdict.group, ""));
            scenarios.push(Measured {
                task: task.to_owned(),
                dofs: dofs.to_owned(),
                way: verdict.way,
                median: rounded(spread.median, 5),
                interval: spread.interval,
                ratio_to_closed_form: None,
                error: verdict.error,
                tolerance: verdict.tolerance,
                samples,
            });
        }
        let ratios: Vec<_> = scenarios.iter().map(|measured| measured.ratio(&scenarios)).collect();
        for (measured, ratio) in scenarios.iter_mut().zip(ratios) {
            measured.ratio_to_closed_form = ratio;
        }
        Ok(Self { schema: Self::SCHEMA.to_owned(), environment: verdicts.environment, scenarios })
    }

    /// The scenarios of each task, in the order of the record.
    pub(super) fn tasks(&self) -> impl Iterator<Item = &[Measured]> {
        self.scenarios.chunk_by(|a, b| a.task == b.task)
    }
}

impl Measured {
    /// The ratio to the closed form of the same task and size among `all`.
    fn ratio(&self, all: &[Self]) -> Option<Ratio> {
        let same = |other: &&Self| (&other.task, &other.dofs) == (&self.task, &self.dofs);
        let closed = all.iter().filter(same).find(|other| other.way == DENOMINATOR)?;
        if closed.way == self.way {
            return Some(Ratio { value: 1.0, interval: [1.0; 2] });
        }
        Some(spread(&self.samples)?.over(&spread(&closed.samples)?).rounded())
    }
}
