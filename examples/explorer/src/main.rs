//! Builds the pages from their templates, the style of the derivation, the opening states and the module.
//!
//! `beamgap-explorer MODULE REPORTS` reads `REPORTS/equations.json`, and writes `REPORTS/explorer.html` and
//! `REPORTS/learn.html`. `beamgap-explorer frames` answers requests of scenes, one a line.

mod assets;
mod equations_table;
mod explorer_page;
mod learn_page;
#[path = "../../../src/report/derivation/math.rs"]
mod math;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use beamgap_explorer::learn;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::Value;
use std::error::Error;
use std::io::Write as _;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let done = match &arguments[..] {
        [module, reports] => write(Path::new(module), Path::new(reports)),
        [command] if command == "frames" => frames(),
        _ => {
            eprintln!("usage: beamgap-explorer MODULE REPORTS, or beamgap-explorer frames");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn write(module: &Path, reports: &Path) -> Result<(), Box<dyn Error>> {
    let read =
        |path: &Path| fs::read(path).map_err(|error| format!("cannot read {}: {error}", path.display()));
    let module = BASE64_STANDARD.encode(compressed(&read(module)?)?);
    let equations: Value = serde_json::from_slice(&read(&reports.join("equations.json"))?)?;
    fs::write(reports.join("explorer.html"), explorer_page::page(&module, &equations)?)?;
    fs::write(reports.join("learn.html"), learn_page::page(&module)?)?;
    Ok(())
}

/// Answers requests of scenes from standard input, for the test in a browser.
fn frames() -> Result<(), Box<dyn Error>> {
    for request in std::io::stdin().lines() {
        println!("{}", learn(&request?));
    }
    Ok(())
}

fn compressed(module: &[u8]) -> std::io::Result<Vec<u8>> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(module)?;
    encoder.finish()
}

/// The template with its placeholders replaced.
fn compose(template: &str, pieces: &[(&str, String)]) -> Result<String, Box<dyn Error>> {
    let mut page = String::with_capacity(1_000_000);
    let mut rest = template;
    while let Some((before, from)) = rest.split_once("{{") {
        let (name, after) = from.split_once("}}").ok_or("a placeholder does not end")?;
        let piece =
            pieces.iter().find(|(known, _)| *known == name).ok_or_else(|| format!("no piece {name:?}"))?;
        page.push_str(before);
        page.push_str(&piece.1);
        rest = after;
    }
    page.push_str(rest);
    Ok(page)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
