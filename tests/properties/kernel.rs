//! The blocks of the kernel equal the matrices: exactly over a prime field, within the rounding of both in `f64`.

use crate::bounded::{exact_dofs, parameters};
use crate::pairs::{Contacting, Movable, contacting, hermite, quadratic};
use beamgap::closest_point::Held;
use beamgap::curve::{BSpline, Hermite, Quadratic, Segment};
use beamgap::linearization::closed_form::formulation::{Distance, System};
use beamgap::linearization::closed_form::kernel::{DistanceAlone, Full, WithSlips, WithoutSlips};
use beamgap::linearization::closed_form::{Formulation, Matrices, Points, jets};
use beamgap::linearization::{Derivatives, Linearization};
use beamgap::number::{PrimeField, Real};
use beamgap::pair::{Contact, DofVector, Pair};
use nalgebra::{Rotation3, SVector, Unit, Vector3};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

/// The formulation for small angles.
const ROBUST: Formulation = Formulation {
    held: Held { xi: false, xi_bar: false },
    distance: Distance::Normal { reversed: false },
    system: System::CrossProducts,
};

impl Movable<12> for BSpline<4> {
    const POINTS: &'static [usize] = &[0, 3, 6, 9];
}

/// The request of all quantities except the slips, in one layout.
pub(crate) fn without_slips<W>([d, xi, xi_bar, t, t_bar]: &mut [W; 5]) -> WithoutSlips<'_, W> {
    WithoutSlips { d, xi, xi_bar, t, t_bar }
}

/// The request of all quantities, in one layout.
fn with_slips<W>([d, xi, xi_bar, t, t_bar, g_t, g_t_bar]: &mut [W; 7]) -> WithSlips<'_, W> {
    WithSlips { d, xi, xi_bar, t, t_bar, g_t, g_t_bar }
}

/// Value, gradient and Hessian.
pub(crate) fn flat<T: Real, const S: usize>(full: &Full<T, S>) -> Vec<T> {
    [&[full.value], &full.gradient[..], full.hessian.as_flattened()].concat()
}

/// The operations of the kernel in `f64`, over any scalar.
fn by_blocks<T: Real, A: Movable<N>, B: Movable<M>, const N: usize, const M: usize, const S: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    form: Formulation,
) -> [Vec<T>; 7] {
    let mut full = [Full::<T, S>::zeros(); 7];
    assert!(pair.write_over(q, at, form, with_slips(&mut full)));
    full.each_ref().map(flat)
}

/// The same quantities by the matrices.
fn by_matrices<T: Real, A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    form: Formulation,
) -> [Vec<T>; 7] {
    let (jet, jet_bar) = jets(pair, q, at);
    let Linearization { d, xi, xi_bar, t, t_bar, g_t, g_t_bar, .. } =
        Matrices::in_formulation(&jet, &jet_bar, form).all(at, &pair.contact);
    [d, xi, xi_bar, t, t_bar, g_t, g_t_bar].map(flat_expansion)
}

/// The same quantities in blocks.
pub(crate) fn flat_expansion<T: Real, const N: usize, const M: usize>(
    quantity: Derivatives<T, N, M>,
) -> Vec<T> {
    let mut all = vec![quantity.value];
    all.extend((0..N + M).map(|i| quantity.gradient.entry(i)));
    let entries = |i| (0..N + M).map(move |j| (i, j));
    all.extend((0..N + M).flat_map(entries).map(|(i, j)| quantity.hessian.entry(i, j)));
    all
}

/// The blocks are exact for any dofs, after the bar beam is moved so that the point is stationary.
fn equal_over_a_prime_field<A, B, const N: usize, const M: usize, const S: usize>(
    pair: &Pair<A, B, N, M>,
    numbers: &[u64],
    held: Held,
) where
    A: Movable<N>,
    B: Movable<M>,
{
    let mut numbers = numbers.iter().map(|&number| PrimeField::new(number));
    let mut next = || numbers.next().unwrap();
    let beam = SVector::<PrimeField, N>::from_fn(|_, _| next());
    let bar = SVector::<PrimeField, M>::from_fn(|_, _| next());
    let at = (next(), next());
    let (x, x_bar) = (pair.curve.jet(&beam, at.0).geometry, pair.curve_bar.jet(&bar, at.1).geometry);
    let w = Vector3::new(next(), next(), next());
    let normal_to = |t: &Vector3<PrimeField>| w - t * (w.dot(t) / t.dot(t));
    let d = match (held.xi, held.xi_bar) {
        (false, false) => x.t.cross(&x_bar.t) * w.x,
        (true, false) => normal_to(&x_bar.t),
        (false, true) => normal_to(&x.t),
        (true, true) => w,
    };
    // A length needs a square root, which exists in the field in one of two cases.
    if ![d, x.t, x_bar.t, x.t.cross(&x_bar.t)].iter().all(|v| v.dot(v).is_square()) {
        return;
    }
    let mut q = DofVector { beam, bar };
    for &start in A::POINTS {
        for c in 0..3 {
            q.beam[start + c] += (d - (x.x - x_bar.x))[c];
        }
    }
    let robust = Formulation { held, ..ROBUST };
    let regular = Formulation { system: System::Determinants, ..robust };
    for form in [Formulation::paper(held), robust, robust.reversed(), regular, regular.reversed()] {
        let blocks = by_blocks::<_, _, _, N, M, S>(pair, &q, at, form);
        assert!(blocks == by_matrices(pair, &q, at, form), "{form:?}");
        let (mut alone, mut all) = (Full::<_, S>::zeros(), [Full::<_, S>::zeros(); 5]);
        assert!(
            pair.write_over(&q, at, form, DistanceAlone { d: &mut alone }) && flat(&alone) == blocks[0],
            "{form:?}"
        );
        assert!(pair.write_over(&q, at, form, without_slips(&mut all)), "{form:?}");
        assert!(all.iter().zip(&blocks).all(|(one, other)| flat(one) == *other), "{form:?}");
    }
}

/// The formulation that loses the fewest digits.
fn form_at<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    Contacting { pair, q, point, .. }: &Contacting<A, B, N, M>,
) -> Formulation {
    let (jet, jet_bar) = jets(pair, q, (point.xi, point.xi_bar));
    Formulation::at(&Points::new(&jet.geometry, &jet_bar.geometry), point.held())
}

/// Rotates the bar beam about d until the tangents are at `angle`, and moves the beam along d until the gap is `gap`.
pub(crate) fn brought_near<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    case: &Contacting<A, B, N, M>,
    angle: f64,
    gap: f64,
) -> Contacting<A, B, N, M> {
    let Contacting { pair, q, point, .. } = case;
    let (jet, jet_bar) = jets(pair, q, (point.xi, point.xi_bar));
    let Points { beam, bar, d } = Points::new(&jet.geometry, &jet_bar.geometry);
    let axis = Unit::new_normalize(d);
    let now = beam.t.cross(&bar.t).dot(&axis).atan2(beam.t.dot(&bar.t));
    let turn = Rotation3::from_axis_angle(&axis, angle - now);
    let mut near = case.clone();
    for start in (0..M).step_by(3) {
        let v = near.q.bar.fixed_rows::<3>(start).into_owned();
        let turned = if B::POINTS.contains(&start) { bar.x + turn * (v - bar.x) } else { turn * v };
        near.q.bar.fixed_rows_mut::<3>(start).copy_from(&turned);
    }
    near.q.beam = A::moved(&q.beam, &(d * (gap / d.norm() - 1.0)));
    near
}

/// Twice the error bounds of the kernel's operations at the exact closest point, of d, xi, xi_bar, t, t_bar and the
/// slips in the order of [`flat`]: the maximum difference of two evaluations of the same numbers.
pub(crate) fn tolerances<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize, const S: usize>(
    case: &Contacting<A, B, N, M>,
) -> [Vec<f64>; 7] {
    let Contacting { pair, q, point, .. } = case;
    let q = exact_dofs(q);
    let at = parameters(pair, &q, (point.xi, point.xi_bar), point.held());
    by_blocks::<_, _, _, N, M, S>(pair, &q, at, form_at(case))
        .map(|numbers| numbers.into_iter().map(|number| 2.0 * number.bound).collect())
}

/// The blocks are within the sum of the running error bounds. Returns the largest bound, relative to the largest entry.
fn equal_within_rounding<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize, const S: usize>(
    case: &Contacting<A, B, N, M>,
) -> f64 {
    let Contacting { pair, q, point, .. } = case;
    let mut all = [Full::<f64, S>::zeros(); 7];
    pair.write(q, point, with_slips(&mut all));
    let form = form_at(case);
    let q = exact_dofs(q);
    let at = parameters(pair, &q, (point.xi, point.xi_bar), point.held());
    let (ours, theirs) = (by_blocks::<_, _, _, N, M, S>(pair, &q, at, form), by_matrices(pair, &q, at, form));
    let mut widest = 0.0_f64;
    for (i, fast) in all.iter().enumerate() {
        let largest = theirs[i].iter().fold(0.0_f64, |largest, x| largest.max(x.value.abs()));
        for ((x, ours), theirs) in flat(fast).iter().zip(&ours[i]).zip(&theirs[i]) {
            let tolerance = ours.bound + theirs.bound;
            assert!((x - theirs.value).abs() <= tolerance, "quantity {i}: {x:e}, {theirs:?}, {tolerance:e}");
            widest = widest.max(tolerance / (1.0 + largest));
        }
    }
    widest
}

/// In 19 of 20 cases, which are fixed, the bounds are less than `useful`, so the comparison is meaningful.
fn narrow<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize, const S: usize>(
    cases: impl Strategy<Value = Contacting<A, B, N, M>>,
    useful: f64,
) {
    let mut runner = TestRunner::deterministic();
    let mut draw = || cases.new_tree(&mut runner).unwrap().current();
    let mut widths: Vec<f64> = (0..200).map(|_| equal_within_rounding::<_, _, N, M, S>(&draw())).collect();
    widths.sort_by(f64::total_cmp);
    assert!(widths[190] < useful, "{:e}", widths[190]);
}

/// Pairs at angles of 0.05 or more and gaps of 2^-20 or more.
fn near() -> impl Strategy<Value = Contacting<Quadratic, Hermite, 9, 12>> {
    let inside = contacting(quadratic(), hermite()).prop_filter("inside", |case| case.point.is_interior());
    (inside, 0.05..1.5_f64, 0.0..20.0_f64)
        .prop_map(|(case, angle, gap)| brought_near(&case, angle, f64::exp2(-gap)))
}

#[test]
fn bounds_are_narrow() {
    narrow::<_, _, 9, 12, 21>(contacting(quadratic(), hermite()), 1e-6);
    narrow::<_, _, 9, 12, 21>(near(), 1e-3);
}

fn pair<A, B, const N: usize, const M: usize>(curve: A, curve_bar: B) -> Pair<A, B, N, M> {
    Pair { curve, curve_bar, contact: Contact { xi_0: 0.25, xi_bar_0: -0.5, ..Contact::default() } }
}

fn numbers() -> impl Strategy<Value = (Vec<u64>, Held)> {
    let held = (0.0..1.0, any::<bool>(), any::<bool>())
        .prop_map(|(inside, xi, xi_bar)| if inside < 0.5 { Held::default() } else { Held { xi, xi_bar } });
    (proptest::collection::vec(any::<u64>(), 64), held)
}

proptest! {
    #[test]
    fn exactly_hermite_and_quadratic((numbers, held) in numbers()) {
        let pair = pair(Hermite::scaled_by(3.0), Quadratic::new());
        equal_over_a_prime_field::<_, _, 12, 9, 21>(&pair, &numbers, held);
    }

    #[test]
    fn exactly_segment_and_spline((numbers, held) in numbers()) {
        let spline = BSpline::<4>::new(&[0.0, 0.25, 1.0, 1.5, 2.0, 3.0]).unwrap();
        equal_over_a_prime_field::<_, _, 6, 12, 18>(&pair(Segment::new(), spline), &numbers, held);
    }

    /// 9 dofs are not a multiple of the vector length.
    #[test]
    fn within_rounding(case in contacting(quadratic(), hermite())) {
        equal_within_rounding::<_, _, 9, 12, 21>(&case);
    }

    /// The same is true where digits cancel in the paper's formulation, and another one is chosen.
    #[test]
    fn within_rounding_at_small_gaps_and_angles(case in near()) {
        equal_within_rounding::<_, _, 9, 12, 21>(&case);
    }
}
