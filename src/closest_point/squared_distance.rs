//! The gradient and the Hessian of half the squared distance at a pair of points, and their scale-free measures.

mod step;

use super::held::{Held, SINGULAR, STANDSTILL, WEAK};
use crate::curve::Geometry;
use nalgebra::{Vector2, Vector3};

/// Lengths below this, relative to the positions and tangents, are zero to rounding.
const ROUNDING: f64 = 9e-16;

/// F = |d|²/2 with its derivatives in (xi, xi_bar) at a pair of points.
///
/// The Hessian is H = [[a, -b], [-b, -a_bar]], and the determinant of the linearized orthogonality conditions is
/// D = a a_bar + b² = -det H.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SquaredDistance {
    /// d = x - x_bar.
    pub d: Vector3<f64>,
    /// ‖d‖.
    pub distance: f64,
    /// The gradient (d·t, -d·t_bar).
    pub gradient: [f64; 2],
    /// a = t·t + d·t,xi.
    pub a: f64,
    /// b = t·t_bar.
    pub b: f64,
    /// a_bar = -t_bar·t_bar + d·t_bar,xi_bar.
    pub a_bar: f64,
    /// det H = -D, without the cancellation of t²t_bar² - b² between nearly parallel tangents.
    pub det: f64,
    /// t·t and t_bar·t_bar.
    pub(super) squares: [f64; 2],
    /// t,xi·t,xi and t,xixi·t,xixi, and those of the bar beam.
    bends: [f64; 2],
    twists: [f64; 2],
    /// The third derivatives: three times in xi, twice in xi and once in xi_bar, and so on.
    third: [f64; 4],
    /// The sum of the squares of the positions and the tangents.
    pub(super) size2: f64,
}

impl SquaredDistance {
    /// The derivatives of half the squared distance between two points.
    #[inline(always)]
    pub fn new(x: &Geometry<f64>, x_bar: &Geometry<f64>) -> Self {
        let d = x.x - x_bar.x;
        let squares = [x.t.norm_squared(), x_bar.t.norm_squared()];
        let (p, q) = (d.dot(&x.t_xi), d.dot(&x_bar.t_xi));
        Self {
            d,
            distance: d.norm(),
            gradient: [d.dot(&x.t), -d.dot(&x_bar.t)],
            a: squares[0] + p,
            b: x.t.dot(&x_bar.t),
            a_bar: q - squares[1],
            // det H = |t × t_bar|² + p t_bar² - q t² - p q with p = d·t,xi and q = d·t_bar,xi_bar.
            det: (x.t.cross(&x_bar.t).norm_squared() - p * q) + (p * squares[1] - q * squares[0]),
            squares,
            bends: [x.t_xi.norm_squared(), x_bar.t_xi.norm_squared()],
            twists: [x.t_xixi.norm_squared(), x_bar.t_xixi.norm_squared()],
            third: [
                3.0 * x.t.dot(&x.t_xi) + d.dot(&x.t_xixi),
                -x_bar.t.dot(&x.t_xi),
                -x.t.dot(&x_bar.t_xi),
                3.0 * x_bar.t.dot(&x_bar.t_xi) - d.dot(&x_bar.t_xixi),
            ],
            size2: x.x.norm_squared() + x_bar.x.norm_squared() + squares[0] + squares[1],
        }
    }

    /// Whether the squares of all numbers of both curves are finite, and hence the numbers themselves.
    pub(super) fn is_finite(&self) -> bool {
        let [bend, bend_bar] = self.bends;
        let [twist, twist_bar] = self.twists;
        (self.size2 + (bend + bend_bar) + (twist + twist_bar)).is_finite()
    }

    /// D = a a_bar + b².
    #[doc(alias = "Eq. (52)")]
    pub fn determinant(&self) -> f64 {
        -self.det
    }

    /// The smallest eigenvalue of the Hessian for unit tangents, over the parameters that are not held.
    ///
    /// It is infinite if both are held, and zero if a tangent that counts has no length.
    pub fn conditioning(&self, held: Held) -> f64 {
        self.eigenvalues(held)[0]
    }

    /// The smallest absolute value of the eigenvalues.
    pub(super) fn smallest_magnitude(&self, held: Held) -> f64 {
        let [low, high] = self.eigenvalues(held);
        low.abs().min(high.abs())
    }

    /// The eigenvalues for unit tangents in ascending order, each with a small relative error. One free parameter gives
    /// two equal ones.
    pub(super) fn eigenvalues(&self, held: Held) -> [f64; 2] {
        let [t2, t_bar2] = self.squares;
        let (first, second) = (self.a / t2, -self.a_bar / t_bar2);
        match (held.xi, held.xi_bar) {
            (true, true) => [f64::INFINITY; 2],
            (true, false) if second.is_finite() => [second; 2],
            (false, true) if first.is_finite() => [first; 2],
            (false, false) if first.is_finite() && second.is_finite() => {
                let root = ((first - second).powi(2) + 4.0 * (self.b / t2) * (self.b / t_bar2)).sqrt();
                let (trace, det) = (first + second, self.det / t2 / t_bar2);
                let large = 0.5 * (trace + root.copysign(trace));
                // The determinant does not cancel between parallel tangents, but rounds as if large were 1.
                let small = if large.abs() > 0.5 { det / large } else { trace - large };
                if trace < 0.0 { [large, small] } else { [small, large] }
            }
            _ => [0.0; 2],
        }
    }

    /// The cosine of the angle between d and the gradient's tangent `i`, 0 if one of the two has no length.
    pub(super) fn cosine(&self, i: usize) -> f64 {
        let scale = self.distance * self.squares[i].sqrt();
        let still = self.squares[i] <= STANDSTILL * STANDSTILL * self.size2_about(i);
        if self.is_crossing() || still { 0.0 } else { self.gradient[i] / scale }
    }

    /// t·t + t,xi·t,xi: the size of tangent `i`, even near a point where it vanishes.
    fn size2_about(&self, i: usize) -> f64 {
        self.squares[i] + self.bends[i]
    }

    /// Whether a scaled eigenvalue of this size, over the parameters that are not held, may be zero up to the rounding of
    /// d.
    ///
    /// The rounding of d contributes to the scaled Hessian its error times the curvature, which is ‖t,xi‖ / t² at most.
    pub(super) fn rounds_to_zero(&self, eigenvalue: f64, held: Held) -> bool {
        let [t2, t_bar2] = self.squares;
        let [bend, bend_bar] = self.bends;
        // 2 u v <= u² + v² decides without a root unless both sides are close.
        let high = (self.size2 + bend) * t_bar2 + (self.size2 + bend_bar) * t2;
        (eigenvalue - SINGULAR) * (t2 * t_bar2) <= 8.0 * ROUNDING * high && {
            let curvature = |held: bool, bend: f64, t2: f64| if held { 0.0 } else { bend.sqrt() / t2 };
            let of_both = curvature(held.xi, bend, t2) + curvature(held.xi_bar, bend_bar, t_bar2);
            eigenvalue <= SINGULAR + 16.0 * self.rounding() * of_both
        }
    }

    /// Whether tangent `i` has no length, relative to its change along the beam.
    pub(super) fn stands_still(&self, i: usize) -> bool {
        let (t2, bend, twist) = (self.squares[i], self.bends[i], self.twists[i]);
        // (u + v)² <= 2 (u² + v²) decides without a root unless both sides are close.
        t2 <= 2.0 * STANDSTILL * STANDSTILL * (bend + twist)
            && t2.sqrt() <= STANDSTILL * (bend.sqrt() + twist.sqrt())
    }

    /// The cosine between d and the direction of the curve that leads from the end `end` (-1 or 1) of parameter `i` into
    /// the beam, if the tangent has no length there. The first derivative that does not vanish has this direction.
    ///
    /// With ξ = end - end s, F changes by F,ξξ s²/2 - end F,ξξξ s³/6.
    pub(super) fn cosine_into(&self, i: usize, end: f64) -> f64 {
        let (bend, twist) = (self.bends[i].sqrt(), self.twists[i].sqrt());
        let (change, size) = if bend > STANDSTILL * twist {
            ([self.a, -self.a_bar][i], bend)
        } else {
            (-end * [self.third[0], self.third[3]][i], twist)
        };
        if self.is_crossing() { 0.0 } else { change / (self.distance * size) }
    }

    /// Whether parameter `i` is near a zero of its tangent instead of a zero of the cosine between d and its tangent.
    ///
    /// There a Newton step of this size changes the tangent by its own length. If the tangent has a zero of second order,
    /// the steps become small although the cosine does not, until the tangent and its change are both rounding.
    pub(super) fn is_near_standstill(&self, i: usize, step: f64) -> bool {
        const LARGE: f64 = 1e-6;
        let bend = self.bends[i];
        let is_double = || bend < LARGE * LARGE * self.twists[i] && self.stands_still(i);
        ((step * step) * bend > 0.01 * self.squares[i] || is_double()) && self.cosine(i).abs() > LARGE
    }

    /// The largest |cos| over the parameters that are not held.
    pub fn residual(&self, held: Held) -> f64 {
        let of = |held: bool, i| if held { 0.0 } else { self.cosine(i).abs() };
        of(held.xi, 0).max(of(held.xi_bar, 1))
    }

    /// Whether the gradient over the parameters that are not held vanishes.
    pub(super) fn is_stationary(&self, held: Held) -> bool {
        (held.xi || self.gradient[0] == 0.0) && (held.xi_bar || self.gradient[1] == 0.0)
    }

    /// The larger component of the gradient, for tangents of unit size, over the parameters that are not held.
    pub(super) fn slope(&self, held: Held) -> f64 {
        let of = |held: bool, i: usize| {
            if held || self.gradient[i] == 0.0 {
                0.0
            } else {
                self.gradient[i].abs() / self.squares[i].sqrt()
            }
        };
        of(held.xi, 0).max(of(held.xi_bar, 1))
    }

    /// Whether d is zero to rounding.
    pub fn is_crossing(&self) -> bool {
        self.distance * self.distance <= ROUNDING * ROUNDING * self.size2
    }

    /// Whether the gradient in parameter `i` is zero within the tolerance of a multiplier.
    ///
    /// A change of the parameter by the tolerance changes the gradient by t² + d·t,xi times it, and the rounding of the
    /// positions changes it by t times that. If the tangent is short next to its change, t,xi enters with d only: in any
    /// other product it would hide the minimum at an end where the tangent turns soon.
    pub(super) fn is_weak(&self, i: usize) -> bool {
        let (t, about) = (self.squares[i].sqrt(), self.size2_about(i).sqrt());
        self.gradient[i].abs() <= WEAK * (self.distance * about + self.squares[i]) + t * self.rounding()
    }

    /// Whether the Hessian over the parameters that are not held is positive definite.
    pub(super) fn is_convex(&self, held: Held) -> bool {
        (held.xi || self.a > 0.0)
            && (held.xi_bar || self.a_bar < 0.0)
            && (held.xi || held.xi_bar || self.det > 0.0)
    }

    /// The absolute error of the positions.
    pub(super) fn rounding(&self) -> f64 {
        ROUNDING * self.size2.sqrt()
    }

    /// Whether a curve is so short, next to the other one or the positions, that rounding moves its parameter far.
    pub(super) fn is_unlike(&self) -> bool {
        const RATIO: f64 = 1e5;
        let own = |i: usize| self.size2_about(i) + self.twists[i];
        self.size2 > RATIO * RATIO * own(0).min(own(1))
    }

    /// The possible error of parameter `i`: the rounding of the gradient divided by an eigenvalue of this size.
    pub(super) fn uncertainty(&self, i: usize, eigenvalue: f64) -> f64 {
        self.rounding() / eigenvalue / self.squares[i].sqrt()
    }

    /// The relative error of the parameters' gradients from the rounding of the positions. `eigenvalue` is the smallest
    /// eigenvalue for unit tangents.
    ///
    /// The error of the closest point is rounding / eigenvalue along the eigenvector v. The eigenvalue changes by this
    /// error times the third derivative of F along v, which is zero for straight beams and for symmetric ones.
    pub(super) fn gradient_error(&self, eigenvalue: f64, held: Held) -> f64 {
        let [t, t_bar] = self.squares.map(f64::sqrt);
        let v = match (held.xi, held.xi_bar) {
            (true, _) => Vector2::y(),
            (false, true) => Vector2::x(),
            (false, false) => self.eigenvector(eigenvalue),
        };
        let (x, y) = (v.x / t, v.y / t_bar);
        let [xxx, xxy, xyy, yyy] = self.third;
        let third = x * x * (xxx * x + 3.0 * xxy * y) + y * y * (3.0 * xyy * x + yyy * y);
        self.rounding() * third.abs() / (eigenvalue * eigenvalue)
    }

    /// The unit eigenvector of an eigenvalue, both for unit tangents.
    fn eigenvector(&self, eigenvalue: f64) -> Vector2<f64> {
        let [t, t_bar] = self.squares.map(f64::sqrt);
        let (a, b, c) = (self.a / self.squares[0], -self.b / t / t_bar, -self.a_bar / self.squares[1]);
        if (a - eigenvalue).abs() > (c - eigenvalue).abs() {
            Vector2::new(-b, a - eigenvalue).normalize()
        } else {
            Vector2::new(c - eigenvalue, -b).normalize()
        }
    }

    /// The direction, for unit tangents, in which F changes least: along a continuum of nearest points.
    pub(super) fn valley(&self) -> [f64; 2] {
        let [low, high] = self.eigenvalues(Held::default());
        self.eigenvector(if low.abs() < high.abs() { low } else { high }).into()
    }
}

#[cfg(test)]
mod tests;
