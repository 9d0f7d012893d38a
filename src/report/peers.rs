//! What other programs take for the same work, `beamgap-peers/1`, as the script that runs them writes it.

use super::Record;
use super::number::{count, error, plain, time};
use super::page::Block;
use serde::{Deserialize, Serialize};

/// Other programs on the same pairs, on one machine, in one run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Peers {
    /// `beamgap-peers/1`.
    pub schema: String,
    /// The processor and the system.
    pub machine: String,
    /// When they ran.
    pub date: String,
    /// What was run.
    pub command: String,
    /// The commit of this crate, with `+changes` if there were any on top of it.
    pub commit: String,
    /// How many pairs.
    pub pairs: u64,
    /// How many rounds, in each of which every program was timed.
    pub rounds: u64,
    /// What the numbers are.
    pub what: String,
    /// The programs.
    pub rows: Vec<Peer>,
    /// Those that could not be run.
    pub left_out: Vec<LeftOut>,
}

/// One program, one task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Peer {
    /// The program, and how it is used.
    pub method: String,
    /// Its version, or that of its compiler.
    pub version: String,
    /// How it was made.
    pub how: String,
    /// `A`: d with gradient and Hessian; `B`: d, xi, xi_bar, t and t_bar.
    pub task: String,
    /// How the Hessians are stored.
    pub layout: String,
    /// The median time of a pair in nanoseconds.
    pub ns_median: f64,
    /// The lower quartile.
    pub ns_low: f64,
    /// The upper quartile.
    pub ns_high: f64,
    /// Times what the reference takes, run just before.
    pub ratio: f64,
    /// The largest relative error in a gradient or Hessian; none of what computes nothing.
    pub error: Option<f64>,
    /// What else is to be said.
    pub note: String,
}

/// A program that could not be run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LeftOut {
    /// The program.
    pub method: String,
    /// Why.
    pub reason: String,
}

impl Record for Peers {
    const SCHEMA: &'static str = "beamgap-peers/1";

    fn schema(&self) -> &str {
        &self.schema
    }
}

/// The crate's own way that other programs are held against.
const OURS: &str = "beamgap, blocks";

impl Peers {
    /// The ratio of a program's time to that of the closed form, whole matrices written by both; of its fastest method.
    pub(super) fn over_ours(&self, program: &str, task: &str) -> Option<f64> {
        let fastest = |program: &str| {
            let rows = self
                .rows
                .iter()
                .filter(|row| row.method.starts_with(program) && row.task == task && row.layout == "full");
            rows.map(|row| row.ratio).min_by(f64::total_cmp)
        };
        Some(fastest(program)? / fastest(OURS)?)
    }

    /// What the page says of them.
    pub(super) fn blocks(&self) -> Vec<Block> {
        let mut blocks = vec![
            Block::heading("Other programs"),
            Block::text(&format!(
                "The same {} pairs of Hermite beams through other programs, on one machine in one run of {} rounds: {}.",
                count(self.pairs),
                count(self.rounds),
                self.what
            )),
        ];
        for (task, name) in [("A", "d"), ("B", "d, xi, xi_bar, t, t_bar")] {
            let rows = self.rows.iter().filter(|row| row.task == task).map(Peer::cells).collect();
            let head = [name, "version", "layout", "#median", "#quartiles", "#ratio", "#error", "how, note"];
            blocks.push(Block::table(&head, rows));
        }
        let run = format!("{}; {}; commit {}; `{}`.", self.machine, self.date, self.commit, self.command);
        let left_out = self.left_out.iter();
        let left_out = left_out.map(|LeftOut { method, reason }| format!("Left out: {method}: {reason}."));
        blocks.push(Block::List(std::iter::once(run).chain(left_out).collect()));
        blocks
    }
}

impl Peer {
    fn cells(&self) -> Vec<String> {
        let Self { method, version, how, layout, ns_median, ns_low, ns_high, ratio, note, .. } = self;
        let note = if note.is_empty() { how.clone() } else { format!("{how}; {note}") };
        vec![
            method.clone(),
            version.clone(),
            layout.clone(),
            time(*ns_median),
            format!("{} to {}", time(*ns_low), time(*ns_high)),
            plain(*ratio),
            self.error.map_or_else(String::new, |of| error(Some(of))),
            note,
        ]
    }
}
