//! The Hessians of xi and xi_bar.
//!
//! The vectors are those of P and P_bar, multiplied out, in section 5 of the [derivation](super::super::derivation).

use super::Matrices;
use crate::curve::{DofDerivatives, Jet};
use crate::linearization::BlockHessian;
use crate::linearization::closed_form::sums::add_product;
use crate::number::{Formula, Real, named, orders};
use crate::pair::DofVector;
#[cfg(beamgap_faults)]
use crate::source_fault::source_fault;
use nalgebra::Vector3;

impl<T, U, V, const N: usize, const M: usize> Matrices<'_, T, U, V, N, M>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
{
    /// The Hessians of xi and xi_bar.
    #[doc(alias = "Eq. (59)")]
    #[inline]
    pub fn parameters(&self) -> [BlockHessian<T, N, M>; 2] {
        let mut hessians = [BlockHessian::zeros(); 2];
        self.write_parameters(hessians.each_mut());
        hessians
    }

    /// [`Matrices::parameters`], written over `to`.
    #[inline]
    pub fn write_parameters(&self, to: [&mut BlockHessian<T, N, M>; 2]) {
        let Self { jet: Jet { dofs: a, .. }, jet_bar: Jet { dofs: b, .. }, d, g, g_bar, .. } = self;
        let [alpha, beta, alpha_bar, beta_bar] = self.vectors();
        // H_ξ = (ā P + b P̄)/D   H_ξ̄ = (−b P + a P̄)/D, each P sorted by g and ḡ
        let inverse = self.projection.inverse();
        for (i, (hessian, [p, q])) in to.into_iter().zip(inverse).enumerate() {
            let m = self.mean(i, [p, q]);
            let [of_g, of_g_bar] = self.vectors_along(&m);
            let with_g = alpha.times(-p).plus(-q, &beta_bar).plus(-T::one(), &of_g);
            let with_g_bar = alpha_bar.times(-q).plus(-p, &beta).plus(T::one(), &of_g_bar);
            hessian.set_sum(&[], &[[g, &with_g], [g_bar, &with_g_bar]]);
            // C = GᵀA₁ + A₁ᵀG + K_x,ξ(d)   C̄ = GᵀB₁ + B₁ᵀG + K_x̄,ξ̄(d)
            let BlockHessian { beam, mixed, bar } = hessian;
            let [k, l] = orders::<T>(Formula::C, "A0'A1", [0, 1]);
            add_product(beam, -named(Formula::C, "A0'A1", p), (a, k), (a, l));
            let [k, l] = orders::<T>(Formula::C, "A1'A0", [1, 0]);
            add_product(beam, -named(Formula::C, "A1'A0", p), (a, k), (a, l));
            let [k, l] = orders::<T>(Formula::C, "A1'B0", [1, 0]);
            add_product(mixed, named(Formula::C, "A1'B0", p), (a, k), (b, l));
            let [k, l] = orders::<T>(Formula::CBar, "A0'B1", [0, 1]);
            add_product(mixed, -named(Formula::CBar, "A0'B1", q), (a, k), (b, l));
            let [k, l] = orders::<T>(Formula::CBar, "B0'B1", [0, 1]);
            add_product(bar, named(Formula::CBar, "B0'B1", q), (b, k), (b, l));
            let [k, l] = orders::<T>(Formula::CBar, "B1'B0", [1, 0]);
            add_product(bar, named(Formula::CBar, "B1'B0", q), (b, k), (b, l));
            // S_x(m) − S_x̄(m) has K_x(m) − K_x̄(m)
            if !U::LINEAR {
                *beam -= named(Formula::S, "K(m)", a.hessian(0, &m))
                    + named(Formula::C, "K,xi(d)", a.hessian(1, &(d * p)));
            }
            if !V::LINEAR {
                *bar += named(Formula::S, "K_bar(m)", b.hessian(0, &m))
                    - named(Formula::CBar, "K_bar,xi(d)", b.hessian(1, &(d * q)));
            }
        }
    }

    /// m = p t + q t_bar, where p and q are the row `i` of the inverse matrix.
    #[inline]
    pub(super) fn mean(&self, i: usize, [p, q]: [T; 2]) -> Vector3<T> {
        self.projection.cross_products.map_or_else(
            || {
                named(Formula::M, "t", self.jet.geometry.t) * p
                    + named(Formula::M, "t_bar", self.jet_bar.geometry.t) * q
            },
            |cross_products| -named(Formula::M, "u", cross_products.u[i]),
        )
    }

    /// The vectors v and v_bar of S_x(m) − S_x̄(m) = sym(g, v) − sym(ḡ, v̄) + K_x(m) − K_x̄(m).
    #[inline]
    fn vectors_along(&self, m: &Vector3<T>) -> [DofVector<T, N, M>; 2] {
        let Self {
            jet: Jet { geometry: x, dofs: a }, jet_bar: Jet { geometry: y, dofs: b }, g, g_bar, ..
        } = self;
        let half = T::from(0.5);
        // v = A₁ᵀm + ½(m·t,ξ) g   v̄ = B₁ᵀm + ½(m·t̄,ξ̄) ḡ
        let v = DofVector::of_beam(named(Formula::S, "A1'm g'", a.gradient(1, m)));
        let v_bar = DofVector::of_bar(named(Formula::S, "B1'm g_bar'", b.gradient(1, m)));
        [
            v.plus(half * named(Formula::S, "m.t,xi gg'", m.dot(&x.t_xi)), g),
            v_bar.plus(half * named(Formula::S, "m.t_bar,xi g_bar g_bar'", m.dot(&y.t_xi)), g_bar),
        ]
    }

    /// The vectors alpha, beta, alpha_bar, beta_bar of the derivation.
    #[inline]
    fn vectors(&self) -> [DofVector<T, N, M>; 4] {
        let Self {
            jet: Jet { geometry: x, dofs: a },
            jet_bar: Jet { geometry: y, dofs: b },
            d,
            g,
            g_bar,
            ..
        } = self;
        let half = T::from(0.5);
        // α = Gᵀt,ξ + A₁ᵀt + A₂ᵀd + (t·t,ξ + ½ d·t,ξξ) g − (t̄·t,ξ) ḡ
        let alpha = DofVector {
            beam: named(Formula::Alpha, "A0't,xi", a.gradient(0, &x.t_xi))
                + named(Formula::Alpha, "A1't", a.gradient(1, &x.t))
                + named(Formula::Alpha, "A2'd", a.gradient(2, d)),
            bar: -named(Formula::Alpha, "B0't,xi", b.gradient(0, &x.t_xi)),
        }
        .plus(
            named(Formula::Alpha, "t.t,xi g", x.t.dot(&x.t_xi))
                + half * named(Formula::Alpha, "d.t,xixi g", d.dot(&x.t_xixi)),
            g,
        )
        .plus(-named(Formula::Alpha, "t_bar.t,xi g_bar", y.t.dot(&x.t_xi)), g_bar);
        // β = −A₁ᵀt̄
        let beta = DofVector::of_beam(-named(Formula::Beta, "A1't_bar", a.gradient(1, &y.t)));
        // ᾱ = Gᵀt̄,ξ̄ − B₁ᵀt̄ + B₂ᵀd + (½ d·t̄,ξ̄ξ̄ − t̄·t̄,ξ̄) ḡ + (t·t̄,ξ̄) g
        let alpha_bar = DofVector {
            beam: named(Formula::AlphaBar, "A0't_bar,xi", a.gradient(0, &y.t_xi)),
            bar: named(Formula::AlphaBar, "B2'd", b.gradient(2, d))
                - named(Formula::AlphaBar, "B0't_bar,xi", b.gradient(0, &y.t_xi))
                - named(Formula::AlphaBar, "B1't_bar", b.gradient(1, &y.t)),
        }
        .plus(
            half * named(Formula::AlphaBar, "d.t_bar,xixi g_bar", d.dot(&y.t_xixi))
                - named(Formula::AlphaBar, "t_bar.t_bar,xi g_bar", y.t.dot(&y.t_xi)),
            g_bar,
        )
        .plus(named(Formula::AlphaBar, "t.t_bar,xi g", x.t.dot(&y.t_xi)), g);
        // β̄ = B₁ᵀt
        let beta_bar = DofVector::of_bar(named(Formula::BetaBar, "B1't", b.gradient(1, &x.t)));
        #[cfg(beamgap_faults)]
        let beta_bar = source_fault!("sign-of-beta": beta_bar.times(-T::one()), beta_bar);
        [alpha, beta, alpha_bar, beta_bar]
    }
}
