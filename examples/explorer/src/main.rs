//! Builds the pages from their templates, the style of the derivation, the opening states and the module.
//!
//! `beamgap-explorer MODULE REPORTS` reads `REPORTS/equations.json`, and writes `REPORTS/explorer.html` and
//! `REPORTS/learn.html`. `beamgap-explorer frames` answers requests of scenes, one a line.

mod learn_page;
#[path = "../../../src/report/derivation/math.rs"]
mod math;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use beamgap::test_beam::Family;
use beamgap::variant::catalogue;
use beamgap_explorer::{Answer, EquationCells, State, learn, preset};
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::{Map, Value, json};
use std::error::Error;
use std::fmt::Write;
use std::io::Write as _;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

const TEMPLATE: &str = include_str!("../page/page.html");
/// The parts of the script, which share one scope.
const SCRIPT: &str = concat!(
    "\"use strict\";\n(() => {\n",
    include_str!("../page/module.js"),
    "\n",
    include_str!("../page/picture.js"),
    "\n",
    include_str!("../page/controls.js"),
    "\n",
    include_str!("../page/link.js"),
    "})();\n"
);
const STYLES: [&str; 2] =
    [include_str!("../../../src/report/derivation/style.css"), include_str!("../page/explorer.css")];

/// Instructive faults: their names, and the labels of their buttons.
const LESSONS: [(&str, &str); 6] = [
    ("", "no fault"),
    ("a: d.t,xi = dropped", "a without d·t,ξ"),
    ("R: du,xi.d = dropped", "R without δu,ξ·d"),
    ("d|d|: n.du_hat = sign", "δd with the wrong sign"),
    ("Dd x: rest = dropped", "Δδx without its known terms"),
    ("Ddg_T: dt Dxi = dropped", "Δδg of the slip without a mixed term"),
];

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
    let page = page(&module, &equations)?;
    fs::write(reports.join("explorer.html"), page)?;
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

/// The page, with the standard case as it is shown before the module is loaded.
fn page(module: &str, equations: &Value) -> Result<String, Box<dyn Error>> {
    let standard = State::default();
    let answer = Answer::of(&standard)?;
    let known: Vec<String> = catalogue().iter().map(ToString::to_string).collect();
    if let Some((unknown, _)) =
        LESSONS.iter().find(|(name, _)| !name.is_empty() && !known.iter().any(|known| known == name))
    {
        return Err(format!("no fault is called {unknown:?}").into());
    }
    let cells = answer.equations.clone().unwrap_or_default();
    let style: String = STYLES
        .concat()
        .lines()
        .filter(|line| !is_of_formulas(line))
        .fold(String::new(), |all, line| all + line + "\n");
    let pieces = [
        ("style", style),
        ("scene", answer.scene.clone()),
        ("handles", String::new()),
        ("gap", answer.gap.clone()),
        ("families", options(Family::ALL.map(Family::name)).replace(">hermite<", " selected>hermite<")),
        ("radius", standard.contact.radius.to_string()),
        ("situations", buttons("situation", situations().iter().map(|(name, _)| (*name, *name)))),
        ("terms", options(terms().iter().map(|(term, _)| term.as_str()))),
        ("lessons", buttons("fault", LESSONS)),
        ("words", answer.words.clone()),
        ("points", answer.points.clone()),
        ("checks", answer.checks.clone()),
        ("prediction", answer.prediction.clone()),
        ("plot", answer.plot.clone()),
        ("numbers", answer.numbers.clone()),
        ("equations", rows(equations, &cells)?),
        ("test", escaped(&answer.test)),
        ("command", escaped(&answer.command)),
        ("data", data(&standard)?),
        ("script", SCRIPT.to_owned()),
        ("module", module.to_owned()),
    ];
    compose(TEMPLATE, &pieces)
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

/// Whether a line of the style is for MathML, which this page does not use.
fn is_of_formulas(line: &str) -> bool {
    ["@namespace", "@font-face", "m|"].iter().any(|start| line.starts_with(start))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn options<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let options: Vec<_> =
        names.into_iter().map(|name| format!("<option>{}</option>", escaped(name))).collect();
    options.concat()
}

fn buttons<'a>(what: &str, names: impl IntoIterator<Item = (&'a str, &'a str)>) -> String {
    let button = |(value, words): (&str, &str)| {
        format!("<button type=\"button\" data-{what}=\"{}\">{}</button> ", escaped(value), escaped(words))
    };
    names.into_iter().map(button).collect()
}

/// The terms in the order in which they are evaluated, with their faults.
fn terms() -> Vec<(String, Vec<String>)> {
    let mut terms: Vec<(String, Vec<String>)> = Vec::new();
    for fault in catalogue() {
        let (term, kind) = (fault.label.to_string(), fault.kind.name().to_owned());
        match terms.iter_mut().find(|(known, _)| *known == term) {
            Some((_, kinds)) => kinds.push(kind),
            None => terms.push((term, vec![kind])),
        }
    }
    terms
}

/// The initial data of the script; the text cannot close the script element.
fn data(standard: &State) -> Result<String, serde_json::Error> {
    let presets = |bar: bool| -> Result<Map<String, Value>, serde_json::Error> {
        let of = |family: Family| Ok((family.name().to_owned(), serde_json::to_value(preset(family, bar))?));
        Family::ALL.into_iter().map(of).collect()
    };
    let faults: Map<String, Value> = terms().into_iter().map(|(term, kinds)| (term, json!(kinds))).collect();
    let data = json!({
        "standard": standard,
        "presets": { "beam": presets(false)?, "bar": presets(true)? },
        "situations": situations().into_iter().map(|(name, state)| (name.to_owned(), state)).collect::<Map<_, _>>(),
        "faults": faults,
    });
    Ok(data.to_string().replace("</", "<\\/"))
}

/// Beams in a special position: parts of a state by name.
fn situations() -> Vec<(&'static str, Value)> {
    let directed = |q: &[f64], bar: bool| {
        let family = if q.len() == 6 { Family::Segment } else { Family::Quadratic };
        let mut beam = preset(family, bar);
        beam.q = q.to_vec();
        beam
    };
    let pair = |q: &[f64], q_bar: &[f64]| json!({ "beam": directed(q, false), "bar": directed(q_bar, true) });
    let standard = State::default();
    vec![
        ("standard", json!({ "beam": standard.beam, "bar": standard.bar, "contact": standard.contact })),
        ("parallel", pair(&[-1.2, 0.0, 0.3, 1.2, 0.0, 0.3], &[-1.2, 0.0, -0.3, 1.2, 0.0, -0.3])),
        ("nearly parallel", pair(&[-1.2, 0.0, 0.3, 1.2, 0.0, 0.3], &[-1.2, -0.001, -0.3, 1.2, 0.001, -0.3])),
        ("crossing", pair(&[-1.2, 0.0, 0.0, 1.2, 0.0, 0.0], &[0.0, -1.2, 0.0, 0.0, 1.2, 0.0])),
        ("at an end", pair(&[-1.4, 0.0, 0.4, -0.2, 0.2, 0.3], &[0.3, -1.2, -0.3, 0.3, 1.2, -0.3])),
        (
            "two minima",
            pair(&[-1.2, 1.0, 0.3, 0.0, -0.5, 0.3, 1.2, 1.0, 0.3], &[-1.3, 0.0, -0.3, 1.3, 0.0, -0.3]),
        ),
    ]
}

/// The table of the equations, with the numbers of the standard case.
fn rows(equations: &Value, cells: &[EquationCells]) -> Result<String, Box<dyn Error>> {
    let mut rows = String::new();
    for row in equations["equations"].as_array().ok_or("equations.json has no equations")? {
        let (Some(number), Some(says), Some(verdict)) =
            (row["number"].as_u64(), row["says"].as_str(), row["verdict"].as_str())
        else {
            return Err("an equation has no number, words or verdict".into());
        };
        let cell =
            cells.iter().find(|cell| u64::from(cell.number) == number).ok_or("an equation is missing")?;
        let class = if verdict == "misprint" { "bad" } else { "good" };
        let _ = write!(
            rows,
            "<tr data-equation=\"{number}\"><th scope=\"row\"><a href=\"derivation.html#eq-{number}\">({number})</a></th>\
             <td class=\"words\">{}</td><td class=\"{class}\">{}</td>",
            escaped(says),
            verdict.replace('-', " ")
        );
        for (name, text) in [
            ("formula", &cell.formula),
            ("hyper_dual", &cell.hyper_dual),
            ("digits", &cell.digits),
            ("printed", &cell.printed),
        ] {
            let _ = write!(rows, "<td data-cell=\"{name}\">{}</td>", escaped(text));
        }
        rows += "</tr>\n";
    }
    Ok(format!(
        "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"equations of the paper\"><table><thead><tr>\
         <th scope=\"col\">equation</th><th scope=\"col\">what it says</th><th scope=\"col\">verdict</th>\
         <th scope=\"col\">formula, corrected</th><th scope=\"col\">hyper-dual</th><th scope=\"col\">digits</th>\
         <th scope=\"col\">digits of the print</th></tr></thead><tbody>\n{rows}</tbody></table></div>\n"
    ))
}
