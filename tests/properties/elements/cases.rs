//! Exported cases for the hand-written elements.

use super::conditions::Condition;
use crate::program::run;
use beamgap::check::external::{Vector, VectorReader};
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};

/// The number of regimes.
pub(super) const REGIMES: usize = beamgap::check::Regime::ALL.len();

/// The cases of a seed.
pub(super) struct Cases {
    pub(super) seed: u64,
    pub(super) path: PathBuf,
    pub(super) vectors: Vec<Vector>,
    pub(super) lines: Vec<serde_json::Value>,
}

impl Cases {
    pub(super) fn exported(seed: u64, cases: usize, families: &[&str], folder: &Path) -> Self {
        Self::of(&["--expected", "none"], seed, cases, families, folder)
    }

    /// Cases with contact elements.
    pub(super) fn with_elements(seed: u64, cases: usize, families: &[&str], folder: &Path) -> Self {
        Self::of(&["--element"], seed, cases, families, folder)
    }

    /// The same, with earlier steps.
    pub(super) fn with_steps(seed: u64, cases: usize, families: &[&str], folder: &Path) -> Self {
        Self::of(&["--element", "--steps"], seed, cases, families, folder)
    }

    fn of(options: &[&str], seed: u64, cases: usize, families: &[&str], folder: &Path) -> Self {
        let path = folder.join(format!("{}-{seed}-{cases}.jsonl", families.join("-")));
        let (seed_text, cases_text) = (seed.to_string(), cases.to_string());
        let families = families.iter().flat_map(|family| ["--family", family]);
        let arguments =
            [&["export", "--seed", &seed_text, "--cases", &cases_text], options, &["-o"]].concat();
        let arguments: Vec<_> =
            arguments.into_iter().chain([path.to_str().unwrap()]).chain(families).collect();
        let output = run(&arguments);
        assert!(output.status.success(), "{output:?}");
        let mut reader = VectorReader::new(BufReader::new(File::open(&path).unwrap()), "cases").unwrap();
        let vectors = std::iter::from_fn(|| reader.next_vector().unwrap()).collect();
        let lines = BufReader::new(File::open(&path).unwrap()).lines().skip(1);
        let lines = lines.map(|line| serde_json::from_str(&line.unwrap()).unwrap()).collect();
        Self { seed, path, vectors, lines }
    }

    /// The number of cases of each regime.
    pub(super) fn of_a_regime(&self) -> usize {
        self.vectors.len() / REGIMES
    }

    /// The smallest number of cases a regime that has the condition of an error.
    pub(super) fn with(&self, needs: &Condition) -> usize {
        let first = self.lines.iter().position(|line| needs.holds(line));
        first.map_or(usize::MAX, |first| first / REGIMES + 1)
    }
}
