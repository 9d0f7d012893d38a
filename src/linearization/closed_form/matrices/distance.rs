//! The gradient and the Hessian of the distance.

use super::Matrices;
use crate::curve::DofDerivatives;
use crate::linearization::closed_form::form::{inverse_gram, unit_normal};
use crate::linearization::closed_form::jets::{Jets, MatrixTerms};
use crate::linearization::closed_form::sums::add_product;
use crate::linearization::{DofMatrix, Expansion};
use crate::number::Real;
use crate::pair::DofVector;
use nalgebra::Vector3;

impl<'a, T, U, V, const N: usize, const M: usize, F> Matrices<'a, T, U, V, N, M, F>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
    F: MatrixTerms<'a, T, U, V, N, M>,
{
    /// d (and, but for its value, g_N) with gradient and Hessian.
    #[doc(alias = "Eq. (57)")]
    #[inline]
    pub fn d(&self) -> Expansion<T, N, M> {
        let mut d = Expansion::zero();
        self.write_d(&mut d);
        d
    }

    /// [`Matrices::d`], written over `to`.
    #[inline]
    pub fn write_d(&self, to: &mut Expansion<T, N, M>) {
        let Expansion { value, gradient, hessian } = to;
        // Eq. (4), (37): ∇d = Gᵀn
        let n;
        (*value, n) = self.value_and_normal();
        gradient.beam = self.term("grad d: A0'n", |o| o.jet.dofs.gradient(0, &n));
        gradient.bar = -self.term("grad d: B0'n", |o| o.jet_bar.dofs.gradient(0, &n));
        if self.form.sign().is_some() {
            self.write_along_normal((*value, &n), hessian);
        } else {
            self.write_by_length(T::one() / *value, gradient, hessian);
        }
        if !U::LINEAR {
            hessian.beam += self.term("H_d: K(n)", |o| o.jet.dofs.hessian(0, &n));
        }
        if !V::LINEAR {
            hessian.bar -= self.term("H_d: K_bar(n)", |o| o.jet_bar.dofs.hessian(0, &n));
        }
    }

    /// d and n: d/|d|, or the common normal of the tangents.
    #[inline]
    fn value_and_normal(&self) -> (T, Vector3<T>) {
        let d = &self.at.d;
        match self.form.sign() {
            None => {
                let value = d.dot(d).sqrt();
                (value, d * (T::one() / value))
            }
            Some(sign) => {
                let c = self.term("n: t x t_bar", |o| o.jet.geometry.t.cross(&o.jet_bar.geometry.t));
                let n = unit_normal(&(c * T::from(sign)));
                (n.dot(d), n)
            }
        }
    }

    /// H = [Gᵀ(I − nnᵀ)G − a ggᵀ + b(gḡᵀ + ḡgᵀ) + ā ḡḡᵀ]/d, less K: Eq. (40).
    #[inline]
    fn write_by_length(&self, inverse: T, gradient: &DofVector<T, N, M>, hessian: &mut DofMatrix<T, N, M>) {
        let (Jets { g, g_bar, .. }, half) = (&self.at, T::from(0.5));
        let with_n = gradient.times(-self.term("H_d: G'nn'G", |_| half * inverse));
        let with_g = g
            .times(-self.term("H_d: a gg'", |o| half * o.matrix[0] * inverse))
            .plus(self.term("H_d: b gg_bar'", |o| o.matrix[1] * inverse), g_bar);
        let with_g_bar = g_bar.times(self.term("H_d: a_bar g_bar g_bar'", |o| half * o.matrix[2] * inverse));
        hessian.set_sum([], [(gradient, &with_n), (g, &with_g), (g_bar, &with_g_bar)]);
        self.product("H_d: A0'A0", (0, 0), |o, factor, (k, l)| {
            add_product(&mut hessian.beam, inverse * factor, (&o.jet.dofs, k), (&o.jet.dofs, l));
        });
        self.product("H_d: A0'B0", (0, 0), |o, factor, (k, l)| {
            add_product(&mut hessian.mixed, -inverse * factor, (&o.jet.dofs, k), (&o.jet_bar.dofs, l));
        });
        self.product("H_d: B0'B0", (0, 0), |o, factor, (k, l)| {
            add_product(&mut hessian.bar, inverse * factor, (&o.jet_bar.dofs, k), (&o.jet_bar.dofs, l));
        });
    }

    /// H = S_x(n) − S_x̄(n) + d [j, j̄] Γ [j, j̄]ᵀ with j = J_tᵀn and j̄ = J_t̄ᵀn, less K: see [`Form`](super::Form).
    #[inline]
    fn write_along_normal(&self, (d, n): (T, &Vector3<T>), hessian: &mut DofMatrix<T, N, M>) {
        let (Jets { g, g_bar, .. }, half) = (&self.at, T::from(0.5));
        // S_x(n) = (n·t,ξ) ggᵀ + g(A₁ᵀn)ᵀ + (A₁ᵀn)gᵀ + K_x(n)
        let with_g = DofVector::of_beam(self.term("H_d: A1'n g'", |o| o.jet.dofs.gradient(1, n)))
            .plus(self.term("H_d: n.t,xi gg'", |o| half * n.dot(&o.jet.geometry.t_xi)), g);
        let with_g_bar = DofVector::of_bar(self.term("H_d: B1'n g_bar'", |o| o.jet_bar.dofs.gradient(1, n)))
            .plus(
                self.term("H_d: n.t_bar,xi g_bar g_bar'", |o| half * n.dot(&o.jet_bar.geometry.t_xi)),
                g_bar,
            )
            .times(-T::one());
        // j = A₁ᵀn + (n·t,ξ) g   j̄ = B₁ᵀn + (n·t̄,ξ̄) ḡ
        let j = DofVector::of_beam(self.term("j: A1'n", |o| o.jet.dofs.gradient(1, n)))
            .plus(self.term("j: n.t,xi g", |o| n.dot(&o.jet.geometry.t_xi)), g);
        let j_bar = DofVector::of_bar(self.term("j_bar: B1'n", |o| o.jet_bar.dofs.gradient(1, n)))
            .plus(self.term("j_bar: n.t_bar,xi g_bar", |o| n.dot(&o.jet_bar.geometry.t_xi)), g_bar);
        let gram = |o: &Jets<'a, T, U, V, N, M>| {
            inverse_gram(&o.jet.geometry.t, &o.jet_bar.geometry.t).map(|g| g * d)
        };
        let with_j = j
            .times(self.term("H_d: d G11 jj'", |o| half * gram(o)[0]))
            .plus(self.term("H_d: d G12 jj_bar'", |o| gram(o)[1]), &j_bar);
        let with_j_bar = j_bar.times(self.term("H_d: d G22 j_bar j_bar'", |o| half * gram(o)[2]));
        hessian.set_sum([], [(g, &with_g), (g_bar, &with_g_bar), (&j, &with_j), (&j_bar, &with_j_bar)]);
    }
}
