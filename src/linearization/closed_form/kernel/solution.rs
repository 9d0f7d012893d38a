//! The results that depend on the formulation: the first variations of the parameters, and the distance.

use super::arithmetic::{Arithmetic, ScalarArithmetic, by_axis};
use super::products::Products;
use super::side::Point;
use crate::linearization::closed_form::formulation::System;
use crate::linearization::closed_form::{Formulation, Points, Projection};
use crate::number::Real;

/// The first variations of the parameters, and the distance.
#[derive(Clone, Copy)]
pub(super) struct Solution<T, V> {
    /// p, q and q_bar: the inverse of the projection's matrix is [[p, q], [-q, q_bar]].
    pub(super) inverse: [T; 3],
    /// The coefficients of u_hat in delta xi and in -delta xi_bar.
    pub(super) u: V,
    pub(super) u_bar: V,
    pub(super) distance: Distance<T, V>,
}

/// The distance, its normal n and the rows of K, its Hessian in the positions.
#[derive(Clone, Copy)]
pub(super) struct Distance<T, V> {
    pub(super) value: T,
    pub(super) n: V,
    pub(super) k: [V; 3],
}

impl<T: Real, V: Copy> Solution<T, V> {
    /// Inside both beams, by the paper's system and along the common normal with this sign relative to t × t_bar.
    #[inline(always)]
    pub(super) fn regular<A: Arithmetic<T, Vector = V>>(
        f: A,
        at: (&Point<V>, &Point<V>),
        products: &Products<T, V>,
        sign: T,
    ) -> Self {
        let (a, a_bar) = diagonal(f, at, products);
        let Products { tangents: [.., b], c2, .. } = *products;
        // Eq. (52): [[p, q], [−q, q̄]] = [[ā, b], [−b, a]]/D; with one division for 1/D and 1/c·c.
        let det = f.mul_add(a, a_bar, b * b);
        let over_both = T::one() / (c2 * det);
        let (over_c2, over_det) = (det * over_both, c2 * over_both);
        let inverse = [a_bar * over_det, b * over_det, a * over_det];
        let (u, u_bar) = mean(f, at, inverse);
        let normal = sign * c2.sqrt() * over_c2;
        Self { inverse, u, u_bar, distance: along_normal(f, at, products, inverse, (normal, over_c2)) }
    }
}

impl<T: Real> Solution<T, [T; 3]> {
    /// In any formulation, one number after the other.
    #[cold]
    #[inline(never)]
    pub(super) fn in_formulation(points: &Points<T>, form: Formulation) -> Self {
        let f = ScalarArithmetic;
        let [beam, bar] = [&points.beam, &points.bar].map(|of| {
            let [x, t, t_xi, t_xixi] = [of.x, of.t, of.t_xi, of.t_xixi].map(Into::into);
            Point { x, t, t_xi, t_xixi }
        });
        let at = (&beam, &bar);
        let products = Products::new(f, at);
        if let (Some(sign), System::Determinants) = (form.sign(), form.system) {
            return Self::regular(f, at, &products, T::from(sign));
        }
        let (inverse, (u, u_bar)) = if form.uses_cross_products() {
            cross_products(points, form)
        } else {
            let inverse = by_products(f, at, &products, form);
            (inverse, mean(f, at, inverse))
        };
        let distance = match form.sign() {
            Some(sign) => {
                let over_c2 = T::one() / products.c2;
                let normal = T::from(sign) * products.c2.sqrt() * over_c2;
                along_normal(f, at, &products, inverse, (normal, over_c2))
            }
            None => by_length(f, at, &products, (u, u_bar)),
        };
        Self { inverse, u, u_bar, distance }
    }

    /// The same solution in other vectors.
    #[inline(always)]
    pub(super) fn into_vectors<A: Arithmetic<T>>(self, f: A) -> Solution<T, A::Vector> {
        let Distance { value, n, k: [x, y, z] } = self.distance;
        let k = [f.vector(x), f.vector(y), f.vector(z)];
        let distance = Distance { value, n: f.vector(n), k };
        Solution { inverse: self.inverse, u: f.vector(self.u), u_bar: f.vector(self.u_bar), distance }
    }
}

/// Eq. (50), (51): a = t·t + d·t,ξ   b = t·t̄   ā = −t̄·t̄ + d·t̄,ξ̄
#[inline(always)]
fn diagonal<T: Real, A: Arithmetic<T>>(
    f: A,
    (beam, bar): (&Point<A::Vector>, &Point<A::Vector>),
    products: &Products<T, A::Vector>,
) -> (T, T) {
    let Products { d, tangents: [t2, t_bar2, _], .. } = *products;
    (t2 + f.dot(d, beam.t_xi), f.dot(d, bar.t_xi) - t_bar2)
}

/// p, q and q_bar by products of the matrix entries, for any held parameters.
fn by_products<T: Real, A: Arithmetic<T>>(
    f: A,
    at: (&Point<A::Vector>, &Point<A::Vector>),
    products: &Products<T, A::Vector>,
    form: Formulation,
) -> [T; 3] {
    let (zero, one) = (T::zero(), T::one());
    let (a, a_bar) = diagonal(f, at, products);
    let [.., b] = products.tangents;
    match (form.held.xi, form.held.xi_bar) {
        (false, false) => {
            let over_det = one / f.mul_add(a, a_bar, b * b);
            [a_bar * over_det, b * over_det, a * over_det]
        }
        // One parameter is held at an end, so only the other row remains.
        (true, false) => [zero, zero, one / a_bar],
        (false, true) => [one / a, zero, zero],
        (true, true) => [zero; 3],
    }
}

/// Eq. (50), (52): with R = −δᵤû·t − δᵤu,ξ·d and its twin, δξ = u·δᵤû − p d·δᵤu,ξ − q d·δᵤū,ξ̄
/// and δξ̄ = −ū·δᵤû + q d·δᵤu,ξ − q̄ d·δᵤū,ξ̄ where u = −(p t + q t̄), ū = q̄ t̄ − q t
#[inline(always)]
fn mean<T: Real, A: Arithmetic<T>>(
    f: A,
    (beam, bar): (&Point<A::Vector>, &Point<A::Vector>),
    [p, q, q_bar]: [T; 3],
) -> (A::Vector, A::Vector) {
    (f.combined([(-p, beam.t), (-q, bar.t)]), f.combined([(q_bar, bar.t), (-q, beam.t)]))
}

/// p, q and q_bar, u and u_bar without products that cancel.
fn cross_products<T: Real>(points: &Points<T>, form: Formulation) -> ([T; 3], ([T; 3], [T; 3])) {
    let projection = Projection::in_formulation(points, form);
    let [[p, q], [_, q_bar]] = projection.inverse();
    let [u, minus_u_bar] = projection.cross_products.map_or([points.d; 2], |cross_products| cross_products.u);
    ([p, q, q_bar], (u.into(), (-minus_u_bar).into()))
}

/// n = d/d   K = (I − nnᵀ + t uᵀ + t̄ ūᵀ)/d
fn by_length<T: Real, A: Arithmetic<T>>(
    f: A,
    (beam, bar): (&Point<A::Vector>, &Point<A::Vector>),
    Products { d, .. }: &Products<T, A::Vector>,
    (u, u_bar): (A::Vector, A::Vector),
) -> Distance<T, A::Vector> {
    let value = f.dot(*d, *d).sqrt();
    let curvature = T::one() / value;
    let n = f.times(curvature, *d);
    let (by_t, by_t_bar) = (f.times(curvature, beam.t), f.times(curvature, bar.t));
    let (by_t, by_t_bar) = (f.components(by_t), f.components(by_t_bar));
    let minus_n = f.components(f.times(-curvature, n));
    let (x, y, z) = by_axis(|i| {
        let k = f.times_plus(minus_n[i], n, f.along(i, curvature));
        f.times_plus(by_t_bar[i], u_bar, f.times_plus(by_t[i], u, k))
    });
    Distance { value, n, k: [x, y, z] }
}

/// n = ± c/|c| with c = t × t̄, by ± 1/|c| and 1/c·c   K = T W Tᵀ with T = [t, −t̄]
///
/// This K is that of [`by_length`] without its quotient by d: as H = TᵀT + d E, it has W = (TᵀT)⁻¹ E H⁻¹ with
/// (TᵀT)⁻¹ = [[t̄·t̄, b], [b, t·t]]/c·c, E = diag(n·t,ξ, −n·t̄,ξ̄) and H⁻¹ = [[p, −q], [−q, −q̄]].
#[inline(always)]
fn along_normal<T: Real, A: Arithmetic<T>>(
    f: A,
    (beam, bar): (&Point<A::Vector>, &Point<A::Vector>),
    products: &Products<T, A::Vector>,
    [p, q, q_bar]: [T; 3],
    (normal, over_c2): (T, T),
) -> Distance<T, A::Vector> {
    let Products { tangents: [t2, t_bar2, b], c, c_d, .. } = *products;
    let n = f.times(normal, c);
    let by_c2 = normal * over_c2;
    let (e, e_bar) = (by_c2 * f.dot(c, beam.t_xi), -by_c2 * f.dot(c, bar.t_xi));
    let (q_e, b_e_bar) = (q * e, b * e_bar);
    let w_11 = f.mul_add(p * t_bar2, e, -(q * b_e_bar));
    let minus_w_12 = f.mul_add(t_bar2, q_e, q_bar * b_e_bar);
    let w_22 = -f.mul_add(b, q_e, q_bar * t2 * e_bar);
    let by_t = f.components(f.combined([(w_11, beam.t), (minus_w_12, bar.t)]));
    let by_t_bar = f.components(f.combined([(w_22, bar.t), (minus_w_12, beam.t)]));
    let (x, y, z) = by_axis(
        #[inline(always)]
        |i| f.combined([(by_t[i], beam.t), (by_t_bar[i], bar.t)]),
    );
    Distance { value: normal * c_d, n, k: [x, y, z] }
}
