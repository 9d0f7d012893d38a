//! The gradient and the Hessian of the distance.

use super::Matrices;
use crate::curve::{DofDerivatives, Jet};
use crate::linearization::closed_form::formulation::{inverse_gram, unit_normal};
use crate::linearization::closed_form::sums::add_product;
use crate::linearization::{BlockHessian, Derivatives};
use crate::number::{Formula, Real, named};
use crate::pair::DofVector;
use nalgebra::Vector3;

impl<T, U, V, const N: usize, const M: usize> Matrices<'_, T, U, V, N, M>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
{
    /// d with gradient and Hessian. The gradient and the Hessian are also those of g_N.
    #[doc(alias = "Eq. (57)")]
    #[inline]
    pub fn d(&self) -> Derivatives<T, N, M> {
        let mut d = Derivatives::zero();
        self.write_d(&mut d);
        d
    }

    /// [`Matrices::d`], written over `to`.
    #[inline]
    pub fn write_d(&self, to: &mut Derivatives<T, N, M>) {
        let Derivatives { value, gradient, hessian } = to;
        let (a, b) = (&self.jet.dofs, &self.jet_bar.dofs);
        // Eq. (4), (37): ∇d = Gᵀn
        let n;
        (*value, n) = self.value_and_normal();
        gradient.beam = named(Formula::GradD, "A0'n", a.gradient(0, &n));
        gradient.bar = -named(Formula::GradD, "B0'n", b.gradient(0, &n));
        if self.form.sign().is_some() {
            self.write_along_normal((*value, &n), hessian);
        } else {
            self.write_by_length(T::one() / *value, gradient, hessian);
        }
        if !U::LINEAR {
            hessian.beam += named(Formula::HessianD, "K(n)", a.hessian(0, &n));
        }
        if !V::LINEAR {
            hessian.bar -= named(Formula::HessianD, "K_bar(n)", b.hessian(0, &n));
        }
    }

    /// d and n: d/|d|, or the common normal of the tangents.
    #[inline]
    fn value_and_normal(&self) -> (T, Vector3<T>) {
        let d = &self.d;
        match self.form.sign() {
            None => {
                let value = d.dot(d).sqrt();
                (value, d * (T::one() / value))
            }
            Some(sign) => {
                let c =
                    named(Formula::Normal, "t x t_bar", self.jet.geometry.t.cross(&self.jet_bar.geometry.t));
                let n = unit_normal(&(c * T::from(sign)));
                (n.dot(d), n)
            }
        }
    }

    /// H = [Gᵀ(I − nnᵀ)G − a ggᵀ + b(gḡᵀ + ḡgᵀ) + ā ḡḡᵀ]/d, less K: Eq. (40).
    #[inline]
    fn write_by_length(
        &self,
        inverse: T,
        gradient: &DofVector<T, N, M>,
        hessian: &mut BlockHessian<T, N, M>,
    ) {
        let Self { g, g_bar, projection, .. } = self;
        let half = T::from(0.5);
        let with_n = gradient.times(-named(Formula::HessianD, "G'nn'G", half * inverse));
        let with_g = g
            .times(-named(Formula::HessianD, "a gg'", half * projection.a * inverse))
            .plus(named(Formula::HessianD, "b gg_bar'", projection.b * inverse), g_bar);
        let with_g_bar =
            g_bar.times(named(Formula::HessianD, "a_bar g_bar g_bar'", half * projection.a_bar * inverse));
        hessian.set_sum(&[], &[[gradient, &with_n], [g, &with_g], [g_bar, &with_g_bar]]);
        let (a, b) = (&self.jet.dofs, &self.jet_bar.dofs);
        add_product(&mut hessian.beam, named(Formula::HessianD, "A0'A0", inverse), (a, 0), (a, 0));
        add_product(&mut hessian.mixed, -named(Formula::HessianD, "A0'B0", inverse), (a, 0), (b, 0));
        add_product(&mut hessian.bar, named(Formula::HessianD, "B0'B0", inverse), (b, 0), (b, 0));
    }

    /// H = S_x(n) − S_x̄(n) + d [j, j̄] Γ [j, j̄]ᵀ with j = J_tᵀn and j̄ = J_t̄ᵀn, less K: see [`Formulation`](super::Formulation).
    #[inline]
    fn write_along_normal(&self, (d, n): (T, &Vector3<T>), hessian: &mut BlockHessian<T, N, M>) {
        let Self {
            jet: Jet { geometry: x, dofs: a }, jet_bar: Jet { geometry: y, dofs: b }, g, g_bar, ..
        } = self;
        let (turn, turn_bar, half) = (n.dot(&x.t_xi), n.dot(&y.t_xi), T::from(0.5));
        let (a1, b1) = (a.gradient(1, n), b.gradient(1, n));
        // S_x(n) = (n·t,ξ) ggᵀ + g(A₁ᵀn)ᵀ + (A₁ᵀn)gᵀ + K_x(n)
        let with_g = DofVector::of_beam(named(Formula::HessianD, "A1'n g'", a1))
            .plus(named(Formula::HessianD, "n.t,xi gg'", half * turn), g);
        let with_g_bar = DofVector::of_bar(named(Formula::HessianD, "B1'n g_bar'", b1))
            .plus(named(Formula::HessianD, "n.t_bar,xi g_bar g_bar'", half * turn_bar), g_bar)
            .times(-T::one());
        // j = A₁ᵀn + (n·t,ξ) g   j̄ = B₁ᵀn + (n·t̄,ξ̄) ḡ
        let j =
            DofVector::of_beam(named(Formula::J, "A1'n", a1)).plus(named(Formula::J, "n.t,xi g", turn), g);
        let j_bar = DofVector::of_bar(named(Formula::JBar, "B1'n", b1))
            .plus(named(Formula::JBar, "n.t_bar,xi g_bar", turn_bar), g_bar);
        let [gram, gram_mixed, gram_bar] = inverse_gram(&x.t, &y.t).map(|entry| entry * d);
        let with_j = j
            .times(named(Formula::HessianD, "d G11 jj'", half * gram))
            .plus(named(Formula::HessianD, "d G12 jj_bar'", gram_mixed), &j_bar);
        let with_j_bar = j_bar.times(named(Formula::HessianD, "d G22 j_bar j_bar'", half * gram_bar));
        hessian.set_sum(&[], &[[g, &with_g], [g_bar, &with_g_bar], [&j, &with_j], [&j_bar, &with_j_bar]]);
    }
}
