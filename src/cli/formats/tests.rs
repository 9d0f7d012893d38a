//! Every format reports the same, for a result that agrees, one that differs and one in which nothing was compared.

use super::{github, junit, markdown, sarif};
use crate::cli::exit::Exit;
use crate::cli::outcome::{Entry, Outcome, Source, State, Verdict};

fn entry(name: &str, state: State, source: Option<Source>) -> Entry {
    let message = format!("of {name}: 1 < 2, 50 %");
    Entry { group: "second".into(), name: name.into(), state, message, source }
}

fn outcome(exit: Exit, entries: Vec<Entry>) -> Outcome {
    let words = "VERDICT: first line.\nSecond line: a, b.".to_owned();
    Outcome { command: "check", verdict: Verdict::new(exit, "name", words), entries }
}

fn agreeing() -> Outcome {
    outcome(Exit::Agree, vec![entry("d", State::Agrees, None), entry("t", State::NotCompared, None)])
}

fn differing() -> Outcome {
    let source = Some(Source { file: "a b,c.jsonl".into(), line: 7 });
    let entries = vec![
        entry("d", State::Differs, source),
        entry("t", State::Agrees, None),
        entry("xi", State::Differs, None),
    ];
    outcome(Exit::Disagree, entries)
}

#[test]
fn junit_has_a_test_case_for_the_verdict_and_for_each_entry() {
    let agreeing = junit(&agreeing());
    assert!(agreeing.contains("tests=\"3\" failures=\"0\" errors=\"0\" skipped=\"1\""), "{agreeing}");
    let differing = junit(&differing());
    assert!(differing.contains("tests=\"4\" failures=\"3\" errors=\"0\" skipped=\"0\""), "{differing}");
    assert!(
        differing.contains("message=\"of d: 1 &lt; 2, 50 %\">of d: 1 &lt; 2, 50 %\na b,c.jsonl:7</failure>")
    );
    let nothing = junit(&outcome(Exit::Nothing, Vec::new()));
    assert!(nothing.contains("tests=\"1\" failures=\"1\""), "{nothing}");
}

#[test]
fn sarif_has_a_result_for_what_differs() {
    let log =
        |outcome: &Outcome| -> serde_json::Value { serde_json::from_str(&sarif(outcome).unwrap()).unwrap() };
    assert_eq!(log(&agreeing())["runs"][0]["results"], serde_json::json!([]));
    let differing = log(&differing());
    let results = differing["runs"][0]["results"].as_array().unwrap();
    assert_eq!(results.len(), 2);
    let location = &results[0]["locations"][0]["physicalLocation"];
    assert_eq!(location["artifactLocation"]["uri"], "a%20b%2Cc.jsonl");
    assert_eq!(location["region"]["startLine"], 7);
    assert_eq!(differing["runs"][0]["tool"]["driver"]["rules"].as_array().unwrap().len(), 1);
    let nothing = log(&outcome(Exit::Nothing, Vec::new()));
    assert_eq!(nothing["runs"][0]["results"].as_array().unwrap().len(), 1);
    assert_eq!(nothing["runs"][0]["invocations"][0]["exitCode"], 4);
}

#[test]
fn github_annotates_what_differs_and_the_verdict() {
    let expected = "::notice title=beamgap check::VERDICT: first line.%0ASecond line: a, b.\n";
    assert_eq!(github(&agreeing()), expected);
    let differing = github(&differing());
    let first = "::error file=a b%2Cc.jsonl,line=7,title=beamgap check%3A d (second)::of d: 1 < 2, 50 %25\n";
    assert!(differing.starts_with(first), "{differing}");
    assert_eq!((differing.matches("::error ").count(), differing.lines().count()), (3, 3));
    assert_eq!(github(&outcome(Exit::Nothing, Vec::new())).matches("::error ").count(), 1);
}

#[test]
fn markdown_shows_what_differs_and_folds_the_rest() {
    let differing = markdown(&differing());
    assert!(differing.starts_with("## ❌ beamgap check\n\nVERDICT: first line.  \n"), "{differing}");
    assert_eq!(differing.matches("| d | second | differs | of d: 1 &lt; 2, 50 % |").count(), 2);
    assert_eq!(differing.matches("| t | second | agrees |").count(), 1);
    assert!(differing.contains("<details><summary>All 3 entries</summary>"));
    assert!(markdown(&agreeing()).starts_with("## ✅ beamgap check\n"));
}
