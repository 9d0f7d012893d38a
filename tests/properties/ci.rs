//! Results for continuous integration: shards of a run, and formats.
//!
//! A missing tool is skipped. If BEAMGAP_ADAPTERS is set, a missing tool is an error.

use crate::program::{command, golden, has_no_message, json, message, run, stdout};
use crate::schemas::is_valid;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const FAULT: [&str; 2] = ["--plant", "Dd|d|: d.turned = sign"];
const FORMATS: [&str; 6] = ["human", "json", "junit", "sarif", "github", "markdown"];

pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("ci-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Runs in a folder and writes the output in all formats; each file has the name of its format.
fn in_all_formats(folder: &Path, arguments: &[&str]) -> Output {
    let outputs: Vec<String> = FORMATS.map(|format| format!("--output={format}={format}")).to_vec();
    let outputs: Vec<&str> = outputs.iter().map(String::as_str).collect();
    command(&[arguments, &outputs].concat()).current_dir(folder).output().unwrap()
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// The merged shards of a run equal the run to the last byte, in every format.
#[test]
fn a_merged_run_is_the_run() {
    let selections: [&[&str]; 2] = [
        &["check", "--cases", "6", "--oracle", "all"],
        &[
            "check", "--cases", "30", "--family", "hermite", "--regime", "generic", "--regime", "metres",
            FAULT[0], FAULT[1],
        ],
    ];
    for selection in selections {
        let whole = folder("whole");
        let status = in_all_formats(&whole, selection).status.code();
        for partition in [&["2/2", "1/2"][..], &["4/4", "1/2", "2/4"], &["1/5", "2/5", "3/5", "4/5", "5/5"]] {
            let parts = folder("parts");
            let mut names = Vec::new();
            for (i, shard) in partition.iter().enumerate() {
                names.push(format!("{i}.json"));
                let output = format!("--output=json={i}.json");
                let part = [selection, &["--shard", shard, &output]].concat();
                assert!(has_no_message(&command(&part).current_dir(&parts).output().unwrap()));
            }
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            let merged = in_all_formats(&parts, &[&["merge"][..], &names].concat());
            assert_eq!((merged.status.code(), has_no_message(&merged)), (status, true), "{merged:?}");
            // The title is shown before the mismatches are shrunk.
            assert!(merged.stderr.starts_with(b"Contact geometry of two beams"), "{merged:?}");
            for format in FORMATS {
                assert!(read(&whole, format) == read(&parts, format), "{selection:?} {partition:?} {format}");
            }
        }
    }
}

#[test]
fn what_is_no_run_is_not_merged() {
    let folder = folder("no-run");
    let part = |name: &str, more: &[&str]| {
        let output = format!("json={name}.json");
        let small = ["check", "--cases", "2", "--family", "segment", "--output", &output];
        let output = command(&[&small[..], more].concat()).current_dir(&folder).output().unwrap();
        assert!(output.status.success(), "{output:?}");
    };
    part("first", &["--shard", "1/2"]);
    part("second", &["--shard", "2/2"]);
    part("fourth", &["--shard", "2/4"]);
    part("quarter", &["--shard", "1/4"]);
    part("seed", &["--shard", "2/2", "--seed", "7"]);
    part("regime", &["--shard", "2/2", "--regime", "metres"]);
    fs::write(folder.join("broken.json"), "{").unwrap();
    for (parts, told) in [
        (&["first.json"][..], "error: shard 2/2 is missing: the others have 10 of 20 cases\n"),
        (&["first.json", "fourth.json"], "error: shard 4/4 is missing: the others have 16 of 20 cases\n"),
        (&["quarter.json"], "error: shards 2/4, 3/4 and 4/4 are missing: the others have 5 of 20 cases\n"),
        (
            &["second.json", "fourth.json"],
            "error: fourth.json: shard 2/4 has cases of shard 2/2 of second.json\n",
        ),
        (
            &["first.json", "first.json"],
            "error: first.json: shard 1/2 has cases of shard 1/2 of first.json\n",
        ),
        (&["first.json", "seed.json"], "error: seed.json: seed differs from that of first.json\n"),
        (&["first.json", "regime.json"], "error: regime.json: selection differs from that of first.json\n"),
        (
            &["first.json", "none.json"],
            "error: cannot read none.json: No such file or directory (os error 2)\n",
        ),
        (
            &["broken.json"],
            "error: broken.json is not a result of `check --format json`: EOF while parsing an object at line 1 column 1\n",
        ),
    ] {
        let output = command(&[&["merge"][..], parts].concat()).current_dir(&folder).output().unwrap();
        assert_eq!(message(&output), told);
        assert_eq!((output.status.code(), output.stdout.is_empty()), (Some(3), true), "{parts:?}");
    }
}

#[test]
fn what_a_time_budget_leaves_out_is_said() {
    let output = run(&["check", "--time-budget", "0s"]);
    assert_eq!(output.status.code(), Some(4));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.ends_with("\nNot reached in time: 100000 of 100000 cases.\n"), "{text}");
    let some = run(&["check", "--cases", "20000", "--time-budget", "1s", "--format", "json"]);
    let document = json(&some);
    let reached: u64 = document["found"]["regimes"]
        .as_object()
        .unwrap()
        .values()
        .map(|tally| tally["cases"].as_u64().unwrap())
        .sum();
    assert_eq!((some.status.code(), &document["verdict"]), (Some(0), &"agree".into()));
    assert!(reached > 0 && document["not_reached"] == 200_000 - reached, "{reached}");
    assert_eq!(run(&["check", "--time-budget", "soon"]).status.code(), Some(2));
}

/// Validates the log against the schema of OASIS.
fn is_sarif(text: &str) {
    let schema: Value = serde_json::from_str(include_str!("../schemas/sarif-2.1.0.json")).unwrap();
    is_valid(&serde_json::from_str(text).unwrap(), &schema, &schema).unwrap();
}

/// Validates the suite against the schema of Jenkins' xUnit plugin.
fn is_junit(path: &Path) {
    let schema = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/schemas/junit-10.xsd");
    let validated = Command::new("xmllint").arg("--noout").arg("--schema").arg(schema).arg(path).output();
    match validated {
        Ok(output) => assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr)),
        Err(error) => assert!(std::env::var_os("BEAMGAP_ADAPTERS").is_none(), "xmllint: {error}"),
    }
}

#[test]
fn every_format_is_of_its_schema() {
    let small = ["--cases", "11", "--family", "hermite", "--regime", "generic"];
    for (arguments, code) in [
        ([&["check"][..], &small].concat(), 0),
        ([&["check"][..], &small, &FAULT].concat(), 1),
        (vec!["check", "--seed", "7", "--case", "518"], 4),
        ([&["prove", "--draws", "4", "--family", "hermite"][..], &FAULT].concat(), 1),
    ] {
        let folder = folder("schema");
        let output = in_all_formats(&folder, &arguments);
        assert_eq!(output.status.code(), Some(code), "{arguments:?} {output:?}");
        is_sarif(&read(&folder, "sarif"));
        is_junit(&folder.join("junit"));
        let log: Value = serde_json::from_str(&read(&folder, "sarif")).unwrap();
        let results = log["runs"][0]["results"].as_array().unwrap().len();
        let annotations = read(&folder, "github").matches("::error ").count();
        assert_eq!((results > 0, annotations > 0), (code != 0, code != 0), "{arguments:?}");
        assert_eq!(read(&folder, "junit").contains("<failure "), code != 0);
        assert!(read(&folder, "markdown").starts_with(if code == 0 { "## ✅" } else { "## ❌" }));
        assert!(read(&folder, "human").contains(&*String::from_utf8(output.stdout).unwrap()));
    }
    // The schema must reject an invalid log.
    let schema: Value = serde_json::from_str(include_str!("../schemas/sarif-2.1.0.json")).unwrap();
    let wrong =
        serde_json::json!({ "version": "2.1.0", "runs": [{ "tool": { "driver": { "title": "beamgap" } } }] });
    is_valid(&wrong, &schema, &schema).unwrap_err();
}

#[test]
fn wrong_answers_are_shown_at_their_line() {
    let folder = folder("answers");
    let in_folder = |arguments: &[&str]| command(arguments).current_dir(&folder).output().unwrap();
    let export =
        ["export", "--family", "segment", "--cases", "4", "--expected", "none", "-o", "vectors.jsonl"];
    assert!(in_folder(&export).status.success());
    let evaluate = ["evaluate", "vectors.jsonl", "--plant", FAULT[1], "-o", "answers.jsonl"];
    assert!(in_folder(&evaluate).status.success());
    let output = in_all_formats(&folder, &["verify", "vectors.jsonl", "answers.jsonl", "--no-explanation"]);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    is_sarif(&read(&folder, "sarif"));
    is_junit(&folder.join("junit"));
    let log: Value = serde_json::from_str(&read(&folder, "sarif")).unwrap();
    let of_d = log["runs"][0]["results"].as_array().unwrap().iter();
    let of_d: Vec<_> =
        of_d.filter(|result| result["message"]["text"].as_str().unwrap().starts_with("d (second)")).collect();
    let location = &of_d[0]["locations"][0]["physicalLocation"];
    assert_eq!((of_d.len(), &location["artifactLocation"]["uri"]), (1, &"answers.jsonl".into()));
    // The line is that of the case in the message.
    let line = location["region"]["startLine"].as_u64().unwrap();
    let text = of_d[0]["message"]["text"].as_str().unwrap();
    let case = text.split_once("; case ").unwrap().1.split_once(':').unwrap().0;
    let answers = fs::read_to_string(folder.join("answers.jsonl")).unwrap();
    let at = answers.lines().nth(usize::try_from(line).unwrap() - 1).unwrap();
    assert_eq!(serde_json::from_str::<Value>(at).unwrap()["id"], case);
    let told = format!("::error file=answers.jsonl,line={line},title=beamgap verify%3A d (second)::");
    assert!(read(&folder, "github").contains(&told), "{}", read(&folder, "github"));
    assert!(read(&folder, "junit").contains(&format!("\nanswers.jsonl:{line}</failure>")));
}

/// A proof is used, because it has no rounding. The line numbers of the source are not compared.
#[test]
fn formats_are_the_golden_ones() {
    let folder = folder("golden");
    let arguments = ["prove", "--draws", "4", "--family", "segment", "--family", "arc"];
    assert_eq!(in_all_formats(&folder, &[&arguments[..], &FAULT].concat()).status.code(), Some(1));
    let without = |text: String, before: &str| {
        let digits = |part: &str| part.trim_start_matches(|c: char| c.is_ascii_digit()).to_owned();
        let mut parts = text.split(before);
        let first = parts.next().unwrap_or_default().to_owned();
        std::iter::once(first).chain(parts.map(digits)).collect::<Vec<_>>().join(before)
    };
    let blind = |text: &str| [".rs:", "line=", "startLine\": "].into_iter().fold(text.to_owned(), without);
    for (format, name) in [
        ("junit", "prove.xml"),
        ("sarif", "prove.sarif"),
        ("github", "prove.github"),
        ("markdown", "prove.md"),
    ] {
        golden(name, &read(&folder, format), blind);
    }
}

/// The job of the README is the one that is ready to be copied, and what it writes is kept.
#[test]
fn the_example_of_a_job_runs_the_commands_of_the_readme() {
    let file = |name: &str| fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap();
    let (readme, job) = (file("README.md"), file("examples/ci/github.yml"));
    let (_, section) = readme.split_once("\n## Put it into CI\n").unwrap();
    let block = section.split("```").nth(1).unwrap();
    let commands: Vec<&str> = block.lines().filter_map(|line| line.strip_prefix("$ ")).collect();
    assert_eq!(commands.len(), 3, "{block}");
    for command in commands {
        assert!(job.contains(&format!("- run: {command}\n")), "{command} is missing in the job");
        for (_, path) in command.split(" --output ").skip(1).filter_map(|output| output.split_once('=')) {
            assert!(job.contains(&format!(": {path}\n")), "{path} is not kept");
        }
    }
}

#[test]
fn the_summary_of_a_step_is_appended() {
    let folder = folder("step");
    fs::write(folder.join("summary.md"), "before\n").unwrap();
    let small = ["check", "--cases", "1", "--family", "segment"];
    let mut summarized = command(&small);
    summarized.env("GITHUB_STEP_SUMMARY", folder.join("summary.md"));
    let text = stdout(&summarized.output().unwrap());
    assert_eq!(text, stdout(&run(&small)));
    let markdown = stdout(&run(&[&small[..], &["--format", "markdown"]].concat()));
    assert_eq!(read(&folder, "summary.md"), format!("before\n{markdown}"));
    let mut nowhere = command(&small);
    let output = nowhere.env("GITHUB_STEP_SUMMARY", "/nowhere/at/all").output().unwrap();
    assert!(output.status.success() && output.stderr.starts_with(b"warning: cannot write the step summary "));
}
