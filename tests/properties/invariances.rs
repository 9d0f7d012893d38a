//! Results do not depend on the choice of coordinates, units or names.

#![expect(clippy::float_cmp, reason = "multiplying by a power of two is exact, and claimed to be")]

use crate::bounded::{exact, exact_dofs, is_near, linearized, linearized_case, scalars};
use crate::pairs::{Contacting, Movable, contacting, hermite, refined, segment};
use crate::strategies::vector;
use beamgap::check::{Case, CheckConfig, Compared, Comparison, Verdict};
use beamgap::closest_point::{ClosestPoint, Held};
use beamgap::curve::{Bezier, Hermite};
use beamgap::linearization::{Derivatives, Linearization, Quantity};
use beamgap::number::RunningError;
use beamgap::pair::{Contact, DofVector, Pair};
use nalgebra::{Matrix3, SVector, Vector3};
use proptest::prelude::*;

type HermitePair = Contacting<Hermite, Hermite, 12, 12>;
type Dofs<const N: usize, const M: usize> = DofVector<RunningError, N, M>;

fn linearized_in_f64(case: &HermitePair) -> Linearization<f64, 12, 12> {
    *case.pair.linearize(&case.q, &case.point)
}

fn all_derivatives<const N: usize, const M: usize>(
    l: &Linearization<f64, N, M>,
) -> [&Derivatives<f64, N, M>; 7] {
    [&l.d, &l.t, &l.t_bar, &l.xi, &l.xi_bar, &l.g_t, &l.g_t_bar]
}

/// Applies a 3 x 3 matrix to every control vector.
fn apply<const N: usize>(
    matrix: &Matrix3<RunningError>,
    q: &SVector<RunningError, N>,
) -> SVector<RunningError, N> {
    let mut turned = *q;
    for i in (0..N).step_by(3) {
        turned.fixed_rows_mut::<3>(i).copy_from(&(matrix * q.fixed_rows::<3>(i)));
    }
    turned
}

fn apply_both(matrix: &Matrix3<RunningError>, q: &Dofs<12, 12>) -> Dofs<12, 12> {
    DofVector { beam: apply(matrix, &q.beam), bar: apply(matrix, &q.bar) }
}

fn moved(case: &HermitePair, q: DofVector<f64, 12, 12>) -> HermitePair {
    let at = (case.point.xi, case.point.xi_bar);
    let point = refined(&case.pair, &q, at, case.point.held()).expect("the moved point is stationary too");
    Contacting { q, point, ..case.clone() }
}

fn translation(by: &Vector3<f64>) -> Dofs<12, 12> {
    let of_beam = exact(&Hermite::moved(&SVector::zeros(), by));
    DofVector { beam: of_beam, bar: of_beam }
}

/// The product H v.
fn times(e: &Derivatives<RunningError, 12, 12>, v: &Dofs<12, 12>) -> Vec<RunningError> {
    (0..24).map(|i| e.hessian.along(&DofVector::unit(i), v)).collect()
}

/// A rotation whose entries are fractions of small integers, so that only the division rounds.
fn rotation([a, b, c, d]: [i8; 4]) -> Matrix3<RunningError> {
    let [a, b, c, d] = [a, b, c, d].map(f64::from);
    let entries = [
        [a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)],
        [2.0 * (b * c + a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d - a * b)],
        [2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a - b * b - c * c + d * d],
    ];
    let norm = RunningError::from(a * a + b * b + c * c + d * d);
    Matrix3::from_fn(|i, j| RunningError::from(entries[i][j]) / norm)
}

/// Whether the number is zero within rounding.
fn is_zero(x: RunningError) -> bool {
    is_near(x, RunningError::from(0.0))
}

/// The same test for verdicts: all pairs of families in all regimes, in units from 2^-40 to 2^40.
#[test]
fn scaling_by_powers_of_two_scales_every_comparison_of_the_gate() {
    // Each regime, each pair of families and each power occurs.
    for (number, power) in (0..1089).zip((-40..=40).cycle()).step_by(4) {
        let case = Case::draw(0x5eed, number);
        let scaled = case.data().scaled(power).compare(&CheckConfig::default()).unwrap();
        assert!(
            scaled == in_unit(&case.data().compare(&CheckConfig::default()).unwrap(), power),
            "case {number}, 2^{power}"
        );
    }
}

/// The expected comparison of the check in a unit of 2^-power.
fn in_unit(compared: &Compared, power: i32) -> Compared {
    let unit = 2.0_f64.powi(power);
    let entries = |entries: &[Comparison]| {
        let scaled = |entry: &Comparison| {
            // The variation of a length has the unit of a length, because the directions have it.
            let unit = match (entry.quantity, entry.part) {
                (Quantity::Xi | Quantity::XiBar, _) => 1.0,
                // The force of a contact element has the unit of a length, because the stiffness is given.
                (_, part) if part.starts_with("residual") || part.starts_with("tangent") => unit * unit,
                _ => unit,
            };
            let mut scaled = *entry;
            let Comparison { closed, other, scale, bound, tolerance, .. } = &mut scaled;
            for number in [closed, other, scale, bound, tolerance] {
                *number *= unit;
            }
            scaled
        };
        entries.iter().map(scaled).collect()
    };
    let scaled = |(point, verdict): &(Option<ClosestPoint>, Verdict)| {
        let point = point.map(|mut point| {
            point.distance *= unit;
            point
        });
        let verdict = match verdict {
            Verdict::Pass(compared) => Verdict::Pass(entries(compared)),
            Verdict::Mismatch(compared) => Verdict::Mismatch(entries(compared)),
            Verdict::Inconclusive(reason, compared) => Verdict::Inconclusive(*reason, entries(compared)),
        };
        (point, verdict)
    };
    compared.iter().map(scaled).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// d -> x, G -> R G, H -> R H Rᵀ: contracted with rotated directions nothing changes.
    #[test]
    fn rigid_motion_changes_nothing(
        case in contacting(hermite(), hermite()),
        quaternion in proptest::array::uniform4(-5..=5_i8).prop_filter("not zero", |q| *q != [0; 4]),
        by in vector::<3>(),
    ) {
        let Contacting { pair, q, point, dq, linear_dq } = &case;
        let (rotation, near) = (rotation(quaternion), (point.xi, point.xi_bar));
        let turned = apply_both(&rotation, &exact_dofs(q)).plus(RunningError::from(1.0), &translation(&by));
        let (before, after) = (linearized_case(&case), linearized(pair, &turned, near, point.held()));
        let directions = [dq, linear_dq].map(exact_dofs);
        let turned = directions.each_ref().map(|dq| apply_both(&rotation, dq));
        for (x, y) in scalars(&before).into_iter().zip(scalars(&after)) {
            let numbers = |e: &Derivatives<RunningError, 12, 12>, [dq, linear_dq]: &[Dofs<12, 12>; 2]| {
                [e.value, e.gradient.along(dq), e.hessian.along(dq, linear_dq)]
            };
            for (x, y) in numbers(x, &directions).into_iter().zip(numbers(y, &turned)) {
                prop_assert!(is_near(x, y), "{x:?} {y:?}");
            }
        }
    }

    /// The result does not depend on the names of the beams.
    #[test]
    fn swapping_the_beams_swaps_the_results(case in contacting(hermite(), segment())) {
        let Contacting { pair, q, point, .. } = &case;
        let Contact { radius, radius_bar, xi_0, xi_bar_0 } = pair.contact;
        let swapped = Pair {
            curve: pair.curve_bar,
            curve_bar: pair.curve,
            contact: Contact { radius: radius_bar, radius_bar: radius, xi_0: xi_bar_0, xi_bar_0: xi_0 },
        };
        let q_swapped = DofVector { beam: exact(&q.bar), bar: exact(&q.beam) };
        let held = Held { xi: point.held().xi_bar, xi_bar: point.held().xi };
        let one = linearized_case(&case);
        let two = linearized(&swapped, &q_swapped, (point.xi_bar, point.xi), held);
        let theirs = [&two.d, &two.t_bar, &two.t, &two.xi_bar, &two.xi, &two.g_t_bar, &two.g_t];
        for (x, y) in scalars(&one).into_iter().zip(theirs) {
            let index = |i: usize| if i < 12 { i + 6 } else { i - 12 };
            for i in 0..18 {
                prop_assert!(is_near(x.gradient.entry(i), y.gradient.entry(index(i))));
                for j in 0..18 {
                    let (a, b) = (x.hessian.entry(i, j), y.hessian.entry(index(i), index(j)));
                    prop_assert!(is_near(a, b), "{a:?} {b:?}");
                }
            }
        }
    }

    /// The result does not depend on the unit of length, to the last bit: d -> s d, and xi stays.
    #[test]
    fn scaling_by_powers_of_two_scales_exactly(case in contacting(hermite(), hermite()), power in -40_i32..=40) {
        let s = 2.0_f64.powi(power);
        // Both are solved from the same start, because a second solution may differ from the first in the last digit.
        let (case, scaled) = (moved(&case, case.q), moved(&case, case.q.times(s)));
        prop_assert_eq!((scaled.point.xi, scaled.point.xi_bar), (case.point.xi, case.point.xi_bar));
        let (before, after) = (linearized_in_f64(&case), linearized_in_f64(&scaled));
        // Value, gradient and Hessian of a length scale by s, 1 and 1/s. Those of a parameter scale by 1, 1/s and 1/s².
        for (i, (x, y)) in all_derivatives(&before).into_iter().zip(all_derivatives(&after)).enumerate() {
            let unit = if i == 3 || i == 4 { 1.0 } else { s };
            prop_assert_eq!(x.value * unit, y.value);
            for i in 0..24 {
                prop_assert_eq!(x.gradient.entry(i) * (unit / s), y.gradient.entry(i));
                for j in 0..24 {
                    prop_assert_eq!(x.hessian.entry(i, j) * (unit / s / s), y.hessian.entry(i, j));
                }
            }
        }
    }

    /// A rigid translation causes no variation: G . c = 0 and H c = 0.
    #[test]
    fn rigid_translations_are_annihilated(case in contacting(hermite(), hermite()), by in vector::<3>()) {
        let c = translation(&by);
        for e in scalars(&linearized_case(&case)) {
            prop_assert!(is_zero(e.gradient.along(&c)));
            prop_assert!(times(e, &c).into_iter().all(is_zero));
        }
    }

    /// A rigid rotation changes no scalar: G . (w x q) = 0, and H (w x q) = w x G.
    #[test]
    fn rigid_rotations_turn_the_gradient(case in contacting(hermite(), hermite()), w in vector::<3>()) {
        let spin = w.cross_matrix().map(RunningError::from);
        let turning = apply_both(&spin, &exact_dofs(&case.q));
        for e in scalars(&linearized_case(&case)) {
            prop_assert!(is_zero(e.gradient.along(&turning)));
            let expected = apply_both(&spin, &e.gradient);
            for (i, entry) in times(e, &turning).into_iter().enumerate() {
                prop_assert!(is_near(entry, expected.entry(i)));
            }
        }
    }

    /// Euler's theorem: degree 1 in q for lengths (G . q = v, H q = 0), degree 0 for parameters (G . q = 0, H q = -G).
    #[test]
    fn eulers_theorem_holds(case in contacting(hermite(), hermite())) {
        let (q, zero) = (exact_dofs(&case.q), RunningError::from(0.0));
        for (i, e) in scalars(&linearized_case(&case)).into_iter().enumerate() {
            let parameter = i == 3 || i == 4;
            let value = if parameter { zero } else { e.value };
            prop_assert!(is_near(e.gradient.along(&q), value));
            for (i, entry) in times(e, &q).into_iter().enumerate() {
                let expected = if parameter { -e.gradient.entry(i) } else { zero };
                prop_assert!(is_near(entry, expected));
            }
        }
    }

    /// The part of a Bezier curve over [-1, s], as a separate curve. xi changes; d and its variations do not change.
    #[test]
    fn an_affine_change_of_parameter_changes_no_distance(
        case in contacting(bezier(), bezier()).prop_filter("inside both", |case| case.point.held() == Held::default()),
        cut in 0.1..0.9_f64,
    ) {
        // The fraction of the curve that is kept; it extends beyond the point.
        let at = 0.5 * (1.0 + case.point.xi);
        let u = at + cut * (1.0 - at);
        let near = (2.0 * at / u - 1.0, case.point.xi_bar);
        let u = RunningError::from(u);
        let change = |q: &DofVector<f64, 12, 12>| DofVector { beam: split(&exact(&q.beam), u), bar: exact(&q.bar) };
        // The reference parameter of the slips has another value on the part, so the slips are not compared.
        let before = linearized_case(&case);
        let after = linearized(&case.pair, &change(&case.q), near, Held::default());
        let numbers = |e: &Derivatives<RunningError, 12, 12>, [dq, linear_dq]: [Dofs<12, 12>; 2]| {
            [e.value, e.gradient.along(&dq), e.hessian.along(&dq, &linear_dq)]
        };
        let ours = |e| numbers(e, [&case.dq, &case.linear_dq].map(exact_dofs));
        let theirs = |e| numbers(e, [&case.dq, &case.linear_dq].map(change));
        for (x, y) in [(&before.d, &after.d), (&before.xi_bar, &after.xi_bar), (&before.t_bar, &after.t_bar)] {
            for (x, y) in ours(x).into_iter().zip(theirs(y)) {
                prop_assert!(is_near(x, y), "{x:?} {y:?}");
            }
        }
        // ξ is covariant: 1 + ξ = u (1 + ξ'), and t shrinks with it.
        for (x, y) in ours(&before.xi).into_iter().zip(theirs(&after.xi)).skip(1) {
            prop_assert!(is_near(x, u * y), "{x:?} {y:?}");
        }
        for (x, y) in ours(&before.t).into_iter().zip(theirs(&after.t)) {
            prop_assert!(is_near(u * x, y), "{x:?} {y:?}");
        }
    }
}

fn bezier() -> impl Strategy<Value = (Bezier<4>, SVector<f64, 12>)> {
    vector().prop_map(|q| (Bezier::new(), q))
}

impl Movable<12> for Bezier<4> {
    const POINTS: &'static [usize] = &[0, 3, 6, 9];
}

/// De Casteljau's algorithm: the control points of the first part, up to the fraction `u`; linear in the points.
fn split(q: &SVector<RunningError, 12>, u: RunningError) -> SVector<RunningError, 12> {
    let mut points: Vec<Vector3<RunningError>> =
        (0..4).map(|i| q.fixed_rows::<3>(3 * i).into_owned()).collect();
    let mut part = SVector::<RunningError, 12>::zeros();
    for i in 0..4 {
        part.fixed_rows_mut::<3>(3 * i).copy_from(&points[0]);
        points =
            points.windows(2).map(|pair| pair[0] * (RunningError::from(1.0) - u) + pair[1] * u).collect();
    }
    part
}
