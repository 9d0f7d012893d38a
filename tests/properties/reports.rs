//! The reports state what was found and measured, and nothing else.

mod claims;

use crate::program::guides;
use beamgap::check::external::Naming;
use beamgap::check::{self, CheckConfig, Regime, Selection};
use beamgap::prove::prove;
use beamgap::report::{
    Accuracy, BeamProblems, Bounds, Crosscheck, Derivation, Elements, Environment, Equations, Explain,
    Faults, Record, Verify, front_page, picture, symbols,
};
use beamgap::test_beam::Family;
use beamgap::variant::Variant;
use claims::{claims, count};
use std::fs;
use std::path::Path;

pub(crate) fn committed(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Compares a page with the committed one; `BEAMGAP_BLESS=1` writes it instead.
pub(crate) fn is_committed(name: &str, text: &str) {
    if std::env::var_os("BEAMGAP_BLESS").is_some() {
        fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join("reports").join(name), text).unwrap();
    }
    assert!(text == committed(name), "{name} is stale: BEAMGAP_BLESS=1 writes it again");
}

#[test]
fn committed_pages_are_what_the_committed_records_render_to() {
    let crosscheck = Crosscheck::from_json(&committed("crosscheck.json")).unwrap();
    is_committed("crosscheck.md", &crosscheck.page().to_markdown());
    let bounds = Bounds::from_json(&committed("bounds.json")).unwrap();
    is_committed("bounds.md", &bounds.page().to_markdown());
    let accuracy = Accuracy::from_json(&committed("accuracy.json")).unwrap();
    is_committed("accuracy.md", &accuracy.page().to_markdown());
    is_committed("accuracy-gap.svg", &accuracy.gap_to_svg());
    is_committed("accuracy-angle.svg", &accuracy.angle_to_svg());
    let faults = Faults::from_json(&committed("faults.json")).unwrap();
    is_committed("faults.md", &faults.page().to_markdown());
    let equations = Equations::from_json(&committed("equations.json")).unwrap();
    is_committed("equations.md", &equations.page().to_markdown());
    let derivation = Derivation::from_json(&committed("derivation.json")).unwrap();
    is_committed("derivation.html", &derivation.to_html(&equations.table, Some(&accuracy)).unwrap());
    is_committed("symbols.md", &symbols().to_markdown());
    let explain = Explain::from_json(&committed("explain.json")).unwrap();
    is_committed("explain.md", &explain.page().to_markdown());
    for program in explain.programs.iter().filter(|program| !program.kinds.is_empty()) {
        for naming in Naming::ALL {
            let of_kinds: usize = program.kinds.iter().map(|kind| kind.count(&[naming])).sum();
            assert_eq!(of_kinds, program.count(naming), "{}", naming.name());
        }
    }
    let verified = Verify::from_json(&committed("verify.json")).unwrap();
    is_committed("verify.md", &verified.page().to_markdown());
    is_committed("beams.svg", &picture().unwrap());
    let problems = BeamProblems::from_json(&committed("beam-problems.json")).unwrap();
    is_committed("beam-problems.md", &problems.page().to_markdown());
    for (name, svg) in problems.pictures() {
        is_committed(&name, &svg);
    }
    let elements = Elements::from_json(&committed("elements.json")).unwrap();
    is_committed("elements.md", &elements.page().to_markdown());
}

#[test]
fn the_story_of_the_documentation_is_what_its_text_renders_to() {
    is_committed("../src/front_page.md", &front_page().unwrap());
}

#[test]
fn committed_records_are_written_again_as_they_are() {
    let json = committed("crosscheck.json");
    assert!(Crosscheck::from_json(&json).unwrap().to_json().unwrap() == json);
    let json = committed("bounds.json");
    assert!(Bounds::from_json(&json).unwrap().to_json().unwrap() == json);
    let json = committed("faults.json");
    assert!(Faults::from_json(&json).unwrap().to_json().unwrap() == json);
    let json = committed("accuracy.json");
    assert!(Accuracy::from_json(&json).unwrap().to_json().unwrap() == json);
}

/// The results of the report, the check and the proof depend on the seed only, not on the number of threads.
#[test]
fn threads_do_not_matter() {
    let selection = Selection { regimes: Regime::ALL.to_vec(), family: None, cases: 40 };
    let found = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let (summary, proof) = pool.install(|| {
            (
                check::run(&CheckConfig::default(), 7, &selection, || ()),
                prove(&Variant::Unmodified, 7, &Family::ALL[..4], 16, || ()),
            )
        });
        let record = Crosscheck::new(summary.clone(), 7, 40, Environment::here("none")).to_json().unwrap();
        (summary, proof, record)
    };
    let one = found(1);
    assert!(one == found(2) && one == found(5));
}

/// README and the guides state what the checks found, in words made from their records.
#[test]
fn the_guides_claim_what_was_found() {
    let words = guides().split_whitespace().collect::<Vec<_>>().join(" ");
    for claim in claims() {
        assert!(words.contains(&claim), "README.md or docs are to say:\n{claim}");
    }
}

/// No report but the table of the equations is longer; details are in the records.
#[test]
fn reports_are_short() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports");
    for entry in fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        if Path::new(&name).extension() == Some("md".as_ref()) && name != "equations.md" {
            assert!(entry.metadata().unwrap().len() <= 12_000, "{name}");
        }
    }
}

#[test]
fn the_mutants_are_counted_as_they_are_listed() {
    let record: serde_json::Value = serde_json::from_str(&committed("mutants.json")).unwrap();
    let rows = |list: &str| record[list].as_array().unwrap();
    let sum = |list, of: &str| rows(list).iter().map(|row| row[of].as_u64().unwrap()).sum::<u64>();
    for of in ["tried", "caught", "timeouts", "survived", "unviable"] {
        assert_eq!(sum("areas", of), sum("files", of), "{of}");
    }
    let (caught, survived) = (sum("files", "caught"), sum("files", "survived"));
    assert_eq!(rows("survivors").len() as u64, survived);
    let all = caught + survived;
    #[expect(clippy::cast_precision_loss, reason = "the counts are small")]
    let share = 100.0 * caught as f64 / all as f64;
    let claim = format!("{} of {} changes of the code, {share:.1} %", count(caught), count(all));
    assert!(committed("mutants.md").contains(&claim), "mutants.md is to say: {claim}");
}

#[test]
fn the_readme_is_short() {
    let readme = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md")).unwrap();
    assert!(readme.lines().count() <= 150);
}

/// The links of the documents in the packaged crate lead to files in it.
#[test]
fn links_hold_in_the_packaged_crate() {
    let root = env!("CARGO_MANIFEST_DIR");
    let list = ["package", "--list", "--offline", "--allow-dirty", "--package", "beamgap"];
    let output = std::process::Command::new(env!("CARGO")).args(list).current_dir(root).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let listed = String::from_utf8(output.stdout).unwrap();
    // Those of `src` are documentation, whose links rustdoc verifies.
    let is_page =
        |path: &&str| Path::new(path).extension() == Some("md".as_ref()) && !path.starts_with("src/");
    let documents = listed.lines().filter(is_page).collect::<Vec<_>>();
    assert!(documents.contains(&"README.md"), "{listed}");
    for document in documents {
        let text = fs::read_to_string(Path::new(root).join(document)).unwrap();
        let folder = document.rsplit_once('/').map_or("", |(folder, _)| folder);
        for (_, after) in text.match_indices("](").map(|(at, _)| text[at..].split_at(2)) {
            let target = after.split([')', '#']).next().unwrap();
            let target = match target.strip_prefix("../") {
                Some(target) => target.to_owned(),
                None => format!("{folder}/{target}").trim_matches('/').to_owned(),
            };
            let is_there = |path: &str| path == target || path.starts_with(&format!("{target}/"));
            let is_outside = target.is_empty() || target.contains("://");
            assert!(is_outside || listed.lines().any(is_there), "{document} links to {target}");
        }
    }
}

/// The packages that users of the library compile, without this one.
#[test]
fn the_guides_count_packages() {
    let packages = |features: &[&str]| {
        let tree =
            ["tree", "--offline", "--package", "beamgap", "--edges", "normal,build", "--prefix", "none"];
        let mut cargo = std::process::Command::new(env!("CARGO"));
        let output =
            cargo.args([&tree, features].concat()).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8(output.stdout).unwrap();
        let name_and_version = |line: &str| line.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
        text.lines().map(name_and_version).collect::<std::collections::BTreeSet<_>>().len() - 1
    };
    let [alone, with_check, all] =
        [&["--no-default-features"][..], &["--no-default-features", "--features", "check"], &[]]
            .map(packages);
    let words = guides().split_whitespace().collect::<Vec<_>>().join(" ");
    for claim in [
        format!("The dependency has the formulas alone, with {alone} other packages."),
        format!("with {with_check} other packages. The command line has {all}."),
    ] {
        assert!(words.contains(&claim), "docs/library.md is to say:\n{claim}");
    }
}

#[test]
fn the_compared_points_lie_on_both_sides_of_every_symmetry() {
    let crosscheck = Crosscheck::from_json(&committed("crosscheck.json")).unwrap();
    for (regime, tally) in &crosscheck.found.regimes {
        assert_eq!(tally.coverage.counts.len(), check::Symmetry::ALL.len());
        for (&symmetry, counts) in &tally.coverage.counts {
            let share = tally.coverage.share(symmetry).unwrap();
            assert!(share >= 0.35, "{}: {} is {counts:?}", regime.name(), symmetry.name());
        }
    }
}

/// Every situation of a contact element is compared in every regime, but for both ends: there are regimes without such pairs.
#[test]
fn contact_elements_are_compared_in_every_situation() {
    let crosscheck = Crosscheck::from_json(&committed("crosscheck.json")).unwrap();
    let rare = check::ContactSituation::BothHeld;
    let mut of_both = 0;
    for (regime, tally) in &crosscheck.found.regimes {
        of_both += tally.elements.get(&rare).map_or(0, |cells| cells.tangent.entries);
        for situation in check::ContactSituation::ALL.into_iter().filter(|&situation| situation != rare) {
            let cells = tally.elements.get(&situation).copied().unwrap_or_default();
            let least = cells.residual.entries.min(cells.tangent.entries);
            assert!(least >= 200, "{}: {} has {least} numbers", regime.name(), situation.name());
        }
    }
    assert!(of_both >= 1000, "{of_both}");
}
