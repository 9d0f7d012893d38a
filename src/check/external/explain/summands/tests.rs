//! The summands are complete.

use crate::check::Regime;
use crate::check::evaluation_point::SummandError;
use crate::check::external::Drawing;
use crate::test_beam::Family;
use crate::variant::Variant;

/// The summands of each sum in lists. Summands that are parts of others are in another list of the same sum.
const COMPLETE: [(usize, &[&[&str]]); 6] = [
    (18, &[&["P: G'A1", "P: A1'G", "P: G't,xi g'", "P: g (G't,xi)'"], &REST_OF_P]),
    (
        18,
        &[
            &["P: A0'A1", "P: A1'A0", "P: B0'A1", "P: A1'B0"],
            &["P: A0't,xi g'", "P: g (A0't,xi)'", "P: B0't,xi g'", "P: g (B0't,xi)'"],
            &REST_OF_P,
        ],
    ),
    (15, &[&["H_d: A0'A0", "H_d: A0'B0", "H_d: B0'A0", "H_d: G'nn'G", "H_d: G't g'", "H_d: A1'd g'"]]),
    (
        15,
        &[&[
            "H_d: G'G",
            "H_d: G'nn'G",
            "H_d: t.t gg'",
            "H_d: d.t,xi gg'",
            "H_d: b gg_bar'",
            "H_d: b g_bar g'",
        ]],
    ),
    (
        16,
        &[
            &["H_t: w.t,xi H_xi", "H_t: w.t,xixi gg'", "H_t: A2'w g'", "H_t: g (A2'w)'", "H_t: A1'A1"],
            &["H_t: A1't,xi g'", "H_t: g (A1't,xi)'", "H_t: t,xi.t,xi gg'", "H_t: grad t grad t'"],
        ],
    ),
    (21, &[&["H_g_T: slip H_t", "H_g_T: t H_xi", "H_g_T: grad t g'", "H_g_T: g grad t'"]]),
];

/// The summands of P without G.
const REST_OF_P: [&str; 13] = [
    "P: A1't g'",
    "P: g (A1't)'",
    "P: A1't_bar g_bar'",
    "P: g_bar (A1't_bar)'",
    "P: B1't g_bar'",
    "P: g_bar (B1't)'",
    "P: A2'd g'",
    "P: g (A2'd)'",
    "P: t.t,xi gg'",
    "P: t.t_bar,xi g_bar g_bar'",
    "P: t_bar.t,xi g_bar g'",
    "P: t_bar.t,xi g g_bar'",
    "P: d.t,xixi gg'",
];

#[test]
fn the_summands_of_a_hessian_add_up_to_it() {
    let drawing = Drawing {
        seed: 11,
        regimes: vec![Regime::Generic, Regime::NearEnd],
        families: vec![Family::Hermite, Family::Quadratic],
        cases: 12,
        penetrating: false,
    };
    let mut count = 0;
    for vector in (0..12).map(|k| drawing.vector(k)) {
        let compared = vector.evaluated(|evaluation| {
            let (plain, scales) =
                (evaluation.plain(&Variant::Unmodified), evaluation.sized(&Variant::Unmodified));
            let summands = evaluation.summands();
            for (component, names) in COMPLETE {
                let is_listed = |name: &str| names.iter().any(|names| names.contains(&name));
                let sum: f64 = summands
                    .iter()
                    .filter(|(of, _)| of.error == SummandError::Factor && is_listed(of.label.name))
                    .map(|(of, increment)| f64::from(of.count) * increment[component][2])
                    .sum();
                let (second, scale) = (plain[component].second, scales[component].second.scale);
                assert!(
                    (sum - second).abs() <= 1e-9 * scale,
                    "{component}, {}: {sum:e} {second:e}",
                    vector.id
                );
            }
        });
        count += usize::from(compared.is_ok());
    }
    assert!(count >= 8, "{count}");
}
