//! The times of other programs for the same work, `beamgap-peers/2`, as written by the script that runs them.

use super::Record;
use super::methods::{LAYOUTS, layout_name, reader_name};
use super::number::{count, error, plain, time};
use super::page::Block;
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

/// The crate's own method that is compared with other programs.
const OURS: &str = "beamgap, blocks";
/// The end of the names of methods that take four pairs at once.
const IN_LANES: &str = "four pairs in lanes";
/// The tasks, and the quantities that they compute.
const TASKS: [(&str, &str); 2] = [("A", "d"), ("B", "d, xi, xi_bar, t, t_bar")];

impl Peers {
    /// The ratio of a program's time, by its fastest method, to that of the closed form. Both write whole matrices.
    pub(super) fn over_ours(&self, program: &str, task: &str) -> Option<f64> {
        let is_full = |row: &Peer, program: &str| row.method.starts_with(program) && row.layout == "full";
        let full = |program: &str| self.fastest(task, |row| is_full(row, program));
        Some(full(program)? / full(OURS)?)
    }

    /// The same for a program that takes four pairs at once, over the time of the closed form for one pair.
    pub(super) fn lanes_over_ours(&self, program: &str, task: &str) -> Option<f64> {
        let is_in_lanes = |row: &Peer| row.method.starts_with(program) && row.method.ends_with(IN_LANES);
        let ours = self.fastest(task, |row| row.method == OURS && row.layout == "full");
        Some(self.fastest(task, is_in_lanes)? / ours?)
    }

    /// The smallest ratio to the reference.
    fn fastest(&self, task: &str, is_it: impl Fn(&Peer) -> bool) -> Option<f64> {
        let rows = self.rows.iter().filter(|row| row.task == task && is_it(row));
        rows.map(|row| row.ratio).min_by(f64::total_cmp)
    }

    /// The time of a pair by the closed form, for each layout in which one pair is computed after the other.
    pub(super) fn times_of_ours(&self, task: &str) -> Vec<(String, f64)> {
        let rows = self.rows.iter().filter(|row| row.method == OURS && row.task == task);
        rows.map(|row| (layout_name(&row.layout), row.ns_median)).collect()
    }

    /// The blocks of the page about the peers, collapsed.
    pub(super) fn blocks(&self) -> Vec<Block> {
        let mut blocks = vec![Block::text(&format!(
            "Other programs compute the same {} pairs of Hermite beams, on one machine in one run of {} rounds: {}. {LAYOUTS} \
             *Four lanes*: four pairs at once, in the lanes of a vector.",
            count(self.pairs),
            count(self.rounds),
            self.what
        ))];
        for (task, name) in TASKS {
            let rows = self.rows.iter().filter(|row| row.task == task).map(Peer::cells).collect();
            let head = [
                name,
                "version",
                "layout",
                "#median",
                "#quartiles",
                "#times the reference",
                "#error",
                "how, note",
            ];
            blocks.push(Block::table(&head, rows));
        }
        let run = format!("{}; {}; commit {}; `{}`.", self.machine, self.date, self.commit, self.command);
        let left_out = self.left_out.iter();
        let left_out = left_out.map(|LeftOut { method, reason }| format!("Left out: {method}: {reason}."));
        blocks.push(Block::List(std::iter::once(run).chain(left_out).collect()));
        let gaps = self.cost_over_gaps();
        std::iter::once(Block::details("Other programs", blocks)).chain(gaps).collect()
    }

    /// A table with methods as rows and gaps as columns; empty if none was measured.
    fn cost_over_gaps(&self) -> Vec<Block> {
        let methods = distinct(self.over_gaps.iter().map(AtGap::method_and_task));
        let gaps = distinct(self.over_gaps.iter().map(|of| of.gap));
        if methods.is_empty() {
            return Vec::new();
        }
        let cell = |method: [&str; 3], gap: Option<f64>| {
            let found = self.over_gaps.iter().find(|of| of.method_and_task() == method && of.gap == gap);
            found.map_or_else(String::new, |of| plain(of.ratio))
        };
        let row = |of: [&str; 3]| {
            let [method, layout, task] = of;
            let task = TASKS.into_iter().find(|&(letter, _)| letter == task).map_or(task, |(_, name)| name);
            let names = [reader_name(method), layout_name(layout), task.to_owned()].into_iter();
            names.chain(gaps.iter().map(|&gap| cell(of, gap))).collect()
        };
        let rows = methods.into_iter().map(row).collect();
        let name = |gap: &Option<f64>| format!("#{}", gap.map_or_else(|| "mixture".to_owned(), short));
        let names: Vec<String> = gaps.iter().map(name).collect();
        let head: Vec<&str> =
            ["method", "layout", "task"].into_iter().chain(names.iter().map(String::as_str)).collect();
        vec![Block::details("Cost over the distance", vec![Block::text(OF_GAPS), Block::table(&head, rows)])]
    }
}

/// Each value once, in the order of its first occurrence.
fn distinct<T: PartialEq>(all: impl Iterator<Item = T>) -> Vec<T> {
    let mut found = Vec::new();
    for one in all {
        if !found.contains(&one) {
            found.push(one);
        }
    }
    found
}

/// The description of the table of the distances.
const OF_GAPS: &str = "The columns are d/|t|, the distance of the centroids over the length of a tangent. In contact it is 4 r/L for \
     elements of length L and radius r: 0.1 at L = 40 r, 0.02 at L = 200 r. In the mixture each pair has one of these \
     distances, at random. Each number is the ratio to the reference on the same pairs in the same run. The reference has one \
     form for all distances, which loses digits at small ones.";

/// A gap in few characters.
fn short(gap: f64) -> String {
    if gap < 1e-3 { format!("{gap:e}") } else { gap.to_string() }
}

impl AtGap {
    /// The name of its row in the table.
    fn method_and_task(&self) -> [&str; 3] {
        [&self.method, &self.layout, &self.task]
    }
}

/// A text with the letters of the tasks replaced by their names.
fn in_words(note: &str) -> String {
    note.replace("A one chord step, B two", "one chord step for d, two for the other quantities")
        .replace("B: with", "all: with")
}

impl Peer {
    fn cells(&self) -> Vec<String> {
        let Self { method, version, how, layout, ns_median, ns_low, ns_high, ratio, note, .. } = self;
        let [how, note] = [how, note].map(|text| in_words(text));
        let note = if note.is_empty() { how } else { format!("{how}; {note}") };
        vec![
            reader_name(method),
            version.clone(),
            layout_name(layout),
            time(*ns_median),
            format!("{} to {}", time(*ns_low), time(*ns_high)),
            plain(*ratio),
            self.error.map_or_else(String::new, |of| error(Some(of))),
            note,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::{AtGap, Peers};
    use crate::report::page::Block;
    use crate::report::{Record, ReportError};

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
