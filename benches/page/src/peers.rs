//! The times of other programs for the same work, `beamgap-peers/2`, as written by the script that runs them.

mod tables;

use beamgap::report::Record;
use serde::{Deserialize, Serialize};

/// Other programs on the same pairs, on one machine, in one run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Peers {
    /// `beamgap-peers/2`.
    pub schema: String,
    /// The processor and the system.
    pub machine: String,
    /// The date of the run.
    pub date: String,
    /// The command.
    pub command: String,
    /// The commit of this crate, with `+changes` if it has uncommitted changes.
    pub commit: String,
    /// The number of pairs.
    pub pairs: u64,
    /// The number of rounds. Every program is timed in each round.
    pub rounds: u64,
    /// The meaning of the numbers.
    pub what: String,
    /// The programs.
    pub rows: Vec<Peer>,
    /// The crate's methods on the same pairs at several gaps; none if all pairs were moved to given gaps.
    pub over_gaps: Vec<AtGap>,
    /// The programs that could not be run.
    pub left_out: Vec<LeftOut>,
}

/// One program, one task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Peer {
    /// The program and its use.
    pub method: String,
    /// Its version, or that of its compiler.
    pub version: String,
    /// How it was built.
    pub how: String,
    /// `A`: d with gradient and Hessian; `B`: d, xi, xi_bar, t and t_bar.
    pub task: String,
    /// The layout of the Hessians.
    pub layout: String,
    /// The median time of a pair in nanoseconds.
    pub ns_median: f64,
    /// The lower quartile.
    pub ns_low: f64,
    /// The upper quartile.
    pub ns_high: f64,
    /// The time over that of the reference, which is run just before.
    pub ratio: f64,
    /// The largest relative error in a gradient or Hessian; none for a program that computes nothing.
    pub error: Option<f64>,
    /// Additional remarks.
    pub note: String,
}

/// One method of the crate, one task, one gap.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AtGap {
    /// The method.
    pub method: String,
    /// `A` or `B`, as for a [`Peer`].
    pub task: String,
    /// The layout of the Hessians.
    pub layout: String,
    /// The distance of every pair, in lengths of a tangent; none if each pair has one of the gaps.
    pub gap: Option<f64>,
    /// The median time of a pair in nanoseconds.
    pub ns_median: f64,
    /// The time over that of the reference for the same pairs, which is run just before.
    pub ratio: f64,
    /// The largest relative error in a gradient or Hessian.
    pub error: f64,
}

/// A program that could not be run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LeftOut {
    /// The program.
    pub method: String,
    /// The reason.
    pub reason: String,
}

impl Record for Peers {
    const SCHEMA: &'static str = "beamgap-peers/2";

    fn schema(&self) -> &str {
        &self.schema
    }
}

#[cfg(test)]
mod tests {
    use super::{AtGap, Peers};
    use beamgap::report::page::Block;
    use beamgap::report::{Record, ReportError};

    fn peers(over_gaps: Vec<AtGap>) -> Peers {
        let text = String::new;
        Peers {
            schema: Peers::SCHEMA.to_owned(),
            machine: text(),
            date: text(),
            command: text(),
            commit: text(),
            pairs: 1,
            rounds: 1,
            what: text(),
            rows: Vec::new(),
            over_gaps,
            left_out: Vec::new(),
        }
    }

    fn at(layout: &str, gap: Option<f64>, ratio: f64) -> AtGap {
        let (method, task) = ("blocks".to_owned(), "A".to_owned());
        AtGap { method, task, layout: layout.to_owned(), gap, ns_median: 100.0, ratio, error: 0.0 }
    }

    #[test]
    fn every_ratio_stands_in_the_column_of_its_gap() {
        // The second method comes in another order, and one of its gaps is missing.
        let (low, high) = (Some(1e-4), Some(0.02));
        let of_full = [at("full", low, 1.25), at("full", high, 1.5), at("full", None, 2.0)];
        let of_upper = [at("upper", None, 0.5), at("upper", low, 0.75)];
        let record = peers([&of_full[..], &of_upper].concat());
        let blocks = record.blocks();
        let Some(Block::Details { blocks, .. }) = blocks.last() else { panic!("{blocks:?}") };
        let Some(Block::Table { head, rows }) = blocks.last() else { panic!("{blocks:?}") };
        let names: Vec<&str> = head.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["method", "layout", "task", "1e-4", "0.02", "mixture"]);
        assert!(head.iter().skip(3).all(|&(_, is_number)| is_number));
        assert_eq!(rows[0], ["blocks", "full", "d", "1.25", "1.50", "2.00"]);
        assert_eq!(rows[1], ["blocks", "blocks", "d", "0.750", "", "0.500"]);
        assert_eq!(rows.len(), 2);
    }

    #[test]
    fn without_gaps_there_is_no_table_of_them() {
        assert_eq!(peers(vec![at("full", None, 1.0)]).blocks().len(), 2);
        assert_eq!(peers(Vec::new()).blocks().len(), 1);
    }

    #[test]
    fn gaps_are_read_back_and_the_old_schema_is_refused() {
        let record = peers(vec![at("full", Some(1e-6), 1.0), at("full", None, 1.0)]);
        let json = record.to_json().unwrap();
        assert_eq!(Peers::from_json(&json).unwrap(), record);
        let old = json.replace(Peers::SCHEMA, "beamgap-peers/1");
        assert!(matches!(Peers::from_json(&old), Err(ReportError::Schema { .. })));
    }
}
