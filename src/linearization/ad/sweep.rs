//! Sweeps by the routes: two directions at once, all pairs of directions one after another, or all dofs at once.

use super::evaluate::{Perturbed, PositionAt, evaluate};
use super::lift::{Chord, newton, stationary};
use crate::closest_point::{ClosestPoint, Held};
use crate::curve::Curve;
use crate::linearization::{Derivatives, Quantities, Varied};
use crate::pair::{Contact, DofVector, Pair};
use nalgebra::{Const, SMatrix, SVector, U1};
use num_dual::{Dual, Dual2SVec, Dual2SVec64, DualSVec, HyperDual64};

/// How the closest point is lifted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Route {
    /// Newton's method in dual arithmetic on the orthogonality conditions.
    Newton,
    /// Stationarity of the squared distance.
    Stationary,
    /// The given number of chord steps on the orthogonality conditions, with the given real matrix. Two steps lift all
    /// quantities, one is enough for d alone (the envelope theorem).
    Chord(Chord<f64>, usize),
}

/// A curve with hyper-dual dofs, for all the hyper-dual routes. The trait is object-safe.
pub trait HyperBeam:
    PositionAt<Dual<HyperDual64>>
    + PositionAt<Dual<DualSVec<HyperDual64, 2>>>
    + PositionAt<Dual2SVec<HyperDual64, 2>>
{
}

impl<B> HyperBeam for B where
    B: PositionAt<Dual<HyperDual64>>
        + PositionAt<Dual<DualSVec<HyperDual64, 2>>>
        + PositionAt<Dual2SVec<HyperDual64, 2>>
        + ?Sized
{
}

/// All quantities in hyper-dual numbers, for the two directions that `beam` and `bar` are perturbed in.
pub fn hyper_dual(
    route: Route,
    beam: &(impl HyperBeam + ?Sized),
    bar: &(impl HyperBeam + ?Sized),
    at: (f64, f64),
    held: Held,
    contact: &Contact,
) -> Quantities<HyperDual64> {
    let lifted = match route {
        Route::Newton => newton(beam, bar, at, held),
        Route::Stationary => stationary(beam, bar, at, held),
        Route::Chord(chord, steps) => chord.lift(beam, bar, at, steps),
    };
    evaluate::<HyperDual64>(beam, bar, lifted, contact)
}

/// The real chord matrix of a pair at its closest point, for [`Route::Chord`] and [`expand_by_vector_dual`].
pub fn chord<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
) -> Chord<f64> {
    let beam = Perturbed { curve: &pair.curve, q: q.beam };
    let bar = Perturbed { curve: &pair.curve_bar, q: q.bar };
    Chord::new(&beam, &bar, (point.xi, point.xi_bar), point.held())
}

/// All quantities with their variations along `dq` (delta) and `linear_dq` (Delta), at a closest point of the pair.
pub fn vary<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    route: Route,
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    dq: &DofVector<f64, N, M>,
    linear_dq: &DofVector<f64, N, M>,
) -> Quantities<Varied<f64>> {
    let beam = Perturbed { curve: &pair.curve, q: seeded(&q.beam, &dq.beam, &linear_dq.beam) };
    let bar = Perturbed { curve: &pair.curve_bar, q: seeded(&q.bar, &dq.bar, &linear_dq.bar) };
    let (at, beams) = ((point.xi, point.xi_bar), nameless(&beam, &bar));
    hyper_dual(route, beams.0, beams.1, at, point.held(), &pair.contact).map(Varied::from)
}

/// Both curves as trait objects. The code that solves for the closest point is long, and is compiled once.
fn nameless<'a>(beam: &'a impl HyperBeam, bar: &'a impl HyperBeam) -> (&'a dyn HyperBeam, &'a dyn HyperBeam) {
    (beam, bar)
}

/// q + eps1 dq + eps2 Dq.
pub fn seeded<const N: usize>(
    q: &SVector<f64, N>,
    dq: &SVector<f64, N>,
    linear_dq: &SVector<f64, N>,
) -> SVector<HyperDual64, N> {
    SVector::from_fn(|i, _| HyperDual64::new(q[i], dq[i], linear_dq[i], 0.0))
}

/// Gradients and Hessians of the quantities that `pick` picks, one pair of dofs at a time.
///
/// Each entry of a Hessian costs one hyper-dual evaluation; the lower triangle is copied from the upper.
pub fn expand_by_sweep<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize, const K: usize>(
    route: Route,
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    pick: impl Fn(Quantities<HyperDual64>) -> [HyperDual64; K],
) -> [Derivatives<f64, N, M>; K] {
    let mut all_derivatives = [Derivatives::zero(); K];
    let at = (point.xi, point.xi_bar);
    let unit = DofVector::<f64, N, M>::unit;
    for j in 0..N + M {
        for i in 0..=j {
            let beam = Perturbed { curve: &pair.curve, q: seeded(&q.beam, &unit(i).beam, &unit(j).beam) };
            let bar = Perturbed { curve: &pair.curve_bar, q: seeded(&q.bar, &unit(i).bar, &unit(j).bar) };
            let beams = nameless(&beam, &bar);
            let picked = pick(hyper_dual(route, beams.0, beams.1, at, point.held(), &pair.contact));
            for (derivatives, number) in all_derivatives.iter_mut().zip(picked) {
                derivatives.value = number.re;
                derivatives.gradient.set(j, number.eps2);
                derivatives.hessian.set(i, j, number.eps1eps2);
            }
        }
    }
    all_derivatives
}

/// Gradients and Hessians of the quantities that `pick` picks, all `S` = N + M dofs at once in vector duals.
pub fn expand_by_vector_dual<
    A: Curve<N>,
    B: Curve<M>,
    const N: usize,
    const M: usize,
    const S: usize,
    const K: usize,
>(
    chord: Chord<f64>,
    steps: usize,
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    pick: impl Fn(Quantities<Dual2SVec64<S>>) -> [Dual2SVec64<S>; K],
) -> [Derivatives<f64, N, M>; K] {
    const { assert!(S == N + M, "one variable for each dof of both beams") };
    let seeded = |value: f64, i: usize| Dual2SVec64::<S>::from_re(value).derivative(i);
    let beam = Perturbed { curve: &pair.curve, q: SVector::from_fn(|i, _| seeded(q.beam[i], i)) };
    let bar = Perturbed { curve: &pair.curve_bar, q: SVector::from_fn(|i, _| seeded(q.bar[i], N + i)) };
    let lifted = chord.lift(&beam, &bar, (point.xi, point.xi_bar), steps);
    pick(evaluate(&beam, &bar, lifted, &pair.contact)).map(|number| {
        let gradient: SMatrix<f64, 1, S> = number.v1.unwrap_generic(U1, Const::<S>);
        let hessian: SMatrix<f64, S, S> = number.v2.unwrap_generic(Const::<S>, Const::<S>);
        let mut derivatives = Derivatives { value: number.re, ..Derivatives::zero() };
        for j in 0..S {
            derivatives.gradient.set(j, gradient[j]);
            for i in 0..=j {
                derivatives.hessian.set(i, j, hessian[(i, j)]);
            }
        }
        derivatives
    })
}
