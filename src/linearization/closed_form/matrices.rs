//! Gradients and Hessians in all dofs of both beams: the step from variations to matrices.
//!
//! # Derivation
//! Stack the dofs of beam and bar beam. With A_k the Jacobian of the k-th xi-derivative of x (zero on the bar beam),
//! B_k its twin, and G = A_0 - B_0, the variations are delta_u u,xi = A_1 dQ and so on. Let g and g_bar be the
//! gradients of xi and xi_bar, and K(w) the second derivatives of w . x in the dofs. The Jacobians of d and t are
//!
//! ```text
//! J_d = G + t gᵀ − t̄ ḡᵀ        J_t = A₁ + t,ξ gᵀ        J_t̄ = B₁ + t̄,ξ̄ ḡᵀ
//! ```
//!
//! and Δδ(d·t) = 0, Δδ(d·t̄) = 0 (48) become
//!
//! ```text
//! P = −[J_dᵀJ_t + J_tᵀJ_d + S_x(t) − S_x̄(t) + S_t(d)]     P̄ = −[J_dᵀJ_t̄ + J_t̄ᵀJ_d + S_x(t̄) − S_x̄(t̄) + S_t̄(d)]
//! S_x(w) = (w·t,ξ) ggᵀ + g(A₁ᵀw)ᵀ + (A₁ᵀw)gᵀ + K_x(w)     S_t(w) = (w·t,ξξ) ggᵀ + g(A₂ᵀw)ᵀ + (A₂ᵀw)gᵀ + K_x,ξ(w)
//! ```
//!
//! Multiplied out, all of this but a product of two A or B is a symmetric sum of g or ḡ with some vector, which is how
//! it is computed: with sym(u, v) = uvᵀ + vuᵀ,
//!
//! ```text
//! P = −[sym(g, α) + sym(ḡ, β) + C]
//! α = Gᵀt,ξ + 2A₁ᵀt + A₂ᵀd + ½(3 t·t,ξ + d·t,ξξ) g − (t̄·t,ξ) ḡ     β = −A₁ᵀt̄ − B₁ᵀt − ½(t·t̄,ξ̄) ḡ
//! C = GᵀA₁ + A₁ᵀG + K_x(t) − K_x̄(t) + K_x,ξ(d)
//! P̄ = −[sym(ḡ, ᾱ) + sym(g, β̄) + C̄]
//! ᾱ = Gᵀt̄,ξ̄ − 2B₁ᵀt̄ + B₂ᵀd + ½(d·t̄,ξ̄ξ̄ − 3 t̄·t̄,ξ̄) ḡ + (t·t̄,ξ̄) g   β̄ = A₁ᵀt̄ + B₁ᵀt + ½(t̄·t,ξ) g
//! C̄ = GᵀB₁ + B₁ᵀG + K_x(t̄) − K_x̄(t̄) + K_x̄,ξ̄(d)
//! ```

use super::Projection;
use super::sums::{add_product, write_length, write_slip};
use crate::closest_point::Active;
use crate::curve::{DofDerivatives, Geometry, Jet};
use crate::linearization::{DofMatrix, Expansion, Linearization};
use crate::number::Real;
use crate::pair::{Contact, DofVector};
use nalgebra::Vector3;

/// The linearization of a pair at its closest point, from which each quantity is taken on demand.
///
/// Whoever needs the gap alone asks for [`Matrices::d`] and pays for no Hessian of a parameter.
#[derive(Clone, Copy, Debug)]
pub struct Matrices<'a, T, U, V, const N: usize, const M: usize> {
    jet: &'a Jet<T, U>,
    jet_bar: &'a Jet<T, V>,
    d: Vector3<T>,
    projection: Projection<T>,
    /// The gradient of xi, g.
    g: DofVector<T, N, M>,
    /// The gradient of xi_bar, g_bar.
    g_bar: DofVector<T, N, M>,
}

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

impl<'a, T, U, V, const N: usize, const M: usize> Matrices<'a, T, U, V, N, M>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
{
    /// The first order: gradients of xi and xi_bar, from the jets of both curves at the closest point.
    #[doc(alias = "compute_lin_xi_and_lin_eta")]
    #[inline]
    pub fn new(jet: &'a Jet<T, U>, jet_bar: &'a Jet<T, V>, active: Active) -> Self {
        let (t, t_bar) = (&jet.geometry.t, &jet_bar.geometry.t);
        let d = jet.geometry.x - jet_bar.geometry.x;
        let projection = Projection::new(&jet.geometry, &jet_bar.geometry, active);
        let (a, b) = (&jet.dofs, &jet_bar.dofs);
        // Eq. (50): r = −(Gᵀt + A₁ᵀd)   r̄ = −(Gᵀt̄ + B₁ᵀd)
        let r = DofVector { beam: -(a.gradient(0, t) + a.gradient(1, &d)), bar: b.gradient(0, t) };
        let r_bar = DofVector { beam: -a.gradient(0, t_bar), bar: b.gradient(0, t_bar) - b.gradient(1, &d) };
        // Eq. (52): g = (ā r + b r̄)/D   ḡ = (−b r + a r̄)/D
        let [[p, q], [p_bar, q_bar]] = projection.inverse();
        let g = r.times(p).plus(q, &r_bar);
        let g_bar = r.times(p_bar).plus(q_bar, &r_bar);
        Self { jet, jet_bar, d, projection, g, g_bar }
    }

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
        let Projection { a, b, a_bar, .. } = self.projection;
        let (x, y) = (&self.jet.dofs, &self.jet_bar.dofs);
        let Expansion { value, gradient, hessian } = to;
        // Eq. (4), (37): ∇d = Gᵀn
        *value = self.d.dot(&self.d).sqrt();
        let (inverse, half) = (T::one() / *value, T::from(0.5));
        let n = self.d * inverse;
        *gradient = DofVector { beam: x.gradient(0, &n), bar: -y.gradient(0, &n) };
        // Eq. (40): H = [Gᵀ(I − nnᵀ)G − a ggᵀ + b(gḡᵀ + ḡgᵀ) + ā ḡḡᵀ]/d + K_x(n) − K_x̄(n)
        let (g, g_bar) = (&self.g, &self.g_bar);
        let with_n = gradient.times(-half * inverse);
        let with_g = g.times(-half * a * inverse).plus(b * inverse, g_bar);
        let with_g_bar = g_bar.times(half * a_bar * inverse);
        hessian.set_sum([], [(gradient, &with_n), (g, &with_g), (g_bar, &with_g_bar)]);
        add_product(&mut hessian.beam, inverse, (x, 0), (x, 0));
        add_product(&mut hessian.mixed, -inverse, (x, 0), (y, 0));
        add_product(&mut hessian.bar, inverse, (y, 0), (y, 0));
        if !U::LINEAR {
            hessian.beam += x.hessian(0, &n);
        }
        if !V::LINEAR {
            hessian.bar -= y.hessian(0, &n);
        }
    }

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
        let (x, y) = (&self.jet.geometry, &self.jet_bar.geometry);
        let (a, b) = (&self.jet.dofs, &self.jet_bar.dofs);
        let (d, g, g_bar) = (&self.d, &self.g, &self.g_bar);
        let [half, two, three] = [0.5, 2.0, 3.0].map(<T as From<f64>>::from);

        // The vectors of the module's derivation.
        let alpha = DofVector {
            beam: a.gradient(0, &x.t_xi) + a.gradient(1, &x.t) * two + a.gradient(2, d),
            bar: -b.gradient(0, &x.t_xi),
        }
        .plus(half * (three * x.t.dot(&x.t_xi) + d.dot(&x.t_xixi)), g)
        .plus(-y.t.dot(&x.t_xi), g_bar);
        let beta = DofVector { beam: -a.gradient(1, &y.t), bar: -b.gradient(1, &x.t) }
            .plus(-half * x.t.dot(&y.t_xi), g_bar);
        let alpha_bar = DofVector {
            beam: a.gradient(0, &y.t_xi),
            bar: b.gradient(2, d) - b.gradient(0, &y.t_xi) - b.gradient(1, &y.t) * two,
        }
        .plus(half * (d.dot(&y.t_xixi) - three * y.t.dot(&y.t_xi)), g_bar)
        .plus(x.t.dot(&y.t_xi), g);
        let beta_bar = DofVector { beam: a.gradient(1, &y.t), bar: b.gradient(1, &x.t) }
            .plus(half * y.t.dot(&x.t_xi), g);

        // H_ξ = (ā P + b P̄)/D   H_ξ̄ = (−b P + a P̄)/D, each P sorted by g and ḡ
        for (hessian, [p, q]) in to.into_iter().zip(self.projection.inverse()) {
            let with_g = alpha.times(-p).plus(-q, &beta_bar);
            let with_g_bar = alpha_bar.times(-q).plus(-p, &beta);
            hessian.set_sum([], [(g, &with_g), (g_bar, &with_g_bar)]);
            // C = GᵀA₁ + A₁ᵀG + K_x(t) − K_x̄(t) + K_x,ξ(d)   C̄ = GᵀB₁ + B₁ᵀG + K_x(t̄) − K_x̄(t̄) + K_x̄,ξ̄(d)
            add_product(&mut hessian.beam, -p, (a, 0), (a, 1));
            add_product(&mut hessian.beam, -p, (a, 1), (a, 0));
            add_product(&mut hessian.mixed, p, (a, 1), (b, 0));
            add_product(&mut hessian.mixed, -q, (a, 0), (b, 1));
            add_product(&mut hessian.bar, q, (b, 0), (b, 1));
            add_product(&mut hessian.bar, q, (b, 1), (b, 0));
            // K is linear in its vector.
            if !U::LINEAR {
                hessian.beam -= a.hessian(0, &(x.t * p + y.t * q)) + a.hessian(1, &(d * p));
            }
            if !V::LINEAR {
                hessian.bar += b.hessian(0, &(x.t * p + y.t * q)) - b.hessian(1, &(d * q));
            }
        }
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
        let Linearization { d, t, t_bar, xi, xi_bar, g_t, g_t_bar } = to;
        self.write_d(d);
        (xi.value, xi.gradient) = (at, self.g);
        (xi_bar.value, xi_bar.gradient) = (at_bar, self.g_bar);
        self.write_parameters([&mut xi.hessian, &mut xi_bar.hessian]);
        self.write_t(xi, t);
        self.write_t_bar(xi_bar, t_bar);
        write_slip(t, xi, contact.xi_0, g_t);
        write_slip(t_bar, xi_bar, contact.xi_bar_0, g_t_bar);
    }

    /// w . v for a fixed vector w and a vector quantity v; unit vectors for w give its components.
    ///
    /// `parameters` are xi and xi_bar as in [`Linearization`].
    #[doc(alias = "Eq. (31)")]
    #[doc(alias = "Eq. (32)")]
    pub fn vector(
        &self,
        quantity: VectorQuantity,
        w: &Vector3<T>,
        parameters: [&Expansion<T, N, M>; 2],
    ) -> Expansion<T, N, M> {
        let (x, y) = (&self.jet.geometry, &self.jet_bar.geometry);
        let [xi, xi_bar] = parameters;
        let (minus, one) = (-T::one(), T::one());
        // The beam's part, of order k in ξ, and the bar beam's, each with its sign.
        let (value, k, beam, bar) = match quantity {
            VectorQuantity::X => (w.dot(&x.x), 0, Some(one), None),
            VectorQuantity::XBar => (w.dot(&y.x), 0, None, Some(one)),
            VectorQuantity::D => (w.dot(&self.d), 0, Some(one), Some(minus)),
            VectorQuantity::T => (w.dot(&x.t), 1, Some(one), None),
            VectorQuantity::TBar => (w.dot(&y.t), 1, None, Some(one)),
        };
        let slopes = |of: &Geometry<T>| match k {
            0 => (w.dot(&of.t), w.dot(&of.t_xi)),
            _ => (w.dot(&of.t_xi), w.dot(&of.t_xixi)),
        };
        let half = T::from(0.5);
        // Hess(w·x_C) = (w·t) H_ξ + S_x(w)   Hess(w·x_C,ξ) = (w·t,ξ) H_ξ + S_t(w)
        let (mut gradient, mut hessian) = (DofVector::zeros(), DofMatrix::zeros());
        if let Some(sign) = beam {
            let (first, second) = slopes(x);
            let own = DofVector::of_beam(self.jet.dofs.gradient(k, w));
            let along = DofVector::of_beam(self.jet.dofs.gradient(k + 1, w));
            gradient = own.plus(first, &xi.gradient).times(sign);
            let with = along.plus(half * second, &xi.gradient).times(sign);
            hessian.set_sum([(sign * first, &xi.hessian)], [(&xi.gradient, &with)]);
        }
        if let Some(sign) = bar {
            let (first, second) = slopes(y);
            let own = DofVector::of_bar(self.jet_bar.dofs.gradient(k, w));
            let along = DofVector::of_bar(self.jet_bar.dofs.gradient(k + 1, w));
            gradient = gradient.plus(sign, &own.plus(first, &xi_bar.gradient));
            let with = along.plus(half * second, &xi_bar.gradient).times(sign);
            let beam = hessian;
            hessian
                .set_sum([(T::one(), &beam), (sign * first, &xi_bar.hessian)], [(&xi_bar.gradient, &with)]);
        }
        if !U::LINEAR
            && let Some(sign) = beam
        {
            hessian.beam += self.jet.dofs.hessian(k, w) * sign;
        }
        if !V::LINEAR
            && let Some(sign) = bar
        {
            hessian.bar += self.jet_bar.dofs.hessian(k, w) * sign;
        }
        Expansion { value, gradient, hessian }
    }

    /// t, written over `to`.
    #[inline]
    fn write_t(&self, xi: &Expansion<T, N, M>, to: &mut Expansion<T, N, M>) {
        let of = &self.jet.dofs;
        let gradient = |k, w: &Vector3<T>| DofVector::of_beam(of.gradient(k, w));
        let (inverse, w) = write_length(&self.jet.geometry, gradient, xi, to);
        add_product(&mut to.hessian.beam, inverse, (of, 1), (of, 1));
        if !U::LINEAR {
            to.hessian.beam += of.hessian(1, &w);
        }
    }

    /// t_bar, written over `to`.
    #[inline]
    fn write_t_bar(&self, xi_bar: &Expansion<T, N, M>, to: &mut Expansion<T, N, M>) {
        let of = &self.jet_bar.dofs;
        let gradient = |k, w: &Vector3<T>| DofVector::of_bar(of.gradient(k, w));
        let (inverse, w) = write_length(&self.jet_bar.geometry, gradient, xi_bar, to);
        add_product(&mut to.hessian.bar, inverse, (of, 1), (of, 1));
        if !V::LINEAR {
            to.hessian.bar += of.hessian(1, &w);
        }
    }
}
