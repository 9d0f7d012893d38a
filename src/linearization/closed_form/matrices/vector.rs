//! Gradients and Hessians of vectors, along a fixed direction.

use super::Matrices;
use crate::curve::{DofDerivatives, Geometry};
use crate::linearization::{BlockHessian, Derivatives};
use crate::number::Real;
use crate::pair::DofVector;
use crate::source_fault::source_fault;
use nalgebra::Vector3;

/// A vector quantity, linearized by [`Matrices::vector`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VectorQuantity {
    /// x_C.
    X,
    /// x_bar_C.
    XBar,
    /// d.
    D,
    /// t = x_C,xi.
    T,
    /// t_bar = x_bar_C,xi_bar.
    TBar,
}

impl<T, U, V, const N: usize, const M: usize> Matrices<'_, T, U, V, N, M>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
{
    /// w . v for a fixed vector w and a vector quantity v; unit vectors for w give its components.
    ///
    /// `parameters` are xi and xi_bar as in [`Linearization`](crate::linearization::Linearization).
    #[doc(alias = "Eq. (31)")]
    #[doc(alias = "Eq. (32)")]
    pub fn vector(
        &self,
        quantity: VectorQuantity,
        w: &Vector3<T>,
        parameters: [&Derivatives<T, N, M>; 2],
    ) -> Derivatives<T, N, M> {
        let Self { jet, jet_bar, d, .. } = self;
        let (x, y) = (&jet.geometry, &jet_bar.geometry);
        let [xi, xi_bar] = parameters;
        let (minus, one) = (-T::one(), T::one());
        // The beam's part, of order k in ξ, and the bar beam's, each with its sign.
        let (value, k, beam, bar) = match quantity {
            VectorQuantity::X => (w.dot(&x.x), 0, Some(one), None),
            VectorQuantity::XBar => (w.dot(&y.x), 0, None, Some(one)),
            VectorQuantity::D => (w.dot(d), 0, Some(one), Some(minus)),
            VectorQuantity::T => (w.dot(&x.t), 1, Some(one), None),
            VectorQuantity::TBar => (w.dot(&y.t), 1, None, Some(one)),
        };
        let slopes = |of: &Geometry<T>| match k {
            0 => (w.dot(&of.t), w.dot(&of.t_xi)),
            _ => (w.dot(&of.t_xi), w.dot(&of.t_xixi)),
        };
        let half = T::from(source_fault!("half-of-vector": 1.0, 0.5));
        // Hess(w·x_C) = (w·t) H_ξ + S_x(w)   Hess(w·x_C,ξ) = (w·t,ξ) H_ξ + S_t(w)
        let (mut gradient, mut hessian) = (DofVector::zeros(), BlockHessian::zeros());
        if let Some(sign) = beam {
            let (first, second) = slopes(x);
            let own = DofVector::of_beam(jet.dofs.gradient(k, w));
            let along = DofVector::of_beam(jet.dofs.gradient(k + 1, w));
            gradient = own.plus(first, &xi.gradient).times(sign);
            let with = along.plus(half * second, &xi.gradient).times(sign);
            hessian.set_sum(&[(sign * first, &xi.hessian)], &[[&xi.gradient, &with]]);
        }
        if let Some(sign) = bar {
            let (first, second) = slopes(y);
            let own = DofVector::of_bar(jet_bar.dofs.gradient(k, w));
            let along = DofVector::of_bar(jet_bar.dofs.gradient(k + 1, w));
            gradient = gradient.plus(sign, &own.plus(first, &xi_bar.gradient));
            let with = along.plus(half * second, &xi_bar.gradient).times(sign);
            let beam = hessian;
            hessian
                .set_sum(&[(T::one(), &beam), (sign * first, &xi_bar.hessian)], &[[&xi_bar.gradient, &with]]);
        }
        if !U::LINEAR
            && let Some(sign) = beam
        {
            hessian.beam += jet.dofs.hessian(k, w) * sign;
        }
        if !V::LINEAR
            && let Some(sign) = bar
        {
            hessian.bar += jet_bar.dofs.hessian(k, w) * sign;
        }
        Derivatives { hessian, gradient, value }
    }
}
