//! The closest point as a dual number: the parameters that keep the conditions of the closest point when the dofs
//! are perturbed.

use super::evaluate::{PositionAt, tangent};
use crate::closest_point::Active;
use crate::number::{Differentiable, Extends, HyperDual};
use nalgebra::{SVector, Vector3};
use num_dual::{Dual, Dual2SVec, DualSVec, HyperDual64, implicit_derivative_binary, implicit_derivative_sp};

/// d.t and d.t_bar.
fn orthogonality<T: Differentiable>(
    beam: &(impl PositionAt<T::Dual> + ?Sized),
    bar: &(impl PositionAt<T::Dual> + ?Sized),
    (xi, xi_bar): (T, T),
) -> [T; 2] {
    let (x, t) = tangent(beam, xi);
    let (x_bar, t_bar) = tangent(bar, xi_bar);
    let d: Vector3<T> = x - x_bar;
    [d.dot(&t), d.dot(&t_bar)]
}

/// Lifts by Newton's method in dual arithmetic on the orthogonality conditions.
#[doc(alias = "Eq. (48)")]
pub fn newton<B, C>(beam: &B, bar: &C, (xi, xi_bar): (f64, f64), active: Active) -> (HyperDual64, HyperDual64)
where
    B: PositionAt<Dual<DualSVec<HyperDual64, 2>>> + ?Sized,
    C: PositionAt<Dual<DualSVec<HyperDual64, 2>>> + ?Sized,
{
    type Scalar = DualSVec<HyperDual64, 2>;
    let conditions = |xi_lifted: Scalar, xi_bar_lifted: Scalar, (): &()| {
        let [mut f, mut f_bar] = orthogonality(beam, bar, (xi_lifted, xi_bar_lifted));
        // At an end the condition is that the parameter stays.
        if active.xi {
            f = xi_lifted - Scalar::from(xi);
        }
        if active.xi_bar {
            f_bar = xi_bar_lifted - Scalar::from(xi_bar);
        }
        [f, f_bar]
    };
    let [xi, xi_bar] = implicit_derivative_binary::<_, HyperDual64, ()>(conditions, xi, xi_bar, &());
    (xi, xi_bar)
}

/// Lifts by making the squared distance stationary.
#[doc(alias = "Eq. (2)")]
pub fn stationary<B, C>(
    beam: &B,
    bar: &C,
    (xi, xi_bar): (f64, f64),
    active: Active,
) -> (HyperDual64, HyperDual64)
where
    B: PositionAt<Dual2SVec<HyperDual64, 2>> + ?Sized,
    C: PositionAt<Dual2SVec<HyperDual64, 2>> + ?Sized,
{
    type Scalar = Dual2SVec<HyperDual64, 2>;
    let potential = |parameters: SVector<Scalar, 2>, (): &()| {
        let [held, held_bar] = [xi, xi_bar].map(Scalar::from);
        // A held parameter leaves the distance and is tied to its end by a potential of its own.
        let mut tie = Scalar::from(0.0);
        let mut at = |held: Scalar, free: Scalar, active: bool| {
            if active {
                tie += (free - held) * (free - held);
                held
            } else {
                free
            }
        };
        let x = beam.position_at(at(held, parameters[0], active.xi));
        let x_bar = bar.position_at(at(held_bar, parameters[1], active.xi_bar));
        let d = x - x_bar;
        d.dot(&d) + tie
    };
    let lifted = implicit_derivative_sp::<_, HyperDual64, (), _>(potential, SVector::from([xi, xi_bar]), &());
    (lifted[0], lifted[1])
}

/// The inverse of the real Jacobian of the orthogonality conditions, over the base scalar `B`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord<B> {
    inverse: [[B; 2]; 2],
}

impl<B> Chord<B>
where
    B: Differentiable,
    B::Dual: Differentiable,
{
    /// Differentiates the unperturbed orthogonality conditions, from positions alone.
    pub fn new<S, R>(beam: &S, bar: &R, (xi, xi_bar): (B, B), active: Active) -> Self
    where
        S: PositionAt<<B::Dual as Differentiable>::Dual> + ?Sized,
        R: PositionAt<<B::Dual as Differentiable>::Dual> + ?Sized,
    {
        let columns = [(1.0, 0.0), (0.0, 1.0)].map(|(along, along_bar)| {
            orthogonality::<B::Dual>(beam, bar, (xi.dual(along), xi_bar.dual(along_bar)))
                .map(|f| B::parts(f).1)
        });
        let [[j00, j10], [j01, j11]] = columns;
        let (zero, one) = (B::zero(), B::one());
        let inverse = match (active.xi, active.xi_bar) {
            (false, false) => {
                let det = j00 * j11 - j01 * j10;
                [[j11 / det, -j01 / det], [-j10 / det, j00 / det]]
            }
            (true, false) => [[zero, zero], [zero, one / j11]],
            (false, true) => [[one / j00, zero], [zero, zero]],
            (true, true) => [[zero; 2]; 2],
        };
        Self { inverse }
    }

    /// Lifts to the scalar `T` by `steps` chord steps: one makes the first derivatives exact, two the second.
    pub fn lift<T, S, R>(&self, beam: &S, bar: &R, (xi, xi_bar): (B, B), steps: usize) -> (T, T)
    where
        T: Differentiable + Extends<B>,
        S: PositionAt<T::Dual> + ?Sized,
        R: PositionAt<T::Dual> + ?Sized,
    {
        let [[p, q], [r, s]] = self.inverse.map(|row| row.map(T::constant));
        let (mut xi, mut xi_bar) = (T::constant(xi), T::constant(xi_bar));
        // Eq. (43), (45), (46): (d + δd)·(t + δt) = 0 after each step, no product dropped
        for _ in 0..steps {
            let [f, f_bar] = orthogonality(beam, bar, (xi, xi_bar));
            xi -= p * f + q * f_bar;
            xi_bar -= r * f + s * f_bar;
        }
        (xi, xi_bar)
    }

    /// Lifts to hyper-dual numbers order by order: the first step yields the parts of first order, the second that of
    /// second order, and neither touches what is known already.
    ///
    /// In exact arithmetic, at the exact closest point, this is [`Chord::lift`] by two steps. Over numbers with error
    /// bounds it is sharper: there the second step, which changes the first order by zero, is charged for it.
    pub fn lift_by_orders<S, R>(
        &self,
        beam: &S,
        bar: &R,
        (xi, xi_bar): (B, B),
    ) -> (HyperDual<B>, HyperDual<B>)
    where
        HyperDual<B>: Differentiable,
        S: PositionAt<<HyperDual<B> as Differentiable>::Dual> + ?Sized,
        R: PositionAt<<HyperDual<B> as Differentiable>::Dual> + ?Sized,
    {
        let solve = |f: B, f_bar: B| self.inverse.map(|[p, q]| -(p * f + q * f_bar));
        let known = |xi: B, eps1: B, eps2: B| HyperDual::new(xi, eps1, eps2, B::zero());
        let held = (known(xi, B::zero(), B::zero()), known(xi_bar, B::zero(), B::zero()));
        let [f, f_bar] = orthogonality(beam, bar, held);
        let [delta, delta_bar] = solve(f.eps1, f_bar.eps1);
        let [linear, linear_bar] = solve(f.eps2, f_bar.eps2);
        let (first, first_bar) = (known(xi, delta, linear), known(xi_bar, delta_bar, linear_bar));
        let [f, f_bar] = orthogonality(beam, bar, (first, first_bar));
        let [second, second_bar] = solve(f.eps1eps2, f_bar.eps1eps2);
        let with = |first: HyperDual<B>, eps1eps2: B| HyperDual { eps1eps2, ..first };
        (with(first, second), with(first_bar, second_bar))
    }
}
