//! The tests that the check prints compile and pass.

use crate::program::golden;
use beamgap::check::{CaseData, CheckConfig, Comparison, Family, TestBeam, Verdict, test_source};
use beamgap::pair::Contact;
use std::fmt::Write;

include!("../golden/pasted.rs");

/// A case with few short numbers: a curve of this family above a straight one.
fn small(family: Family) -> CaseData {
    let node = |x: f64| [x, 0.0, 0.25 * x * x];
    let points = |nodes: &[f64]| nodes.iter().flat_map(|&x| node(x)).collect::<Vec<_>>();
    let hermite = [&node(-1.0)[..], &[1.0, 0.0, -0.5], &node(1.0), &[1.0, 0.0, 0.5]].concat();
    let (parameters, q) = match family {
        Family::Segment => (vec![], points(&[-1.0, 1.0])),
        Family::Quadratic => (vec![], points(&[-1.0, 0.0, 1.0])),
        Family::Cubic => (vec![], points(&[-1.0, -0.5, 0.5, 1.0])),
        Family::Hermite => (vec![], hermite),
        Family::HermiteScaled => (vec![2.0], hermite),
        Family::Bezier => (vec![], points(&[-1.0, -0.5, -0.5, 0.5, 0.5, 1.0])),
        Family::BSpline => (vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0], points(&[-3.0, -1.0, 1.0, 3.0])),
        Family::Nurbs => (vec![0.0, 1.0, 2.0, 3.0, 1.0, 0.5, 2.0], points(&[-2.0, 0.0, 2.0])),
        Family::NurbsWeighted => {
            let weighted = [(-3.0, 1.0), (-1.0, 2.0), (1.0, 1.0), (3.0, 0.5)];
            let q = weighted.iter().flat_map(|&(x, w)| [&node(x)[..], &[w]].concat()).collect();
            (vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0], q)
        }
        Family::Arc => (vec![0.75], vec![0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, -1.5]),
        Family::Helix => (vec![0.75], vec![0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.5, -1.5]),
    };
    let directed = |family, parameters, q: Vec<f64>| {
        let direction =
            |step: u32| (0..).map(|i| f64::from(i * step % 5) / 4.0 - 0.5).take(q.len()).collect();
        TestBeam { family, parameters, dq: direction(2), linear_dq: direction(3), q }
    };
    let bar = directed(Family::Segment, vec![], vec![0.25, -1.0, -0.5, 0.25, 1.0, -0.5]);
    let contact = Contact { xi_bar_0: 0.5, ..Contact::default() };
    CaseData { test_beams: [directed(family, parameters, q), bar], contact }
}

#[test]
fn tests_to_be_pasted_are_the_golden_ones() {
    let mut text = String::new();
    for (k, family) in Family::ALL.into_iter().enumerate() {
        let mut case = small(family);
        if k % 2 == 1 {
            case.test_beams.reverse();
        }
        let compared = case.compare(&CheckConfig::default()).unwrap();
        let (minimum, entries) = compared
            .iter()
            .enumerate()
            .find_map(
                |(i, (_, verdict))| {
                    if let Verdict::Pass(entries) = verdict { Some((i, entries)) } else { None }
                },
            )
            .unwrap_or_else(|| panic!("{compared:?}"));
        // The cases take all kinds of entries one after another.
        let entry: &Comparison = &entries[(k * 29 + 9) % entries.len()];
        let name = family.name().replace('-', "_");
        let _ = writeln!(text, "mod {name} {{\n{}}}", test_source(&case, minimum, entry, None));
    }
    // Only the function for d alone has these numbers.
    let case = small(Family::Hermite);
    let compared = case.compare(&CheckConfig::default()).unwrap();
    let of_d =
        compared[0].1.entries().iter().filter(|entry| entry.against == "write DistanceAlone, 12 + 6 dofs");
    for entry in of_d.filter(|entry| ["value", "Delta-delta"].contains(&entry.part)) {
        let name = entry.part.replace('-', "_").to_lowercase();
        let _ = writeln!(text, "mod d_alone_{name} {{\n{}}}", test_source(&case, 0, entry, None));
    }
    for needed in [
        "DistanceAlone",
        "Route::Newton",
        "Route::Stationary",
        "Route::Chord",
        "linearize",
        "&linear_dq, &dq",
    ] {
        assert!(text.contains(needed), "{needed}");
    }
    // The tolerance depends on how the formulas are written, so it is not compared.
    let blind = |text: &str| {
        let tolerance =
            |line: &str| line.split_once(" <= ").map_or(line.into(), |(before, _)| before.to_owned());
        text.lines().map(tolerance).collect::<Vec<_>>().join("\n")
    };
    golden("pasted.rs", &text, blind);
}
