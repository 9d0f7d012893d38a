//! The hand-written contact element with friction agrees in every state, and every error that is put into it is detected.
//!
//! With BEAMGAP_ELEMENTS=all more seeds are tried, and all errors are explained.

use super::{Cases, answers_of, cause, compiled};
use crate::program::run;
use beamgap::check::external::{CaseFound, Demands, Judgement, compare_answers};
use beamgap::contact::State;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// The cases of a regime: all situations occur.
const CASES: usize = 3;
/// The cases of a regime for explanations.
const EXPLAINED_CASES: usize = 12;

fn table() -> Vec<u32> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/elements/friction.csv");
    let text = std::fs::read_to_string(path).unwrap();
    text.lines().skip(1).map(|line| line.split_once(',').unwrap().0.parse().unwrap()).collect()
}

/// The program and its folder. It is compiled once, because tests that run side by side use it.
fn program() -> Option<(PathBuf, PathBuf)> {
    static PROGRAM: LazyLock<Option<(PathBuf, PathBuf)>> = LazyLock::new(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("element-friction");
        std::fs::create_dir_all(&folder).unwrap();
        Some((compiled("friction", "friction.c", &["cc", "-O2", "-std=c99"], &folder)?, folder))
    });
    PROGRAM.clone()
}

/// Whether a number of the answers is wrong, and the states of the cases.
fn is_red(program: &Path, error: u32, cases: &Cases) -> bool {
    let all = answers_of(program, error, cases);
    let mut is_red = false;
    for (vector, answers) in cases.vectors.iter().zip(&all) {
        match compare_answers(vector, answers, &Demands::default()).unwrap() {
            CaseFound::Compared(judged, is_doubted) => {
                assert!(!is_doubted, "error {error}, case {}: the references disagree", vector.id);
                is_red |= judged.iter().any(|judged| judged.judgement == Judgement::Wrong);
            }
            other => panic!("error {error}, case {}: {other:?}", vector.id),
        }
    }
    is_red
}

#[test]
fn errors_of_an_element_with_friction_are_detected() {
    let Some((program, folder)) = program() else { return };
    let seeds = if std::env::var_os("BEAMGAP_ELEMENTS").is_some() { 1..=10 } else { 1..=2 };
    let errors = table();
    let source = include_str!("../../elements/friction.c");
    for error in &errors {
        let marks = [
            format!("E({error},"),
            format!("F({error},"),
            format!("error == {error}"),
            format!("error != {error}"),
        ];
        assert!(marks.iter().any(|mark| source.contains(mark)), "{error} is not in the program");
    }
    for seed in seeds {
        let cases = Cases::with_elements(seed, CASES, &["hermite"], &folder);
        assert!(!is_red(&program, 0, &cases), "the unmodified element, seed {seed}");
        let mixed = Cases::with_elements(seed, CASES, &["hermite", "segment"], &folder);
        assert!(!is_red(&program, 0, &mixed), "Hermite curves and segments, seed {seed}");
        let green: Vec<_> = errors.iter().filter(|error| !is_red(&program, **error, &cases)).collect();
        assert!(green.is_empty(), "not detected with seed {seed}: {green:?}");
    }
}

/// A program that keeps its own history goes through the earlier steps of a case. If it keeps the elastic slip as a vector in
/// space, this is named.
#[test]
fn a_history_of_the_program_itself_agrees_unless_it_does_not_turn_with_the_beams() {
    let Some((program, folder)) = program() else { return };
    let folder = folder.join("steps");
    std::fs::create_dir_all(&folder).unwrap();
    for seed in [1, 2] {
        let cases = Cases::with_steps(seed, 6, &["hermite", "segment"], &folder);
        let with = |is: &dyn Fn(&serde_json::Value) -> bool| {
            let has_steps = |line: &&serde_json::Value| !line["element"]["steps"].is_null();
            cases.lines.iter().filter(has_steps).filter(|line| is(line)).count()
        };
        assert!(3 * with(&|_| true) >= cases.lines.len(), "{} cases have steps", with(&|_| true));
        for state in [State::Stick, State::Slip] {
            let is_in = |line: &serde_json::Value| line["expected"]["state"] == state.name();
            assert!(with(&is_in) >= 5, "{}: {}", state.name(), with(&is_in));
        }
        assert!(!is_red(&program, 0, &cases), "seed {seed}");
        assert!(is_red(&program, 451, &cases), "seed {seed}");
    }
    let cases = Cases::with_steps(1, EXPLAINED_CASES, &["hermite"], &folder);
    let told = cause(&program, 451, &cases);
    assert!(told.contains("tau_n stands in the place of tau"), "{told}");
}

/// A program without the tangent is not complete, and one in another state is wrong.
#[test]
fn a_part_that_is_left_out_is_not_green() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("element-parts");
    std::fs::create_dir_all(&folder).unwrap();
    let cases = Cases::with_elements(1, 2, &["segment"], &folder);
    let evaluated = run(&["evaluate", cases.path.to_str().unwrap()]);
    let text = String::from_utf8(evaluated.stdout).unwrap();
    let verified = |name: &str, change: &dyn Fn(&mut serde_json::Value)| {
        let path = folder.join(name);
        let changed = text.lines().map(|line| {
            let mut line: serde_json::Value = serde_json::from_str(line).unwrap();
            change(&mut line);
            line.to_string() + "\n"
        });
        std::fs::write(&path, changed.collect::<String>()).unwrap();
        let files = [&cases.path, &path].map(|path| path.to_str().unwrap());
        let output = run(&["verify", files[0], files[1]]);
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let (code, told) = verified("all", &|_| ());
    assert!(code == Some(0) && !told.contains("ever answered"), "{told}");
    let (code, told) = verified("no-tangent", &|line| {
        line.as_object_mut().unwrap().remove("tangent");
    });
    assert!(code == Some(4) && told.contains("INCOMPLETE: the tangent is never answered."), "{told}");
    let (code, told) = verified("columns", &|line| {
        if let Some(tangent) = line.get_mut("tangent").and_then(|tangent| tangent.as_array_mut()) {
            tangent.chunks_mut(12).for_each(|row| row.swap(6, 7));
        }
    });
    let cause = "Cause: the tangent has its columns in another order: at the dofs 6, 7 stand those of 7, 6.";
    let words = told.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(code == Some(1) && words.contains(cause), "{told}");
    for (key, wrong) in
        [("state", "frictionless".into()), ("F_N", 1.5.into()), ("F_bar", serde_json::json!(0.25))]
    {
        let (code, told) = verified(key, &|line| {
            if line.get(key).is_some() {
                line[key] = wrong.clone();
            }
        });
        assert_eq!(code, Some(1), "{key}: {told}");
        let name = if key == "state" { "the state" } else { key };
        assert!(told.contains(&format!("First wrong number: {name}, case ")), "{told}");
        let is_row = |line: &str| line.trim_start().starts_with("element") && line.contains(key);
        assert!(told.lines().any(is_row), "{told}");
        let words = told.split_whitespace().collect::<Vec<_>>().join(" ");
        let cause =
            format!("what is answered beside residual and tangent, which are right, is wrong: {key}.");
        assert!(words.contains(&cause), "{told}");
    }
}

/// Every state occurs, on both sides of the cone, and after crossing.
#[test]
fn exported_elements_are_in_every_state() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("element-states");
    std::fs::create_dir_all(&folder).unwrap();
    let cases = Cases::with_elements(1, CASES, &["hermite"], &folder);
    let count = |is: &dyn Fn(&serde_json::Value) -> bool| cases.lines.iter().filter(|line| is(line)).count();
    for state in State::ALL {
        let found = count(&|line| line["expected"]["state"] == state.name());
        assert!(found >= 2, "{}: {found}", state.name());
    }
    for (key, values) in [("law", ["linear", "lpqp", "augmented"].as_slice()), ("work", &["rate", "paper"])] {
        for value in values {
            assert!(count(&|line| line["element"][key] == *value) >= 5, "{value}");
        }
    }
    let number = |of: &serde_json::Value| of.as_f64().unwrap();
    let force = |line: &serde_json::Value| number(&line["expected"]["F_N"]);
    assert!(cases.lines.iter().all(|line| force(line) >= 0.0));
    assert!(count(&|line| number(&line["element"]["mu"]) == 0.0 && force(line) > 0.0) >= 1);
    let history = |line: &serde_json::Value| line["element"]["history"].clone();
    assert!(count(&|line| history(line)["slips"].is_null()) >= 1);
    assert!(count(&|line| history(line)["normal"].is_null()) >= 1);
    // A parameter that becomes held, and one that becomes free.
    let changes =
        |to: &str, from: &str| count(&|line| line["held"] == to && history(line)["slips"]["held"] == from);
    assert!(changes("xi", "none") + changes("xi_bar", "none") >= 1);
    assert!(changes("none", "xi") + changes("none", "xi_bar") >= 1);
}

/// The errors that are explained in every test run: of the law, of the slip vector, of a term, of the vector form, of shape
/// functions, one of them with a polynomial of its own, and of a condition, a side, a held parameter and precision.
const EXPLAINED: [u32; 13] = [401, 415, 431, 438, 444, 460, 461, 462, 463, 464, 465, 466, 467];

/// The causes of errors, against the table of them. With BEAMGAP_ELEMENTS=all every error is explained, and with
/// BEAMGAP_BLESS=1 the table is written.
#[test]
fn causes_of_errors_with_friction_are_named() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/elements/friction-causes.txt");
    let Some((program, folder)) = program() else { return };
    let cases = Cases::with_elements(1, EXPLAINED_CASES, &["hermite"], &folder);
    let is_full = std::env::var_os("BEAMGAP_ELEMENTS").is_some();
    let known = std::fs::read_to_string(&path).unwrap_or_default();
    let errors = table().into_iter().filter(|error| is_full || EXPLAINED.contains(error));
    let lines: Vec<_> = errors.map(|error| format!("{error} {}", cause(&program, error, &cases))).collect();
    if is_full && std::env::var_os("BEAMGAP_BLESS").is_some() {
        std::fs::write(path, lines.join("\n") + "\n").unwrap();
        return;
    }
    assert_eq!(known.lines().count(), table().len());
    for line in &lines {
        assert!(known.lines().any(|known| known == line), "not in the table: {line}");
    }
}
