//! Counts the instructions of the main scenarios with callgrind, and compares the counts with the record.
//!
//! The program runs itself under valgrind, which writes one file at each exit from [`counted`].

use crate::is_given;
use crate::scenario::{self, Runner, Scenario};
use beamgap::report::Record;
use beamgap_benchmark::{Count, Difference, Instructions, Task};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::{env, fs};

/// The file of the recorded counts.
const RECORD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../reports/instructions.json");
/// The argument of the process whose instructions are counted.
const COUNTED: &str = "--counted";

/// Counts, prints the counts, and checks or writes the record, if an argument requests this.
pub(crate) fn main() -> Option<ExitCode> {
    if is_given(COUNTED) {
        main_scenarios().iter().for_each(run);
        return Some(ExitCode::SUCCESS);
    }
    let (check, write) = (is_given("--check-counts"), is_given("--write-counts"));
    if !(check || write || is_given("--count")) {
        return None;
    }
    let Some(now) = count() else {
        println!("valgrind is not installed: nothing is counted, and nothing is checked");
        return Some(ExitCode::SUCCESS);
    };
    for Count { scenario, instructions } in &now.rows {
        println!("{instructions:>12}  {scenario}");
    }
    if write {
        fs::write(RECORD, now.to_json().expect("a record is JSON")).expect("the record can be written");
    }
    Some(if check { self::check(&now) } else { ExitCode::SUCCESS })
}

/// The counted scenarios: every closed form and search, and the fastest methods of automatic differentiation.
fn main_scenarios() -> Vec<Scenario> {
    let is_main = |scenario: &Scenario| match scenario.task {
        // The counts of several threads differ from run to run.
        Task::DistanceOfMany | Task::AllOfMany => false,
        Task::ClosestPoint | Task::ContactElement => true,
        _ => scenario.method.contains("closed form") || scenario.method.contains("by orders"),
    };
    scenario::all().into_iter().filter(is_main).collect()
}

/// The first run does the initialization, the second run is counted.
fn run(scenario: &Scenario) {
    let mut runner = scenario.runner();
    runner();
    counted(&mut runner);
}

/// The function whose instructions valgrind counts.
#[inline(never)]
fn counted(runner: &mut Runner) {
    runner();
}

/// Counts all main scenarios, if valgrind is installed.
fn count() -> Option<Instructions> {
    Command::new("valgrind").arg("--version").stdout(Stdio::null()).status().ok()?;
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("counts");
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).expect("the target directory can be written to");
    let files = directory.join("callgrind.out");
    let done = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--collect-atstart=no", "--instr-atstart=yes"])
        .args([
            "--toggle-collect=linearization::counts::counted",
            "--dump-after=linearization::counts::counted",
            "--combine-dumps=no",
        ])
        .arg(format!("--callgrind-out-file={}", files.display()))
        .arg(env::current_exe().expect("a program has a name"))
        .arg(COUNTED)
        .status()
        .expect("valgrind runs");
    assert!(done.success(), "valgrind: {done}");
    let scenarios = main_scenarios();
    let rows = scenarios.iter().zip(1..).map(|(scenario, i)| Count {
        scenario: scenario.to_string(),
        instructions: total(&directory.join(format!("callgrind.out.{i}"))),
    });
    let version = Command::new("rustc").arg("--version").output().expect("rustc runs").stdout;
    Some(Instructions {
        schema: Instructions::SCHEMA.to_owned(),
        rustc: String::from_utf8_lossy(&version).trim().to_owned(),
        target: target(),
        command: "cargo bench --bench linearization -- --write-counts".to_owned(),
        rows: rows.collect(),
    })
}

/// The architecture, and the instruction sets that are chosen at run time.
fn target() -> String {
    #[cfg(target_arch = "x86_64")]
    let chosen = if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
        " with AVX2 and FMA"
    } else {
        " without AVX2"
    };
    #[cfg(not(target_arch = "x86_64"))]
    let chosen = "";
    format!("{}{chosen}", env::consts::ARCH)
}

/// The total count in a file of callgrind.
fn total(file: &PathBuf) -> u64 {
    let text = fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let line = |name: &str| text.lines().find_map(|line| line.strip_prefix(name)?.trim().parse().ok());
    line("summary:").or_else(|| line("totals:")).expect("callgrind writes a total")
}

/// Compares the counts with the record.
fn check(now: &Instructions) -> ExitCode {
    let record = Instructions::from_json(&fs::read_to_string(RECORD).expect("there is a record"));
    let record = record.expect("the record is one");
    if !record.is_comparable(now) {
        println!(
            "recorded with {} for {}, counted with {} for {}: not compared",
            record.rustc, record.target, now.rustc, now.target
        );
        return ExitCode::SUCCESS;
    }
    let differences = record.differences(now);
    for difference in &differences {
        println!("{difference}");
    }
    if differences.iter().any(Difference::is_failure) { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
