//! The samples of criterion and the counts of callgrind are read, summarized and compared correctly.

use crate::{
    Benchmark, BenchmarkError, Count, Difference, Instructions, Measured, Rounds, Spread, Task, VERDICTS,
    Verdict, Verdicts, median_interval, spread, write_rounds,
};
use beamgap::report::{Environment, Record, ReportError};
use beamgap::test_beam::Family;
use std::fs;
use std::path::{Path, PathBuf};

/// The path of a file of the workspace.
fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name)
}

fn committed(name: &str) -> String {
    let path = path("reports").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// `BEAMGAP_BLESS=1` writes the pages instead.
#[test]
fn committed_pages_are_what_the_committed_record_renders_to() {
    for (name, text) in Benchmark::from_json(&committed("benchmark.json")).unwrap().pages() {
        if std::env::var_os("BEAMGAP_BLESS").is_some() {
            fs::write(path("reports").join(&name), &text).unwrap();
        }
        assert!(text == committed(&name), "{name} is stale: BEAMGAP_BLESS=1 writes it again");
    }
}

#[test]
fn the_committed_record_is_written_again_as_it_is() {
    let json = committed("benchmark.json");
    assert!(Benchmark::from_json(&json).unwrap().to_json().unwrap() == json);
    assert!(json.len() < 300_000, "{} bytes", json.len());
}

/// The guide states the claims of the record, in the words generated from the record, and README some of these.
#[test]
fn the_guide_claims_what_was_measured() {
    let words = |name: &str| {
        let text = fs::read_to_string(path(name)).unwrap();
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let (guide, readme) = (words("docs/cost.md"), words("README.md"));
    for claim in Benchmark::from_json(&committed("benchmark.json")).unwrap().claims() {
        assert!(guide.contains(&claim), "docs/cost.md is to say:\n{claim}");
    }
    let (_, cost) = readme.split_once(" ## Cost - ").unwrap();
    let (cost, _) = cost.split_once(" ## ").unwrap();
    let claims: Vec<_> = cost.split(" - ").collect();
    assert_eq!(claims.len(), 5);
    for claim in claims {
        assert!(guide.contains(claim), "docs/cost.md does not say, as README does:\n{claim}");
    }
}

#[test]
fn committed_medians_and_intervals_follow_from_the_samples() {
    for measured in Benchmark::from_json(&committed("benchmark.json")).unwrap().scenarios {
        let of_samples = spread(&measured.samples).unwrap();
        assert!((of_samples.median - measured.median).abs() <= 1e-4 * measured.median, "{measured:?}");
        assert_eq!(of_samples.interval.map(f64::to_bits), measured.interval.map(f64::to_bits));
        assert!(measured.share <= 1.0, "no row without a green verdict");
    }
}

/// The committed benchmark contains every method and family, also those that are too slow to compile in a test.
#[test]
fn every_family_is_timed_in_every_way() {
    let all = Benchmark::from_json(&committed("benchmark.json")).unwrap().scenarios;
    let has = |task: Task, family: &str, method: &str| {
        let is_it = |of: &&Measured| of.task == task.name() && of.family == family && of.method == method;
        assert_eq!(all.iter().filter(is_it).count(), 1, "{}, {family}, {method}", task.name());
    };
    for family in ["segment", "quadratic", "hermite", "bspline", "nurbs", "helix"] {
        for task in [Task::Distance, Task::All] {
            has(task, family, "closed form");
            has(task, family, "rows of hyper-duals, by orders");
            has(task, family, "rows of hyper-duals, chord");
            has(task, family, "differences of gradients");
            has(task, family, "differences of values");
        }
        for task in [Task::Distance, Task::All, Task::Directions] {
            has(task, family, "hyper-dual, chord");
            has(task, family, "hyper-dual, Newton");
            has(task, family, "hyper-dual, stationary");
        }
        for task in [Task::Directions, Task::GradientOfDistance, Task::Gradients] {
            has(task, family, "closed form");
        }
        has(Task::WithSlips, family, "closed form, term by term");
    }
    for family in Family::ALL {
        has(Task::ClosestPoint, family.name(), "search for all minima");
        has(Task::ClosestPoint, family.name(), "Newton from 0.05 off");
    }
}

/// An entry of a large result costs no more instructions than an entry of a small result.
#[test]
fn the_cost_is_proportional_to_the_size_of_the_result() {
    let counts = Instructions::from_json(&committed("instructions.json")).unwrap().rows;
    #[expect(clippy::cast_precision_loss, reason = "counts instructions")]
    let of_an_entry = |task: Task, family: &str, dofs: usize| {
        let name = format!("{}, closed form", task.group(family, dofs));
        counts.iter().find(|row| row.scenario == name).expect(&name).instructions as f64
            / (dofs * dofs) as f64
    };
    for task in [Task::DistanceBySize, Task::AllBySize] {
        for (family, sizes) in [("lagrange", &[12, 24, 48, 72, 96][..]), ("bspline", &[24, 48, 96])] {
            let costs: Vec<f64> = sizes.iter().map(|&dofs| of_an_entry(task, family, dofs)).collect();
            assert!(costs.iter().all(|cost| (0.25..=costs[0]).contains(cost)), "{family}: {costs:?}");
        }
    }
}

#[test]
fn a_record_of_another_schema_is_refused() {
    let other = committed("benchmark.json").replace(Benchmark::SCHEMA, "beamgap-benchmark/0");
    assert!(matches!(Benchmark::from_json(&other), Err(ReportError::Schema { .. })));
}

#[test]
#[expect(clippy::float_cmp, reason = "the ends of an interval are samples themselves")]
fn intervals_of_medians_have_the_ranks_of_the_tables() {
    // n, and the lower rank of the 95 % interval, from W. Conover's table of the binomial distribution.
    for (n, rank) in [(6, 1), (9, 2), (12, 3), (20, 6), (25, 8), (30, 10)] {
        let sorted: Vec<f64> = (1..=n).map(f64::from).collect();
        assert_eq!(median_interval(&sorted, 0.95), [f64::from(rank), f64::from(n + 1 - rank)], "n = {n}");
    }
    // Three samples are too few for 95 %.
    assert_eq!(median_interval(&[1.0, 2.0, 3.0], 0.95), [1.0, 3.0]);
}

#[test]
fn times_are_summed_up_in_any_order() {
    let times: Vec<f64> = (1..=30).rev().map(f64::from).collect();
    let Spread { median, interval } = spread(&times).unwrap();
    assert_eq!((median, interval), (15.5, [10.0, 21.0]));
    assert!(spread(&[]).is_none());
}

/// A directory with the files that criterion writes; it is removed at the end.
struct Left(PathBuf);

impl Left {
    fn new(name: &str) -> Self {
        let directory = std::env::temp_dir().join(format!("beamgap-benches-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&directory);
        fs::create_dir_all(&directory).unwrap();
        Self(directory)
    }

    fn verdicts(&self, methods: &[(&str, f64)]) {
        let verdict = |&(method, share): &(&str, f64)| Verdict {
            task: "d".to_owned(),
            family: "hermite".to_owned(),
            dofs: 24,
            method: method.to_owned(),
            pairs: 4,
            error: 1e-16,
            share,
        };
        let verdicts = Verdicts {
            environment: Environment::here("by hand"),
            scenarios: methods.iter().map(verdict).collect(),
        };
        verdicts.write(&self.0).unwrap();
    }

    /// Ten samples with 1 to 10 iterations, at `time` nanoseconds an iteration.
    fn samples(&self, method: &str, time: f64) {
        self.samples_of("d/hermite, 24 dofs", method, time);
    }

    fn samples_of(&self, group: &str, method: &str, time: f64) {
        let directory = self.0.join(group.replace('/', "_")).join(method).join("new");
        fs::create_dir_all(&directory).unwrap();
        let name = format!(r#"{{"group_id":"{group}","function_id":"{method}","of_the_future":[1,2]}}"#);
        fs::write(directory.join("benchmark.json"), name).unwrap();
        let iterations: Vec<f64> = (1..=10).map(f64::from).collect();
        let times: Vec<f64> = iterations.iter().map(|n| n * time).collect();
        let sample = format!(r#"{{"sampling_mode":"Flat","iters":{iterations:?},"times":{times:?}}}"#);
        fs::write(directory.join("sample.json"), sample).unwrap();
    }
}

impl Drop for Left {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn what_criterion_left_is_read_and_what_it_should_not_hold_is_passed_over() {
    let left = Left::new("whole");
    left.verdicts(&[("closed form", 0.1), ("hyper-dual", 0.2)]);
    left.samples("closed form", 800.0);
    left.samples("hyper-dual", 160_000.0);
    left.samples("of an older version", 1.0);
    let roofline = Rounds::Roofline { multiply_adds: 1500, samples: vec![[812.5, 0.5, 0.25]] };
    // The machine is slower in the second round. By their own samples the dual numbers take 200 times as long.
    let samples = vec![[48_000.0, 200.0], [72_000.0, 300.0], [49_000.0, 200.0]];
    let of_group =
        |method: &str, rounds: &Rounds| ("d/hermite, 24 dofs".to_owned(), method.to_owned(), rounds.clone());
    let by_closed_form = Rounds::ClosedForm { samples };
    let rounds = [("closed form", &roofline), ("hyper-dual", &by_closed_form), ("hyper-dual", &roofline)];
    write_rounds(&left.0, &rounds.map(|(method, rounds)| of_group(method, rounds))).unwrap();
    let broken = left.0.join("broken/new");
    fs::create_dir_all(&broken).unwrap();
    fs::write(broken.join("benchmark.json"), "{").unwrap();
    fs::write(broken.join("sample.json"), "{}").unwrap();

    let Benchmark { scenarios, .. } = Benchmark::read(&left.0).unwrap();
    let methods: Vec<&str> = scenarios.iter().map(|measured| measured.method.as_str()).collect();
    assert_eq!(methods, ["closed form", "hyper-dual"]);
    assert_eq!(scenarios[0].rounds, std::slice::from_ref(&roofline));
    assert_eq!(
        (&scenarios[0].ratio_to_closed_form, &scenarios[1].rounds),
        (&None, &vec![by_closed_form, roofline])
    );
    let Measured { task, family, dofs, median, ratio_to_closed_form, .. } = &scenarios[1];
    // The time of one of four pairs.
    assert_eq!((task.as_str(), family.as_str(), *dofs, *median), ("d", "hermite", 24, 40_000.0));
    let ratio = ratio_to_closed_form.unwrap();
    assert_eq!((ratio.value, ratio.interval), (240.0, [240.0, 245.0]));
    assert!(ratio.is_different());
}

#[test]
fn what_is_missing_is_named_with_the_command_that_makes_it() {
    let left = Left::new("pieces");
    let error = || Benchmark::read(&left.0).unwrap_err();
    assert!(matches!(error(), BenchmarkError::NoMeasurements { .. }));
    assert!(error().to_string().contains("`cargo bench`"));

    left.samples("closed form", 800.0);
    assert!(matches!(error(), BenchmarkError::NoVerdicts { .. }));
    assert!(error().to_string().contains("`cargo bench`") && error().to_string().contains(VERDICTS));

    // The method is timed before it is verified. The sleep makes the times of the two files differ.
    std::thread::sleep(std::time::Duration::from_millis(20));
    left.verdicts(&[("closed form", 0.1)]);
    assert!(matches!(error(), BenchmarkError::NotTimed { .. }));
    assert!(error().to_string().starts_with("d/hermite, 24 dofs, closed form"));

    left.verdicts(&[("closed form", 1.01)]);
    assert!(matches!(error(), BenchmarkError::Wrong { .. }));
}

#[test]
fn counts_that_grow_by_more_than_three_percent_or_vanish_fail() {
    let counts = |rows: &[(&str, u64)]| Instructions {
        schema: Instructions::SCHEMA.to_owned(),
        rustc: "rustc 1".to_owned(),
        target: "x86_64".to_owned(),
        command: "none".to_owned(),
        rows: rows.iter().map(|&(name, n)| Count { scenario: name.to_owned(), instructions: n }).collect(),
    };
    let record = counts(&[("a", 1000), ("b", 1000), ("c", 1000), ("d", 1000)]);
    assert!(record.differences(&record).is_empty());
    let now = counts(&[("a", 1030), ("b", 1031), ("c", 969), ("e", 1)]);
    let found = record.differences(&now);
    let [grown, shrunk, gone, new] = &found[..] else { panic!("{found:?}") };
    assert!(matches!(grown, Difference::Grown(name, _) if name == "b") && grown.is_failure(), "{grown}");
    assert!(matches!(shrunk, Difference::Shrunk(name, _) if name == "c") && !shrunk.is_failure(), "{shrunk}");
    assert!(*gone == Difference::Gone("d".into()) && gone.is_failure(), "{gone}");
    assert!(*new == Difference::New("e".into()) && !new.is_failure(), "{new}");
    assert!(!record.is_comparable(&Instructions { rustc: "rustc 2".to_owned(), ..now }));
}
