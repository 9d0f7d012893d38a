//! Programs that answer while they run, and results for other programs.

use super::{drawing, vectors};
use crate::program::{command, json, message, run};
use beamgap::check::external::VectorWriter;
use beamgap::check::{Family, Regime};
use std::fmt::Write as _;
use std::io::Write;
use std::path::PathBuf;
use std::process::Stdio;

pub(super) fn scratch(name: &str, text: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).unwrap();
    path
}

pub(super) fn exported(name: &str, more: &[&str]) -> PathBuf {
    let path = scratch(name, "");
    let output = run(&[&["export", "-o", path.to_str().unwrap()], more].concat());
    assert!(output.status.success(), "{output:?}");
    path
}

#[test]
fn a_program_is_run_and_its_exit_status_time_and_words_are_told() {
    let path = exported("run.jsonl", &["--family", "segment", "--cases", "3", "--expected", "none"]);
    let vectors = path.to_str().unwrap();
    let own = format!("'{}' evaluate", env!("CARGO_BIN_EXE_beamgap"));
    let verify = |program: &str| {
        let output = run(&["verify", vectors, "--run", program]);
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        (output.status.code(), text, message(&output))
    };
    let (code, text, _) = verify(&own);
    assert!(code == Some(0) && text.contains("AGREE: at "), "{text}");
    let (code, text, _) = verify(&format!("{own} --plant 'b: t.t_bar = halved'"));
    assert!(
        code == Some(1) && text.contains("Cause: the term t.t_bar of b, eq. (50), counts half"),
        "{text}"
    );
    assert!(text.contains("`b: t.t_bar = halved`") && text.contains("First wrong number: entry ["), "{text}");
    for (program, expected) in [
        (
            "sh -c 'echo broken >&2; exit 7'",
            "exit status: 7, after 0 answers\nIts standard error ends:\nbroken",
        ),
        ("sh -c 'echo no; cat >/dev/null'", "standard output of sh:1:1: the titles `case,quantity,value`"),
        // The program ends by SIGPIPE, because its answers are no longer read.
        ("yes", "standard output of yes:1:1: the titles `case,quantity,value`"),
        ("/no/such/program", "cannot start /no/such/program"),
        ("sh -c 'exit", "a program, with its arguments, expected"),
        ("true", "true: no output; a program must read the cases on standard input"),
    ] {
        let (code, _, told) = verify(program);
        assert!(code == Some(3) && told.contains(expected), "{program}: {told}");
    }
}

/// The first fault in time is the message; what follows from it is not.
#[test]
fn the_first_fault_is_the_message() {
    let path = exported("first.jsonl", &["--family", "segment", "--cases", "3"]);
    let vectors = path.to_str().unwrap();
    let right = scratch("first-right.jsonl", "");
    let right = right.to_str().unwrap();
    assert!(run(&["evaluate", vectors, "-o", right]).status.success());
    // The program reads its input, answers five cases, prints this, goes on, and fails in the end.
    let program = |name: &str, line: &str, end: &str| {
        let text = format!("sed -n 1,6p '{right}'\n{line}\nsed 1,6d '{right}'\n{end}\n");
        format!("sh '{}'", scratch(&format!("first-{name}.sh"), &text).display())
    };
    let fails = "sleep 2\necho BrokenPipeError >&2\nexit 1";
    let unknown = "echo '{\"id\":\"abc\",\"d\":1}'";
    let of_cases = format!("7: the id of a case of {vectors} expected, found \"abc\"");
    for (name, line, expected) in [
        ("banner", "echo 'Newton 3 iterations'", "7:1: a number expected, found \"Newton\""),
        ("stars", "echo '{\"id\":\"5\",\"d\":****}'", "7:15: a number expected, found asterisks"),
        ("key", "echo '{\"id\":\"5\",\"distance\":1}'", "7:22: one of x, x_bar,"),
        ("cut", "echo '{\"id\":\"5\",\"d\":{\"va'", "7:16: a closing quote expected, found none"),
        ("unknown", unknown, of_cases.as_str()),
    ] {
        let start = std::time::Instant::now();
        let output = run(&["verify", vectors, "--run", &program(name, line, fails)]);
        let told = message(&output);
        assert_eq!(output.status.code(), Some(3), "{told}");
        assert!(told.contains(expected), "{name}: {told}");
        assert!(!told.contains("exit status") && !told.contains("BrokenPipe"), "{name}: {told}");
        assert!(start.elapsed().as_secs() < 20, "{name}");
    }
    // A last line that is cut off follows from the end of the program.
    let text = format!("sed -n 1,6p '{right}'\nprintf '{{\"id\":\"5\",\"d\":{{\"va'\necho why >&2\nexit 3\n");
    let program = format!("sh '{}'", scratch("first-end.sh", &text).display());
    let told = message(&run(&["verify", vectors, "--run", &program]));
    assert!(told.contains("exit status: 3, after 5 answers\nIts standard error ends:\nwhy"), "{told}");
}

/// A program that does not answer in time is told what it did with its input.
#[test]
fn a_time_out_says_what_the_program_did_with_its_input() {
    let [few, many] = [1, 4].map(|cases: u32| {
        let (name, cases) = (format!("late-{cases}.jsonl"), cases.to_string());
        let more = ["--family", "segment", "--regime", "generic", "--cases", &cases, "--expected", "all"];
        exported(&name, &more)
    });
    assert!(std::fs::metadata(&few).unwrap().len() < 1 << 16, "the first pipe is not full");
    assert!(std::fs::metadata(&many).unwrap().len() > 1 << 17, "the second pipe is full");
    let head = scratch("late-head.jsonl", "{\"schema\":\"beamgap-answers/1\"}\n");
    let head = format!("cat {}", head.display());
    let flush =
        "a program must write each answer out (flush): it is sent at most 2 cases ahead of its answers";
    let late = [
        (&few, "sleep 30".to_owned(), "all cases are on its standard input, which is closed"),
        (&many, "sleep 30".to_owned(), "it does not read its standard input"),
        (&many, format!("sh -c '{head}; exec sleep 30'"), "it does not read its standard input"),
        (&many, format!("sh -c '{head}; exec sleep 30 <&-'"), "it has closed its standard input"),
        (&many, format!("sh -c '{head}; cat >/dev/null; exec sleep 30'"), flush),
    ];
    let is_late = |(vectors, program, told): (&PathBuf, String, &str)| {
        let arguments =
            ["verify", vectors.to_str().unwrap(), "--run", &program, "--time-out", "1", "--look-ahead", "2"];
        let output = run(&arguments);
        let found = message(&output);
        assert_eq!(output.status.code(), Some(3), "{found}");
        assert!(
            found.contains(": no answer within 1 s, after 0 answers; ") && found.contains(told),
            "{found}"
        );
    };
    // All wait at the same time.
    std::thread::scope(|scope| {
        for each in late {
            scope.spawn(|| is_late(each));
        }
        let program = format!("sh -c '{head}; exec >&-; exec sleep 30'");
        let output = run(&["verify", few.to_str().unwrap(), "--run", &program]);
        let told = "sh: still running 5 s after the end of its answers; a program must end then";
        assert!(message(&output).contains(told), "{output:?}");
    });
}

#[test]
fn results_are_written_for_programs_too() {
    let path = exported("json.jsonl", &["--family", "hermite", "--cases", "2", "--expected", "all"]);
    let answers = scratch("json-answers.jsonl", "");
    let (vectors, answered) = (path.to_str().unwrap(), answers.to_str().unwrap());
    let output = run(&["evaluate", vectors, "--plant", "a: t.t = doubled", "-o", answered]);
    assert!(output.status.success(), "{output:?}");
    let output = run(&["verify", vectors, answered, "--format", "json"]);
    let document = json(&output);
    assert_eq!((output.status.code(), &document["verdict"]), (Some(1), &"disagree".into()));
    assert_eq!(document["schema"], "beamgap-verify/2");
    assert_eq!(document["explanation"]["causes"][0]["name"], "a: t.t = doubled");
    assert!(
        document["first"]["place"]["line"].as_u64().unwrap() >= 2
            && document["first"]["entry"]["of"] == "gradient"
    );
    // What is read back has all results.
    let read: beamgap::report::VerifyRun = serde_json::from_value(document.clone()).unwrap();
    let again = serde_json::to_value(&read.report).unwrap();
    let again = again.as_object().unwrap();
    assert!(read.report.wrong > 0 && again.contains_key("parts") && again.contains_key("regimes"));
    assert!(again.iter().all(|(key, value)| document[key] == *value), "{document}");
    // The expected answers are accepted as answers.
    let text = std::fs::read_to_string(&path).unwrap();
    let mut expected = "{\"schema\":\"beamgap-answers/1\"}\n".to_owned();
    for line in text.lines().skip(1) {
        let line: serde_json::Value = serde_json::from_str(line).unwrap();
        let mut answer = line["expected"].clone();
        if answer.is_object() {
            answer["id"] = line["id"].clone();
            let _ = writeln!(expected, "{answer}");
        }
    }
    let expected = scratch("json-expected.jsonl", &expected);
    let output = run(&["verify", vectors, expected.to_str().unwrap(), "--format", "json"]);
    assert_eq!(json(&output)["verdict"], "agree", "{output:?}");
    // A result in which nothing is compared is not a success.
    let none = scratch("json-none.jsonl", "{\"schema\":\"beamgap-answers/1\"}\n");
    let output = run(&["verify", vectors, none.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(4), "{output:?}");
}

#[test]
fn a_closed_pipe_is_no_error() {
    let mut child = command(&["evaluate"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let all = drawing(&[Family::Segment], &[Regime::Generic], 30);
    let writer = VectorWriter::default();
    let mut stdin = child.stdin.take().unwrap();
    let _ = writeln!(stdin, "{}", writer.head(&all));
    for vector in vectors(&all) {
        let _ = writeln!(stdin, "{}", writer.line(&vector));
    }
    drop(stdin);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
}
