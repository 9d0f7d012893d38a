//! How well explanations are, as a record: every fault of the catalogue, answered by a program that has it.

use super::{Environment, Record, ReportError};
use crate::check::external::{ExplainedFault, Naming, explained_faults};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The record.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Explain {
    /// The schema.
    pub schema: String,
    /// Where it was made.
    pub environment: Environment,
    /// The seed of the cases.
    pub seed: u64,
    /// By what the programs answer.
    pub programs: Vec<ExplainProgram>,
}

/// Programs that answer the same, each with one fault.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExplainProgram {
    /// What they answer.
    pub answers: String,
    /// How many faults are named in which way.
    pub counts: Vec<NamingCount>,
    /// The faults that are not named first alone, and not undetected.
    pub others: Vec<NotFirst>,
    /// The largest deviation that is left after an explanation that names the fault; none if it is not finite.
    pub largest_left: Option<f64>,
}

/// How many faults are named in a way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NamingCount {
    /// The way.
    pub naming: String,
    /// How many.
    pub faults: usize,
}

/// A fault that is not named first alone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotFirst {
    /// The fault.
    pub fault: String,
    /// How it was named.
    pub naming: String,
    /// What was named.
    pub named: Vec<String>,
    /// The deviation before the explanation and after it; none where it is not finite.
    pub deviation: [Option<f64>; 2],
}

impl Record for Explain {
    const SCHEMA: &'static str = "beamgap-explain/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl ExplainProgram {
    fn new(answers: &str, found: &[ExplainedFault]) -> Self {
        let of = |naming: Naming| found.iter().filter(move |of| of.naming == naming);
        let counts = Naming::ALL
            .map(|naming| NamingCount { naming: naming.name().to_owned(), faults: of(naming).count() });
        let is_other = |of: &&ExplainedFault| !matches!(of.naming, Naming::First | Naming::Undetected);
        let others = found.iter().filter(is_other).map(|of| NotFirst {
            fault: of.fault.to_string(),
            naming: of.naming.name().to_owned(),
            named: of.named.clone(),
            deviation: of.deviation.map(rounded),
        });
        let left = of(Naming::First).map(|of| of.deviation[1]).fold(0.0, f64::max);
        Self {
            answers: answers.to_owned(),
            counts: counts.to_vec(),
            others: others.collect(),
            largest_left: rounded(left),
        }
    }

    /// How many faults are named in this way.
    pub fn count(&self, naming: Naming) -> usize {
        self.counts.iter().filter(|count| count.naming == naming.name()).map(|count| count.faults).sum()
    }

    /// Whether every fault that shows is named, alone or with equivalent ones.
    pub fn holds(&self) -> bool {
        self.count(Naming::Other) + self.count(Naming::None) == 0
    }
}

/// Two digits: the others depend on the machine.
fn rounded(number: f64) -> Option<f64> {
    format!("{number:.1e}").parse().ok().filter(|number: &f64| number.is_finite())
}

impl Explain {
    /// Measures.
    pub fn new(seed: u64, command: &str) -> Self {
        let program = |answers: &str, digits| ExplainProgram::new(answers, &explained_faults(seed, digits));
        Self {
            schema: Self::SCHEMA.to_owned(),
            environment: Environment::here(command),
            seed,
            programs: vec![
                program(
                    "values, gradients, Hessians and variations along the directions, to all digits",
                    None,
                ),
                program("gradients and Hessians alone, to 6 significant digits", Some(6)),
            ],
        }
    }
}

/// Measures how well explanations are, and writes `explain.json` and `explain.md` into the directory `to`.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written.
pub fn explain(to: &Path, seed: u64, command: &str) -> Result<Explain, ReportError> {
    let json = Explain::new(seed, command).to_json()?;
    let record = Explain::from_json(&json)?;
    super::write(to, "explain.json", &json)?;
    super::write(to, "explain.md", &record.page().to_markdown())?;
    Ok(record)
}
