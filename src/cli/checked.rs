//! The request and the result of a run of the check, of the schema `beamgap-check/2`. Results of shards can be merged.
//!
//! Names and meanings stay; entries may be added. Numbers have all digits. Infinity and NaN are words, such as `"inf"`.

mod json;
mod shown;
mod verdict;

use super::arguments::{planting, variant};
use anyhow::{Context, ensure};
use beamgap::check::{CheckConfig, Counts, Moved, Oracles, Regime, Selection, Shard, Summary};
use beamgap::report::SEED;
use clap::ValueEnum;
use serde::{Deserialize, Serialize};
use std::path::Path;

pub(super) use shown::Shown;

/// The schema.
const SCHEMA: &str = "beamgap-check/2";
/// The maximum number of cases of a regime.
pub(super) const MOST_CASES: u64 = 1_000_000;
/// The number of mismatches shown in full and shrunk; the others are counted.
pub(super) const SHOWN: usize = 5;

/// With what the closed form is compared. Where it disagrees with AD, the differences always arbitrate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Oracle {
    /// Automatic differentiation
    Ad,
    /// AD, and finite differences in double-double: in every thirteenth case,
    /// and where the tolerance for AD is too large
    All,
}

/// The request and the result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Checked {
    pub(super) schema: String,
    pub(super) version: String,
    /// Written as a string, because some readers cannot represent 64 bits.
    #[serde(with = "seed")]
    pub(super) seed: u64,
    pub(super) planted: Vec<String>,
    pub(super) oracle: Oracle,
    pub(super) selection: Selection,
    pub(super) shard: Shard,
    pub(super) found: Summary,
}

mod seed {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};

    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it with a reference")]
    pub(super) fn serialize<S: Serializer>(seed: &u64, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&format_args!("{seed:#x}"))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u64, D::Error> {
        crate::cli::arguments::seed(&String::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

impl Checked {
    /// The request, with an empty result.
    pub(super) fn new(
        seed: u64,
        planted: Vec<String>,
        oracle: Oracle,
        selection: Selection,
        shard: Shard,
    ) -> Self {
        let (schema, version) = (SCHEMA.to_owned(), env!("CARGO_PKG_VERSION").to_owned());
        Self { schema, version, seed, planted, oracle, selection, shard, found: Summary::default() }
    }

    /// The configuration of the check.
    pub(super) fn config(&self) -> anyhow::Result<CheckConfig> {
        let oracles = match self.oracle {
            Oracle::Ad => Oracles::Ad,
            Oracle::All => Oracles::Sample,
        };
        Ok(CheckConfig { variant: variant(&self.planted)?, oracles })
    }

    /// The options with which a command repeats a case of this run.
    pub(super) fn options(&self) -> String {
        planting(&self.planted) + if self.oracle == Oracle::All { " --oracle all" } else { "" }
    }

    /// The number of requested cases, and the number of those that were not reached.
    pub(super) fn asked(&self) -> (u64, u64) {
        let asked = self.selection.count(self.shard);
        let reached: u64 = self.found.regimes.values().map(|tally| tally.cases).sum();
        (asked, asked.saturating_sub(reached))
    }

    /// The counts that are not those of the record, if this run is one that the record is for.
    pub(super) fn moved(&self) -> Vec<Moved> {
        let Self { seed, planted, oracle, selection, shard, found, .. } = self;
        let is_recorded = *seed == SEED
            && planted.is_empty()
            && *oracle == Oracle::Ad
            && selection.family.is_none()
            && *shard == Shard::WHOLE
            && self.asked().1 == 0;
        let recorded = if is_recorded { Counts::recorded().ok() } else { None };
        recorded.map_or_else(Vec::new, |recorded| {
            found.counts.moved(&recorded, &selection.regimes, selection.cases)
        })
    }

    /// Whether the counts of this run can be the record.
    ///
    /// # Errors
    /// If this is no run of the default seed with enough cases of all regimes.
    pub(super) fn can_be_recorded(&self) -> anyhow::Result<()> {
        let Self { seed, selection, oracle, .. } = self;
        let is_whole = selection.regimes.len() == Regime::ALL.len() && selection.cases >= Counts::CASES;
        ensure!(
            *seed == SEED && is_whole && *oracle == Oracle::Ad,
            "--write-counts: seed {SEED:#x} and at least {} cases of all regimes, compared with AD, expected",
            Counts::CASES
        );
        Ok(())
    }

    /// Writes the counts as the record.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(super) fn write_counts(&self, path: &Path) -> anyhow::Result<()> {
        let text = serde_json::to_string_pretty(&self.found.counts)? + "\n";
        std::fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))
    }

    /// Merges the parts of a run, in any order.
    ///
    /// # Errors
    /// If the parts are from different runs, share a case or leave cases out.
    pub(super) fn merge(parts: Vec<(String, Self)>) -> anyhow::Result<Self> {
        let mut merged: Option<Self> = None;
        let mut known: Vec<(String, Shard)> = Vec::new();
        for (name, part) in parts {
            ensure!(part.schema == SCHEMA, "{name}: schema {SCHEMA:?} expected, found {:?}", part.schema);
            let version = env!("CARGO_PKG_VERSION");
            ensure!(part.version == version, "{name}: version {version} expected, found {}", part.version);
            let cases = part.selection.cases;
            ensure!(cases <= MOST_CASES, "{name}: at most {MOST_CASES} cases expected, found {cases}");
            if let Some((other, shard)) = known.iter().find(|(_, shard)| shard.overlaps(part.shard)) {
                anyhow::bail!("{name}: shard {} has cases of shard {shard} of {other}", part.shard);
            }
            known.push((name.clone(), part.shard));
            merged = Some(match merged {
                None => part,
                Some(all) => {
                    for (what, is_same) in [
                        ("seed", part.seed == all.seed),
                        ("planted", part.planted == all.planted),
                        ("oracle", part.oracle == all.oracle),
                        ("selection", part.selection == all.selection),
                    ] {
                        ensure!(is_same, "{name}: {what} differs from that of {}", known[0].0);
                    }
                    Self { found: all.found.merge(part.found), ..all }
                }
            });
        }
        let Some(merged) = merged else { anyhow::bail!("a part expected") };
        let shards: Vec<Shard> = known.iter().map(|(_, shard)| *shard).collect();
        let held: u64 = shards.iter().map(|shard| merged.selection.count(*shard)).sum();
        let all = merged.selection.count(Shard::WHOLE);
        ensure!(held == all, "{}: the others have {held} of {all} cases", missing(&merged, &shards));
        Ok(Self { shard: Shard::WHOLE, ..merged })
    }
}

/// The shards without which a run is not complete, in words.
fn missing(merged: &Checked, shards: &[Shard]) -> String {
    let mut names: Vec<_> = Shard::missing(shards)
        .into_iter()
        .filter(|shard| merged.selection.count(*shard) > 0)
        .map(|shard| shard.to_string())
        .collect();
    if let Some(rest @ 1..) = names.len().checked_sub(SHOWN) {
        names.truncate(SHOWN);
        names.push(format!("{rest} more"));
    }
    match names.as_slice() {
        [] => "shards are missing".to_owned(),
        [one] => format!("shard {one} is missing"),
        [first @ .., last] => format!("shards {} and {last} are missing", first.join(", ")),
    }
}
