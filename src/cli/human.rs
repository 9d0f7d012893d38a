//! A run as tables for people, 80 columns wide.

use super::arguments::planted;
use super::check::{Checked, Verdict};
use super::disagreements;
use super::table::Table;
use beamgap::check::{Cell, Comparison, Differences, Family, Inconclusive, Order};
use beamgap::linearization::Quantity;
use std::collections::BTreeMap;
use std::fmt::Write;

/// All that is to be said about a run.
pub(super) fn document(checked: &Checked, verdict: &Verdict) -> String {
    let mut text = title(checked);
    let mut add = |title: &str, body: String| {
        if !body.is_empty() {
            let _ = write!(text, "\n{title}\n{body}");
        }
    };
    add(
        "Worst error over scale, the sum of the sizes of its terms",
        cells(checked, |cell| error(cell.scaled_error)),
    );
    add("The case that showed it", cells(checked, |cell| case_of(cell).unwrap_or_else(|| "-".into())));
    add("Regimes: closest points compared, worst error, and most of a tolerance used", regimes(checked));
    add(&coverage(checked), families(checked));
    add("Not compared", not_compared(checked));
    add("Differences in double-double", differences(checked));
    add("Disagreements", disagreements::listed(checked));
    add("Made small: as a test, and as a command", disagreements::made_small(checked));
    text + "\n" + &verdict.words + "\n"
}

fn title(Checked { plant, seed, selection, .. }: &Checked) -> String {
    let family =
        selection.family.map_or_else(|| "all families".into(), |family| format!("family {}", family.name()));
    let regimes = match selection.regimes.as_slice() {
        [one] => format!("regime {}", one.name()),
        several => format!("{} regimes", several.len()),
    };
    format!(
        "Contact geometry of two beams: closed form against automatic differentiation\n\
         seed {seed:#x}, {regimes}, {} cases each, {family}\n{}\n\
         first: delta and Delta; second: Delta-delta; symmetry: second, with the\n\
         directions exchanged; matrix: gradient and Hessian times the directions\n",
        selection.cases,
        planted(plant)
    )
}

fn cells(checked: &Checked, show: impl Fn(&Cell) -> String) -> String {
    let cells = &checked.summary.cells;
    if cells.is_empty() {
        return String::new();
    }
    let mut table = Table::new(&[&["quantity"], &Order::ALL.map(Order::name)[..]].concat());
    for quantity in Quantity::ALL {
        let of = |order| cells.get(&(quantity, order)).map_or_else(|| "-".into(), &show);
        table.row([quantity.name().into()].into_iter().chain(Order::ALL.map(of)).collect());
    }
    table.to_string()
}

fn regimes(checked: &Checked) -> String {
    let titles = ["regime", "cases", "inside", "at ends", "differ", "error", "case", "of tol."];
    let mut table = Table::new(&titles);
    for (regime, tally) in &checked.summary.regimes {
        let counts =
            [tally.cases, tally.interior, tally.at_end, tally.mismatches].map(|count| count.to_string());
        let worst = match tally.worst.entries {
            0 => ["-"; 3].map(String::from),
            _ => [
                error(tally.worst.scaled_error),
                case_of(&tally.worst).unwrap_or_else(|| "-".into()),
                error(tally.worst.over_tolerance),
            ],
        };
        table.row([regime.name().into()].into_iter().chain(counts).chain(worst).collect());
    }
    table.to_string()
}

fn coverage(checked: &Checked) -> String {
    let of = Family::ALL.len().pow(2);
    format!(
        "Families: closest points compared; {} of {of} ordered pairs of families",
        checked.summary.pairs.len()
    )
}

fn families(checked: &Checked) -> String {
    let mut table = Table::default().left(&[0, 2, 4]);
    for families in Family::ALL.chunks(3) {
        let count = |family| checked.summary.families.get(family).copied().unwrap_or(0).to_string();
        table.row(families.iter().flat_map(|family| [family.name().into(), count(family)]).collect());
    }
    table.to_string()
}

fn not_compared(checked: &Checked) -> String {
    let mut table = Table::new(&["reason", "count", "first case"]);
    let reasons = reasons(checked);
    for (reason, (count, case)) in &reasons {
        table.row(vec![reason.reason().into(), count.to_string(), case.to_string()]);
    }
    if reasons.is_empty() { String::new() } else { table.to_string() }
}

/// What the third oracle was asked.
fn differences(checked: &Checked) -> String {
    let Differences { points, unclear, decided } = checked.summary.differences;
    if points == 0 {
        return String::new();
    }
    format!(
        "  asked at {points} closest points; of {unclear} where the tolerance for AD means nothing,\n  \
         they decided {decided}\n"
    )
}

/// Why closest points or cases were not compared, over all regimes.
fn reasons(checked: &Checked) -> BTreeMap<Inconclusive, (u64, u64)> {
    let mut reasons = BTreeMap::new();
    for (&reason, &(count, case)) in checked.summary.regimes.values().flat_map(|tally| &tally.inconclusive) {
        let sum = reasons.entry(reason).or_insert((0, case));
        *sum = (sum.0 + count, sum.1.min(case));
    }
    reasons
}

/// The quantity with its component.
pub(super) fn name(entry: &Comparison) -> String {
    entry
        .axis
        .map_or_else(|| entry.quantity.name().into(), |axis| format!("{}.{axis}", entry.quantity.name()))
}

/// The command that shows one case again.
pub(super) fn repeat(seed: u64, number: u64) -> String {
    format!("beamgap check --seed {seed:#x} --case {number}")
}

/// Two digits.
pub(super) fn error(error: f64) -> String {
    if error == 0.0 { "0".into() } else { format!("{error:.1e}") }
}

/// The case that showed the worst error, if there was an error.
fn case_of(cell: &Cell) -> Option<String> {
    (cell.scaled_error > 0.0).then(|| cell.case.to_string())
}

#[cfg(test)]
mod tests {
    use super::super::check::{Checked, verdict};
    use super::super::exit::Exit;
    use super::super::json;
    use super::{document, name};
    use beamgap::check::{
        Case, Cell, Comparison, Family, Finding, Inconclusive, Order, Regime, Selection, Shrunk, Summary,
        Tally, Trial, Verdict, compare,
    };
    use beamgap::linearization::Quantity;
    use std::collections::BTreeMap;

    fn shown(summary: Summary) -> (Exit, String) {
        let selection = Selection { regimes: Regime::ALL.to_vec(), family: None, cases: 1_000_000 };
        let verdict = verdict(&summary);
        let text = document(
            &Checked { plant: Vec::new(), seed: u64::MAX, selection, summary, shrunk: Vec::new() },
            &verdict,
        );
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
        (verdict.exit, text)
    }

    #[test]
    fn the_largest_run_fits_a_terminal() {
        let worst = Cell { scaled_error: 1e-12, case: 51_857_137, over_tolerance: 1e-12, entries: 1 };
        let count = 1_000_000;
        let tally = Tally {
            cases: count,
            interior: count,
            at_end: count,
            mismatches: count,
            worst,
            inconclusive: BTreeMap::from([(Inconclusive::Unresolved, (count, worst.case))]),
        };
        let cells = Quantity::ALL.iter().flat_map(|&q| Order::ALL.map(|order| ((q, order), worst)));
        shown(Summary {
            cells: cells.collect(),
            regimes: Regime::ALL.map(|regime| (regime, tally.clone())).into(),
            families: Family::ALL.map(|family| (family, 18 * count)).into(),
            ..Summary::default()
        });
    }

    #[test]
    fn a_disagreement_is_shown_with_the_command_that_repeats_it() {
        let case = Case::draw(u64::MAX, 17);
        let mut points = compare(&Trial::default(), &case);
        let Verdict::Pass(mut entries) = points.remove(0).1 else { panic!("case 17 is a plain one") };
        let of_x = |entry: &&mut Comparison| name(entry) == "x.x" && entry.part == "value";
        for entry in entries.iter_mut().filter(of_x) {
            entry.other *= 1.0 + 1e-3;
        }
        let wrong = (None, Verdict::Mismatch(entries.clone()));
        let (exit, text) = shown(Summary::of(&case, &[wrong]));
        assert_eq!(exit, Exit::Disagree);
        assert!(text.contains("by differences in double-double: undecided"), "{text}");
        let told = "beamgap check --seed 0xffffffffffffffff --case 17\n";
        assert!(text.contains(told) && text.contains("value of x.x (value), against"), "{text}");
        assert!(text.contains("DISAGREE: 1 of 1 closest point"), "{text}");

        // One route of AD alone is off: the routes contradict each other, and the closed form is not accused.
        let route = entries[0].against;
        for entry in entries.iter_mut().filter(|entry| name(entry) == "x.x" && entry.against != route) {
            entry.other = entry.closed;
        }
        let (exit, text) = shown(Summary::of(&case, &[(None, Verdict::Mismatch(entries))]));
        assert_eq!(exit, Exit::Untrusted);
        assert!(
            text.contains("by differences in double-double: automatic differentiation is wrong"),
            "{text}"
        );
        assert!(text.contains("UNTRUSTED: in 1 case"), "{text}");
    }

    #[test]
    fn a_disagreement_made_small_is_a_test_and_a_command() {
        let case = Case::draw(u64::MAX, 17).written();
        let (point, Verdict::Pass(mut entries)) = case.compare(&Trial::default()).unwrap().remove(0) else {
            panic!("case 17 is a plain one")
        };
        let wrong = entries.iter_mut().find(|entry| entry.quantity == Quantity::Xi && entry.part == "Delta");
        wrong.unwrap().closed += 1.0;
        let finding = Finding::of(&vec![(point, Verdict::Mismatch(entries))]).unwrap();
        let shrunk = vec![Shrunk { number: 17, finding, case }];
        let (seed, selection) = (1, Selection { regimes: Vec::new(), family: None, cases: 1 });
        let plant = Vec::new();
        let checked = Checked { plant, seed, selection, summary: Summary::default(), shrunk };
        let text = document(&checked, &verdict(&checked.summary));
        assert!(
            text.contains("\n// From case 17: Delta of xi (first) is the first wrong number.\n#[test]\n"),
            "{text}"
        );
        assert!(text.contains("(&pair, &q, point, &dq, &linear_dq).xi.linear;\n"), "{text}");
        assert!(
            text.contains("\n}\necho '{") && text.contains("}' | beamgap check --case-file -\n"),
            "{text}"
        );
        let told: serde_json::Value =
            serde_json::from_str(&json::document(&checked, &verdict(&checked.summary)).unwrap()).unwrap();
        let told = &told["shrunk"][0];
        assert_eq!(
            (&told["quantity"], &told["part"], &told["case"]),
            (&"xi".into(), &"Delta".into(), &17.into())
        );
        for pasted in ["test", "repeat"] {
            assert!(text.contains(told[pasted].as_str().unwrap()), "{pasted}");
        }
        assert_eq!(told["shrunk"]["beam"]["family"], "segment");
    }

    #[test]
    fn nothing_at_all_is_no_agreement() {
        assert_eq!(shown(Summary::default()).0, Exit::Nothing);
    }
}
