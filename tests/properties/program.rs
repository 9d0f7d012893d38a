//! The program is run, and its output is compared with golden files.
//!
//! The golden files contain real output. The last digits of sine and power depend on the machine. Errors and the
//! cases with the worst errors are thus not compared; all else must be equal. `BEAMGAP_BLESS=1` writes the files.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

pub(crate) fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_beamgap"));
    command.args(arguments).env_remove("RAYON_NUM_THREADS").env_remove("GITHUB_STEP_SUMMARY");
    command
}

pub(crate) fn run(arguments: &[&str]) -> Output {
    command(arguments).output().unwrap()
}

/// Standard output of a run that must succeed without a message.
pub(crate) fn stdout(output: &Output) -> String {
    assert!(has_no_message(output) && output.status.success(), "{output:?}");
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// Whether standard error has no error and no warning. It may have the title of a result in another format.
pub(crate) fn has_no_message(output: &Output) -> bool {
    let told = String::from_utf8_lossy(&output.stderr);
    let is_title = |line: &str| !["error", "warning", "internal"].iter().any(|word| line.starts_with(word));
    told.lines().all(is_title)
}

/// Standard error with its error on one line, which the program folds.
pub(crate) fn message(output: &Output) -> String {
    let told = String::from_utf8(output.stderr.clone()).unwrap();
    assert!(told.lines().all(|line| line.chars().count() <= 80 || !line.trim().contains(' ')), "{told}");
    told.replace("\n  ", " ")
}

/// README.md and the guides in docs, with the links of README.
pub(crate) fn guides() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut pages: Vec<_> =
        std::fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path()).collect();
    pages.sort();
    pages.insert(0, root.join("README.md"));
    let text: String = pages.iter().map(|page| std::fs::read_to_string(page).unwrap()).collect();
    text.replace("](../", "](")
}

/// The lines that a guide shows after a command are some that the command prints, without a gap.
pub(crate) fn shown_in_the_guides(output: &str, command: &str) {
    let guides = guides();
    let (_, after) =
        guides.split_once(&format!("{command}\n")).unwrap_or_else(|| panic!("{command} is missing"));
    let shown: Vec<&str> = after.lines().take_while(|line| !line.starts_with("```")).collect();
    let lines: Vec<&str> = output.lines().collect();
    let is_printed = !shown.is_empty() && lines.windows(shown.len()).any(|part| part == shown);
    assert!(is_printed, "a guide shows\n{shown:#?}\nfor\n{output}");
}

pub(crate) fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Compares with a golden file after both are filtered by `blind`, or writes the file.
pub(crate) fn golden(name: &str, output: &str, blind: impl Fn(&str) -> String) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
    if std::env::var_os("BEAMGAP_BLESS").is_some() {
        std::fs::write(&path, output).unwrap();
    }
    let expected = std::fs::read_to_string(&path).unwrap();
    assert_eq!(blind(output), blind(&expected), "BEAMGAP_BLESS=1 writes {name} again");
}

/// Tables without errors and without the cases of the worst errors.
pub(crate) fn blind_text(text: &str) -> String {
    let mut kept = usize::MAX;
    let mut blind = String::new();
    for line in text.lines() {
        if !line.starts_with(' ') {
            kept = match line.split_whitespace().next() {
                Some("Worst" | "The") => 1,
                Some("Regimes:") => 5,
                // The degree depends on how the formula is written.
                Some("degree") => 4,
                _ => usize::MAX,
            };
        }
        let tokens = line.split_whitespace().enumerate().map(|(i, token)| {
            let number = token == "-" || token.parse::<f64>().is_ok();
            if i >= kept && number { "#" } else { token }
        });
        blind += &(tokens.collect::<Vec<_>>().join(" ") + "\n");
    }
    blind
}

/// The same filter for the document.
pub(crate) fn blind_json(text: &str) -> String {
    fn hide(value: &mut Value) {
        match value {
            Value::Array(values) => values.iter_mut().for_each(hide),
            Value::Object(entries) => {
                for (key, value) in entries {
                    match key.as_str() {
                        "scaled_error" | "over_tolerance" | "case" | "degree" | "log10_probability" => {
                            *value = Value::Null;
                        }
                        _ => hide(value),
                    }
                }
            }
            _ => {}
        }
    }
    let mut document = serde_json::from_str(text).unwrap();
    hide(&mut document);
    serde_json::to_string_pretty(&document).unwrap()
}
