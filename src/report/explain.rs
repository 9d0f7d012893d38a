//! The record of the quality of explanations: every fault of the catalogue, in the answers of a program that has it.

use super::{Environment, Record, ReportError};
use crate::check::external::{ExplainedFault, Naming, Programs, explained_faults};
use crate::variant::Kind;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The record.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Explain {
    /// The schema.
    pub schema: String,
    /// The environment of the run.
    pub environment: Environment,
    /// The seed of the cases, and of the choice of pairs.
    pub seed: u64,
    /// The step through the catalogue: one of this many faults is taken.
    pub every: usize,
    /// The results, by the number of faults in a program and by its kind of answers.
    pub programs: Vec<ExplainProgram>,
}

/// Programs with the same kind of answers and the same number of faults.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExplainProgram {
    /// The number of faults in each program.
    pub faults: usize,
    /// The kind of answers.
    pub answers: String,
    /// The significant digits of the answers; none if they have all.
    #[serde(default)]
    pub digits: Option<u8>,
    /// The number of programs for each quality of naming.
    pub counts: Vec<NamingCount>,
    /// The same by the kind of the fault, if there is one.
    #[serde(default)]
    pub kinds: Vec<KindCount>,
    /// The programs whose faults are detected, but not named first alone.
    pub others: Vec<NotFirst>,
    /// The largest number of explanations that are named together.
    pub largest_set: usize,
    /// The largest deviation that remains after an explanation that names the faults alone; none if it is not finite.
    pub largest_left: Option<f64>,
}

/// The number of programs with one quality of naming.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NamingCount {
    /// The quality of naming.
    pub naming: String,
    /// The number of programs.
    pub programs: usize,
}

/// The programs whose fault is of one kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KindCount {
    /// The kind of the fault.
    pub kind: String,
    /// The number of programs for each quality of naming.
    pub counts: Vec<NamingCount>,
}

impl KindCount {
    /// The number of programs with one of these qualities of naming.
    pub fn count(&self, namings: &[Naming]) -> usize {
        let is_asked = |of: &&NamingCount| namings.iter().any(|naming| naming.name() == of.naming);
        self.counts.iter().filter(is_asked).map(|of| of.programs).sum()
    }
}

/// A program whose faults are not named first alone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NotFirst {
    /// Its faults.
    pub fault: String,
    /// The quality of naming.
    pub naming: String,
    /// The first of the named explanations.
    pub named: Vec<String>,
    /// The number of explanations that are named together.
    pub count: usize,
    /// The deviation before and after the explanation; none if it is not finite.
    pub deviation: [Option<f64>; 2],
}

impl Record for Explain {
    const SCHEMA: &'static str = "beamgap-explain/2";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl ExplainProgram {
    fn new(faults: usize, answers: &str, digits: Option<u8>, found: &[ExplainedFault]) -> Self {
        let found: Vec<_> = found.iter().filter(|of| of.faults.len() == faults).collect();
        let of = |naming: Naming| found.iter().filter(move |of| of.naming == naming);
        let counted = |is_asked: &dyn Fn(&ExplainedFault) -> bool| {
            Naming::ALL.map(|naming| NamingCount {
                naming: naming.name().to_owned(),
                programs: of(naming).filter(|of| is_asked(of)).count(),
            })
        };
        let counts = counted(&|_| true);
        let kind = |kind: Kind| KindCount {
            kind: kind.name().to_owned(),
            counts: counted(&|of| of.faults[0].kind == kind).to_vec(),
        };
        let is_other = |of: &&&ExplainedFault| !matches!(of.naming, Naming::First | Naming::Undetected);
        let others = found.iter().filter(is_other).map(|of| NotFirst {
            fault: of.faults.iter().map(ToString::to_string).collect::<Vec<_>>().join(" and "),
            naming: of.naming.name().to_owned(),
            named: of.named.iter().take(SHOWN).cloned().collect(),
            count: of.named.len(),
            deviation: of.deviation.map(rounded),
        });
        let left = of(Naming::First).map(|of| of.deviation[1]).fold(0.0, f64::max);
        Self {
            faults,
            answers: answers.to_owned(),
            digits,
            counts: counts.to_vec(),
            kinds: if faults == 1 { Kind::ALL.map(kind).to_vec() } else { Vec::new() },
            others: others.collect(),
            largest_set: found.iter().map(|of| of.named.len()).max().unwrap_or(0),
            largest_left: rounded(left),
        }
    }

    /// The number of programs with this quality of naming.
    pub fn count(&self, naming: Naming) -> usize {
        self.counts.iter().filter(|count| count.naming == naming.name()).map(|count| count.programs).sum()
    }

    /// Whether each program has one of its faults named, and each detected single fault is named, alone or with those that
    /// the answers do not distinguish from it. For two faults the explanation may name none: it then says that it knows none.
    pub fn holds(&self) -> bool {
        let unnamed = if self.faults == 1 { self.count(Naming::None) } else { 0 };
        self.count(Naming::Other) + unnamed == 0
    }
}

/// The maximum number of listed explanations of those that are named together.
const SHOWN: usize = 4;

/// Two digits, because the others depend on the machine.
fn rounded(number: f64) -> Option<f64> {
    format!("{number:.1e}").parse().ok().filter(|number: &f64| number.is_finite())
}

/// The part of the catalogue that is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExplainSample {
    /// The seed of the cases, and of the choice of pairs.
    pub seed: u64,
    /// The step through the catalogue: one of this many faults is taken.
    pub every: usize,
    /// The number of pairs of faults.
    pub pairs: usize,
}

impl Explain {
    /// Runs the measurement.
    pub fn new(sample: ExplainSample, command: &str) -> Self {
        let ExplainSample { seed, every, pairs } = sample;
        let programs = [
            ("values, gradients, Hessians and variations along the directions, to all digits", None),
            ("gradients and Hessians alone, to 6 significant digits", Some(6)),
        ];
        let programs = programs.map(|(answers, digits)| {
            let found = explained_faults(Programs { seed, digits, every, pairs });
            let of_faults = |faults: &usize| found.iter().any(|of| of.faults.len() == *faults);
            [1, 2]
                .into_iter()
                .filter(of_faults)
                .map(|n| ExplainProgram::new(n, answers, digits, &found))
                .collect::<Vec<_>>()
        });
        Self {
            schema: Self::SCHEMA.to_owned(),
            environment: Environment::here(command),
            seed,
            every,
            programs: programs.concat(),
        }
    }
}

/// Measures the quality of explanations, and writes `explain.json` and `explain.md` into the directory `to`.
///
/// # Errors
/// [`ReportError::Write`] if a file cannot be written.
pub fn explain(to: &Path, sample: ExplainSample, command: &str) -> Result<Explain, ReportError> {
    let json = Explain::new(sample, command).to_json()?;
    let record = Explain::from_json(&json)?;
    super::write(to, "explain.json", &json)?;
    super::write(to, "explain.md", &record.page().to_markdown())?;
    Ok(record)
}
