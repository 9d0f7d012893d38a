//! The rounding errors do not exceed the error bounds that the check uses.
//!
//! `beamgap bounds` runs the same test for 100,000 cases.

use beamgap::check::{Bounds, Order, Regime, Selection, Side, bounds};

fn measured(seed: u64) -> Bounds {
    bounds(seed, &Selection { regimes: Regime::ALL.to_vec(), family: None, cases: 1000 }, || ())
}

/// Compares with the closed form in double-double, for both sides, in every order and every regime.
#[test]
fn no_error_exceeds_its_bound() {
    let found = measured(0xb0d);
    assert!(found.violations.is_empty(), "{:?}", found.violations);
    for regime in Regime::ALL {
        assert!(found.points[&regime].measured >= 990, "{regime:?} {:?}", found.points[&regime]);
        for side in Side::ALL {
            for order in [Order::Value, Order::First, Order::Second] {
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
