//! One case in full: the drawn beams, the closest points, and every compared entry.

use super::case_file;
use super::json;
use super::open_regions;
use super::outcome::Verdict;
use super::searched;
use super::words::{error, name};
use beamgap::check::{
    Arbitration, CaseData, Compared, Comparison, Order, Regime, Searched, Verdict as Found,
};
use beamgap::closest_point::{ClosestPoint, End};
use beamgap::pair::Contact;
use beamgap::report::Table;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

/// A case with its result.
pub(super) struct Shown<'a> {
    /// The case.
    pub(super) case: &'a CaseData,
    /// Seed, number and regime, if the case was drawn.
    pub(super) drawn: Option<(u64, u64, Regime)>,
    /// The comparison.
    pub(super) points: &'a Compared,
    /// The comparison of the search with the independent search.
    pub(super) search: &'a Searched,
    /// The verdict.
    pub(super) verdict: &'a Verdict,
    /// Whether numbers that agree are left out.
    pub(super) only_wrong: bool,
}

/// The heading: which case it is.
pub(super) fn head(case: &CaseData, drawn: Option<(u64, u64, Regime)>) -> String {
    let [beam, bar] = case.test_beams.each_ref().map(|test_beam| test_beam.family.name());
    match drawn {
        Some((seed, number, regime)) => {
            format!("seed {seed:#x}, case {number}\nregime {}, {beam} and {bar}\n", regime.name())
        }
        None => format!("{beam} and {bar}\n"),
    }
}

/// The case for people; the numbers are printed with all digits.
pub(super) fn human(Shown { case, drawn, points, search, verdict, only_wrong }: &Shown) -> String {
    let mut text = head(case, *drawn);
    for (title, beam) in ["beam", "bar beam"].into_iter().zip(&case.test_beams) {
        let _ = writeln!(text, "\n{title}\n  {}", beam.family.name());
        for (name, _) in beam.family.parameters() {
            match beam.parameter(name) {
                [number] => drop(writeln!(text, "  {name} = {number:e}")),
                numbers => list(&mut text, name, numbers),
            }
        }
        for (name, numbers) in [("q", &beam.q), ("dq", &beam.dq), ("Dq", &beam.linear_dq)] {
            list(&mut text, name, numbers);
        }
    }
    let Contact { radius, radius_bar, xi_0, xi_bar_0 } = case.contact;
    text += "\ncontact\n";
    for (name, number) in
        [("radius", radius), ("radius_bar", radius_bar), ("xi_0", xi_0), ("xi_bar_0", xi_bar_0)]
    {
        let _ = writeln!(text, "  {name} = {number:e}");
    }
    for (point, compared) in *points {
        text += "\n";
        if let Some(point) = point {
            text += &described(point);
        }
        match compared {
            Found::Inconclusive(reason, entries) => {
                let _ = writeln!(text, "Not compared: {}", reason.reason());
                text += &numbers(entries, *only_wrong);
            }
            Found::Pass(entries) | Found::Mismatch(entries) => text += &numbers(entries, *only_wrong),
        }
        if let Some(who) = Arbitration::of_mismatch(compared) {
            let _ = writeln!(text, "By differences in double-double: {}", who.words());
        }
    }
    for region in case.open_regions() {
        text += &open_regions::described(&region);
    }
    text + &searched::in_words(search) + "\n" + &verdict.words + "\n"
}

/// Prints one number a line.
fn list(text: &mut String, name: &str, numbers: &[f64]) {
    for (i, number) in numbers.iter().enumerate() {
        let _ = writeln!(text, "  {name}[{i}] = {number:e}");
    }
}

fn described(point: &ClosestPoint) -> String {
    let end = |end: Option<End>| match end {
        Some(End { strict, multiplier, .. }) => {
            let kind = if strict { "held" } else { "weakly held" };
            format!("at an end, {kind}, multiplier {}", error(multiplier))
        }
        None => "inside".into(),
    };
    let degeneracy = point.degeneracy().map_or_else(|| "none".into(), |degeneracy| format!("{degeneracy:?}"));
    let conditioning =
        if point.conditioning.is_finite() { format!("{:e}", point.conditioning) } else { "-".into() };
    format!(
        "closest point\n  xi = {:e}, {}\n  xi_bar = {:e}, {}\n  kind: {:?}\n  d = {:e}\n  residual = {:e}\n  \
         conditioning = {conditioning}\n  degeneracy: {degeneracy}\n",
        point.xi,
        end(point.end),
        point.xi_bar,
        end(point.end_bar),
        point.kind,
        point.distance,
        point.residual
    )
}

/// Each number of the closed form with the compared number, 80 columns wide.
fn numbers(entries: &[Comparison], only_wrong: bool) -> String {
    let mut parts: Vec<(String, Vec<&Comparison>)> = Vec::new();
    let mut places = BTreeMap::new();
    for entry in entries.iter().filter(|entry| !only_wrong || entry.is_wrong()) {
        let at = *places.entry((entry.quantity, entry.axis, entry.part)).or_insert_with(|| {
            let Comparison { closed, scale, part, .. } = entry;
            parts.push((format!("{}, {part}: {closed:e}, scale {}", name(entry), error(*scale)), Vec::new()));
            parts.len() - 1
        });
        parts[at].1.push(entry);
    }
    if parts.is_empty() {
        let none = "No number differs beyond rounding.\n";
        return if entries.is_empty() { String::new() } else { none.into() };
    }
    let mut table = Table::new(&["compared with", "its number", "error", "tol.", ""]).left(&[4]);
    let shown: Vec<_> = parts.iter().map(|(_, entries)| with_one_function(entries)).collect();
    for (against, entry) in shown.iter().flatten() {
        table.row(vec![
            against.clone(),
            format!("{:e}", entry.other),
            error(entry.difference()),
            error(entry.tolerance),
            told(entry).into(),
        ]);
    }
    let table = table.to_string();
    let mut rows = table.lines();
    let mut text = rows.next().unwrap_or_default().to_owned() + "\n";
    for ((title, _), shown) in parts.iter().zip(&shown) {
        let _ = writeln!(text, "{title}");
        for row in rows.by_ref().take(shown.len()) {
            let _ = writeln!(text, "{row}");
        }
    }
    text
}

/// The entries with their references. Of the functions that agree, only the one with the largest error.
fn with_one_function<'a>(entries: &[&'a Comparison]) -> Vec<(String, &'a Comparison)> {
    let is_alike = |entry: &&Comparison| entry.order == Order::Function && told(entry) == "agrees";
    let (alike, others): (Vec<&Comparison>, Vec<&Comparison>) = entries.iter().copied().partition(is_alike);
    let count = alike.len();
    let worst = alike.into_iter().max_by(|a, b| a.over_tolerance().total_cmp(&b.over_tolerance()));
    let of = |entry: &'a Comparison| match count {
        1 => (entry.against.to_owned(), entry),
        _ => (format!("{count} functions, the worst"), entry),
    };
    let worst = worst.map(of);
    let others = others.into_iter().map(|entry| (entry.against.to_owned(), entry));
    others.chain(worst).collect()
}

fn told(entry: &Comparison) -> &'static str {
    match (entry.is_meaningful(), entry.agrees()) {
        (false, _) => "unclear",
        (true, true) => "agrees",
        (true, false) => "WRONG",
    }
}

/// The case as JSON, of the schema `beamgap-case/1`.
pub(super) fn json(
    Shown { case, drawn, points, search, verdict, only_wrong }: &Shown,
) -> anyhow::Result<String> {
    let mut document = case_file::object(case);
    let mut add = |name: &str, value: Value| drop(document.insert(name.into(), value));
    if let Some((seed, number, regime)) = drawn {
        add("seed", json!(format!("{seed:#x}")));
        add("case", json!(number));
        add("regime", json!(regime.name()));
    }
    add("version", json!(env!("CARGO_PKG_VERSION")));
    add("verdict", json!(verdict.name));
    add("search", json!(search));
    let points = points.iter().map(|(point, compared)| at_point(point.as_ref(), compared, *only_wrong));
    add("closest_points", points.collect());
    add("open_regions", case.open_regions().iter().map(open_regions::json).collect());
    json::text(&document)
}

fn at_point(point: Option<&ClosestPoint>, compared: &Found, only_wrong: bool) -> Value {
    let end = |end: Option<End>| {
        end.map(
            |end| json!({ "side": end.side.parameter(), "strict": end.strict, "multiplier": end.multiplier }),
        )
    };
    let point = point.map(|point| {
        json!({
            "xi": point.xi,
            "xi_bar": point.xi_bar,
            "end": end(point.end),
            "end_bar": end(point.end_bar),
            "kind": format!("{:?}", point.kind).to_lowercase(),
            "distance": point.distance,
            "residual": point.residual,
            "conditioning": point.conditioning,
            "degeneracy": point.degeneracy().map(|degeneracy| format!("{degeneracy:?}")),
        })
    });
    let (verdict, reason, entries) = match compared {
        Found::Pass(entries) => ("agree", None, entries.as_slice()),
        Found::Mismatch(entries) => ("disagree", None, entries.as_slice()),
        Found::Inconclusive(reason, entries) => ("not-compared", Some(reason.reason()), entries.as_slice()),
    };
    let arbitration = Arbitration::of_mismatch(compared).map(Arbitration::name);
    let shown = entries.iter().filter(|entry| !only_wrong || entry.is_wrong());
    let entries: Vec<_> = shown.map(json::compared).collect();
    json!({
        "point": point,
        "verdict": verdict,
        "reason": reason,
        "arbitration": arbitration,
        "entries": entries,
    })
}
