//! The blocks are the matrices: exactly over a prime field, within the rounding of both in `f64`, in every layout.

#![expect(clippy::float_cmp, reason = "layouts hold the same bits")]
#![expect(clippy::large_stack_arrays, reason = "five quantities of 21 dofs")]

use crate::pairs::{Contacting, Movable, any_arc, contacting, hermite, quadratic};
use beamgap::closest_point::Active;
use beamgap::curve::{BSpline, Hermite, Quadratic, Segment};
use beamgap::linearization::closed_form::blocks::{
    Full, Gradient, Packed, Targets, write_all, write_all_over, write_d, write_d_batch,
};
use beamgap::linearization::closed_form::{Form, Matrices, Points, Projection, Sound, jets};
use beamgap::linearization::{Expansion, Linearization};
use beamgap::number::{Bounded, Lanes, Real, Residue};
use beamgap::pair::{Contact, DofVector, Pair};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;

impl Movable<12> for BSpline<4> {
    const POINTS: &'static [usize] = &[0, 3, 6, 9];
}

/// All quantities in one layout.
fn targets<W>([d, xi, xi_bar, t, t_bar]: &mut [W; 5]) -> Targets<'_, W> {
    Targets { d, xi, xi_bar, t, t_bar }
}

/// Value, gradient and Hessian.
fn flat<T: Real, const S: usize>(full: &Full<T, S>) -> Vec<T> {
    [&[full.value], &full.gradient[..], full.hessian.as_flattened()].concat()
}

/// The very operations of `f64` over any scalar.
fn in_form<T: Real, A: Movable<N>, B: Movable<M>, const N: usize, const M: usize, const S: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    active: Active,
) -> [Vec<T>; 5] {
    let mut full = [Full::<T, S>::zeros(); 5];
    assert!(write_all_over(pair, q, at, active, &mut targets(&mut full)));
    full.each_ref().map(flat)
}

/// The same by the matrices.
fn by_matrices<T: Real, A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    active: Active,
) -> [Vec<T>; 5] {
    let (jet, jet_bar) = jets(pair, q, at);
    let Linearization { d, xi, xi_bar, t, t_bar, .. } =
        Matrices::new(&jet, &jet_bar, active).all(at, &pair.contact);
    [d, xi, xi_bar, t, t_bar].map(flat_expansion)
}

/// The same of blocks.
fn flat_expansion<T: Real, const N: usize, const M: usize>(quantity: Expansion<T, N, M>) -> Vec<T> {
    let mut all = vec![quantity.value];
    all.extend((0..N + M).map(|i| quantity.gradient.entry(i)));
    let entries = |i| (0..N + M).map(move |j| (i, j));
    all.extend((0..N + M).flat_map(entries).map(|(i, j)| quantity.hessian.entry(i, j)));
    all
}

/// Whatever the dofs, once the bar beam is moved to where the point is stationary.
fn equal_over_a_prime_field<A, B, const N: usize, const M: usize, const S: usize>(
    pair: &Pair<A, B>,
    numbers: &[u64],
    active: Active,
) where
    A: Movable<N>,
    B: Movable<M>,
{
    let mut numbers = numbers.iter().map(|&number| Residue::new(number));
    let mut next = || numbers.next().unwrap();
    let beam = SVector::<Residue, N>::from_fn(|_, _| next());
    let bar = SVector::<Residue, M>::from_fn(|_, _| next());
    let at = (next(), next());
    let (x, x_bar) = (pair.curve.jet(&beam, at.0).geometry, pair.curve_bar.jet(&bar, at.1).geometry);
    let w = Vector3::new(next(), next(), next());
    let normal_to = |t: &Vector3<Residue>| w - t * (w.dot(t) / t.dot(t));
    let d = match (active.xi, active.xi_bar) {
        (false, false) => x.t.cross(&x_bar.t) * w.x,
        (true, false) => normal_to(&x_bar.t),
        (false, true) => normal_to(&x.t),
        (true, true) => w,
    };
    // A length is a number of the field in one of two cases.
    if ![d, x.t, x_bar.t].iter().all(|v| v.dot(v).is_square()) {
        return;
    }
    let mut q = DofVector { beam, bar };
    for &start in A::POINTS {
        for c in 0..3 {
            q.beam[start + c] += (d - (x.x - x_bar.x))[c];
        }
    }
    assert!(
        in_form::<_, _, _, N, M, S>(pair, &q, at, active) == by_matrices(pair, &q, at, active),
        "{active:?}"
    );
}

/// How far a parameter may be from that of the exact closest point.
fn parameters<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    case: &Contacting<A, B, N, M>,
) -> (Bounded, Bounded) {
    let Contacting { pair, q, point, .. } = case;
    let q = DofVector { beam: q.beam.map(Bounded::from), bar: q.bar.map(Bounded::from) };
    let (jet, jet_bar) = jets(pair, &q, (point.xi.into(), point.xi_bar.into()));
    let (x, x_bar) = (jet.geometry, jet_bar.geometry);
    let residual = [x.t, x_bar.t].map(|t| (x.x - x_bar.x).dot(&t)).map(|f| f.value.abs() + f.bound);
    let [step, step_bar] = Projection::new(&x, &x_bar, point.active())
        .inverse()
        .map(|row| 2.0 * row.into_iter().zip(residual).map(|(entry, f)| entry.value.abs() * f).sum::<f64>());
    (Bounded::new(point.xi, step), Bounded::new(point.xi_bar, step_bar))
}

/// The blocks that users get are within both running bounds of the matrices.
fn equal_within_rounding<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize, const S: usize>(
    case: &Contacting<A, B, N, M>,
) {
    let Contacting { pair, q, point, .. } = case;
    let mut fast = [Full::<f64, S>::zeros(); 5];
    write_all(pair, q, point, &mut targets(&mut fast));
    let q = DofVector { beam: q.beam.map(Bounded::from), bar: q.bar.map(Bounded::from) };
    let (at, active) = (parameters(case), point.active());
    let (ours, theirs) =
        (in_form::<_, _, _, N, M, S>(pair, &q, at, active), by_matrices(pair, &q, at, active));
    for (i, fast) in fast.iter().enumerate() {
        let largest = theirs[i].iter().fold(0.0_f64, |largest, x| largest.max(x.value.abs()));
        for ((x, ours), theirs) in flat(fast).iter().zip(&ours[i]).zip(&theirs[i]) {
            let tolerance = ours.bound + theirs.bound;
            assert!((x - theirs.value).abs() <= tolerance, "quantity {i}: {x:e}, {theirs:?}, {tolerance:e}");
            // The bounds are bounds of something.
            assert!(tolerance < 1e-6 * (1.0 + largest), "quantity {i}: {tolerance:e} of {largest:e}");
        }
    }
}

fn pair<A, B>(curve: A, curve_bar: B) -> Pair<A, B> {
    Pair { curve, curve_bar, contact: Contact::default() }
}

fn numbers() -> impl Strategy<Value = (Vec<u64>, Active)> {
    let active = (0.0..1.0, any::<bool>(), any::<bool>()).prop_map(|(inside, xi, xi_bar)| {
        if inside < 0.5 { Active::default() } else { Active { xi, xi_bar } }
    });
    (proptest::collection::vec(any::<u64>(), 64), active)
}

proptest! {
    #[test]
    fn exactly_hermite_and_quadratic((numbers, active) in numbers()) {
        let pair = pair(Hermite::scaled_by(3.0), Quadratic::new());
        equal_over_a_prime_field::<_, _, 12, 9, 21>(&pair, &numbers, active);
    }

    #[test]
    fn exactly_segment_and_spline((numbers, active) in numbers()) {
        let spline = BSpline::<4>::new(&[0.0, 0.25, 1.0, 1.5, 2.0, 3.0]).unwrap();
        equal_over_a_prime_field::<_, _, 6, 12, 18>(&pair(Segment::new(), spline), &numbers, active);
    }

    /// 9 dofs are no multiple of what is taken at once.
    #[test]
    fn within_rounding(case in contacting(quadratic(), hermite())) {
        equal_within_rounding::<_, _, 9, 12, 21>(&case);
    }

    #[test]
    fn layouts_agree(case in contacting(quadratic(), hermite())) {
        let Contacting { pair, q, point, .. } = &case;
        let (mut full, mut blocks) = ([Full::<f64, 21>::zeros(); 5], [Expansion::zero(); 5]);
        let (mut packed, mut gradient) = ([Packed::<f64, 21, 231>::zeros(); 5], [Gradient::<f64, 21>::zeros(); 5]);
        write_all(pair, q, point, &mut targets(&mut full));
        write_all(pair, q, point, &mut targets(&mut blocks));
        write_all(pair, q, point, &mut targets(&mut packed));
        write_all(pair, q, point, &mut targets(&mut gradient));
        for (i, full) in full.iter().enumerate() {
            let values = [blocks[i].value, packed[i].value, gradient[i].value];
            prop_assert_eq!(values, [full.value; 3]);
            prop_assert!(packed[i].gradient == full.gradient && gradient[i].gradient == full.gradient);
            for (j, row) in full.hessian.iter().enumerate() {
                prop_assert_eq!(blocks[i].gradient.entry(j), full.gradient[j]);
                for (k, entry) in row.iter().enumerate() {
                    // Either triangle was written; what differs is the order of sums.
                    let rounding = 1e-12 * row.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
                    prop_assert!((packed[i].entry(j, k) - entry).abs() <= rounding.max(1e-12));
                    prop_assert!((blocks[i].hessian.entry(j, k) - entry).abs() <= rounding.max(1e-12));
                    if k <= j {
                        prop_assert_eq!(packed[i].entry(j, k), *entry);
                        // Matrices lie in memory by their columns.
                        prop_assert_eq!(blocks[i].hessian.entry(k, j), *entry);
                    }
                }
            }
        }
        let mut d = Full::<f64, 21>::zeros();
        write_d(pair, q, point, &mut d);
        prop_assert!(d == full[0], "d alone is d");
    }

    /// Each lane is its pair, the last four and those at an end of a beam among them; whatever is too long is left.
    #[test]
    fn batches(cases in proptest::collection::vec(contacting(hermite(), hermite()), 1..=6)) {
        let pair = &cases[0].pair;
        let (q, points): (Vec<_>, Vec<_>) = cases.iter().map(|case| (case.q, case.point)).unzip();
        let mut lanes = [Packed::<Lanes, 24, 300>::zeros(); 2];
        prop_assert_eq!(write_d_batch(pair, &q, &points, &mut lanes), cases.len());
        prop_assert_eq!(write_d_batch(pair, &q, &points, &mut lanes[..1]), cases.len().min(4));
        for (i, case) in cases.iter().enumerate() {
            let (of_four, lane) = (&lanes[i / 4], i % 4);
            let mut one = Packed::<f64, 24, 300>::zeros();
            write_d(pair, &case.q, &case.point, &mut one);
            let largest = one.hessian.iter().fold(one.value, |largest, x| largest.max(x.abs()));
            let both = [(of_four.value, one.value)].into_iter()
                .chain(of_four.gradient.into_iter().zip(one.gradient))
                .chain(of_four.hessian.into_iter().zip(one.hessian));
            for (four, one) in both {
                prop_assert!((four.0[lane] - one).abs() <= 1e-12 * largest, "{:e}, {:e} of {:e}", four.0[lane], one, largest);
            }
        }
    }

    /// Curves without shape functions are linearized all the same.
    #[test]
    fn curves_without_shape_functions(case in contacting(hermite(), any_arc())) {
        let Contacting { pair, q, point, .. } = &case;
        let mut full = [Full::<f64, 21>::zeros(); 5];
        write_all(pair, q, point, &mut targets(&mut full));
        let at = (point.xi, point.xi_bar);
        let (jet, jet_bar) = jets(pair, q, at);
        let form = Form::at(&Points::new(&jet.geometry, &jet_bar.geometry), point.active());
        let Linearization::<f64, 12, 9> { d, xi, xi_bar, t, t_bar, .. } =
            Matrices::with(Sound, &jet, &jet_bar, form).all(at, &pair.contact);
        prop_assert_eq!(full.each_ref().map(flat), [d, xi, xi_bar, t, t_bar].map(flat_expansion));
    }
}
