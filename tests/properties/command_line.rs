//! The command line: its output, its exit codes, and that its output is reproducible.

use crate::program::{
    blind_json, blind_text, command, golden, has_no_message, json, message, run, shown_in_the_guides, stdout,
};
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};

const SMALL: [&str; 5] = ["check", "--cases", "11", "--family", "segment"];

fn small(more: &[&str]) -> Output {
    run(&[&SMALL, more].concat())
}

/// A file that only this test uses.
fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

#[test]
fn tables_are_the_golden_ones() {
    let text = stdout(&small(&[]));
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    golden("check.txt", &text, blind_text);
}

#[test]
fn the_document_is_the_golden_one() {
    golden("check.json", &stdout(&small(&["--format", "json"])), blind_json);
}

#[test]
fn one_case_is_the_golden_one() {
    // The numbers depend on the machine in their last digits, so only the words, the names and the order are compared.
    let words = |text: &str| {
        let number = |token: &&str| token.parse::<f64>().is_err();
        let lines =
            text.lines().map(|line| line.split_whitespace().filter(number).collect::<Vec<_>>().join(" "));
        lines.collect::<Vec<_>>().join("\n")
    };
    golden("case.txt", &stdout(&run(&["check", "--case", "17"])), words);
}

/// For a case with a fault, `--only-wrong` shows only the numbers that differ.
#[test]
fn one_case_fits_a_terminal_and_shows_what_differs() {
    let fault = ["--plant", "Dd|d|: d.turned = sign"];
    for number in ["6", "8", "10"] {
        let all = run(&[&["check", "--case", number], &fault[..]].concat());
        let wrong = run(&[&["check", "--case", number, "--only-wrong"], &fault[..]].concat());
        assert_eq!((all.status.code(), wrong.status.code()), (Some(1), Some(1)));
        let [all, wrong] = [all, wrong].map(|output| String::from_utf8(output.stdout).unwrap());
        assert!(all.lines().all(|line| line.chars().count() <= 80), "{all}");
        let rows = |text: &str, told: &str| text.lines().filter(|line| line.ends_with(told)).count();
        assert!(rows(&all, " WRONG") > 0 && rows(&all, " agrees") > 100, "{all}");
        assert_eq!((rows(&wrong, " WRONG"), rows(&wrong, " agrees")), (rows(&all, " WRONG"), 0));
    }
    assert_eq!(run(&["check", "--only-wrong"]).status.code(), Some(2));
}

/// A guide shows what a red check prints.
#[test]
fn an_injected_fault_is_answered_as_a_guide_shows() {
    let output = run(&["check", "--cases", "121", "--plant", "a: d.t,xi = dropped"]);
    assert_eq!(output.status.code(), Some(1));
    let command = "$ cargo run --release -- check --cases 121 --plant 'a: d.t,xi = dropped'";
    let text = String::from_utf8(output.stdout).unwrap();
    shown_in_the_guides(&text, command);
    // A screen, with the cause before the numbers. The command that repeats a case may be longer than a line.
    let fits = |line: &str| line.chars().count() <= 80 || line.contains(" check --seed ");
    assert!(text.lines().count() <= 40 && text.lines().all(fits), "{text}");
    let order =
        ["Likely cause: the", "look at the 2 x 2", "First mismatch", "--seed 0x5eed --case 99", "\n  xi "];
    assert!(order.map(|words| text.find(words).expect(words)).is_sorted(), "{text}");
    // The rest is there if it is asked for.
    let all = run(&["check", "--cases", "121", "--plant", "a: d.t,xi = dropped", "--all"]).stdout;
    let all = String::from_utf8(all).unwrap();
    for words in ["The case with this error", "Not compared\n", "and 978 more", "#[test]"] {
        assert!(all.contains(words) && !text.contains(words), "{words:?}: {all}");
    }
    assert!(all.contains("Likely cause: the term"), "{all}");
}

#[test]
fn the_help_fits_a_terminal_and_lists_the_exit_codes() {
    for arguments in [&["--help"][..], &["check", "--help"], &["prove", "--help"]] {
        let help = stdout(&run(arguments));
        assert!(help.lines().all(|line| line.chars().count() <= 80), "{help}");
        for code in [
            "  0  all",
            "  1  some",
            "  2  wrong",
            "  3  bad",
            "  4  nothing",
            "  5  the",
            " 70  an internal",
        ] {
            assert!(help.contains(code), "{code:?} is missing in {help}");
        }
    }
}

#[test]
fn bad_input_is_one_line_and_a_code() {
    let families = "segment, quadratic, cubic, hermite, hermite-scaled, bezier, bspline, nurbs, nurbs-weighted, \
                    arc, helix";
    let family =
        format!("invalid value 'beam' for '--family <FAMILY>' [possible values: {families}] (see --help)");
    let seed = "expected a decimal or 0x-hexadecimal number below 2^64 (see --help)";
    let bad_seed = |seed_given: &str| format!("invalid value '{seed_given}' for '--seed <SEED>': {seed}");
    let told = [
        (&["check", "--family", "beam"][..], 2, family.as_str()),
        (
            &["check", "--cases", "0"],
            2,
            "invalid value '0' for '--cases <N>': 0 is not in 1..=1000000 (see --help)",
        ),
        (&["check", "--seed", "soon"], 2, &bad_seed("soon")),
        (&["check", "--seed", "-1"], 2, &bad_seed("-1")),
        (
            &["verify", "vectors", "answers", "--digits", "-1"],
            2,
            "invalid value '-1' for '--digits <N>': -1 is not in 1..=15 (see --help)",
        ),
        (
            &["explain", "vectors", "answers", "--threads", "-1"],
            2,
            "invalid value '-1' for '--threads <N>': -1 is not in 1..=1024 (see --help)",
        ),
        (
            &["evaluate", "--penalty", "-1e3"],
            2,
            "invalid value '-1e3' for '--penalty <STIFFNESS>': expected a positive number (see --help)",
        ),
        (
            &["check", "--time-budget", "-5s"],
            2,
            "invalid value '-5s' for '--time-budget <TIME>': a time expected, such as 30s, 5m or 1h (see --help)",
        ),
        (
            &["check", "--shard", "-1/2"],
            2,
            "invalid value '-1/2' for '--shard <I/N>': i/n expected, with i from 1 to n (see --help)",
        ),
        (
            &["verify", "vectors", "answers", "--reason", "few digits are printed"],
            2,
            "--digits expected: a reason is that of the digits, which are not given (see --help)",
        ),
        (&["check", "--seed", "0x10000000000000000"], 2, &bad_seed("0x10000000000000000")),
        (&["check", "--seed", "0x+1"], 2, &bad_seed("0x+1")),
        (
            &["check", "--famly", "arc"],
            2,
            "unexpected argument '--famly' found, tip: a similar argument exists: '--family' (see --help)",
        ),
        (
            &["check", "--case", "1", "--cases", "2"],
            2,
            "the argument '--case <N>' cannot be used with '--cases <N>' (see --help)",
        ),
        (
            &["check", "--threads", "0"],
            2,
            "invalid value '0' for '--threads <N>': 0 is not in 1..=1024 (see --help)",
        ),
        (
            &["prove", "--draws", "0"],
            2,
            "invalid value '0' for '--draws <N>': 0 is not in 1..=1000000 (see --help)",
        ),
        (
            &["prove", "--format", "xml"],
            2,
            "invalid value 'xml' for '--format <FORMAT>' [possible values: human, json, junit, sarif, github, markdown] (see --help)",
        ),
        (
            // The path must be checked before the work, which takes hours.
            &["check", "--cases", "1000000", "--output", "/nowhere/at/all"],
            3,
            "cannot write /nowhere/at/all: No such file or directory (os error 2)",
        ),
    ];
    for (arguments, code, line) in told {
        let output = run(arguments);
        assert_eq!(message(&output), format!("error: {line}\n"), "{arguments:?}");
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
    let none = run(&[]);
    let line = message(&none);
    assert!(
        line.starts_with("error: 'beamgap' requires a subcommand") && line.lines().count() == 1,
        "{line}"
    );
    assert_eq!(none.status.code(), Some(2));
}

#[test]
fn a_closed_pipe_is_no_error() {
    for more in [&[][..], &["--format", "json"]] {
        let mut child =
            command(&[&SMALL, more].concat()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success() && has_no_message(&output), "{output:?}");
    }
}

/// The JSON document contains every number, and the tables are made from the same numbers.
#[test]
fn threads_do_not_matter() {
    for work in [&["check", "--cases", "33"][..], &["prove", "--draws", "2"]] {
        let asked = [work, &["--format", "json"]].concat();
        let document = |output: Output| {
            assert!(output.status.success(), "{output:?}");
            output.stdout
        };
        let one = document(command(&asked).env("RAYON_NUM_THREADS", "1").output().unwrap());
        for threads in ["2", "5"] {
            let several = document(run(&[&asked[..], &["--threads", threads]].concat()));
            assert!(one == several, "{asked:?} with {threads} threads");
        }
    }
}

#[test]
fn the_file_holds_what_standard_output_would() {
    let path = scratch("check.txt");
    // The old text is longer than the document, and none of it may remain.
    std::fs::write(&path, "old\n".repeat(10_000)).unwrap();
    let verdict = stdout(&small(&["--output", path.to_str().unwrap()]));
    let document = stdout(&small(&[]));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), document);
    assert!(verdict.starts_with("AGREE") && document.ends_with(&verdict), "{verdict}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_loses_nothing() {
    let output = small(&["--output", "/dev/full"]);
    assert_eq!(output.status.code(), Some(3));
    assert_eq!(output.stdout, small(&[]).stdout);
    let told = message(&output);
    let line = told.lines().last().unwrap_or_default();
    assert!(line.starts_with("error: cannot write /dev/full, wrote to standard output instead"), "{line}");
}

#[test]
fn seeds_are_decimal_or_hexadecimal() {
    assert_eq!(small(&["--seed", "24301"]), small(&["--seed", "0x5EED"]));
    assert_eq!(small(&[]), small(&["--seed", "0x5eed"]));
    assert_ne!(small(&[]).stdout, small(&["--seed", "1"]).stdout);
}

#[test]
fn a_regime_is_counted_once_however_often_it_is_named() {
    let twice = small(&["--regime", "near-end", "--regime", "near-end", "--format", "json"]);
    let document = json(&twice);
    assert_eq!(document["selection"]["regimes"], serde_json::json!(["near-end"]));
    assert_eq!(document["found"]["regimes"]["near-end"]["cases"], 11);
}

#[test]
fn a_case_that_is_repeated_shows_the_error_of_the_run() {
    let cell = json(&small(&["--format", "json"]))["found"]["quantities"]["x"]["value"].clone();
    let case = json(&run(&["check", "--case", &cell["case"].to_string(), "--format", "json"]));
    let points = case["closest_points"].as_array().unwrap();
    let errors = points.iter().flat_map(|point| point["entries"].as_array().unwrap()).filter_map(|entry| {
        let same = entry["quantity"] == "x" && entry["order"] == "value";
        same.then(|| entry["difference"].as_f64().unwrap() / entry["scale"].as_f64().unwrap())
    });
    assert_eq!(Some(errors.fold(0.0, f64::max)), cell["scaled_error"].as_f64());
}

#[test]
fn nothing_compared_is_no_success() {
    let mut nothing = 0;
    for (seed, number) in [("7", "518"), ("9", "30513"), ("0x5eed", "247")] {
        let output = run(&["check", "--seed", seed, "--case", number, "--format", "json"]);
        let case = json(&output);
        let mut points = case["closest_points"].as_array().unwrap().iter();
        let none = points.all(|point| point["verdict"] == "not-compared");
        assert_eq!(output.status.code(), Some(if none { 4 } else { 0 }), "case {number}");
        assert_eq!(case["verdict"], if none { "nothing-compared" } else { "agree" });
        nothing += u32::from(none);
    }
    assert!(nothing > 0, "no case of these is without a comparison");
}

#[test]
fn the_largest_numbers_are_taken() {
    let largest = u64::MAX.to_string();
    let output = run(&["check", "--seed", &largest, "--case", &largest]);
    assert!(matches!(output.status.code(), Some(0 | 4)) && output.stderr.is_empty(), "{output:?}");
}
