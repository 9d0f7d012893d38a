//! How long the linearization takes, by way, by size and by task; every way is verified before any is timed.

mod differences;
mod pairs;
mod scenarios;

use beamgap::report::{Environment, Verdict, Verdicts, criterion_directory};
use criterion::{Criterion, SamplingMode, criterion_group, criterion_main};
use scenarios::Scenario;
use std::time::Duration;

fn linearization(criterion: &mut Criterion) {
    let scenarios = scenarios::scenarios();
    leave_verdicts(&scenarios);
    for of_group in scenarios.chunk_by(|a, b| a.group == b.group) {
        let mut group = criterion.benchmark_group(&of_group[0].group);
        group.sampling_mode(SamplingMode::Flat);
        for scenario in of_group {
            group.bench_function(scenario.name, |bencher| bencher.iter(&scenario.run));
        }
        group.finish();
    }
}

/// Writes down next to criterion's files what was verified, unless nothing is going to be timed.
fn leave_verdicts(scenarios: &[Scenario]) {
    let is_given = |flag: &str| std::env::args().any(|argument| argument == flag);
    if !is_given("--bench") || is_given("--test") || is_given("--list") {
        return;
    }
    let verdict = |scenario: &Scenario| {
        let Scenario { group, name, error, tolerance, .. } = scenario;
        Verdict { group: group.clone(), way: (*name).to_owned(), error: *error, tolerance: *tolerance }
    };
    let verdicts = Verdicts {
        environment: Environment::here("cargo bench"),
        scenarios: scenarios.iter().map(verdict).collect(),
    };
    verdicts.write(&criterion_directory()).expect("criterion's directory can be written to");
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .sample_size(30)
        .nresamples(2000);
    targets = linearization
}
criterion_main!(benches);
