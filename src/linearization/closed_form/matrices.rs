//! Gradients and Hessians in all dofs of both beams: the step from variations to matrices.
//!
//! The formulas are in section 5 of the [derivation](super::derivation).

use super::sums::{add_product, write_length, write_slip};
use super::{Formulation, Points, Projection};
use crate::closest_point::Held;
use crate::curve::{DofDerivatives, Jet};
use crate::linearization::{Derivatives, Linearization};
use crate::number::{Formula, Real, Which, named};
use crate::pair::{Contact, DofVector};
use nalgebra::Vector3;

mod distance;
mod parameters;
mod vector;

pub use vector::VectorQuantity;

/// The linearization of a pair at its closest point, from which each quantity is taken on demand.
///
/// If only the gap is needed, [`Matrices::d`] avoids the Hessians of the parameters.
#[derive(Debug)]
pub struct Matrices<'a, T, U, V, const N: usize, const M: usize> {
    jet: &'a Jet<T, U>,
    jet_bar: &'a Jet<T, V>,
    /// d = x_C - x_bar_C.
    d: Vector3<T>,
    projection: Projection<T>,
    /// The gradient of xi, g.
    g: DofVector<T, N, M>,
    /// The gradient of xi_bar, g_bar.
    g_bar: DofVector<T, N, M>,
    form: Formulation,
}

impl<'a, T, U, V, const N: usize, const M: usize> Matrices<'a, T, U, V, N, M>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
{
    /// The first order: gradients of xi and xi_bar, from the jets of both curves at the closest point.
    ///
    /// All formulas are the paper's; [`Matrices::in_formulation`] uses those of any [`Formulation`].
    #[doc(alias = "compute_lin_xi_and_lin_eta")]
    #[inline]
    pub fn new(jet: &'a Jet<T, U>, jet_bar: &'a Jet<T, V>, held: Held) -> Self {
        Self::in_formulation(jet, jet_bar, Formulation::paper(held))
    }

    /// The same in the given formulation.
    #[inline]
    pub fn in_formulation(jet: &'a Jet<T, U>, jet_bar: &'a Jet<T, V>, form: Formulation) -> Self {
        let points = Points::new(&jet.geometry, &jet_bar.geometry);
        let projection = Projection::in_formulation(&points, form);
        let zeros = DofVector::zeros();
        let mut matrices = Self { jet, jet_bar, d: points.d, projection, g: zeros, g_bar: zeros, form };
        // Eq. (50), (52): g = p r + q r̄ with r = −(Gᵀt + A₁ᵀd), r̄ = −(Gᵀt̄ + B₁ᵀd), and ḡ by the other row: with the row's
        // m = p t + q t̄ it is −[Gᵀm + p A₁ᵀd + q B₁ᵀd]
        let (a, b) = (&jet.dofs, &jet_bar.dofs);
        let turned = named(Formula::GradR, "A1'd", a.gradient(1, &points.d));
        let turned_bar = named(Formula::GradRBar, "B1'd", b.gradient(1, &points.d));
        let inverse = projection.inverse();
        let [g, g_bar] = [0, 1].map(|i| {
            let ([p, q], m) = (inverse[i], matrices.mean(i, inverse[i]));
            DofVector {
                beam: -named(Formula::GradXi, "A0'm", a.gradient(0, &m)) - turned * p,
                bar: named(Formula::GradXi, "B0'm", b.gradient(0, &m)) - turned_bar * q,
            }
        });
        (matrices.g, matrices.g_bar) = (g, g_bar);
        matrices
    }

    /// All scalar quantities; the slips are measured from the reference parameters of `contact`.
    ///
    /// `xi` and `xi_bar` are the parameters of the closest point, at which the jets were taken.
    pub fn all(&self, at: (T, T), contact: &Contact) -> Linearization<T, N, M> {
        let mut all = Linearization::zeros();
        self.write_all(at, contact, &mut all);
        all
    }

    /// [`Matrices::all`], written over `to`.
    #[inline]
    pub fn write_all(&self, (at, at_bar): (T, T), contact: &Contact, to: &mut Linearization<T, N, M>) {
        let Linearization { d, t, t_bar, xi, xi_bar, g_t, g_t_bar, radii } = to;
        *radii = T::from(contact.radius) + T::from(contact.radius_bar);
        self.write_without_slips((at, at_bar), [d, t, t_bar, xi, xi_bar]);
        write_slip(Which::Beam, t, xi, contact.xi_0, g_t);
        write_slip(Which::Bar, t_bar, xi_bar, contact.xi_bar_0, g_t_bar);
    }

    /// d, t, t_bar, xi and xi_bar, written over `to`.
    #[inline]
    pub(crate) fn write_without_slips(
        &self,
        (at, at_bar): (T, T),
        [d, t, t_bar, xi, xi_bar]: [&mut Derivatives<T, N, M>; 5],
    ) {
        self.write_d(d);
        (xi.value, xi.gradient) = (at, self.g);
        (xi_bar.value, xi_bar.gradient) = (at_bar, self.g_bar);
        self.write_parameters([&mut xi.hessian, &mut xi_bar.hessian]);
        self.write_t(xi, t);
        self.write_t_bar(xi_bar, t_bar);
    }

    /// t, written over `to`.
    #[inline]
    fn write_t(&self, xi: &Derivatives<T, N, M>, to: &mut Derivatives<T, N, M>) {
        let Jet { geometry, dofs: a } = self.jet;
        let gradient = |k, w: &Vector3<T>| DofVector::of_beam(a.gradient(k, w));
        let (inverse, w) = write_length(Which::Beam, geometry, gradient, xi, to);
        add_product(&mut to.hessian.beam, named(Formula::HessianT, "A1'A1", inverse), (a, 1), (a, 1));
        if !U::LINEAR {
            to.hessian.beam += named(Formula::HessianT, "K,xi(t)", a.hessian(1, &w));
        }
    }

    /// t_bar, written over `to`.
    #[inline]
    fn write_t_bar(&self, xi_bar: &Derivatives<T, N, M>, to: &mut Derivatives<T, N, M>) {
        let Jet { geometry, dofs: b } = self.jet_bar;
        let gradient = |k, w: &Vector3<T>| DofVector::of_bar(b.gradient(k, w));
        let (inverse, w) = write_length(Which::Bar, geometry, gradient, xi_bar, to);
        add_product(&mut to.hessian.bar, named(Formula::HessianTBar, "B1'B1", inverse), (b, 1), (b, 1));
        if !V::LINEAR {
            to.hessian.bar += named(Formula::HessianTBar, "K_bar,xi(t_bar)", b.hessian(1, &w));
        }
    }
}
