//! Which of two equal formulas is evaluated at a point: the paper's, or one that keeps its digits where the paper's
//! cancel.
//!
//! # The distance along the normal
//! At a closest point inside both beams d is normal to both tangents, and so is t × t_bar. With n = ± t × t_bar/|t × t_bar|
//! the distance and its variations need no division by d, and hold through d = 0 as those of a signed distance:
//!
//! ```text
//! d = n·d      δd = n·δᵤû      H_d = S_x(n) − S_x̄(n) + d [J_tᵀn, J_t̄ᵀn] Γ [J_tᵀn, J_t̄ᵀn]ᵀ
//! Γ = [[t̄·t̄, −b], [−b, t·t]]/|t × t̄|²
//! ```
//!
//! The first two terms are n·Δδd of the vector, as n is normal to what Δδξ and Δδξ̄ multiply; the last is what n itself
//! varies by. In (40) a bracket of size d, made of numbers of size 1, is divided by d instead.
//!
//! # The system by cross products
//! Near parallel tangents D = a a_bar + b² loses what t²t_bar² − (t·t_bar)² cancels, and so do the numerators of (59). With
//! c = t × t_bar nothing of that size is subtracted:
//!
//! ```text
//! D = −c·c + (d·t,ξ) ā + (d·t̄,ξ̄) t·t
//! (ā R + b R̄)/D = (−ā e − b ē)/D + u·w      u = [t̄ × c − (d·t̄,ξ̄) t]/D      for R = −t·w − e,  R̄ = −t̄·w − ē
//! (−b R + a R̄)/D = (b e − a ē)/D + ū·w      ū = [t × c − (d·t,ξ) t̄]/D
//! ```
//!
//! # What is lost
//! Relative errors in units of the rounding unit u, at the angle θ, measured against double-double:
//!
//! | | paper | here |
//! |---|---|---|
//! | H_d | (t/d)² + 1/sin²θ | 1/sin θ + k/sin²θ with k = abs(d·t,ξ)/t², the gap over the radius of curvature |
//! | H_ξ, straight beams | 1/sin²θ | 1/sin θ, as for a change of the dofs in their last digits |
//!
//! So at wide angles the normal is never worse as long as abs(t,ξ)² d⁴ < t⁴ (t² + d²): at every gap below the
//! radius of curvature. The paper's (40) is better where curvature alone keeps nearly parallel beams apart, or where a tangent is short
//! next to its change and to d; the cross products are never worse.

use super::Points;
use crate::closest_point::Active;
use crate::curve::Geometry;
use crate::number::Real;
use nalgebra::Vector3;

/// The gap, in lengths of a tangent, from which on (40) loses no more than the normal at a small angle.
const FAR: f64 = 1.0 / 2.0;
/// k/sin θ from which on it loses no more than the normal at a small angle.
const CURVED: f64 = 1.0 / 8.0;
/// The squared sine of the angle from which on (52) loses next to nothing.
const WIDE: f64 = 1.0 / 16.0;
/// The range of |t × t̄|² in which products of eight lengths neither overflow nor underflow.
const SMALL: f64 = 1e-70;
const LARGE: f64 = 1e70;

/// Which parameters are held at a point, and by which formulas the rest is linearized there.
///
/// At an end the forms do not differ: one parameter's equation has nothing to cancel, and the distance of a point from a
/// curve has no second derivative that stays finite at d = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Form {
    /// Which parameters are held at an end.
    pub active: Active,
    /// How the distance is varied.
    pub distance: Distance,
    /// How the two-by-two system is solved.
    pub system: Elimination,
}

/// How the distance is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Distance {
    /// As the length of d, (37) and (40): divided by d.
    #[default]
    Length,
    /// Along the common normal n of the tangents, as a signed distance.
    Normal {
        /// Whether n is -t × t_bar/|t × t_bar|, and not t × t_bar/|t × t_bar|.
        reversed: bool,
    },
}

/// How the two-by-two system is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Elimination {
    /// By the products of its entries, (52) and (59).
    #[default]
    Products,
    /// By cross products of the tangents.
    CrossProducts,
}

impl Form {
    /// The paper's formulas.
    pub const fn paper(active: Active) -> Self {
        Self { active, distance: Distance::Length, system: Elimination::Products }
    }

    /// The formulas that keep their digits at small d and at small angles; n has the sign with n·d >= 0.
    pub fn apart(points: &Points<f64>, active: Active) -> Self {
        let reversed = points.cross().dot(&points.d) < 0.0;
        Self { active, distance: Distance::Normal { reversed }, system: Elimination::CrossProducts }
    }

    /// The formulas that lose the fewest digits at a point, up to a small factor.
    ///
    /// The cross products where sin θ < 1/4. The normal where sin θ < 1/4, k < sin θ/8 and d < t/2 for both beams, or where
    /// sin θ >= 1/4 and abs(t,ξ)² d⁴ < t⁴ (t² + d²) for both; the length elsewhere.
    ///
    /// The choice depends on ratios of lengths alone. Next to it the two forms agree within what either loses.
    #[inline]
    pub fn at(points: &Points<f64>, active: Active) -> Self {
        let Points { beam, bar, d } = points;
        let apart = Self::apart(points, active);
        let squares = Squares::at(points);
        let Squares { t2: [t2, t_bar2], c2, .. } = squares;
        let is_near = |x: &Geometry<f64>, t2: f64, other: f64| {
            let turn = d.dot(&x.t_xi);
            d.dot(d) < FAR * FAR * t2 && turn * turn * other < CURVED * CURVED * c2 * t2
        };
        let (wide, normal) = if squares.is_wide() {
            (true, squares.favour_normal())
        } else {
            (false, is_near(beam, t2, t_bar2) && is_near(bar, t_bar2, t2))
        };
        Self {
            active,
            distance: if normal { apart.distance } else { Distance::Length },
            system: if wide { Elimination::Products } else { apart.system },
        }
    }

    /// The form with n the other way round.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self.distance {
            Distance::Length => self,
            Distance::Normal { reversed } => {
                Self { distance: Distance::Normal { reversed: !reversed }, ..self }
            }
        }
    }

    /// Whether no parameter is held.
    const fn is_inside(self) -> bool {
        !self.active.xi && !self.active.xi_bar
    }

    /// Whether the system is solved by cross products.
    #[inline]
    pub fn is_crossed(self) -> bool {
        self.is_inside() && self.system == Elimination::CrossProducts
    }

    /// The sign of n to t × t_bar, if the distance is varied along n.
    #[inline]
    pub fn sign(self) -> Option<f64> {
        match self.distance {
            Distance::Normal { reversed } if self.is_inside() => Some(if reversed { -1.0 } else { 1.0 }),
            _ => None,
        }
    }
}

/// The products that decide between the forms at wide angles.
#[derive(Clone, Copy, Debug)]
pub struct Squares<T> {
    /// t·t and t̄·t̄.
    pub t2: [T; 2],
    /// t,ξ·t,ξ and its twin.
    pub t_xi2: [T; 2],
    /// c·c with c = t × t̄.
    pub c2: T,
    /// c·d, whose square is c·c d·d as d is along c.
    pub c_d: T,
}

impl<T: Real> Squares<T> {
    /// Those of both beams at their contact points.
    #[inline]
    pub fn at(points: &Points<T>) -> Self {
        let Points { beam, bar, d } = points;
        let c = points.cross();
        let square = |v: &Vector3<T>| v.dot(v);
        Self {
            t2: [square(&beam.t), square(&bar.t)],
            t_xi2: [square(&beam.t_xi), square(&bar.t_xi)],
            c2: square(&c),
            c_d: c.dot(d),
        }
    }

    /// The same over another number type.
    #[inline(always)]
    pub fn map<U>(&self, number: impl Fn(T) -> U) -> Squares<U> {
        let [t2, t_bar2] = self.t2;
        let [t_xi2, t_bar_xi2] = self.t_xi2;
        Squares {
            t2: [number(t2), number(t_bar2)],
            t_xi2: [number(t_xi2), number(t_bar_xi2)],
            c2: number(self.c2),
            c_d: number(self.c_d),
        }
    }
}

impl Squares<f64> {
    /// Whether sin²θ = c·c/(t²t̄²) is so large that (52) loses next to nothing.
    #[inline(always)]
    fn is_wide(&self) -> bool {
        let [t2, t_bar2] = self.t2;
        self.c2 >= WIDE * (t2 * t_bar2)
    }

    /// Whether the normal loses no more than (40) at a wide angle: abs(t,ξ)² d⁴ < t⁴ (t² + d²) for both beams.
    #[inline(always)]
    #[expect(clippy::needless_bitwise_bool, reason = "without a branch")]
    fn favour_normal(&self) -> bool {
        let Self { t2: [t2, t_bar2], t_xi2: [t_xi2, t_bar_xi2], c2, c_d } = *self;
        // All lengths but those of t and t,ξ times that of c.
        let d2 = c_d * c_d;
        let (sum, sum_bar) = (t2 * c2 + d2, t_bar2 * c2 + d2);
        let d4 = d2 * d2;
        (t_xi2 * d4 < t2 * t2 * (c2 * sum)) & (t_bar_xi2 * d4 < t_bar2 * t_bar2 * (c2 * sum_bar))
    }

    /// Whether [`Form::at`] takes the normal and the paper's system, in numbers whose products are in range.
    ///
    /// One branch for all conditions: the kernel goes on with what it needs anyway while they are decided.
    #[inline(always)]
    #[expect(clippy::needless_bitwise_bool, reason = "without a branch")]
    pub fn is_regular(&self) -> bool {
        self.is_wide() & self.favour_normal() & (self.c2 > SMALL) & (self.c2 < LARGE)
    }
}

/// The unit vector along a normal c = ± t × t_bar.
#[inline(always)]
pub fn unit_normal<T: Real>(c: &Vector3<T>) -> Vector3<T> {
    c * (T::one() / c.dot(c).sqrt())
}

/// Γ = [[t̄·t̄, −b], [−b, t·t]]/|t × t̄|² as [Γ₁₁, Γ₁₂, Γ₂₂]: the inverse of the tangents' Gram matrix.
#[inline(always)]
pub fn inverse_gram<T: Real>(t: &Vector3<T>, t_bar: &Vector3<T>) -> [T; 3] {
    let c = t.cross(t_bar);
    let scale = T::one() / c.dot(&c);
    [t_bar.dot(t_bar) * scale, -t.dot(t_bar) * scale, t.dot(t) * scale]
}

/// The symmetric W = [[w₁₁, w₁₂], [w₁₂, w₂₂]], as these three numbers, with
///
/// ```text
/// (I − nnᵀ + t uᵀ − t̄ ūᵀ)/d = T W Tᵀ      T = [t, −t̄]
/// ```
///
/// where n = ± t × t_bar/|t × t_bar| is normal to both tangents, d is along it, and u and ū are what δξ = u·δᵤû + .. and
/// δξ̄ = ū·δᵤû + .. multiply: the Hessian of the distance in the positions, without the division by d. `det` is -D = det H.
///
/// As H = TᵀT + d E with E = diag(n·t,ξ, −n·t̄,ξ̄), it is W = (TᵀT)⁻¹ E H⁻¹.
#[inline(always)]
pub fn weights<T: Real>(points: &Points<T>, n: &Vector3<T>, det: T) -> [T; 3] {
    let Points { beam: Geometry { t, t_xi, .. }, bar: Geometry { t: t_bar, t_xi: t_bar_xi, .. }, d } = points;
    let c = t.cross(t_bar);
    let scale = T::one() / (c.dot(&c) * det);
    let (e, e_bar, distance) = (n.dot(t_xi), -n.dot(t_bar_xi), n.dot(d));
    let (t2, t_bar2, b) = (t.dot(t), t_bar.dot(t_bar), t.dot(t_bar));
    let (h, h_bar) = (t2 + distance * e, t_bar2 + distance * e_bar);
    [
        (t_bar2 * e * h_bar + b * b * e_bar) * scale,
        b * (t_bar2 * e + h * e_bar) * scale,
        (b * b * e + t2 * e_bar * h) * scale,
    ]
}

#[cfg(test)]
mod tests {
    use super::{Active, Distance, Elimination, Form, Points, Squares, inverse_gram, unit_normal, weights};
    use crate::curve::Geometry;
    use crate::linearization::closed_form::Projection;
    use nalgebra::{Matrix3, Matrix3x2, Vector3};

    /// Curved beams whose tangents are at the angle `angle` and whose gap is d.
    fn points(angle: f64, d: f64) -> Points<f64> {
        let geometry = |x: [f64; 3], t: [f64; 3], t_xi: [f64; 3]| Geometry {
            x: x.into(),
            t: t.into(),
            t_xi: t_xi.into(),
            t_xixi: Vector3::zeros(),
        };
        let (sin, cos) = angle.sin_cos();
        let beam = geometry([0.25, 0.5, d], [1.5, 0.0, 0.0], [0.25, -0.5, 0.75]);
        let bar = geometry([0.25, 0.5, 0.0], [0.75 * cos, 0.75 * sin, 0.0], [0.5, 0.25, 0.5]);
        Points { beam, bar, d: beam.x - bar.x }
    }

    #[test]
    fn weights_are_the_hessian_in_the_positions() {
        for d in [0.5, -0.25] {
            let points = points(1.0, d);
            let (t, t_bar) = (points.beam.t, points.bar.t);
            let n = unit_normal(&(t.cross(&t_bar) * d.signum()));
            assert!((n.dot(&points.d) - d.abs()).abs() < 1e-15);
            let projection = Projection::new(&points.beam, &points.bar, Active::default());
            let [[p, q], [r, s]] = projection.inverse();
            let (u, u_bar) = (-(t * p + t_bar * q), -(t * r + t_bar * s));
            let divided = (Matrix3::identity() - n * n.transpose() + t * u.transpose()
                - t_bar * u_bar.transpose())
                / d.abs();
            let [w11, w12, w22] = weights(&points, &n, -projection.det());
            let tangents = Matrix3x2::from_columns(&[t, -t_bar]);
            let product = tangents * nalgebra::Matrix2::new(w11, w12, w12, w22) * tangents.transpose();
            assert!((product - divided).amax() < 1e-14, "{product} is not {divided}");
        }
    }

    #[test]
    fn the_inverse_of_the_gram_matrix_is_one() {
        let Points { beam, bar, .. } = points(0.75, 0.0);
        let [g11, g12, g22] = inverse_gram(&beam.t, &bar.t);
        let (t2, b, t_bar2) = (beam.t.dot(&beam.t), beam.t.dot(&bar.t), bar.t.dot(&bar.t));
        let product =
            [g11 * t2 + g12 * b, g11 * b + g12 * t_bar2, g12 * t2 + g22 * b, g12 * b + g22 * t_bar2];
        for (entry, of_unit) in product.into_iter().zip([1.0, 0.0, 0.0, 1.0]) {
            assert!((entry - of_unit).abs() < 1e-15, "{product:?}");
        }
    }

    #[test]
    fn the_form_is_that_of_the_smaller_loss() {
        let at = |angle, d| {
            let Form { distance, system, .. } = Form::at(&points(angle, d), Active::default());
            (distance, system)
        };
        let normal = |reversed| Distance::Normal { reversed };
        let (products, crossed) = (Elimination::Products, Elimination::CrossProducts);
        assert_eq!(at(1.5, 0.5), (normal(false), products));
        assert_eq!(at(1.5, 8.0), (Distance::Length, products));
        assert_eq!(at(1.5, 1e-2), (normal(false), products));
        assert_eq!(at(1.5, -1e-2), (normal(true), products));
        assert_eq!(at(1.5, 0.0), (normal(false), products));
        assert_eq!(at(1e-2, 1e-2), (Distance::Length, crossed));
        assert_eq!(at(1e-2, 1e-4), (normal(false), crossed));
        // Parallel tangents have no common normal, not even where the centroids cross.
        assert_eq!(at(0.0, 1e-9), (Distance::Length, crossed));
        assert_eq!(at(0.0, 0.0), (Distance::Length, crossed));
        // Nor do straight ones lose anything by theirs.
        let mut straight = points(1e-5, 0.25);
        (straight.beam.t_xi, straight.bar.t_xi) = (Vector3::zeros(), Vector3::zeros());
        assert_eq!(Form::at(&straight, Active::default()).distance, normal(false));
        // A slow parametrization: the tangent is short next to its change.
        let mut slow = points(1.5, 1e-2);
        slow.beam.t *= 1e-3;
        assert_eq!(Form::at(&slow, Active::default()).distance, Distance::Length);
        assert!(Squares::at(&points(1.5, 1e-9)).is_regular());
        assert!(!Squares::at(&points(1e-2, 0.25)).is_regular());
        assert!(!Squares::at(&slow).is_regular());
        let held = Form::at(&points(1e-2, 1e-5), Active { xi: true, xi_bar: false });
        assert_eq!((held.sign(), held.is_crossed()), (None, false));
    }
}
