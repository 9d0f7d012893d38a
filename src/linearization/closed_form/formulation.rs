//! The choice between two equal formulas at a point: the paper's, or one that keeps its digits where the paper's
//! formula cancels.
//!
//! The formulas, and the digits that each loses, are in section 6 of the [derivation](super::derivation).

use super::Points;
use crate::closest_point::Held;
use crate::curve::Geometry;
use crate::number::Real;
use nalgebra::Vector3;

/// From this gap on, in lengths of a tangent, (40) loses no more digits than the normal at a small angle.
const FAR: f64 = 1.0 / 2.0;
/// From this ρ/sin θ on, (40) loses no more digits than the normal at a small angle.
const CURVED: f64 = 1.0 / 8.0;
/// From this squared sine of the angle on, (52) loses almost no digits.
const WIDE: f64 = 1.0 / 16.0;
/// The range of |t × t̄|² in which products of eight lengths neither overflow nor underflow.
const SMALL: f64 = 1e-70;
const LARGE: f64 = 1e70;

/// Which parameters are held at a point, and which formulas linearize the other quantities there.
///
/// At an end the formulations do not differ. The equation of one parameter has no terms that cancel, and the distance
/// of a point from a curve has no second derivative that stays finite at d = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Formulation {
    /// Which parameters are held at an end.
    pub held: Held,
    /// How the distance is varied.
    pub distance: Distance,
    /// How the two-by-two system is solved.
    pub system: System,
}

/// How the distance is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Distance {
    /// As the length of d, by (37) and (40), with a division by d.
    #[default]
    Length,
    /// Along the common normal n of the tangents, as a signed distance.
    Normal {
        /// Whether n is -t × t_bar/|t × t_bar| instead of t × t_bar/|t × t_bar|.
        reversed: bool,
    },
}

/// How the two-by-two system is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum System {
    /// By the products of its entries, (52) and (59).
    #[default]
    Determinants,
    /// By cross products of the tangents.
    CrossProducts,
}

impl Formulation {
    /// The paper's formulas.
    pub const fn paper(held: Held) -> Self {
        Self { held, distance: Distance::Length, system: System::Determinants }
    }

    /// The formulas that keep their digits at small d and at small angles. The sign of n gives n·d >= 0.
    pub fn robust(points: &Points<f64>, held: Held) -> Self {
        let reversed = points.cross().dot(&points.d) < 0.0;
        Self { held, distance: Distance::Normal { reversed }, system: System::CrossProducts }
    }

    /// The formulas that lose the fewest digits at a point, up to a small factor.
    ///
    /// Cross products are used if sin θ < 1/4. The normal is used if sin θ < 1/4, ρ < sin θ/8 and d < t/2 for both
    /// beams, or if sin θ >= 1/4 and abs(t,ξ)² d⁴ < t⁴ (t² + d²) for both. Otherwise the length is used.
    ///
    /// It depends on ratios of lengths alone if |t × t̄|² is in 1e±70. Near its limits both agree within what either loses.
    #[inline]
    pub fn at(points: &Points<f64>, held: Held) -> Self {
        let Points { beam, bar, d } = points;
        let robust = Self::robust(points, held);
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
            held,
            distance: if normal { robust.distance } else { Distance::Length },
            system: if wide { System::Determinants } else { robust.system },
        }
    }

    /// The formulation with n reversed.
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
        !self.held.xi && !self.held.xi_bar
    }

    /// Whether the system is solved by cross products.
    #[inline]
    pub fn uses_cross_products(self) -> bool {
        self.is_inside() && self.system == System::CrossProducts
    }

    /// The sign of n relative to t × t_bar, if the distance is varied along n.
    #[inline]
    pub fn sign(self) -> Option<f64> {
        match self.distance {
            Distance::Normal { reversed } if self.is_inside() => Some(if reversed { -1.0 } else { 1.0 }),
            _ => None,
        }
    }
}

/// The products that decide between the formulations at wide angles.
#[derive(Clone, Copy, Debug)]
pub struct Squares<T> {
    /// t·t and t̄·t̄.
    pub t2: [T; 2],
    /// t,ξ·t,ξ, and the same of the bar beam.
    pub t_xi2: [T; 2],
    /// c·c with c = t × t̄.
    pub c2: T,
    /// c·d, whose square is c·c d·d as d is along c.
    pub c_d: T,
}

impl<T: Real> Squares<T> {
    /// The products of both beams at their contact points.
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

    /// The same products over another number type.
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
    /// Whether sin²θ = c·c/(t²t̄²) is so large that (52) loses almost no digits.
    #[inline(always)]
    fn is_wide(&self) -> bool {
        let [t2, t_bar2] = self.t2;
        self.c2 >= WIDE * (t2 * t_bar2)
    }

    /// Whether the normal loses no more digits than (40) at a wide angle: abs(t,ξ)² d⁴ < t⁴ (t² + d²) for both beams.
    #[inline(always)]
    #[expect(clippy::needless_bitwise_bool, reason = "without a branch")]
    fn favour_normal(&self) -> bool {
        let Self { t2: [t2, t_bar2], t_xi2: [t_xi2, t_bar_xi2], c2, c_d } = *self;
        // All lengths except those of t and t,ξ are multiplied by that of c.
        let d2 = c_d * c_d;
        let (sum, sum_bar) = (t2 * c2 + d2, t_bar2 * c2 + d2);
        let d4 = d2 * d2;
        (t_xi2 * d4 < t2 * t2 * (c2 * sum)) & (t_bar_xi2 * d4 < t_bar2 * t_bar2 * (c2 * sum_bar))
    }

    /// Whether [`Formulation::at`] selects the normal and the paper's system, in numbers whose products are in range.
    ///
    /// There is one branch for all conditions, so that the kernel computes what it needs anyway during the decision.
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

#[cfg(test)]
mod tests;
