//! The closed form and automatic differentiation agree.

use super::beams::{Case, HELD, LAWS, Movable, STATES, Valued, Wish, differences, numbers};
use crate::contact::{State, Work};
use crate::curve::{Arc, Bezier, Helix, Hermite, NurbsWeighted, Segment};
use crate::number::{Differentiable, DoubleDouble, Extends};

/// Compares one case; returns the differences of R and K.
fn compare<A, B, T, const N: usize, const M: usize>(curve: A, curve_bar: B, wish: Wish, seed: u32) -> [f64; 2]
where
    A: Movable<N>,
    B: Movable<M>,
    T: Valued + Differentiable,
    T::Dual: Differentiable,
    <T::Dual as Differentiable>::Dual: Extends<T>,
{
    let case: Case<A, B, T, N, M> = Case::new(curve, curve_bar, wish, numbers(seed));
    let decision = case.decision();
    let expected = match wish.state {
        State::Stick | State::Slip if wish.held.xi && wish.held.xi_bar => State::Frictionless,
        state => state,
    };
    assert_eq!(decision.state, expected, "{wish:?}");
    let (closed, values) = case.closed(&decision);
    if expected != State::Open {
        assert!(values.f_n.value_of() > 0.0, "{wish:?}");
    }
    differences(&closed, &case.by_ad(&decision))
}

/// All ends, states, laws and works of a pair of families.
fn worst<A, B, T, const N: usize, const M: usize>(curve: A, curve_bar: B, every: usize) -> [[f64; 2]; 4]
where
    A: Movable<N>,
    B: Movable<M>,
    T: Valued + Differentiable,
    T::Dual: Differentiable,
    <T::Dual as Differentiable>::Dual: Extends<T>,
{
    let mut worst = [[0.0_f64; 2]; 4];
    let mut count = 0;
    for held in HELD {
        for (state, worst) in STATES.into_iter().zip(&mut worst) {
            for law in LAWS {
                for (work, factor) in
                    [(Work::Rate, 1.0), (Work::Paper, 1.0), (Work::Rate, -0.25), (Work::Paper, 0.0)]
                {
                    count += 1;
                    // A contact at an end has no normal at d = 0. Crossed beams are not open.
                    let skipped =
                        factor == 0.0 && (held.xi || held.xi_bar) || factor < 1.0 && state == State::Open;
                    if skipped || count % every != 0 {
                        continue;
                    }
                    let mut wish = Wish::new(held, state, law);
                    wish.distance *= factor;
                    wish.parameters.work = work;
                    if count % 3 == 0 {
                        // A large slip.
                        wish.slip *= 16.0;
                        wish.parameters.mu *= if state == State::Stick { 64.0 } else { 1.0 };
                    }
                    let seed = u32::try_from(count).unwrap();
                    let [r, k] = compare::<A, B, T, N, M>(curve, curve_bar, wish, seed);
                    *worst = [worst[0].max(r), worst[1].max(k)];
                }
            }
        }
    }
    worst
}

/// Prints and checks the worst differences of the states.
fn check(name: &str, worst: [[f64; 2]; 4], tolerance: f64) {
    println!("{name}: {:?}", worst.map(|of| of.map(|x| format!("{x:.1e}"))));
    assert!(worst.as_flattened().iter().all(|&difference| difference <= tolerance), "{name}: {worst:?}");
}

#[test]
fn in_double_precision() {
    let knots = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0];
    let weighted = NurbsWeighted::<4>::new(&knots).unwrap();
    check("Hermite, Hermite", worst::<_, _, f64, 12, 12>(Hermite::new(), Hermite::new(), 1), 1e-13);
    check("Segment, Segment", worst::<_, _, f64, 6, 6>(Segment::new(), Segment::new(), 1), 1e-13);
    check("Bezier, Hermite", worst::<_, _, f64, 12, 12>(Bezier::<4>::new(), Hermite::new(), 2), 1e-13);
    check("Arc, Helix", worst::<_, _, f64, 9, 10>(Arc::new(0.7), Helix::new(0.6), 2), 1e-13);
    check("Segment, NurbsWeighted", worst::<_, _, f64, 6, 16>(Segment::new(), weighted, 2), 1e-13);
}

#[test]
fn in_double_double() {
    check("Hermite", worst::<_, _, DoubleDouble, 12, 12>(Hermite::new(), Hermite::new(), 5), 1e-29);
    check("Arc, Segment", worst::<_, _, DoubleDouble, 9, 6>(Arc::new(0.7), Segment::new(), 5), 1e-29);
}
