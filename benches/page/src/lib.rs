//! The page of the benchmark, from a record of what criterion, callgrind and the programs of others measured.
//!
//! [`Benchmark`] is the record. Markdown, HTML and SVG are pure functions of the data read back from its JSON.

mod benchmark;
mod claims;
mod criterion;
mod error;
mod figures;
mod instructions;
mod interval;
mod machine;
mod method;
mod methods;
mod page;
mod peers;
mod roof;
mod rounds;
mod task;
#[cfg(test)]
mod tests;

pub use benchmark::{Benchmark, CLOSED_FORM, Measured, Ratio};
pub use criterion::{VERDICTS, Verdict, Verdicts, criterion_directory, write_rounds};
pub use error::BenchmarkError;
pub use instructions::{Count, Difference, Instructions};
pub use interval::{Spread, median_interval, spread};
pub use peers::{AtGap, LeftOut, Peer, Peers};
pub use rounds::Rounds;
pub use task::Task;

use beamgap::report::{Record, write};
use std::fs;
use std::path::Path;

/// Reads the results of criterion from `from`, and the counts of instructions and the peers if `to` has them. Writes
/// `benchmark.json` and its pages and pictures into the directory `to`.
///
/// # Errors
/// [`BenchmarkError::NoMeasurements`] or a similar error if a part is missing; the error names the part and the command for
/// it. [`BenchmarkError::Report`] if a file cannot be written.
pub fn publish(to: &Path, from: &Path) -> Result<Benchmark, BenchmarkError> {
    let read = |name: &str| fs::read_to_string(to.join(name)).ok();
    let instructions = read("instructions.json").map(|json| Instructions::from_json(&json)).transpose()?;
    let peers = read("peers.json").map(|json| Peers::from_json(&json)).transpose()?;
    let json = Benchmark { instructions, peers, ..Benchmark::read(from)? }.to_json()?;
    let record = Benchmark::from_json(&json)?;
    write(to, "benchmark.json", &json)?;
    for (name, text) in record.pages() {
        write(to, &name, &text)?;
    }
    Ok(record)
}
