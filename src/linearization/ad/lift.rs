//! The closest point as a dual number: the parameters that keep the conditions of the closest point when the dofs
//! are perturbed.

use super::evaluate::{PositionAt, quantities, tangent};
use crate::closest_point::Held;
use crate::linearization::Quantities;
use crate::number::{Differentiable, Extends, HyperDual, Real};
use crate::pair::Contact;
use nalgebra::{SVector, Vector3};
use num_dual::linalg::LU;
use num_dual::{Dual, Dual2SVec, DualNum, DualSVec, HyperDual64, implicit_derivative_binary};

/// d.t and d.t_bar.
pub(super) fn orthogonality<T: Differentiable>(
    beam: &(impl PositionAt<T::Dual> + ?Sized),
    bar: &(impl PositionAt<T::Dual> + ?Sized),
    (xi, xi_bar): (T, T),
) -> [T; 2] {
    conditions(tangent(beam, xi), tangent(bar, xi_bar))
}

/// The two conditions from points and tangents.
fn conditions<T: Real>((x, t): (Vector3<T>, Vector3<T>), (x_bar, t_bar): (Vector3<T>, Vector3<T>)) -> [T; 2] {
    let d = x - x_bar;
    [d.dot(&t), d.dot(&t_bar)]
}

/// Lifts by Newton's method in dual arithmetic on the orthogonality conditions.
#[doc(alias = "Eq. (48)")]
pub fn newton<B, C>(beam: &B, bar: &C, (xi, xi_bar): (f64, f64), held: Held) -> (HyperDual64, HyperDual64)
where
    B: PositionAt<Dual<DualSVec<HyperDual64, 2>>> + ?Sized,
    C: PositionAt<Dual<DualSVec<HyperDual64, 2>>> + ?Sized,
{
    type Scalar = DualSVec<HyperDual64, 2>;
    let conditions = |xi_lifted: Scalar, xi_bar_lifted: Scalar, (): &()| {
        let [mut f, mut f_bar] = orthogonality(beam, bar, (xi_lifted, xi_bar_lifted));
        // At an end the condition is that the parameter stays.
        if held.xi {
            f = xi_lifted - Scalar::from(xi);
        }
        if held.xi_bar {
            f_bar = xi_bar_lifted - Scalar::from(xi_bar);
        }
        [f, f_bar]
    };
    let [xi, xi_bar] = implicit_derivative_binary::<_, HyperDual64, ()>(conditions, xi, xi_bar, &());
    (xi, xi_bar)
}

/// Lifts by making the squared distance stationary.
#[doc(alias = "Eq. (2)")]
pub fn stationary<B, C>(beam: &B, bar: &C, (xi, xi_bar): (f64, f64), held: Held) -> (HyperDual64, HyperDual64)
where
    B: PositionAt<Dual2SVec<HyperDual64, 2>> + ?Sized,
    C: PositionAt<Dual2SVec<HyperDual64, 2>> + ?Sized,
{
    type Scalar = Dual2SVec<HyperDual64, 2>;
    let potential = |parameters: SVector<Scalar, 2>| {
        let [end, end_bar] = [xi, xi_bar].map(Scalar::from);
        // A held parameter does not enter the distance. A separate potential ties it to its end.
        let mut tie = Scalar::from(0.0);
        let mut at = |end: Scalar, free: Scalar, held: bool| {
            if held {
                tie += (free - end) * (free - end);
                end
            } else {
                free
            }
        };
        let x = beam.position_at(at(end, parameters[0], held.xi));
        let x_bar = bar.position_at(at(end_bar, parameters[1], held.xi_bar));
        let d = x - x_bar;
        d.dot(&d) + tie
    };
    // This is num-dual's implicit_derivative_sp, but with a result that is not a number instead of a panic if LU fails.
    let mut lifted = SVector::from([xi, xi_bar].map(HyperDual64::from));
    for _ in 0..HyperDual64::NDERIV {
        let (_, gradient, hessian) = num_dual::hessian(potential, &lifted);
        let Ok(factors) = LU::new(hessian) else {
            return (f64::NAN.into(), f64::NAN.into());
        };
        lifted -= factors.solve(&gradient);
    }
    (lifted[0], lifted[1])
}

/// The inverse of the real Jacobian of the orthogonality conditions, over the base scalar `B`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord<B> {
    inverse: [[B; 2]; 2],
    /// t,xi and t_bar,xi_bar, from which the matrix is computed.
    t_xi: [Vector3<B>; 2],
}

impl<B> Chord<B>
where
    B: Differentiable,
    B::Dual: Differentiable,
{
    /// Differentiates the unperturbed orthogonality conditions, from positions alone.
    pub fn new<S, R>(beam: &S, bar: &R, (xi, xi_bar): (B, B), held: Held) -> Self
    where
        S: PositionAt<<B::Dual as Differentiable>::Dual> + ?Sized,
        R: PositionAt<<B::Dual as Differentiable>::Dual> + ?Sized,
    {
        // Each beam is evaluated once, with a moving parameter. At rest only the last derivative is zero.
        let at_rest = |v: Vector3<B::Dual>| v.map(|component| B::parts(component).0.dual(0.0));
        let slopes = |x, x_bar| conditions::<B::Dual>(x, x_bar).map(|f| B::parts(f).1);
        let (x, t) = tangent::<B::Dual>(beam, xi.dual(1.0));
        let (x_bar, t_bar) = tangent::<B::Dual>(bar, xi_bar.dual(1.0));
        let [j00, j10] = slopes((x, t), (at_rest(x_bar), at_rest(t_bar)));
        let [j01, j11] = slopes((at_rest(x), at_rest(t)), (x_bar, t_bar));
        let (zero, one) = (B::zero(), B::one());
        let inverse = match (held.xi, held.xi_bar) {
            (false, false) => {
                let det = j00 * j11 - j01 * j10;
                [[j11 / det, -j01 / det], [-j10 / det, j00 / det]]
            }
            (true, false) => [[zero, zero], [zero, one / j11]],
            (false, true) => [[one / j00, zero], [zero, zero]],
            (true, true) => [[zero; 2]; 2],
        };
        Self { inverse, t_xi: [t, t_bar].map(|t| t.map(|component| B::parts(component).1)) }
    }

    /// The changes of both parameters that cancel changes of the conditions, to first order.
    #[inline]
    pub(super) fn solve(&self, f: B, f_bar: B) -> [B; 2] {
        self.inverse.map(|[p, q]| -(p * f + q * f_bar))
    }

    /// The chord step from parameters of the base scalar, from positions alone.
    #[cfg(feature = "check")]
    pub(crate) fn step<S, R>(&self, beam: &S, bar: &R, (xi, xi_bar): (B, B)) -> [B; 2]
    where
        S: PositionAt<<B::Dual as Differentiable>::Dual> + ?Sized,
        R: PositionAt<<B::Dual as Differentiable>::Dual> + ?Sized,
    {
        let [f, f_bar] = orthogonality::<B::Dual>(beam, bar, (xi.dual(0.0), xi_bar.dual(0.0)));
        self.solve(B::parts(f).0, B::parts(f_bar).0)
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

    /// All quantities in hyper-dual numbers, order by order. The first step yields the parts of first order, the second
    /// those of second order. Neither step changes the parts that are known already.
    ///
    /// In exact arithmetic, at the exact closest point, this equals [`Chord::lift`] by two steps and [`evaluate`]. Over
    /// numbers with error bounds, the bounds are smaller: the second step of [`Chord::lift`] changes the first order by
    /// zero, but increases its bounds.
    ///
    /// [`evaluate`]: super::evaluate()
    pub fn evaluate_by_orders<S, R>(
        &self,
        beam: &S,
        bar: &R,
        (xi, xi_bar): (B, B),
        contact: &Contact,
    ) -> Quantities<HyperDual<B>>
    where
        HyperDual<B>: Differentiable,
        S: PositionAt<<HyperDual<B> as Differentiable>::Dual> + ?Sized,
        R: PositionAt<<HyperDual<B> as Differentiable>::Dual> + ?Sized,
    {
        let known = |xi: B, eps1: B, eps2: B| HyperDual::new(xi, eps1, eps2, B::zero());
        let held = (known(xi, B::zero(), B::zero()), known(xi_bar, B::zero(), B::zero()));
        let [f, f_bar] = orthogonality(beam, bar, held);
        let [delta, delta_bar] = self.solve(f.eps1, f_bar.eps1);
        let [linear, linear_bar] = self.solve(f.eps2, f_bar.eps2);
        let (mut xi, mut xi_bar) = (known(xi, delta, linear), known(xi_bar, delta_bar, linear_bar));
        let [mut point, mut point_bar] = [tangent(beam, xi), tangent(bar, xi_bar)];
        let [f, f_bar] = conditions(point, point_bar);
        let seconds = self.solve(f.eps1eps2, f_bar.eps1eps2);
        // The part of second order moves points and tangents only along the tangent and its derivative.
        for (i, (xi, (x, t))) in
            [(&mut xi, &mut point), (&mut xi_bar, &mut point_bar)].into_iter().enumerate()
        {
            xi.eps1eps2 = seconds[i];
            for c in 0..3 {
                x[c].eps1eps2 += t[c].re * seconds[i];
                t[c].eps1eps2 += self.t_xi[i][c] * seconds[i];
            }
        }
        quantities(point, point_bar, (xi, xi_bar), contact)
    }
}
