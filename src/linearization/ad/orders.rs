//! Gradients and Hessians, order by order. What one order needs of the order below is computed once.
//!
//! By the implicit function theorem the derivatives of xi and xi_bar are solutions of linear systems, all with the
//! real matrix of [`Chord`]. AD supplies the right-hand sides: the residuals of the orthogonality conditions, with the
//! parameters lifted to the order below. The first order takes one pass over the dofs and not over their pairs. The
//! second takes no step of its own: its residual comes with the quantities, and Delta-delta xi adds to them its value
//! times their slope. d alone needs neither of these two (the envelope theorem), nor any tangent.

use super::evaluate::{Perturbed, PositionAt, evaluate};
use super::lift::{Chord, orthogonality};
use super::sweep::chord;
use crate::closest_point::ClosestPoint;
use crate::curve::Curve;
use crate::linearization::{Derivatives, Quantities};
use crate::number::{Extends, HyperDualRow, Real};
use crate::pair::{DofVector, Pair};
use crate::source_fault::source_fault;
use nalgebra::SVector;

/// Gradients and Hessians of the quantities that `pick` picks, the second order by the implicit function theorem.
#[doc(alias = "implicit function theorem")]
pub fn expand_by_orders<
    A: Curve<N>,
    B: Curve<M>,
    const N: usize,
    const M: usize,
    const C: usize,
    const K: usize,
>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    pick: impl Fn(Quantities<HyperDualRow<C>>) -> [HyperDualRow<C>; K],
) -> [Derivatives<f64, N, M>; K] {
    let evaluation = EvaluationPoint { pair, q, point };
    let chord = chord(pair, q, point);
    let gradients = evaluation.gradients::<C>(&chord);
    let slopes = evaluation.slopes(&pick);
    let mut all_derivatives = [Derivatives::zero(); K];
    for (a, start) in rows::<C>(N + M) {
        let (beam, bar) = evaluation.perturbed::<C>(Some(a), start);
        let quantities = evaluate(&beam, &bar, evaluation.lifted::<C>(&gradients, a, start), &pair.contact);
        // Eq. (54): the second variations of d·t and d·t̄, but for Δδξ and Δδξ̄
        let [residual, residual_bar] =
            [quantities.t_vector, quantities.t_bar_vector].map(|t| quantities.d_vector.dot(&t));
        let picked = pick(quantities);
        for (j, b) in entries::<C>(N + M, start) {
            // Eq. (56)
            let [second, second_bar] = chord.solve(residual.eps1eps2[j], residual_bar.eps1eps2[j]);
            for ((derivatives, number), [slope, slope_bar]) in
                all_derivatives.iter_mut().zip(&picked).zip(slopes)
            {
                let entry = number.eps1eps2[j] + slope * second + slope_bar * second_bar;
                derivatives.hessian.set(a, b, entry);
                derivatives.gradient.set(b, number.eps2[j]);
                derivatives.value = number.re;
            }
        }
    }
    all_derivatives
}

/// d with gradient and Hessian, by the envelope theorem: xi and xi_bar to first order.
#[doc(alias = "envelope theorem")]
pub fn expand_d_by_orders<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize, const C: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
) -> Derivatives<f64, N, M> {
    let evaluation = EvaluationPoint { pair, q, point };
    let gradients = evaluation.gradients::<C>(&chord(pair, q, point));
    let mut derivatives = Derivatives::zero();
    for (a, start) in rows::<C>(N + M) {
        let (beam, bar) = evaluation.perturbed::<C>(Some(a), start);
        let (xi, xi_bar) = evaluation.lifted::<C>(&gradients, a, start);
        // Eq. (4), (9)
        let d = beam.position_at(xi) - bar.position_at(xi_bar);
        let d = d.dot(&d).sqrt();
        for (j, b) in entries::<C>(N + M, start) {
            derivatives.hessian.set(a, b, d.eps1eps2[j]);
            derivatives.gradient.set(b, d.eps2[j]);
        }
        derivatives.value = d.re;
    }
    derivatives
}

/// Gradients and Hessians of the quantities that `pick` picks, by chord steps in each row: two for all quantities, one
/// for d alone.
pub fn expand_by_rows<
    A: Curve<N>,
    B: Curve<M>,
    const N: usize,
    const M: usize,
    const C: usize,
    const K: usize,
>(
    chord: Chord<f64>,
    steps: usize,
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    pick: impl Fn(Quantities<HyperDualRow<C>>) -> [HyperDualRow<C>; K],
) -> [Derivatives<f64, N, M>; K] {
    let evaluation = EvaluationPoint { pair, q, point };
    let mut all_derivatives = [Derivatives::zero(); K];
    for (a, start) in rows::<C>(N + M) {
        let (beam, bar) = evaluation.perturbed::<C>(Some(a), start);
        let lifted = chord.lift(&beam, &bar, (point.xi, point.xi_bar), steps);
        let picked = pick(evaluate(&beam, &bar, lifted, &pair.contact));
        for (derivatives, number) in all_derivatives.iter_mut().zip(&picked) {
            for (j, b) in entries::<C>(N + M, start) {
                derivatives.hessian.set(a, b, number.eps1eps2[j]);
                derivatives.gradient.set(b, number.eps2[j]);
            }
            derivatives.value = number.re;
        }
    }
    all_derivatives
}

/// A pair at its closest point.
struct EvaluationPoint<'a, A, B, const N: usize, const M: usize> {
    pair: &'a Pair<A, B, N, M>,
    q: &'a DofVector<f64, N, M>,
    point: &'a ClosestPoint,
}

/// Both curves with dofs perturbed in `C` directions Delta at once.
type Beams<'a, A, B, const N: usize, const M: usize, const C: usize> =
    (Perturbed<'a, A, HyperDualRow<C>, N>, Perturbed<'a, B, HyperDualRow<C>, M>);

impl<'a, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize> EvaluationPoint<'a, A, B, N, M> {
    /// Both curves, with the dof `delta` perturbed along delta, and those from `start` on along Delta.
    fn perturbed<const C: usize>(&self, delta: Option<usize>, start: usize) -> Beams<'a, A, B, N, M, C> {
        let one_if = |is: bool| if is { 1.0 } else { 0.0 };
        let seeded = |value: f64, dof: usize| {
            HyperDualRow::to_first_order(value, one_if(delta == Some(dof)), |j| one_if(start + j == dof))
        };
        let beam = SVector::from_fn(|i, _| seeded(self.q.beam[i], i));
        let bar = SVector::from_fn(|i, _| seeded(self.q.bar[i], N + i));
        let Pair { curve, curve_bar, .. } = self.pair;
        (Perturbed { curve, q: beam }, Perturbed { curve: curve_bar, q: bar })
    }

    /// The gradients of xi and xi_bar.
    fn gradients<const C: usize>(&self, chord: &Chord<f64>) -> [DofVector<f64, N, M>; 2] {
        let mut gradients = [DofVector::zeros(); 2];
        let held = (HyperDualRow::constant(self.point.xi), HyperDualRow::constant(self.point.xi_bar));
        for start in (0..N + M).step_by(C) {
            let (beam, bar) = self.perturbed::<C>(None, start);
            // Eq. (49): the first variations of d·t and d·t̄, but for δξ and δξ̄
            let [residual, residual_bar] = orthogonality(&beam, &bar, held);
            for (j, dof) in entries::<C>(N + M, start) {
                // Eq. (52)
                let first = chord.solve(residual.eps2[j], residual_bar.eps2[j]);
                for (gradient, entry) in gradients.iter_mut().zip(first) {
                    gradient.set(dof, entry);
                }
            }
        }
        gradients
    }

    /// The parameters to first order in the dofs of a row.
    fn lifted<const C: usize>(
        &self,
        [g, g_bar]: &[DofVector<f64, N, M>; 2],
        delta: usize,
        start: usize,
    ) -> (HyperDualRow<C>, HyperDualRow<C>) {
        let lift = |value: f64, g: &DofVector<f64, N, M>| {
            let along = |j| if start + j < N + M { g.entry(start + j) } else { 0.0 };
            HyperDualRow::to_first_order(value, g.entry(delta), along)
        };
        (lift(self.point.xi, g), lift(self.point.xi_bar, g_bar))
    }

    /// The slopes of the picked quantities in xi and in xi_bar.
    fn slopes<const C: usize, const K: usize>(
        &self,
        pick: impl Fn(Quantities<HyperDualRow<C>>) -> [HyperDualRow<C>; K],
    ) -> [[f64; 2]; K] {
        let (beam, bar) = self.perturbed::<C>(None, N + M);
        let xi = HyperDualRow::to_first_order(self.point.xi, 1.0, |_| 0.0);
        let xi_bar = HyperDualRow::to_first_order(self.point.xi_bar, 0.0, |_| 1.0);
        let picked = pick(evaluate(&beam, &bar, (xi, xi_bar), &self.pair.contact));
        picked.map(|number| [number.eps1, source_fault!("slope-by-orders": number.eps1, number.eps2[0])])
    }
}

/// The rows of the upper triangle of `size` dofs, cut into chunks: the dof along delta, and the first one along Delta.
fn rows<const C: usize>(size: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..size).flat_map(move |a| (a..size).step_by(C).map(move |start| (a, start)))
}

/// The dofs along Delta of a chunk, each with its place in the chunk.
fn entries<const C: usize>(size: usize, start: usize) -> impl Iterator<Item = (usize, usize)> {
    (start..size).take(C).enumerate()
}
