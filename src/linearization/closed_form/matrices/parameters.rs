//! The Hessians of xi and xi_bar.
//!
//! In the notation of the [derivation](super), P and P_bar are multiplied out: all of them but a product of two A or B is
//! a symmetric sum of g or g_bar with some vector, which is how they are computed. With sym(u, v) = uvᵀ + vuᵀ,
//!
//! ```text
//! P = −[sym(g, α) + sym(ḡ, β) + C + S_x(t) − S_x̄(t)]
//! α = Gᵀt,ξ + A₁ᵀt + A₂ᵀd + (t·t,ξ + ½ d·t,ξξ) g − (t̄·t,ξ) ḡ     β = −A₁ᵀt̄     C = GᵀA₁ + A₁ᵀG + K_x,ξ(d)
//! P̄ = −[sym(ḡ, ᾱ) + sym(g, β̄) + C̄ + S_x(t̄) − S_x̄(t̄)]
//! ᾱ = Gᵀt̄,ξ̄ − B₁ᵀt̄ + B₂ᵀd + (½ d·t̄,ξ̄ξ̄ − t̄·t̄,ξ̄) ḡ + (t·t̄,ξ̄) g     β̄ = B₁ᵀt     C̄ = GᵀB₁ + B₁ᵀG + K_x̄,ξ̄(d)
//! ```
//!
//! S is linear in its vector, so p P + q P_bar holds S_x(m) − S_x̄(m) with m = p t + q t_bar. Near parallel tangents the two
//! parts of m cancel, and m = −u by cross products keeps the digits that they lose ([`Form`](super::super::Form)).

use super::Matrices;
use crate::curve::{DofDerivatives, Geometry};
use crate::linearization::DofMatrix;
use crate::linearization::closed_form::jets::{Jets, MatrixTerms};
use crate::linearization::closed_form::sums::add_product;
use crate::number::Real;
use crate::pair::DofVector;
use nalgebra::{SVector, Vector3};

impl<'a, T, U, V, const N: usize, const M: usize, F> Matrices<'a, T, U, V, N, M, F>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
    F: MatrixTerms<'a, T, U, V, N, M>,
{
    /// The Hessians of xi and xi_bar.
    #[doc(alias = "Eq. (59)")]
    #[inline]
    pub fn parameters(&self) -> [DofMatrix<T, N, M>; 2] {
        let mut hessians = [DofMatrix::zeros(); 2];
        self.write_parameters(hessians.each_mut());
        hessians
    }

    /// [`Matrices::parameters`], written over `to`.
    #[inline]
    pub fn write_parameters(&self, to: [&mut DofMatrix<T, N, M>; 2]) {
        let Jets { g, g_bar, .. } = &self.at;
        let [alpha, beta, alpha_bar, beta_bar] = self.vectors();
        // H_ξ = (ā P + b P̄)/D   H_ξ̄ = (−b P + a P̄)/D, each P sorted by g and ḡ
        let inverse = self.projection.inverse_with(&self.terms);
        for (i, (hessian, [p, q])) in to.into_iter().zip(inverse).enumerate() {
            let m = self.mean(i, [p, q]);
            let [of_g, of_g_bar] = self.vectors_along(&m);
            let with_g = alpha.times(-p).plus(-q, &beta_bar).plus(-T::one(), &of_g);
            let with_g_bar = alpha_bar.times(-q).plus(-p, &beta).plus(T::one(), &of_g_bar);
            hessian.set_sum([], [(g, &with_g), (g_bar, &with_g_bar)]);
            // C = GᵀA₁ + A₁ᵀG + K_x,ξ(d)   C̄ = GᵀB₁ + B₁ᵀG + K_x̄,ξ̄(d)
            self.product("C: A0'A1", (0, 1), |o, factor, (k, l)| {
                add_product(&mut hessian.beam, -p * factor, (&o.jet.dofs, k), (&o.jet.dofs, l));
            });
            self.product("C: A1'A0", (1, 0), |o, factor, (k, l)| {
                add_product(&mut hessian.beam, -p * factor, (&o.jet.dofs, k), (&o.jet.dofs, l));
            });
            self.product("C: A1'B0", (1, 0), |o, factor, (k, l)| {
                add_product(&mut hessian.mixed, p * factor, (&o.jet.dofs, k), (&o.jet_bar.dofs, l));
            });
            self.product("C_bar: A0'B1", (0, 1), |o, factor, (k, l)| {
                add_product(&mut hessian.mixed, -q * factor, (&o.jet.dofs, k), (&o.jet_bar.dofs, l));
            });
            self.product("C_bar: B0'B1", (0, 1), |o, factor, (k, l)| {
                add_product(&mut hessian.bar, q * factor, (&o.jet_bar.dofs, k), (&o.jet_bar.dofs, l));
            });
            self.product("C_bar: B1'B0", (1, 0), |o, factor, (k, l)| {
                add_product(&mut hessian.bar, q * factor, (&o.jet_bar.dofs, k), (&o.jet_bar.dofs, l));
            });
            // S_x(m) − S_x̄(m) has K_x(m) − K_x̄(m)
            if !U::LINEAR {
                hessian.beam -= self.term("S: K(m)", |o| o.jet.dofs.hessian(0, &m))
                    + self.term("C: K,xi(d)", |o| o.jet.dofs.hessian(1, &(o.d * p)));
            }
            if !V::LINEAR {
                hessian.bar += self.term("S: K_bar(m)", |o| o.jet_bar.dofs.hessian(0, &m))
                    - self.term("C_bar: K_bar,xi(d)", |o| o.jet_bar.dofs.hessian(1, &(o.d * q)));
            }
        }
    }

    /// m = p t + q t_bar, where p and q are the row `i` of the inverse matrix.
    #[inline]
    pub(super) fn mean(&self, i: usize, [p, q]: [T; 2]) -> Vector3<T> {
        self.projection.crossed.map_or_else(
            || {
                self.term("m: t", |o| o.jet.geometry.t) * p
                    + self.term("m: t_bar", |o| o.jet_bar.geometry.t) * q
            },
            |crossed| -self.term("m: u", |_| crossed.u[i]),
        )
    }

    /// The vectors v and v_bar of S_x(m) − S_x̄(m) = sym(g, v) − sym(ḡ, v̄) + K_x(m) − K_x̄(m).
    #[inline]
    fn vectors_along(&self, m: &Vector3<T>) -> [DofVector<T, N, M>; 2] {
        let (Jets { g, g_bar, .. }, half) = (&self.at, T::from(0.5));
        // v = A₁ᵀm + ½(m·t,ξ) g   v̄ = B₁ᵀm + ½(m·t̄,ξ̄) ḡ
        let v = DofVector::of_beam(self.term("S: A1'm g'", |o| o.jet.dofs.gradient(1, m)));
        let v_bar = DofVector::of_bar(self.term("S: B1'm g_bar'", |o| o.jet_bar.dofs.gradient(1, m)));
        [
            v.plus(half * self.term("S: m.t,xi gg'", |o| m.dot(&o.jet.geometry.t_xi)), g),
            v_bar.plus(
                half * self.term("S: m.t_bar,xi g_bar g_bar'", |o| m.dot(&o.jet_bar.geometry.t_xi)),
                g_bar,
            ),
        ]
    }

    /// The vectors alpha, beta, alpha_bar, beta_bar of the module's derivation.
    #[inline]
    fn vectors(&self) -> [DofVector<T, N, M>; 4] {
        let Jets { g, g_bar, .. } = &self.at;
        let half = T::from(0.5);
        let scalar = |name, term: fn(&Geometry<T>, &Geometry<T>, &Vector3<T>) -> T| {
            self.term(name, |o| term(&o.jet.geometry, &o.jet_bar.geometry, &o.d))
        };
        let beam = |name, k, vector: fn(&Jets<'a, T, U, V, N, M>) -> Vector3<T>| -> SVector<T, N> {
            self.term(name, |o| o.jet.dofs.gradient(k, &vector(o)))
        };
        let bar = |name, k, vector: fn(&Jets<'a, T, U, V, N, M>) -> Vector3<T>| -> SVector<T, M> {
            self.term(name, |o| o.jet_bar.dofs.gradient(k, &vector(o)))
        };
        // α = Gᵀt,ξ + A₁ᵀt + A₂ᵀd + (t·t,ξ + ½ d·t,ξξ) g − (t̄·t,ξ) ḡ
        let alpha = DofVector {
            beam: beam("alpha: A0't,xi", 0, |o| o.jet.geometry.t_xi)
                + beam("alpha: A1't", 1, |o| o.jet.geometry.t)
                + beam("alpha: A2'd", 2, |o| o.d),
            bar: -bar("alpha: B0't,xi", 0, |o| o.jet.geometry.t_xi),
        }
        .plus(
            scalar("alpha: t.t,xi g", |x, _, _| x.t.dot(&x.t_xi))
                + half * scalar("alpha: d.t,xixi g", |x, _, d| d.dot(&x.t_xixi)),
            g,
        )
        .plus(-scalar("alpha: t_bar.t,xi g_bar", |x, y, _| y.t.dot(&x.t_xi)), g_bar);
        // β = −A₁ᵀt̄
        let beta = DofVector::of_beam(-beam("beta: A1't_bar", 1, |o| o.jet_bar.geometry.t));
        // ᾱ = Gᵀt̄,ξ̄ − B₁ᵀt̄ + B₂ᵀd + (½ d·t̄,ξ̄ξ̄ − t̄·t̄,ξ̄) ḡ + (t·t̄,ξ̄) g
        let alpha_bar = DofVector {
            beam: beam("alpha_bar: A0't_bar,xi", 0, |o| o.jet_bar.geometry.t_xi),
            bar: bar("alpha_bar: B2'd", 2, |o| o.d)
                - bar("alpha_bar: B0't_bar,xi", 0, |o| o.jet_bar.geometry.t_xi)
                - bar("alpha_bar: B1't_bar", 1, |o| o.jet_bar.geometry.t),
        }
        .plus(
            half * scalar("alpha_bar: d.t_bar,xixi g_bar", |_, y, d| d.dot(&y.t_xixi))
                - scalar("alpha_bar: t_bar.t_bar,xi g_bar", |_, y, _| y.t.dot(&y.t_xi)),
            g_bar,
        )
        .plus(scalar("alpha_bar: t.t_bar,xi g", |x, y, _| x.t.dot(&y.t_xi)), g);
        // β̄ = B₁ᵀt
        let beta_bar = DofVector::of_bar(bar("beta_bar: B1't", 1, |o| o.jet.geometry.t));
        [alpha, beta, alpha_bar, beta_bar]
    }
}
