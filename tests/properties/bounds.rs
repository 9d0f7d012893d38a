//! The rounding errors do not exceed the error bounds that the check uses.
//!
//! `beamgap bounds` runs the same test for 100,000 cases.

use crate::program::{json, run};
use beamgap::check::{Bounds, Order, Regime, Selection, Side, bounds};

fn measured(seed: u64) -> Bounds {
    bounds(seed, &Selection { regimes: Regime::ALL.to_vec(), family: None, cases: 1000 }, || ())
}

/// Compares with the closed form in double-double, for all sides, in every order and every regime.
#[test]
fn no_error_exceeds_its_bound() {
    let found = measured(0xb0d);
    assert!(found.violations.is_empty(), "{:?}", found.violations);
    for regime in Regime::ALL {
        assert!(found.points[&regime].measured >= 990, "{regime:?} {:?}", found.points[&regime]);
        for side in Side::ALL {
            // A contact element has a residual and a tangent.
            let orders = [Order::Value, Order::First, Order::Second];
            for order in orders.into_iter().skip(usize::from(side == Side::Element)) {
                let measured = &found.regimes[&(side, order)][&regime];
                assert!(measured.entries > 1000, "{regime:?} {side:?} {order:?}: {measured:?}");
                // The smallest overestimation factor is at least one, and `f64` has rounding errors.
                assert!(measured.overestimation.unwrap().min >= 1.0);
                assert!(measured.error.unwrap().max > 1e-17);
            }
        }
    }
}

#[test]
fn bounds_do_not_depend_on_threads() {
    let of = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let selection = Selection { regimes: Regime::ALL.to_vec(), family: None, cases: 5 };
        pool.install(|| bounds(1, &selection, || ()))
    };
    assert_eq!(of(1), of(2));
}

/// A drawn badly-scaled case.
const ROUNDING_OF_XI_BAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/rounding_of_xi_bar.json");

/// A case in which the tolerance is attained: the error is 0.99999 of it.
///
/// The beams are 1e4 and 3e7 long. The rounding of xi_bar has more effect on the closed form than all other rounding. The
/// exact variations were computed with 60 digits at the root of d·t_bar = 0, found with 60 digits.
#[test]
fn an_error_comes_near_its_bound_where_one_rounding_is_all_of_it() {
    let case = json(&run(&["check", "--case-file", ROUNDING_OF_XI_BAR, "--format", "json"]));
    let entries = case["closest_points"][1]["entries"].as_array().unwrap();
    for (part, exact) in [("delta", 0.890_245_528_622_911_4), ("Delta", 0.782_330_472_645_806_6)] {
        let is_own = |against: &str| against == "own hyper-dual, chord";
        let entry = entries.iter().find(|entry| {
            entry["quantity"] == "d" && entry["part"] == part && is_own(entry["against"].as_str().unwrap())
        });
        let of = |key: &str| entry.unwrap()[key].as_f64().unwrap();
        assert!((of("other") - exact).abs() < 1e-15, "{entry:?}");
        let share = (of("closed") - exact).abs() / of("bound");
        assert!(share > 0.9999 && share < 1.0 / (1.0 + f64::exp2(-20.0)), "{share}");
        assert!(of("difference") / of("tolerance") < 1.0 / (1.0 + f64::exp2(-20.0)), "{entry:?}");
    }
}
