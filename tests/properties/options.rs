//! Options from flags, from the environment and from a file; colours; shell completions and manual pages.

use crate::ci::folder;
use crate::program::{command, has_no_message, json, message, run, stdout};
use std::fs;

#[test]
fn flags_win_over_the_environment_and_it_over_the_file() {
    let folder = folder("config");
    let cases = |arguments: &[&str], environment: &[(&str, &str)]| {
        let small = [&["check", "--family", "segment", "--format", "json"], arguments].concat();
        let output = command(&small).envs(environment.iter().copied()).current_dir(&folder).output().unwrap();
        (output.status.code(), message(&output), output)
    };
    let count = |arguments: &[&str], environment: &[(&str, &str)]| {
        let (code, error, output) = cases(arguments, environment);
        assert!(code == Some(0) && has_no_message(&output), "{error}");
        json(&output)["selection"]["cases"].as_u64().unwrap()
    };
    fs::write(folder.join("beamgap.toml"), "[check]\ncases = 3\nregime = [\"metres\"]\n").unwrap();
    fs::write(folder.join("other.toml"), "[check]\ncases = 4\n").unwrap();
    assert_eq!(count(&[], &[]), 3);
    assert_eq!(count(&["--config", "other.toml"], &[]), 4);
    assert_eq!(count(&[], &[("BEAMGAP_CONFIG", "other.toml")]), 4);
    assert_eq!(count(&[], &[("BEAMGAP_CHECK_CASES", "2")]), 2);
    assert_eq!(count(&["--cases", "1"], &[("BEAMGAP_CHECK_CASES", "2")]), 1);
    for (text, told) in [
        ("[check]\ncsaes = 3", "error: beamgap.toml:2:1: check: no key `csaes`, the nearest is `cases`\n"),
        (
            "[check]\ncases = 0",
            "error: beamgap.toml:2:9: check.cases: invalid value '0' for '--cases <N>': 0 is not in 1..=1000000 (see --help)\n",
        ),
        ("[check", "error: beamgap.toml:1:"),
        (
            "[check]\nplant = \"a: d.t,xi = lost\"",
            "error: beamgap.toml:2:9: check.plant: invalid value 'a: d.t,xi = lost' for '--plant <FAULT>': a term",
        ),
    ] {
        fs::write(folder.join("beamgap.toml"), text).unwrap();
        let (code, error, output) = cases(&[], &[]);
        assert!(error.starts_with(told) && error.lines().count() == 1, "{error}");
        assert_eq!((code, output.stdout.is_empty()), (Some(3), true));
    }
    assert_eq!(cases(&["--config", "none.toml"], &[]).0, Some(3));
    let mut export = command(&["export"]);
    let output = export.env("BEAMGAP_EXPORT_CASES", "1").current_dir(&folder).output().unwrap();
    let told = "error: BEAMGAP_EXPORT_CASES: the environment sets options of check, verify, prove, faults, but none of export\n";
    assert_eq!((output.status.code(), message(&output).as_str()), (Some(3), told));
    // With `--case`, the number of cases in the file has no effect.
    fs::write(folder.join("beamgap.toml"), "[check]\ncases = 3\n").unwrap();
    let one = command(&["check", "--case", "17"]).current_dir(&folder).output().unwrap();
    assert!(one.status.success(), "{one:?}");
}

/// The result contains a tolerance that the file loosens, and the reason.
#[test]
fn few_digits_need_a_reason() {
    let folder = folder("digits");
    let in_folder = |arguments: &[&str]| command(arguments).current_dir(&folder).output().unwrap();
    let export =
        ["export", "--family", "segment", "--cases", "2", "--expected", "none", "-o", "vectors.jsonl"];
    assert!(in_folder(&export).status.success());
    let program = format!("'{}' evaluate", env!("CARGO_BIN_EXE_beamgap"));
    let config = format!(
        "[verify]\nrun = \"{program}\"\ndigits = {{ value = 6, reason = \"printed with few digits\" }}\n"
    );
    fs::write(folder.join("beamgap.toml"), config).unwrap();
    let text = stdout(&in_folder(&["verify", "vectors.jsonl"]));
    let told = "6 significant digits are required where they are attainable: printed with few digits\n";
    assert!(text.contains(told), "{text}");
    let document = json(&in_folder(&["verify", "vectors.jsonl", "--format", "json"]));
    assert_eq!((&document["digits"], &document["reason"]), (&6.into(), &"printed with few digits".into()));
    // The reason is that of six digits.
    let text = stdout(&in_folder(&["verify", "vectors.jsonl", "--digits", "10"]));
    assert!(text.contains("10 significant digits are required where they are attainable\n"), "{text}");
    fs::write(folder.join("beamgap.toml"), "[verify]\ndigits = 6\n").unwrap();
    assert_eq!(in_folder(&["verify", "vectors.jsonl"]).status.code(), Some(3));
}

#[test]
fn colours_are_for_who_wants_them() {
    let small = ["check", "--cases", "1", "--family", "segment"];
    let shown = |more: &[&str], variable: &str| {
        let mut command = command(&[&small[..], more].concat());
        command.env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE");
        if !variable.is_empty() {
            command.env(variable, "1");
        }
        String::from_utf8(command.output().unwrap().stdout).unwrap()
    };
    let plain = shown(&[], "");
    let coloured = plain.replace("AGREE:", "\u{1b}[1;32mAGREE\u{1b}[0m:");
    assert!(plain.contains("\nAGREE: at ") && !plain.contains('\u{1b}'), "{plain}");
    assert_eq!(shown(&["--color", "always"], ""), coloured);
    assert_eq!(shown(&[], "CLICOLOR_FORCE"), coloured);
    assert_eq!(shown(&["--color", "never"], "CLICOLOR_FORCE"), plain);
    assert_eq!(shown(&[], "NO_COLOR"), plain);
    let document = shown(&["--format", "json", "--color", "always"], "");
    assert!(!document.contains('\u{1b}'), "a document has no colours");
}

#[test]
fn shells_and_man_know_the_commands() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = stdout(&run(&["completions", shell]));
        assert!(script.contains("time-budget") && script.contains("verify"), "{shell}");
    }
    let page = stdout(&run(&["man"]));
    assert!(page.contains(".TH beamgap 1") && page.contains("beamgap\\-verify"), "{page}");
    let page = stdout(&run(&["man", "check"]));
    assert!(page.contains("\\-\\-time\\-budget"), "{page}");
    assert_eq!(run(&["man", "chekc"]).status.code(), Some(2));
}
