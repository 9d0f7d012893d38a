//! How long the linearization takes, by way, by size and by task; every way is verified before any is timed.

mod differences;
mod pairs;
mod scenarios;

use criterion::{Criterion, SamplingMode, criterion_group, criterion_main};
use std::time::Duration;

fn linearization(criterion: &mut Criterion) {
    let scenarios = scenarios::scenarios();
    for of_group in scenarios.chunk_by(|a, b| a.group == b.group) {
        let mut group = criterion.benchmark_group(&of_group[0].group);
        group.sampling_mode(SamplingMode::Flat);
        for scenario in of_group {
            group.bench_function(scenario.name, |bencher| bencher.iter(&scenario.run));
        }
        group.finish();
    }
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
