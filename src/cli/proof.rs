//! A proof as tables for people, and as a JSON document.

use super::arguments::{planted, planting, program};
use super::count::count;
use super::exit::Exit;
use super::json;
use super::outcome::{Entry as OutcomeEntry, Outcome, Source, State, Verdict};
use super::proved::Proved;
use beamgap::check::Order;
use beamgap::linearization::Quantity;
use beamgap::number::PrimeField;
use beamgap::prove::{Draw, Entry, Layer, Proof, Row};
use beamgap::report::Table;
use beamgap::test_beam::Family;
use serde::Serialize;
use std::fmt::Write;

/// The number of refutations shown; the others are counted.
const SHOWN: usize = 5;

/// The formulas of the contact element.
const ELEMENT: &str = "src/contact/closed_form/assemble.rs";

/// The outcome of a proof, with one entry for each layer of each quantity.
pub(super) fn outcome(proof: &Proof) -> Outcome {
    let (exit, name, words) = if proof.holds() {
        let words = "PROVED: closed form and automatic differentiation are equal in every draw.".to_owned();
        (Exit::Agree, "proved", words)
    } else {
        let (pairs, all) = (proof.refutations.len(), proof.pairs);
        let all = count(all, "pair");
        let words = format!("REFUTED: in {pairs} of {all} of families they are not equal.");
        (Exit::Disagree, "refuted", words)
    };
    let entries = proof.rows.iter().map(|&Row { quantity, layer, equal, refuted, .. }| {
        let order = match layer {
            Layer::Value => Order::Value,
            Layer::First => Order::First,
            Layer::Second => Order::Second,
            Layer::Matrix | Layer::Kernel => Order::Matrix,
            Layer::Residual | Layer::Tangent => Order::Function,
        };
        OutcomeEntry {
            group: layer.name().to_owned(),
            name: subject(layer, quantity).to_owned(),
            state: State::of(equal + refuted, refuted),
            message: format!("equal in {}, unequal in {refuted}", count(equal, "draw")),
            source: Some(match layer {
                Layer::Residual | Layer::Tangent => Source { file: ELEMENT.into(), line: 1 },
                _ => Source::of_formula(order, quantity),
            }),
        }
    });
    Outcome { command: "prove", verdict: Verdict::new(exit, name, words), entries: entries.collect() }
}

/// What a row is about.
fn subject(layer: Layer, quantity: Quantity) -> &'static str {
    match layer {
        Layer::Residual | Layer::Tangent => "element",
        _ => quantity.name(),
    }
}

/// The heading: the request.
pub(super) fn head(plant: &[String], seed: u64, families: &[Family], draws: u64) -> String {
    format!(
        "Contact geometry of two beams: closed form against automatic differentiation,\n\
         over the field of 2^61 - 1 elements, compared by ==\n\
         seed {seed:#x}, {} of families, {} each\n{}\n",
        count(families.len().pow(2), "ordered pair"),
        count(draws, "draw"),
        planted(plant)
    )
}

/// The proof for people, 80 columns wide.
pub(super) fn human(proved: &Proved) -> String {
    let Proved { plant, seed, families, draws, proof } = proved;
    let mut text = head(plant, *seed, families, *draws);
    text += "The chance that a wrong formula passes one draw is at most 10^bound, from the\n\
             degree of the two sides (Schwartz and Zippel); independent draws multiply.\n\n";
    let mut table = Table::new(&["quantity", "layer", "equal", "unequal", "degree <", "bound"]).left(&[1]);
    for row in &proof.rows {
        let Row { quantity, layer, equal, refuted, degree } = row;
        table.row(vec![
            subject(*layer, *quantity).into(),
            layer.name().into(),
            equal.to_string(),
            refuted.to_string(),
            format!("{degree:.1e}"),
            format!("{:.1}", row.log_probability()),
        ]);
    }
    let _ = write!(text, "{table}");
    if let Some(first) = proof.refutations.first() {
        let _ = write!(text, "\n{}", in_full(first));
    }
    for draw in proof.refutations.iter().take(SHOWN) {
        let _ = write!(text, "\n{}", told(&repeat(*seed, draw, plant), draw));
    }
    match proof.refutations.len().saturating_sub(SHOWN) {
        0 => {}
        rest => drop(writeln!(text, "\nand {} of families", count(rest, "more pair"))),
    }
    text + "\n" + &outcome(proof).verdict.words + "\n"
}

/// All entries of one draw. The unequal entries begin at the fault and include all entries that depend on it.
fn in_full(draw: &Draw) -> String {
    let part = |title: &str, wanted: fn(&Entry<PrimeField>) -> bool| {
        let mut table = Table::new(&["quantity", "part", "closed form", "AD", "ratio"]).left(&[1]);
        let mut any = false;
        for entry in draw.entries.iter().filter(|entry| wanted(entry)) {
            any = true;
            table.row(vec![
                name(entry),
                entry.part.into(),
                entry.closed.value().to_string(),
                entry.ad.value().to_string(),
                if entry.is_equal() { String::new() } else { ratio(entry).unwrap_or("unequal".into()) },
            ]);
        }
        if any { format!("{title}\n{table}") } else { String::new() }
    };
    let [beam, bar] = draw.families.map(beamgap::test_beam::Family::name);
    let variations = part(
        &format!(
            "All numbers of draw {} of {beam} and {bar}, with the ratio of those not equal",
            draw.number
        ),
        |entry| matches!(entry.layer, Layer::Value | Layer::First | Layer::Second),
    );
    let matrices = part("Gradients and Hessians of this draw, contracted with its directions", |entry| {
        entry.layer == Layer::Matrix
    });
    let kernel = part("Unequal numbers of the kernel, contracted with the same directions", |entry| {
        entry.layer == Layer::Kernel && !entry.is_equal()
    });
    let element = part("Residual and tangent of a contact element, contracted in the same way", |entry| {
        matches!(entry.layer, Layer::Residual | Layer::Tangent)
    });
    let parts = [variations, matrices, kernel, element];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("\n")
}

/// The first inequality of a draw, and the command that repeats it.
fn told(repeat: &str, draw: &Draw) -> String {
    let Draw { families: [one, other], number, held, .. } = draw;
    let Some(first) = draw.unequal().next() else { return String::new() };
    let first_name = match first.layer {
        Layer::Matrix => format!("contracted matrix, {} of {}", first.part, name(first)),
        Layer::Kernel => format!("{}, {} of {}", first.candidate, first.part, name(first)),
        Layer::Residual | Layer::Tangent => format!("{}: {}", first.candidate, name(first)),
        _ => format!("{} of {}", first.part, name(first)),
    };
    let ends = match (held.xi, held.xi_bar) {
        (false, false) => "inside both beams",
        (true, false) => "at an end of the beam",
        (false, true) => "at an end of the bar beam",
        (true, true) => "at ends of both beams",
    };
    let times = ratio(first).map(|ratio| format!(", {ratio} times AD")).unwrap_or_default();
    format!(
        "{} and {}, draw {number}, {ends}: {} of {} unequal\n  first {first_name}{times}\n  {}\n",
        one.name(),
        other.name(),
        draw.unequal().count(),
        draw.entries.len(),
        repeat
    )
}

/// The command that repeats a draw.
fn repeat(seed: u64, Draw { families: [one, other], number, .. }: &Draw, plant: &[String]) -> String {
    let mut families = format!("--family {}", one.name());
    if one != other {
        let _ = write!(families, " --family {}", other.name());
    }
    let (program, draws) = (program(), number + 1);
    format!("{program} prove --seed {seed:#x} --draws {draws} {families}{}", planting(plant))
}

/// The quantity with its component, or the part of the element.
fn name(entry: &Entry<PrimeField>) -> String {
    if matches!(entry.layer, Layer::Residual | Layer::Tangent) {
        return entry.layer.name().into();
    }
    let quantity = Quantity::name(entry.quantity());
    entry.axis().map_or_else(|| quantity.into(), |axis| format!("{quantity}.{axis}"))
}

/// The ratio of the closed form to AD, if it is a small fraction.
fn ratio(entry: &Entry<PrimeField>) -> Option<String> {
    entry.ratio().map(|(above, below)| match below {
        1 => above.to_string(),
        _ => format!("{above}/{below}"),
    })
}

/// The proof as JSON: the request, the result, and the commands that repeat its refutations.
pub(super) fn json(proved: &Proved) -> anyhow::Result<String> {
    #[derive(Serialize)]
    struct Document<'a> {
        schema: &'static str,
        version: &'static str,
        seed: String,
        planted: &'a [String],
        prime: String,
        families: &'a [Family],
        draws: u64,
        verdict: &'static str,
        #[serde(flatten)]
        proof: &'a Proof,
        repeat: Vec<String>,
    }
    let Proved { plant, seed, families, draws, proof } = proved;
    json::text(&Document {
        schema: "beamgap-prove/2",
        version: env!("CARGO_PKG_VERSION"),
        seed: format!("{seed:#x}"),
        planted: plant,
        prime: PrimeField::PRIME.to_string(),
        families,
        draws: *draws,
        verdict: outcome(proof).verdict.name,
        proof,
        repeat: proof.refutations.iter().map(|draw| repeat(*seed, draw, plant)).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::Proved;
    use super::{human, json};
    use beamgap::linearization::Quantity;
    use beamgap::number::PrimeField;
    use beamgap::prove::{Draw, prove};
    use beamgap::test_beam::Family;
    use beamgap::variant::Variant;
    use serde_json::Value;

    /// A proof with one refutation: xi has the wrong sign in its second variation, g_T half of it, d is off by one.
    fn refuted() -> Proved {
        let families = vec![Family::Segment, Family::Arc];
        let mut proof = prove(&Variant::Unmodified, 1, &families, 2, || ());
        let mut draw = Draw::new(&Variant::Unmodified, 1, [Family::Segment, Family::Arc], 1);
        let half = PrimeField::new(1) / PrimeField::new(2);
        for entry in draw.entries.iter_mut().filter(|entry| entry.part == "Delta-delta") {
            match entry.quantity() {
                Quantity::D => entry.closed += PrimeField::new(1),
                Quantity::Xi => entry.closed = -entry.closed,
                Quantity::GT => entry.closed *= half,
                _ => {}
            }
        }
        proof.refutations.push(draw);
        Proved { plant: Vec::new(), seed: 1, families, draws: 2, proof }
    }

    #[test]
    fn a_refutation_shows_what_the_fault_touches() {
        let text = human(&refuted());
        // A command may be wider, because it is copied and pasted.
        let fits = |line: &str| line.contains(" prove --seed") || line.chars().count() <= 80;
        assert!(text.lines().all(fits), "{text}");
        let last = |start: [&str; 2]| {
            let line = text.lines().find(|line| line.split_whitespace().take(2).eq(start));
            line.and_then(|line| line.split_whitespace().nth(4)).map(str::to_owned)
        };
        assert_eq!(last(["xi", "Delta-delta"]).as_deref(), Some("-1"), "{text}");
        assert_eq!(last(["g_T", "Delta-delta"]).as_deref(), Some("1/2"));
        assert_eq!(last(["d", "Delta-delta"]).as_deref(), Some("unequal"));
        assert_eq!(last(["xi_bar", "Delta-delta"]), None);
        assert!(
            text.contains("draw 1, inside both beams: 6 of 117 unequal\n  first Delta-delta of d\n"),
            "{text}"
        );
        assert!(text.contains(" prove --seed 0x1 --draws 2 --family segment --family arc\n"), "{text}");
        assert!(text.ends_with("REFUTED: in 1 of 4 pairs of families they are not equal.\n"), "{text}");
    }

    #[test]
    fn the_document_has_all_entries_of_a_refutation() {
        let document: Value = serde_json::from_str(&json(&refuted()).unwrap()).unwrap();
        assert_eq!(document["verdict"], "refuted");
        let entries = document["refutations"][0]["entries"].as_array().unwrap();
        let unequal: Vec<_> = entries.iter().filter(|entry| entry["equal"] == false).collect();
        let told = |layer: &str| {
            let of_layer = unequal.iter().filter(|entry| entry["layer"] == layer);
            of_layer.map(|entry| serde_json::json!([entry["quantity"], entry["ratio"]])).collect::<Vec<_>>()
        };
        let expected = serde_json::json!([["d", null], ["xi", [-1, 1]], ["g_T", [1, 2]]]);
        assert_eq!(serde_json::json!(told("second")), expected);
        assert_eq!(serde_json::json!(told("matrix")), expected);
        assert_eq!((entries.len(), unequal.len()), (117, 6));
    }
}
