//! Every equation of the paper is in the table and in the source, and has the verdict that the table states.

use beamgap::equations::{
    CASES, Counts, DRAWS, EquationRow, EquationTable, Reading, SOURCES, Symmetry, Verdict, equation_table,
    named, places,
};
use beamgap::report::{Equations, Record};
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::LazyLock;

/// The current table, computed once for all tests.
static NOW: LazyLock<EquationTable> = LazyLock::new(|| {
    let committed = committed();
    equation_table(committed.seed, committed.draws, CASES)
});

fn file(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap()
}

fn committed() -> EquationTable {
    Equations::from_json(&file("reports/equations.json")).unwrap().table
}

fn numbers(wanted: impl Fn(&EquationRow) -> bool) -> Vec<u8> {
    NOW.equations.iter().filter(|entry| wanted(entry)).map(|entry| entry.number).collect()
}

/// Equal except for the line numbers of the source and the last digits of errors, which depend on the machine. A
/// rounding error must be one in both. Any other error must agree in two digits, within one unit of the last digit.
fn same(one: &Value, other: &Value, key: &str) -> bool {
    match (one, other) {
        (Value::Object(one), Value::Object(other)) => {
            one.keys().eq(other.keys())
                && one.iter().all(|(key, value)| key == "line" || same(value, &other[key], key))
        }
        (Value::Array(one), Value::Array(other)) => {
            one.len() == other.len() && one.iter().zip(other).all(|(one, other)| same(one, other, key))
        }
        (Value::Number(one), Value::Number(other)) if ["errors", "error", "ratio"].contains(&key) => {
            let (one, other) = (one.as_f64().unwrap(), other.as_f64().unwrap());
            one.max(other) < 1e-9 || (one - other).abs() <= 0.11 * one.min(other)
        }
        _ => one == other,
    }
}

#[test]
fn the_committed_equations_are_what_a_run_finds_now() {
    assert_eq!((committed().seed, committed().draws), (0x5eed, DRAWS));
    let value = |table: &EquationTable| serde_json::to_value(table).unwrap();
    for (now, then) in NOW.equations.iter().zip(&committed().equations) {
        let json = |entry: &EquationRow| serde_json::to_value(entry).unwrap();
        assert!(same(&json(now), &json(then), ""), "stale at ({}), now {now:#?}", then.number);
    }
    assert!(
        same(&value(&NOW), &value(&committed()), ""),
        "stale: `cargo run --release -- report` writes it again"
    );
}

#[test]
fn the_committed_page_is_what_the_committed_record_renders_to() {
    let record = Equations::from_json(&file("reports/equations.json")).unwrap();
    assert!(record.page().to_markdown() == file("reports/equations.md"), "equations.md is stale");
    assert!(record.to_json().unwrap() == file("reports/equations.json"));
    assert_eq!(record.environment.command, "cargo run --release -- report");
}

#[test]
fn equations_in_the_source_and_in_the_table_are_the_same() {
    let all: Vec<u8> = (1..=59).collect();
    assert_eq!(NOW.equations.iter().map(|entry| entry.number).collect::<Vec<_>>(), all);
    assert_eq!(places().into_keys().collect::<Vec<_>>(), all);
    for (number, places) in places() {
        assert!(places.iter().all(|place| !place.item.is_empty()), "({number}): {places:?}");
    }
}

#[test]
fn every_file_that_names_an_equation_is_searched() {
    fn files(directory: &Path, found: &mut Vec<std::path::PathBuf>) {
        for entry in std::fs::read_dir(directory).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() { files(&path, found) } else { found.push(path) }
        }
    }
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = Vec::new();
    files(&source, &mut found);
    for path in found {
        let name = path.strip_prefix(&source).unwrap().to_str().unwrap().replace('\\', "/");
        let names_one = std::fs::read_to_string(&path).unwrap().lines().any(|line| !named(line).is_empty());
        // Excluded: the table quotes the paper, a rewrite uses other formulas than the closed form, and the text of
        // the front page computes nothing.
        let others = ["equations", "variant", "front_page", "report/front_page"];
        if names_one && !others.iter().any(|start| name.starts_with(start)) {
            assert!(SOURCES.iter().any(|(file, _)| *file == name), "src/equations/source.rs lacks {name}");
        }
    }
}

#[test]
fn lists_and_ranges_of_equations_are_read() {
    assert_eq!(named("// Eq. (57), (58): δd"), [57, 58]);
    assert_eq!(named("// Eq. (4)-(7), (9), with (10)"), [4, 5, 6, 7, 9]);
    assert_eq!(named("// Eq. (37), from (36): and in part Eq. (38) and (39)"), [37, 36, 38, 39]);
    assert_eq!(named("#[doc(alias = \"Eq. (40)\")]"), [40]);
    assert!(named("eqs. (4)-(59), (60), Eq. (), Eq. 3, Eq. (n)").is_empty());
}

#[test]
fn verdicts_are_those_of_the_derivation() {
    let of = |verdict| numbers(|entry| entry.verdict == verdict);
    assert_eq!(of(Verdict::Definition), [1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 15]);
    assert_eq!(of(Verdict::NotInTheScan), [10]);
    assert_eq!(of(Verdict::Assumption), [13]);
    assert_eq!(of(Verdict::Approximation), [14]);
    assert_eq!(of(Verdict::List), [17, 22]);
    assert_eq!(of(Verdict::ExactIfFinite), [43, 45, 46]);
    assert_eq!(of(Verdict::ExactIfLinear), [27, 30, 31, 54, 55, 59]);
    assert_eq!(of(Verdict::Misprint), [16, 32, 39, 40, 42, 49, 56, 57, 58]);
    assert_eq!(of(Verdict::Refuted), [0; 0]);
    assert!(NOW.holds());
    assert_eq!(NOW.equation(16).unwrap().omitted, [r"\delta\bar{g}_T"]);
}

#[test]
fn the_field_and_floating_point_agree_on_every_reading() {
    // An equation that is refuted at random residues is wrong in f64, and one that is equal there differs by rounding.
    for entry in &NOW.equations {
        for part in &entry.parts {
            for run in &part.runs {
                for (counts, error) in
                    [run.score.linear, run.score.nonlinear].into_iter().zip(run.score.errors)
                {
                    let error = error.unwrap();
                    assert!(counts.equal + counts.refuted > 0);
                    let off = if counts.refuted > 0 { error > 1e-3 } else { error < 1e-12 };
                    assert!(off, "({}) {}, {}: {error:e}, {counts:?}", entry.number, part.name, run.words);
                }
            }
        }
    }
}

#[test]
fn operators_are_symmetric_as_corrected_and_some_by_relations_only() {
    let holds: Vec<bool> = NOW.claims.iter().map(beamgap::equations::Claim::holds).collect();
    assert_eq!(holds, [true, true, false, true, false], "{:#?}", NOW.claims);
    let by_relations = numbers(|entry| {
        let symmetry =
            |part: &beamgap::equations::Part| part.corrected().and_then(beamgap::equations::Run::symmetry);
        entry.parts.iter().any(|part| symmetry(part) == Some(Symmetry::ByRelations))
    });
    assert_eq!(by_relations, [25, 29, 34, 38, 39, 40, 57]);
}

#[test]
fn the_slip_is_an_arc_length_where_the_tangent_keeps_its_length() {
    for arc in &NOW.equation(14).unwrap().arcs {
        let constant = ["segment", "arc", "helix"].contains(&arc.family.as_str());
        assert_eq!(arc.is_exact(), constant, "{arc:?}");
        // The error is quadratic in the slip to leading order.
        assert!(arc.ratio.is_none_or(|ratio| (ratio - 4.0).abs() < 0.3), "{arc:?}");
    }
}

#[test]
fn verdicts_follow_from_the_counts() {
    let verdict = |number: u8, change: &dyn Fn(Reading) -> Option<[u64; 2]>| {
        let mut part = NOW.equation(number).unwrap().parts.last().unwrap().clone();
        for run in &mut part.runs {
            if let Some(refuted) = change(run.reading) {
                let counts = |refuted| Counts { equal: 10 - refuted, refuted };
                (run.score.linear, run.score.nonlinear) = (counts(refuted[0]), counts(refuted[1]));
            }
        }
        part.verdict()
    };
    let printed = |refuted: [u64; 2]| move |reading| (reading == Reading::Printed).then_some(refuted);
    let complete = |refuted: [u64; 2]| move |reading| (reading == Reading::Complete).then_some(refuted);
    assert_eq!(verdict(27, &|_| None), Verdict::ExactIfLinear);
    assert_eq!(verdict(27, &printed([0, 0])), Verdict::Exact);
    assert_eq!(verdict(27, &printed([1, 1])), Verdict::Misprint);
    assert_eq!(verdict(27, &complete([0, 1])), Verdict::Refuted);
    assert_eq!(verdict(27, &complete([1, 0])), Verdict::Refuted);
    assert_eq!(verdict(42, &|_| None), Verdict::Misprint);
    assert_eq!(verdict(42, &|_| Some([0, 10])), Verdict::Refuted);
    assert_eq!(verdict(43, &|reading| (reading == Reading::Other).then_some([0, 0])), Verdict::Exact);
    assert_eq!(verdict(37, &printed([0, 1])), Verdict::Refuted);
}

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_beamgap")).arg("equations").args(arguments).output().unwrap()
}

#[test]
fn the_command_prints_all_or_one() {
    let all = run(&["--draws", "1"]);
    let text = String::from_utf8(all.stdout).unwrap();
    assert!(all.status.success() && all.stderr.is_empty(), "{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    assert!(
        text.ends_with("HOLDS: no equation is refuted as corrected; 9 of 59 are misprinted in the scan.\n")
    );
    for number in 1..=59 {
        let row = |line: &str| line.split_whitespace().next() == Some(&number.to_string());
        assert_eq!(text.lines().filter(|line| row(line)).count(), 1, "({number})");
    }

    let one = run(&["--draws", "1", "--equation", "42"]);
    assert!(
        one.status.success() && one.stderr.is_empty(),
        "an equation that is misprinted holds as corrected"
    );
    let text = String::from_utf8(one.stdout).unwrap();
    let head = "Equation (42) of the paper, as printed and as corrected, evaluated\n\n(42) ";
    assert!(text.starts_with(head), "{text}");
    for part in [
        "1/t³ (𝐭,ξ Δξ + Δᵤ𝐮_C,ξ)·𝐭·(𝐭,ξ δξ + δᵤ𝐮_C,ξ)",
        "+ outside [..]; t (Δt·δt)",
        "As corrected",
        "lengths.rs:",
        "Eq. (42): misprint.",
    ] {
        assert!(text.contains(part), "{part} is missing in {text}");
    }

    assert!(!text.contains('\\'), "{text}");
    let latex = run(&["--draws", "1", "--equation", "42", "--latex"]);
    assert!(String::from_utf8(latex.stdout).unwrap().contains(r"\frac{1}{t^3}"));

    let json = run(&["--draws", "1", "--equation", "42", "--format", "json"]);
    assert!(json.stderr.starts_with(b"Equation (42) of the paper"), "{json:?}");
    let record = Equations::from_json(&String::from_utf8(json.stdout).unwrap()).unwrap().table;
    assert_eq!((record.equations.len(), record.equations[0].number), (1, 42));
}

#[test]
fn the_recorded_command_makes_the_record() {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("equations");
    let written = run(&["--to", directory.to_str().unwrap(), "--allow-dirty", "--format", "json"]);
    let json = std::fs::read_to_string(directory.join("equations.json")).unwrap();
    assert_eq!(json, String::from_utf8(written.stdout).unwrap());
    let record = Equations::from_json(&json).unwrap();
    assert_eq!(record.table, *NOW);
    assert_eq!(record.environment.command, "cargo run --release -- equations --to reports");
    let page = std::fs::read_to_string(directory.join("equations.md")).unwrap();
    assert_eq!(page, record.page().to_markdown());
    let other = run(&["--format", "json", "--seed", "7", "--draws", "1"]);
    let other = serde_json::from_slice::<Value>(&other.stdout).unwrap();
    let command = "cargo run --release -- equations --to reports --seed 0x7 --draws 1";
    assert_eq!(other["environment"]["command"], command);
}

#[test]
fn there_is_no_sixtieth_equation() {
    for number in ["0", "60", "x"] {
        assert_eq!(run(&["--equation", number]).status.code(), Some(2));
    }
    for place in ["--output", "--to"] {
        assert_eq!(run(&["--draws", "1", place, "/dev/null/at/all"]).status.code(), Some(3), "{place}");
    }
    assert_eq!(run(&["--to", "here", "--equation", "1"]).status.code(), Some(2));
}
