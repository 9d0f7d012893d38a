//! One case with everything about it: what was drawn, what was found, and every entry that was compared.

use super::check::Verdict;
use super::human::{error, name, repeat};
use super::json;
use super::table::Table;
use beamgap::check::{Arbitration, Case, Comparison, Specimen, Verdict as Compared};
use beamgap::closest_point::{ClosestPoint, End};
use serde_json::{Value, json};
use std::fmt::Write;

type Points = [(Option<ClosestPoint>, Compared)];

/// The case for people; the numbers have all their digits.
pub(super) fn human(seed: u64, case: &Case, points: &Points, verdict: &Verdict) -> String {
    let [beam, bar] = case.families;
    let mut text = format!(
        "{}\nregime {}, {} and {}\n",
        repeat(seed, case.number),
        case.regime.name(),
        beam.name(),
        bar.name()
    );
    for (title, beam) in ["beam", "bar beam"].into_iter().zip(&case.specimens) {
        let _ = writeln!(text, "\n{title}\n  {}", beam.family.name());
        for (name, _) in beam.family.parameters() {
            let _ = writeln!(text, "  {name} = {:?}", beam.parameter(name));
        }
        for (name, numbers) in [("q", &beam.q), ("dq", &beam.dq), ("Dq", &beam.linear_dq)] {
            for (i, number) in numbers.iter().enumerate() {
                let _ = writeln!(text, "  {name}[{i}] = {number:e}");
            }
        }
    }
    let _ = writeln!(text, "\ncontact\n  {:?}", case.contact);
    for (point, compared) in points {
        text += "\n";
        if let Some(point) = point {
            text += &described(point);
        }
        match compared {
            Compared::Inconclusive(reason, entries) => {
                let _ = writeln!(text, "Not compared: {}", reason.reason());
                if !entries.is_empty() {
                    text += &table(entries);
                }
            }
            Compared::Pass(entries) | Compared::Mismatch(entries) => text += &table(entries),
        }
        if let Some(who) = Arbitration::of(compared.entries()) {
            let _ = writeln!(text, "By differences in double-double: {}", who.words());
        }
    }
    text + "\n" + &verdict.words + "\n"
}

fn described(point: &ClosestPoint) -> String {
    let end = |end: Option<End>| end.map_or_else(|| "inside".into(), |end| format!("{end:?}"));
    let degeneracy = point.degeneracy().map_or_else(|| "none".into(), |degeneracy| format!("{degeneracy:?}"));
    format!(
        "closest point\n  xi = {:e}, {}\n  xi_bar = {:e}, {}\n  kind: {:?}\n  d = {:e}\n  residual = {:e}\n  \
         conditioning = {:e}\n  degeneracy: {degeneracy}\n",
        point.xi,
        end(point.end),
        point.xi_bar,
        end(point.end_bar),
        point.kind,
        point.distance,
        point.residual,
        point.conditioning
    )
}

fn table(entries: &[Comparison]) -> String {
    let titles = [
        "quantity",
        "part",
        "order",
        "against",
        "closed",
        "other",
        "difference",
        "scale",
        "tolerance",
        "verdict",
    ];
    let mut table = Table::new(&titles).left(&[1, 2, 3]);
    for entry in entries {
        table.row(vec![
            name(entry),
            entry.part.into(),
            entry.order.name().into(),
            entry.against.into(),
            format!("{:e}", entry.closed),
            format!("{:e}", entry.other),
            error(entry.difference()),
            error(entry.scale),
            error(entry.tolerance),
            told(entry).into(),
        ]);
    }
    table.to_string()
}

fn told(entry: &Comparison) -> &'static str {
    match (entry.is_meaningful(), entry.agrees()) {
        (false, _) => "not meaningful",
        (true, true) => "agrees",
        (true, false) => "DISAGREES",
    }
}

/// The case for programs, of the schema `beamgap-case/1`.
pub(super) fn json(seed: u64, case: &Case, points: &Points, verdict: &Verdict) -> anyhow::Result<String> {
    let beam = |i: usize| {
        let Specimen { family, q, dq, linear_dq, .. } = &case.specimens[i];
        let parameters = family.parameters().iter().map(|&(name, count)| {
            let numbers = case.specimens[i].parameter(name);
            (name.to_owned(), if count == 1 { json!(numbers[0]) } else { json!(numbers) })
        });
        let curve: serde_json::Map<_, _> = parameters.collect();
        json!({ "family": family.name(), "curve": curve, "q": q, "dq": dq, "linear_dq": linear_dq })
    };
    let contact = &case.contact;
    json::text(&json!({
        "schema": "beamgap-case/1",
        "version": env!("CARGO_PKG_VERSION"),
        "seed": format!("{seed:#x}"),
        "case": case.number,
        "regime": case.regime.name(),
        "verdict": verdict.name,
        "beam": beam(0),
        "bar": beam(1),
        "contact": {
            "radius": contact.radius,
            "radius_bar": contact.radius_bar,
            "xi_0": contact.xi_0,
            "xi_bar_0": contact.xi_bar_0,
        },
        "closest_points": points.iter().map(|(point, compared)| at_point(point.as_ref(), compared)).collect::<Vec<_>>(),
    }))
}

fn at_point(point: Option<&ClosestPoint>, compared: &Compared) -> Value {
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
        Compared::Pass(entries) => ("agree", None, entries.as_slice()),
        Compared::Mismatch(entries) => ("disagree", None, entries.as_slice()),
        Compared::Inconclusive(reason, entries) => {
            ("not-compared", Some(reason.reason()), entries.as_slice())
        }
    };
    let arbitration = Arbitration::of(entries).map(Arbitration::name);
    let entries: Vec<_> = entries.iter().map(json::compared).collect();
    json!({
        "point": point,
        "verdict": verdict,
        "reason": reason,
        "arbitration": arbitration,
        "entries": entries,
    })
}
