//! The times of other programs as tables and sentences.

use super::{AtGap, LeftOut, Peer, Peers};
use crate::methods::{LAYOUTS, layout_name, reader_name};
use beamgap::report::number::{count, error, plain, time};
use beamgap::report::page::Block;

/// The crate's own method that is compared with other programs.
const OURS: &str = "beamgap, blocks";
/// The end of the names of methods that take four pairs at once.
const IN_LANES: &str = "four pairs in lanes";
/// The tasks, and the quantities that they compute.
const TASKS: [(&str, &str); 2] = [("A", "d"), ("B", "d, xi, xi_bar, t, t_bar")];

impl Peers {
    /// The ratio of a program's time, by its fastest method, to that of the closed form. Both write whole matrices.
    pub(crate) fn over_ours(&self, program: &str, task: &str) -> Option<f64> {
        let is_full = |row: &Peer, program: &str| row.method.starts_with(program) && row.layout == "full";
        let full = |program: &str| self.fastest(task, |row| is_full(row, program));
        Some(full(program)? / full(OURS)?)
    }

    /// The same for a program that takes four pairs at once, over the time of the closed form for one pair.
    pub(crate) fn lanes_over_ours(&self, program: &str, task: &str) -> Option<f64> {
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
    pub(crate) fn times_of_ours(&self, task: &str) -> Vec<(String, f64)> {
        let rows = self.rows.iter().filter(|row| row.method == OURS && row.task == task);
        rows.map(|row| (layout_name(&row.layout), row.ns_median)).collect()
    }

    /// The blocks of the page about the peers, collapsed.
    pub(crate) fn blocks(&self) -> Vec<Block> {
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
