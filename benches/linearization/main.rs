//! The time of the linearization, by method, by size and by task. Every method is verified before any is timed.
//!
//! ```console
//! $ cargo bench                                              # times
//! $ cargo bench --bench linearization -- --write-pages       # writes the pages of the last times
//! $ cargo bench --bench linearization -- --count             # counts instructions instead, and prints them
//! $ cargo bench --bench linearization -- --check-counts      # fails if a count has grown by more than 3 %
//! $ cargo bench --bench linearization -- --write-counts      # writes the counts as the record
//! ```

mod counts;
mod roofline;
mod rounds;
mod scenario;
mod timed;

use beamgap::report::Environment;
use beamgap_benchmark::{Verdict, Verdicts, criterion_directory, publish, write_rounds};
use criterion::{Criterion, SamplingMode, Throughput, criterion_group};
use rayon::prelude::*;
use scenario::Scenario;
use std::path::Path;
use std::process::ExitCode;
use std::time::Duration;

fn linearization(criterion: &mut Criterion) {
    let scenarios = scenario::all();
    scenario::check(&scenarios);
    let directory = is_timing().then(criterion_directory);
    let verdicts = Verdicts { environment: Environment::here("cargo bench"), scenarios: judged(&scenarios) };
    if let Some(directory) = &directory {
        verdicts.write(directory).expect(WRITABLE);
    }
    let mut all_rounds = Vec::new();
    for of_group in scenarios.chunk_by(|a, b| a.group() == b.group()) {
        let mut group = criterion.benchmark_group(of_group[0].group());
        group.sampling_mode(SamplingMode::Flat);
        for scenario in of_group {
            group.throughput(Throughput::Elements(scenario.pairs as u64));
            let mut run = scenario.runner();
            group.bench_function(&scenario.method, |bencher| bencher.iter(&mut run));
            if directory.is_some() {
                let of_scenario = rounds::rounds(scenario, of_group).into_iter();
                all_rounds
                    .extend(of_scenario.map(|rounds| (scenario.group(), scenario.method.clone(), rounds)));
            }
        }
        group.finish();
    }
    if let Some(directory) = &directory {
        write_rounds(directory, &all_rounds).expect(WRITABLE);
    }
}

const WRITABLE: &str = "criterion's directory can be written to";

/// Whether the run measures times.
fn is_timing() -> bool {
    is_given("--bench") && !is_given("--test") && !is_given("--list")
}

fn is_given(flag: &str) -> bool {
    std::env::args().any(|argument| argument == flag)
}

/// Writes the record of the last times, with its pages, unless the source has changes that are not committed.
fn write_pages() -> ExitCode {
    let written = Environment::is_clean(is_given("--allow-dirty"))
        .map_err(Into::into)
        .and_then(|()| publish(Path::new("reports"), &criterion_directory()));
    match written {
        Ok(record) => {
            println!("Wrote benchmark to reports. docs/cost.md must state:");
            record.claims().iter().for_each(|claim| println!("- {claim}"));
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The verdicts. A wrong result is an error.
fn judged(scenarios: &[Scenario]) -> Vec<Verdict> {
    let judged: Vec<_> = scenarios.par_iter().map(Scenario::verdict).collect();
    for (scenario, verdict) in scenarios.iter().zip(&judged) {
        assert!(verdict.is_right(), "{scenario}: an error of {} times what is allowed", verdict.share);
    }
    judged
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(800))
        .sample_size(30)
        .nresamples(2000);
    targets = linearization
}

fn main() -> ExitCode {
    // The directory relative to which criterion's files are read.
    std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).expect("the workspace is there");
    if is_given("--write-pages") {
        return write_pages();
    }
    counts::main().unwrap_or_else(|| {
        benches();
        Criterion::default().configure_from_args().final_summary();
        ExitCode::SUCCESS
    })
}
