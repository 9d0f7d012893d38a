//! Hand-written elements agree, and every error that is put into them is detected with one case a regime.
//!
//! The elements and the table of their errors are in `tests/elements`. A compiler that is missing skips its elements; if
//! BEAMGAP_ADAPTERS is set, it is an error. With BEAMGAP_ELEMENTS=all each error is tried with up to ten cases a regime, and
//! with as many as ten seeds. The comparison is that of `beamgap verify`, without its search for the cause.

mod cases;
mod conditions;
mod friction;
mod table;

use crate::program::run;
use beamgap::check::Order;
use beamgap::check::external::{AnswerReader, Answers, CaseFound, Demands, Judgement, compare_answers};
use beamgap::linearization::Quantity;
use cases::{Cases, REGIMES};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use table::{Row, rows};

/// The number of cases of a regime from which on an error is detected, whether the cases have what it needs or not.
const ENOUGH: usize = 10;
/// What is wrong first in the order of evaluation: the order, the place of the quantity in [`QUANTITIES`].
type FirstWrong = (Order, usize);

/// The quantities in the order of evaluation.
const QUANTITIES: [(Quantity, &str); 8] = [
    (Quantity::Xi, "xi"),
    (Quantity::XiBar, "xi_bar"),
    (Quantity::D, "d"),
    (Quantity::GN, "g_N"),
    (Quantity::T, "t"),
    (Quantity::TBar, "t_bar"),
    (Quantity::GT, "g_T"),
    (Quantity::GTBar, "g_T_bar"),
];

/// The answers of a program, compared case by case until one is wrong: the number of this case, and what is wrong there.
fn first_wrong(program: &Path, error: u32, cases: &Cases) -> Option<(usize, FirstWrong)> {
    let mut child = Command::new(program)
        .arg(error.to_string())
        .stdin(File::open(&cases.path).unwrap())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut reader = AnswerReader::new(BufReader::new(child.stdout.take().unwrap()), "answers").unwrap();
    let mut found = None;
    let mut compared = 0;
    for (number, vector) in cases.vectors.iter().enumerate() {
        let answers =
            reader.next_answers().unwrap().unwrap_or_else(|| panic!("error {error}: case {number} expected"));
        assert_eq!(answers.id, vector.id);
        let CaseFound::Compared(judged, doubted) =
            compare_answers(vector, &answers, &Demands::default()).unwrap()
        else {
            continue;
        };
        compared += 1;
        assert!(!doubted, "error {error}, case {number}: the references disagree");
        let wrong = judged.iter().filter(|judged| judged.judgement == Judgement::Wrong);
        let place = |quantity| QUANTITIES.iter().position(|(known, _)| *known == quantity).unwrap();
        if let Some(first) =
            wrong.map(|judged| (judged.comparison.order, place(judged.comparison.quantity))).min()
        {
            found = Some((number, first));
            break;
        }
    }
    assert!(compared > 0, "nothing was compared");
    // The program may wait for its answers to be read.
    drop(reader);
    child.wait().unwrap();
    found
}

/// All answers of a program.
fn answers_of(program: &Path, error: u32, cases: &Cases) -> Vec<Answers> {
    let stdin = File::open(&cases.path).unwrap();
    let output = Command::new(program).arg(error.to_string()).stdin(stdin).output().unwrap();
    assert!(output.status.success(), "error {error}: {}", output.status);
    let mut reader = AnswerReader::new(&output.stdout[..], "answers").unwrap();
    std::iter::from_fn(|| reader.next_answers().unwrap()).collect()
}

/// The compiled element.
fn compiled(style: &str, file: &str, compiler: &[&str], folder: &Path) -> Option<PathBuf> {
    let is_there = Command::new(compiler[0]).arg("--version").output().is_ok();
    assert!(is_there || std::env::var_os("BEAMGAP_ADAPTERS").is_none(), "{} is missing", compiler[0]);
    if !is_there {
        return None;
    }
    let program = folder.join(style);
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/elements").join(file);
    let output = Command::new(compiler[0])
        .args(&compiler[1..])
        .args(["-Wall", "-Wextra", "-Werror"])
        .arg(source)
        .arg("-o")
        .arg(&program)
        .arg("-lm")
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(program)
}

/// The cause of an error, as `beamgap verify` words it, or where to look if it is not known.
fn cause(program: &Path, error: u32, cases: &Cases) -> String {
    let answers = cases.path.with_extension(format!("{error}.answers"));
    let (stdin, stdout) = (File::open(&cases.path).unwrap(), File::create(&answers).unwrap());
    let status = Command::new(program).arg(error.to_string()).stdin(stdin).stdout(stdout).status().unwrap();
    assert!(status.success(), "error {error}: {status}");
    let [cases, answers] = [&cases.path, &answers].map(|path| path.to_str().unwrap());
    let output = run(&["verify", cases, answers, "--format", "json"]);
    let result: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let explanation = &result["explanation"];
    let place = explanation["place"].as_str().unwrap_or("the numbers have a form of their own");
    let words = explanation["causes"][0]["words"].as_str();
    words.map_or_else(|| format!("{UNKNOWN}{place}"), ToOwned::to_owned)
}

/// The words before the place of an error whose cause is not known.
const UNKNOWN: &str = "not known: ";

/// The exit code of `beamgap verify` for the element with an error.
fn exit_code(program: &Path, error: u32, cases: &Cases) -> Option<i32> {
    let command = format!("'{}' {error}", program.display());
    run(&["verify", cases.path.to_str().unwrap(), "--run", &command, "--no-explanation"]).status.code()
}

fn detected((style, file, compiler): (&str, &str, &[&str])) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("element-{style}"));
    std::fs::create_dir_all(&folder).unwrap();
    let Some(program) = compiled(style, file, compiler, &folder) else { return };
    let is_full = std::env::var_os("BEAMGAP_ELEMENTS").is_some();
    let (seeds, counts) = if is_full { (1..=10, ENOUGH) } else { (1..=5, 1) };
    let all: Vec<_> = seeds.map(|seed| Cases::exported(seed, counts, &["hermite"], &folder)).collect();
    // A file of more cases begins with the cases of a smaller one, so an error that is detected stays so.
    let more = Cases::exported(1, counts + 1, &["hermite"], &folder);
    assert_eq!(more.lines[..all[0].lines.len()], all[0].lines);
    for cases in &all {
        assert_eq!(first_wrong(&program, 0, cases), None, "the unmodified element, seed {}", cases.seed);
    }
    let mixed = Cases::exported(1, 4, &["hermite", "segment"], &folder);
    assert_eq!(first_wrong(&program, 0, &mixed), None, "Hermite curves and segments");
    let rows: Vec<Row> = rows().into_iter().filter(|row| row.style == style).collect();
    assert!(rows.len() >= 45, "{style}: {} errors", rows.len());
    let unconditional = rows.iter().find(|row| row.needs.is_empty()).unwrap();
    assert_eq!(
        [0, unconditional.number].map(|error| exit_code(&program, error, &all[0])),
        [Some(0), Some(1)]
    );

    let (mut green, mut misplaced, mut seen) = (Vec::new(), Vec::new(), BTreeMap::<usize, usize>::new());
    for row in &rows {
        let mut first = None;
        for cases in &all {
            let found = first_wrong(&program, row.number, cases);
            let detected_at = found.map_or(usize::MAX, |(number, _)| number / REGIMES + 1);
            let required_at = cases.with(&row.needs).min(ENOUGH);
            *seen.entry(detected_at).or_default() += 1;
            if required_at <= cases.of_a_regime() && detected_at > required_at {
                green.push(format!(
                    "{row}, seed {}: required at {required_at} cases a regime, detected at {}",
                    cases.seed,
                    if found.is_some() { detected_at.to_string() } else { "none".into() }
                ));
            }
            first = first.into_iter().chain(found.map(|(_, wrong)| wrong)).min();
        }
        let named = (row.order, QUANTITIES.iter().position(|(_, name)| *name == row.quantity).unwrap());
        if let Some(first) = first
            && first != named
        {
            misplaced.push(format!("{row}: found {} of {}", first.0.name(), QUANTITIES[first.1].1));
        }
    }
    if is_full {
        println!(
            "{style}: {} errors, {} seeds; cases a regime at detection, and how often: {seen:?}",
            rows.len(),
            all.len()
        );
    }
    assert!(green.is_empty(), "not detected:\n{}", green.join("\n"));
    assert!(misplaced.is_empty(), "first wrong elsewhere:\n{}", misplaced.join("\n"));
}

#[test]
fn errors_of_an_element_with_matrices_are_detected() {
    detected(STYLES[0]);
}

#[test]
fn errors_of_an_element_with_loops_over_components_are_detected() {
    detected(STYLES[1]);
}

#[test]
fn errors_of_an_element_by_sympy_are_detected() {
    detected(STYLES[2]);
}

/// The errors that are explained in every test run: of shape functions, of the inverse, of a sign in it, of a term, at some
/// cases, of the iteration, of a mirrored triangle, of a block, of a curve, one in a program with formulas of its own at held
/// ends, a right number that others contradict, and one that is not known.
const EXPLAINED: [u32; 14] = [104, 115, 136, 182, 183, 185, 210, 214, 230, 276, 280, 304, 321, 365];

/// The causes of errors, against the table of them. With BEAMGAP_ELEMENTS=all every error is explained, and with
/// BEAMGAP_BLESS=1 the table is written.
#[test]
fn causes_of_errors_are_named() {
    let table = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/elements/causes.txt");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("element-causes");
    std::fs::create_dir_all(&folder).unwrap();
    let cases = Cases::exported(1, ENOUGH, &["hermite"], &folder);
    let is_full = std::env::var_os("BEAMGAP_ELEMENTS").is_some();
    let known = std::fs::read_to_string(&table).unwrap_or_default();
    let (mut lines, mut others) = (Vec::new(), Vec::new());
    for (style, file, compiler) in STYLES {
        let Some(program) = compiled(style, file, compiler, &folder) else { return };
        for row in rows().into_iter().filter(|row| row.style == style) {
            if !is_full && !EXPLAINED.contains(&row.number) {
                continue;
            }
            let line = format!("{} {}", row.number, cause(&program, row.number, &cases));
            if !known.lines().any(|known| known == line) {
                others.push(line.clone());
            }
            lines.push(line);
        }
    }
    if is_full && std::env::var_os("BEAMGAP_BLESS").is_some() {
        std::fs::write(table, lines.join("\n") + "\n").unwrap();
        return;
    }
    let guide = include_str!("../../docs/verify.md").replace('\n', " ");
    assert!(guide.contains(&format!("is named for {} errors", known.lines().count())), "docs/verify.md");
    assert_eq!(known.lines().count(), rows().len());
    let unknown = lines.iter().filter(|line| line.contains(UNKNOWN)).count();
    assert!(8 * unknown <= lines.len(), "{unknown} of {} causes are not known", lines.len());
    assert!(others.is_empty(), "not in the table:\n{}", others.join("\n"));
}

/// The styles with their files and compilers.
const STYLES: [(&str, &str, &[&str]); 3] = [
    ("matrices", "matrices.cpp", &["c++", "-O2", "-std=c++17"]),
    ("components", "components.c", &["cc", "-O2", "-std=c99"]),
    ("sympy", "sympy.c", &["cc", "-O2", "-std=c99"]),
];
