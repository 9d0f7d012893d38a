//! The exact results and their tolerances.
//!
//! The exact result is the closed form in double-double, at the closest point refined there. The tolerance of a result
//! is the sum of the running error bounds of both linearizations, that of the closed form and that of automatic
//! differentiation. The check uses the same tolerance, and none is tuned. The tolerance of the closest point itself
//! is twice the rounding of the orthogonality conditions, multiplied by the inverse of their matrix.

use super::error::Exact;
use super::input::{Input, TimedCurve};
use beamgap::closest_point::Held;
use beamgap::curve::{Curve, Geometry, Jet};
use beamgap::linearization::ad::{Chord, Perturbed, PositionAt};
use beamgap::linearization::closed_form::{PartialVariations, Projection, variations};
use beamgap::linearization::{COMPONENTS, Quantity, Varied};
use beamgap::number::{DoubleDouble, Dual, HyperDual, Real, RunningError};
use beamgap::pair::{Contact, DofVector, Pair};
use nalgebra::SVector;

/// The exact rows of a result.
pub(super) type Truth = Vec<Vec<Exact>>;

/// The indices in [`Quantities::components`](beamgap::linearization::Quantities::components) of the scalars d, xi,
/// xi_bar, t, t_bar, g_T and g_T_bar, in the order in which they are written and verified.
const SCALARS: [usize; 7] = [15, 18, 19, 16, 17, 21, 22];

/// A beam at its closest point, in the scalars of the exact result.
trait Side {
    /// In double-double, varied along two directions.
    fn precise(&self, along: [&[f64]; 2]) -> PartialVariations<DoubleDouble>;

    /// With running error bounds, varied along two directions.
    fn bounded(&self, along: [&[f64]; 2]) -> PartialVariations<RunningError>;

    /// With running error bounds and hyper-dual dofs.
    fn perturbed(&self, along: [&[f64]; 2]) -> Box<dyn PositionAt<Dual<HyperDual<RunningError>>> + '_>;
}

struct At<'a, C: Curve<N>, const N: usize> {
    curve: &'a C,
    q: SVector<f64, N>,
    precise: Jet<DoubleDouble, C::Dofs<DoubleDouble>>,
    bounded: Jet<RunningError, C::Dofs<RunningError>>,
}

impl<'a, C: Curve<N>, const N: usize> At<'a, C, N> {
    fn new(curve: &'a C, q: SVector<f64, N>, xi: DoubleDouble, near: RunningError) -> Self {
        let precise = curve.jet(&q.map(DoubleDouble::from), xi);
        Self { curve, q, precise, bounded: curve.jet(&q.map(RunningError::from), near) }
    }
}

fn vector<T: Real, const N: usize>(along: &[f64]) -> SVector<T, N> {
    SVector::from_fn(|i, _| T::from(along[i]))
}

impl<C: Curve<N>, const N: usize> Side for At<'_, C, N> {
    fn precise(&self, along: [&[f64]; 2]) -> PartialVariations<DoubleDouble> {
        let [dq, linear_dq] = along.map(vector);
        PartialVariations::new(&self.precise, &dq, &linear_dq)
    }

    fn bounded(&self, along: [&[f64]; 2]) -> PartialVariations<RunningError> {
        let [dq, linear_dq] = along.map(vector);
        PartialVariations::new(&self.bounded, &dq, &linear_dq)
    }

    fn perturbed(&self, along: [&[f64]; 2]) -> Box<dyn PositionAt<Dual<HyperDual<RunningError>>> + '_> {
        let q = SVector::from_fn(|i, _| {
            let [re, eps1, eps2, both] = [self.q[i], along[0][i], along[1][i], 0.0].map(RunningError::from);
            HyperDual::new(re, eps1, eps2, both)
        });
        Box::new(Perturbed { curve: self.curve, q })
    }
}

/// Both beams at their closest point.
struct EvaluationPoint<'a> {
    sides: [Box<dyn Side + 'a>; 2],
    xi: [DoubleDouble; 2],
    near: (RunningError, RunningError),
    chord: Chord<RunningError>,
    held: Held,
    contact: &'a Contact,
}

impl<'a> EvaluationPoint<'a> {
    fn new<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
        input: &'a Input<A, B, N, M>,
    ) -> Self {
        let Input { pair, q, point, .. } = input;
        let [(xi, near), (xi_bar, near_bar)] = parameters(input);
        let beam = Perturbed { curve: &pair.curve, q: q.beam.map(RunningError::from) };
        let bar = Perturbed { curve: &pair.curve_bar, q: q.bar.map(RunningError::from) };
        Self {
            sides: [
                Box::new(At::new(&pair.curve, q.beam, xi, near)),
                Box::new(At::new(&pair.curve_bar, q.bar, xi_bar, near_bar)),
            ],
            xi: [xi, xi_bar],
            near: (near, near_bar),
            chord: Chord::<RunningError>::new(&beam, &bar, (near, near_bar), point.held()),
            held: point.held(),
            contact: &pair.contact,
        }
    }

    /// All components with their variations along two directions, each given for beam and bar beam.
    fn along(&self, of_beam: [&[f64]; 2], of_bar: [&[f64]; 2]) -> [Varied<Exact>; COMPONENTS] {
        let Self { sides: [beam, bar], xi: [xi, xi_bar], near, held, contact, .. } = self;
        let partial = [beam.precise(of_beam), bar.precise(of_bar)];
        let precise = variations(&partial[0], &partial[1], (*xi, *xi_bar), *held, contact).components();
        let partial = [beam.bounded(of_beam), bar.bounded(of_bar)];
        let closed = variations(&partial[0], &partial[1], *near, *held, contact).components();
        let (beam, bar) = (beam.perturbed(of_beam), bar.perturbed(of_bar));
        let by_ad = self.chord.evaluate_by_orders(&*beam, &*bar, *near, contact);
        let by_ad = by_ad.map(Varied::from).components();
        let exact = |value, one: RunningError, other: RunningError| Exact {
            value,
            tolerance: one.bound + other.bound,
        };
        std::array::from_fn(|i| {
            let (precise, closed, by_ad) = (precise[i], closed[i], by_ad[i]);
            Varied {
                value: exact(precise.value, closed.value, by_ad.value),
                delta: exact(precise.delta, closed.delta, by_ad.delta),
                linear: exact(precise.linear, closed.linear, by_ad.linear),
                second: exact(precise.second, closed.second, by_ad.second),
            }
        })
    }
}

/// Values, gradients and Hessians of all scalars.
pub(super) fn all_derivatives<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    input: &Input<A, B, N, M>,
) -> Truth {
    let evaluation = EvaluationPoint::new(input);
    let unit = |i: usize| DofVector::<f64, N, M>::unit(i);
    let size = N + M;
    let pairs = (0..size).flat_map(|i| (i..size).map(move |j| (unit(i), unit(j))));
    let of_pair = |(one, other): (DofVector<f64, N, M>, DofVector<f64, N, M>)| {
        let of_bar = [one.bar.as_slice(), other.bar.as_slice()];
        evaluation.along([one.beam.as_slice(), other.beam.as_slice()], of_bar)
    };
    let entries: Vec<_> = pairs.map(of_pair).collect();
    // The upper triangle, row by row: row i starts after those of size, size - 1, .. entries.
    let at = |i: usize, j: usize| {
        let (i, j) = (i.min(j), i.max(j));
        &entries[i * (2 * size - i - 1) / 2 + j]
    };
    let of_scalar = |scalar: usize| {
        let hessian = (0..size).flat_map(|i| (0..size).map(move |j| (i, j)));
        [
            vec![at(0, 0)[scalar].value],
            (0..size).map(|i| at(i, i)[scalar].delta).collect(),
            hessian.map(|(i, j)| at(i, j)[scalar].second).collect(),
        ]
    };
    SCALARS.into_iter().flat_map(of_scalar).collect()
}

/// The four parts of each quantity, along the two directions of the input.
pub(super) fn directions<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    input: &Input<A, B, N, M>,
) -> Truth {
    let Input { dq, linear_dq, .. } = input;
    let varied = EvaluationPoint::new(input).along(
        [dq.beam.as_slice(), linear_dq.beam.as_slice()],
        [dq.bar.as_slice(), linear_dq.bar.as_slice()],
    );
    by_quantity(varied)
}

/// One row for each part of each quantity.
pub(super) fn by_quantity<T>(varied: [Varied<T>; COMPONENTS]) -> Vec<Vec<T>> {
    let mut rows: Vec<Vec<T>> = std::iter::repeat_with(Vec::new).take(4 * Quantity::ALL.len()).collect();
    for (i, component) in varied.into_iter().enumerate() {
        for (k, part) in component.parts().into_iter().enumerate() {
            rows[4 * (Quantity::of_component(i) as usize) + k].push(part);
        }
    }
    rows
}

/// xi and xi_bar.
pub(super) fn closest_point<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    input: &Input<A, B, N, M>,
) -> Truth {
    let exact = |(value, near): (DoubleDouble, RunningError)| Exact { value, tolerance: near.bound };
    vec![parameters(input).map(exact).to_vec()]
}

/// xi and xi_bar in double-double, and the values found in `f64` with their error bounds.
pub(super) fn parameters<A: TimedCurve<N>, B: TimedCurve<M>, const N: usize, const M: usize>(
    input: &Input<A, B, N, M>,
) -> [(DoubleDouble, RunningError); 2] {
    let Input { pair, q, point, .. } = input;
    let held = point.held();
    let (mut xi, mut xi_bar) = (DoubleDouble::from(point.xi), DoubleDouble::from(point.xi_bar));
    for _ in 0..STEPS {
        let [x, x_bar] = geometry(pair, q, (xi, xi_bar));
        let d = x.x - x_bar.x;
        // Eq. (48): d·t = d·t̄ = 0, by the matrix of (50).
        let (step, step_bar) = Projection::new(&x, &x_bar, held).solve(-d.dot(&x.t), -d.dot(&x_bar.t));
        (xi, xi_bar) = (xi + step, xi_bar + step_bar);
    }
    let [x, x_bar] = geometry(pair, q, (point.xi.into(), point.xi_bar.into()));
    let d: nalgebra::Vector3<RunningError> = x.x - x_bar.x;
    let rounding = [d.dot(&x.t), d.dot(&x_bar.t)].map(|f| 2.0 * f.bound);
    let far = Projection::new(&x, &x_bar, held).inverse().map(|row| {
        let terms = row.into_iter().zip(rounding).map(|(entry, f)| (entry.value.abs() + entry.bound) * f);
        terms.sum::<f64>()
    });
    [(xi, RunningError::new(point.xi, far[0])), (xi_bar, RunningError::new(point.xi_bar, far[1]))]
}

/// The number of steps of Newton's method from a point with the accuracy of `f64`. Each step doubles the digits.
const STEPS: usize = 3;

fn geometry<T: Real, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    (xi, xi_bar): (T, T),
) -> [Geometry<T>; 2] {
    [
        pair.curve.jet(&q.beam.map(T::from), xi).geometry,
        pair.curve_bar.jet(&q.bar.map(T::from), xi_bar).geometry,
    ]
}
