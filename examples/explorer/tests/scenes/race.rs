//! The scene of Newton's method.

use super::{chosen, number, text};
use beamgap_explorer::spectral_radius;

#[test]
fn newton_needs_the_iterations_that_the_derivation_states() {
    let words = |tangent| text(&chosen("race", &[("tangent", tangent)]), "wrong_words");
    assert_eq!(words("exact"), "4 iterations");
    assert_eq!(words("no_curvature"), "13 iterations");
    assert!(words("frozen").starts_with("stops") && words("sign_a").starts_with("stops"));
}

const ERRORS: [&str; 7] =
    ["no_curvature", "sign_curvature", "no_normal", "sign_b", "sign_right", "sign_a", "frozen"];

/// A run: its iterations if it converges, its gap and that of the exact run, and its spectral radius.
fn run(tangent: &str, push: &str) -> (Option<u32>, [String; 2], f64) {
    let last = chosen("race", &[("tangent", tangent), ("push", push), ("iteration", "300")]);
    let words = text(&last, "wrong_words");
    let iterations = words.strip_suffix(" iterations").and_then(|n| n.parse().ok());
    (
        iterations,
        ["gap", "gap_exact"].map(|name| text(&last, name)),
        spectral_radius(tangent, push.parse().unwrap()).unwrap(),
    )
}

/// The spectral radius tells which errors ruin Newton's method, at every push. Which ones do depends on the push.
#[test]
fn a_wrong_tangent_costs_iterations_or_ruins_the_method() {
    for (push, ruinous) in [
        ("0.2", &[][..]),
        ("0.3", &[]),
        ("0.4", &["sign_a"]),
        ("0.5", &["sign_a"]),
        ("0.6", &["sign_a", "frozen"]),
        ("0.7", &["sign_a", "frozen"]),
        ("0.8", &["sign_a", "frozen"]),
        ("0.9", &["sign_a", "frozen"]),
        ("1.0", &["sign_b", "sign_a", "frozen"]),
    ] {
        for tangent in ERRORS {
            let (iterations, [gap, exact], radius) = run(tangent, push);
            let is_ruined = ruinous.contains(&tangent);
            assert_eq!(radius > 1.0, is_ruined, "{tangent} {push}: {radius}");
            if (tangent, push) == ("sign_b", "1.0") {
                // It leaves the equilibrium and finds another one.
                assert!(iterations.is_some() && gap != exact, "{gap}");
            } else {
                assert_eq!(iterations.is_none(), is_ruined, "{tangent} {push}");
                assert!(is_ruined || gap == exact, "{tangent} {push}: {gap} and {exact}");
            }
        }
        assert!(run("exact", push).2 < 1e-9, "{push}");
    }
}

/// What the answer says of the pushes 0.2 and 0.8.
#[test]
fn a_small_push_hides_a_wrong_tangent() {
    let slowest = ERRORS.into_iter().max_by_key(|tangent| run(tangent, "0.2").0).unwrap();
    assert_eq!(slowest, "sign_a");
    for tangent in ERRORS {
        let [small, large] = ["0.2", "0.8"].map(|push| run(tangent, push).0);
        assert!(large.is_none_or(|n| small.unwrap() < n), "{tangent}");
    }
    // The observed factor is the spectral radius, for the runs that are long enough.
    for tangent in ["no_normal", "sign_b", "sign_right"] {
        let run = chosen("race", &[("tangent", tangent), ("push", "0.8")]);
        let radius = spectral_radius(tangent, 0.8).unwrap();
        assert!((number(&run, "factor") - radius).abs() < 0.02, "{tangent}: {radius}");
    }
}
