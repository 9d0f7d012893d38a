//! The reports say what was found and measured, and nothing else.

use beamgap::check::{self, CheckConfig, Regime, Selection};
use beamgap::equations;
use beamgap::prove::prove;
use beamgap::report::{
    Accuracy, Benchmark, Bounds, Count, Crosscheck, Derivation, Difference, Environment, Equations, Faults,
    Instructions, Measured, Record, ReportError, Rounds, Spread, Task, VERDICTS, Verdict, Verdicts,
    median_interval, picture, spread, symbols, write_rounds,
};
use beamgap::test_beam::Family;
use beamgap::variant::Variant;
use std::fs;
use std::path::{Path, PathBuf};

pub(crate) fn committed(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Compares a page with the committed one; `BEAMGAP_BLESS=1` writes it instead.
pub(crate) fn is_committed(name: &str, text: &str) {
    if std::env::var_os("BEAMGAP_BLESS").is_some() {
        fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join("reports").join(name), text).unwrap();
    }
    assert!(text == committed(name), "{name} is stale: BEAMGAP_BLESS=1 writes it again");
}

#[test]
fn committed_pages_are_what_the_committed_records_render_to() {
    let crosscheck = Crosscheck::from_json(&committed("crosscheck.json")).unwrap();
    is_committed("crosscheck.md", &crosscheck.page().to_markdown());
    let bounds = Bounds::from_json(&committed("bounds.json")).unwrap();
    is_committed("bounds.md", &bounds.page().to_markdown());
    let accuracy = Accuracy::from_json(&committed("accuracy.json")).unwrap();
    is_committed("accuracy.md", &accuracy.page().to_markdown());
    is_committed("accuracy-gap.svg", &accuracy.gap_to_svg());
    is_committed("accuracy-angle.svg", &accuracy.angle_to_svg());
    let faults = Faults::from_json(&committed("faults.json")).unwrap();
    is_committed("faults.md", &faults.page().to_markdown());
    let equations = Equations::from_json(&committed("equations.json")).unwrap();
    is_committed("equations.md", &equations.page().to_markdown());
    let derivation = Derivation::from_json(&committed("derivation.json")).unwrap();
    is_committed("derivation.html", &derivation.to_html(&equations.table, Some(&accuracy)).unwrap());
    is_committed("symbols.md", &symbols().to_markdown());
    is_committed("beams.svg", &picture().unwrap());
    let benchmark = Benchmark::from_json(&committed("benchmark.json")).unwrap();
    for (name, text) in benchmark.pages() {
        is_committed(&name, &text);
    }
}

#[test]
fn committed_records_are_written_again_as_they_are() {
    let json = committed("crosscheck.json");
    assert!(Crosscheck::from_json(&json).unwrap().to_json().unwrap() == json);
    let json = committed("bounds.json");
    assert!(Bounds::from_json(&json).unwrap().to_json().unwrap() == json);
    let json = committed("accuracy.json");
    assert!(Accuracy::from_json(&json).unwrap().to_json().unwrap() == json);
    let json = committed("benchmark.json");
    assert!(Benchmark::from_json(&json).unwrap().to_json().unwrap() == json);
    assert!(json.len() < 300_000, "{} bytes", json.len());
}

/// What the report, the gate and the proof say hangs on the seed alone, not on who does the work.
#[test]
fn threads_do_not_matter() {
    let selection = Selection { regimes: Regime::ALL.to_vec(), family: None, cases: 40 };
    let found = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let (summary, proof) = pool.install(|| {
            (
                check::run(&CheckConfig::default(), 7, &selection, || ()),
                prove(&Variant::Unmodified, 7, &Family::ALL[..4], 16),
            )
        });
        let record = Crosscheck::new(&summary, 7, 40, Environment::here("none")).to_json().unwrap();
        (summary, proof, record)
    };
    let one = found(1);
    assert!(one == found(2) && one == found(5));
}

/// The front page claims of the benchmarks what their record says, in the words that are made of it.
#[test]
fn the_front_page_claims_what_was_measured() {
    let front = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md")).unwrap();
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut claims = Benchmark::from_json(&committed("benchmark.json")).unwrap().claims();
    claims.extend(claims_of_the_table());
    for claim in claims {
        assert!(words(&front).contains(&claim), "README.md is to say:\n{claim}");
    }
}

/// The rows of the table at the top of the front page.
fn claims_of_the_table() -> [String; 7] {
    let crosscheck = Crosscheck::from_json(&committed("crosscheck.json")).unwrap();
    let bounds = Bounds::from_json(&committed("bounds.json")).unwrap();
    let faults = Faults::from_json(&committed("faults.json")).unwrap();
    let equations = Equations::from_json(&committed("equations.json")).unwrap();
    let accuracy = Accuracy::from_json(&committed("accuracy.json")).unwrap();
    let at =
        |rows: &[check::Level], at: f64| *rows.iter().find(|row| (row.at / at - 1.0).abs() < 1e-9).unwrap();
    let (gap, angle) = (at(&accuracy.found.gaps, 1e-6), at(&accuracy.found.angles, 1e-5));
    let error = |error: Option<f64>| format!("{:.1e}", error.unwrap());
    let numbers: u64 = crosscheck.quantities.iter().map(|worst| worst.entries).sum();
    let left = crosscheck.regimes.iter().flat_map(|regime| &regime.not_compared).map(|what| what.count);
    let of_terms: usize = faults.kinds.iter().map(|(_, count)| count).sum();
    let of_gate = || faults.rows.iter().filter(|row| row.check == "gate");
    assert!(of_gate().all(|row| row.detected == of_terms && row.false_positives.is_empty()));
    let most =
        faults.rows.iter().filter(|row| row.check == "symmetry").max_by_key(|row| row.detected).unwrap();
    let operations: usize = faults.operations.iter().map(|row| row.faults).sum();
    let misprints =
        equations.table.equations.iter().filter(|row| row.verdict == equations::Verdict::Misprint).count();
    [
        format!(
            "| Closed form and automatic differentiation agree. | {} closest points, {} numbers, {} regimes, {} pairs of \
             curve families: {} mismatches. {} points are not compared, each with its reason. | \
             [crosscheck](reports/crosscheck.md) |",
            count(crosscheck.points),
            count(numbers),
            crosscheck.regimes.len(),
            crosscheck.pairs.len(),
            crosscheck.mismatches.len(),
            count(left.sum())
        ),
        format!(
            "| The tolerances are bounds. | {} closest points: {} errors exceed their bound. | [bounds](reports/bounds.md) |",
            count(bounds.regimes.iter().map(|regime| regime.points.measured).sum()),
            bounds.violations.len()
        ),
        format!(
            "| The check detects wrong terms. | {} of {} faults in each regime; {} of {} equivalent formulas rejected. \
             Symmetry alone detects {} of {}. | [faults](reports/faults.md) |",
            count(of_terms as u64),
            count(of_terms as u64),
            of_gate().map(|row| row.false_positives.len()).max().unwrap(),
            faults.rewrites.len(),
            most.detected,
            most.planted
        ),
        format!(
            "| The check covers every operation. | {} faults of single operations: each is detected or has a reason. | \
             [faults](reports/faults.md) |",
            count(operations as u64)
        ),
        format!(
            "| The paper is verified equation by equation. | {} equations: {misprints} are misprinted. | \
             [equations](reports/equations.md) |",
            equations.table.equations.len()
        ),
        format!("AGREE: at {} closest points nothing differs beyond rounding.", crosscheck.points),
        format!(
            "At a gap of 1e-6 lengths the second variation of d has a median relative error of {}; the paper's formula has \
             {}. Between straight beams at an angle of 1e-5 that of xi has {}; the paper's formula has {}.",
            error(gap.d.chosen),
            error(gap.d.paper),
            error(angle.xi.chosen),
            error(angle.xi.paper)
        ),
    ]
}

/// A count with its thousands apart.
fn count(number: u64) -> String {
    let digits = number.to_string();
    let grouped: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().map(|group| std::str::from_utf8(group).unwrap()).collect();
    grouped.join(",")
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

/// What is timed with which beams, whatever the tests can afford to compile.
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

/// An entry of a large result costs no more than one of a small result, by the count of instructions.
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
    // Too few for 95 %.
    assert_eq!(median_interval(&[1.0, 2.0, 3.0], 0.95), [1.0, 3.0]);
}

#[test]
fn times_are_summed_up_in_any_order() {
    let times: Vec<f64> = (1..=30).rev().map(f64::from).collect();
    let Spread { median, interval } = spread(&times).unwrap();
    assert_eq!((median, interval), (15.5, [10.0, 21.0]));
    assert!(spread(&[]).is_none());
}

/// A directory as criterion leaves it, removed in the end.
struct Left(PathBuf);

impl Left {
    fn new(name: &str) -> Self {
        let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
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

    /// Ten samples, of one iteration more each, at so many nanoseconds an iteration.
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
    // The machine is slower in the second round; by their samples alone the dual numbers take 200 times as long.
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
    assert!(matches!(error(), ReportError::NoMeasurements { .. }));
    assert!(error().to_string().contains("`cargo bench`"));

    left.samples("closed form", 800.0);
    assert!(matches!(error(), ReportError::NoVerdicts { .. }));
    assert!(error().to_string().contains("`cargo bench`") && error().to_string().contains(VERDICTS));

    // Timed before it was verified, by a clock that may not tell the two caches apart.
    std::thread::sleep(std::time::Duration::from_millis(20));
    left.verdicts(&[("closed form", 0.1)]);
    assert!(matches!(error(), ReportError::NotTimed { .. }));
    assert!(error().to_string().starts_with("d/hermite, 24 dofs, closed form"));

    left.verdicts(&[("closed form", 1.01)]);
    assert!(matches!(error(), ReportError::Wrong { .. }));
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
