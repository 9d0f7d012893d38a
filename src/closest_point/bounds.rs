//! Bounds on the gradient of the squared distance over a box of parameters, from Taylor's theorem at its centre.

use super::SquaredDistance;
use super::held::SINGULAR;
use super::tree::Node;

/// A margin for rounding, relative to the half-widths of a box.
const SLACK: f64 = 1.0 + 1.0 / 16.0;
/// The inflation of a box in which a zero is unique. The bounds grow at most by its cube.
pub(super) const INFLATION: f64 = 1.25;
/// A zero on the boundary of an inflated box may be a known zero of a neighbouring box, up to rounding.
pub(super) const NEXT_DOOR: f64 = INFLATION * (1.0 + 1e-6);
const INFLATED: f64 = INFLATION * INFLATION * INFLATION;

/// A box of parameters.
///
/// # Derivation
/// Write u, v for the distances from the centre, |u| <= h, |v| <= k. With t(u) = t + u t,xi + ρ₁, ‖ρ₁‖ <= h²M/2, and
/// likewise for d and t,xi, where M bounds ‖x,xixixi‖, the Hessian differs from that at the centre by at most
///
/// ```math
/// |Δa| ≤ 3h|t·t,ξ| + k|t̄·t,ξ| + ‖Δt‖² + 2‖ρ₁‖‖t‖ + ‖ρ₀‖‖t,ξ‖ + ‖d‖ hM
/// |Δb| ≤ h|t̄·t,ξ| + k|t·t̄,ξ| + ‖ρ₁‖‖t̄‖ + ‖ρ̄₁‖‖t‖ + ‖Δt‖‖Δt̄‖
/// ```
///
/// where ρ₀ is the remainder of d, and Δā is Δa with the beams exchanged. All terms vanish at the centre and grow at
/// least linearly along rays, so that the mean of ΔH over a ray is at most half of the bound at its end, and the
/// gradient differs from its linear part by at most (Δa h + Δb k)/2 and (Δb h + Δā k)/2.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    pub(super) squared_distance: SquaredDistance,
    pub(super) half: [f64; 2],
    /// Bounds of |Δa|, |Δb|, |Δā|.
    change: [f64; 3],
    /// Bounds of the non-linear part of the gradient.
    pub(super) remainder: [f64; 2],
    /// H⁻¹ in the order of H; not a number if H is singular to rounding.
    inverse: [f64; 3],
}

impl Bounds {
    #[inline]
    pub(super) fn new(x: &Node, y: &Node) -> Self {
        let squared_distance = SquaredDistance::new(&x.geometry, &y.geometry);
        let (h, k) = (x.half, y.half);
        let (g, g_bar) = (&x.geometry, &y.geometry);
        let sag = x.sag + y.sag;
        let reach = squared_distance.distance + h * x.speed + k * y.speed + sag;
        let (cross, cross_bar) = (g_bar.t.dot(&g.t_xi).abs(), g.t.dot(&g_bar.t_xi).abs());
        let own = |node: &Node, h: f64, k: f64, cross: f64| {
            3.0 * h * node.geometry.t.dot(&node.geometry.t_xi).abs()
                + k * cross
                + node.turn * node.turn
                + 2.0 * node.twist * node.speed
                + sag * node.bend
                + reach * node.jerk
        };
        let da = own(x, h, k, cross);
        let da_bar = own(y, k, h, cross_bar);
        let db = h * cross + k * cross_bar + x.twist * y.speed + y.twist * x.speed + x.turn * y.turn;
        let SquaredDistance { a, b, a_bar, det, .. } = squared_distance;
        // The error of H⁻¹H is the rounding of a a_bar + b² relative to det H.
        let invertible = det.abs() > SINGULAR * ((a * a_bar).abs() + b * b);
        let scale = if invertible { 1.0 / det } else { f64::NAN };
        Self {
            half: [h, k],
            change: [da, db, da_bar],
            remainder: [0.5 * (da * h + db * k), 0.5 * (db * h + da_bar * k)],
            inverse: [-a_bar * scale, b * scale, a * scale],
            squared_distance,
        }
    }

    /// Whether component `i` of the gradient keeps the sign it has at the centre.
    pub(super) fn keeps_sign(&self, i: usize) -> bool {
        let SquaredDistance { a, b, a_bar, gradient, .. } = self.squared_distance;
        let own = if i == 0 { a } else { a_bar };
        let linear = own.abs() * self.half[i] + b.abs() * self.half[1 - i];
        gradient[i].abs() > SLACK * (linear + self.remainder[i])
    }

    /// Whether the gradient vanishes nowhere in the box, by its components or by those of H⁻¹ times it.
    pub(super) fn excludes_zero(&self) -> bool {
        if self.keeps_sign(0) || self.keeps_sign(1) {
            return true;
        }
        let ([g, g_bar], [r, r_bar], [p, q, s]) =
            (self.squared_distance.gradient, self.remainder, self.inverse);
        let [h, k] = self.half;
        (p * g + q * g_bar).abs() > SLACK * (h + p.abs() * r + q.abs() * r_bar)
            || (q * g + s * g_bar).abs() > SLACK * (k + q.abs() * r + s.abs() * r_bar)
    }

    /// The Lipschitz constant of y - H⁻¹ grad F(y) over the inflated box, in the maximum norm of the half-widths.
    pub(super) fn contraction(&self) -> f64 {
        let ([da, db, da_bar], [p, q, s], [h, k]) = (self.change, self.inverse.map(f64::abs), self.half);
        let first = (p * da + q * db) * h + (p * db + q * da_bar) * k;
        let second = (q * da + s * db) * h + (q * db + s * da_bar) * k;
        INFLATED * (first / h).max(second / k)
    }

    /// Whether the Hessian is singular to rounding in the whole box, so that halving the box is of no use.
    pub(super) fn is_flat(&self) -> bool {
        let [t2, t_bar2] = self.squared_distance.squares;
        let [da, db, da_bar] = self.change;
        da <= SINGULAR * t2
            && da_bar <= SINGULAR * t_bar2
            && db * db <= SINGULAR * SINGULAR * t2 * t_bar2
            && self.squared_distance.smallest_magnitude(super::Held::default()) <= SINGULAR
    }

    /// The Lipschitz constant for component `i` as a function of its own parameter. The other parameter has no width.
    pub(super) fn contraction_along(&self, i: usize) -> f64 {
        INFLATED * self.change[2 * i] / self.curvature(i).abs()
    }

    /// Whether the curvature in parameter `i` is zero to rounding in the whole interval.
    pub(super) fn is_flat_along(&self, i: usize) -> bool {
        let scale = SINGULAR * self.squared_distance.squares[i];
        self.change[2 * i] <= scale && self.curvature(i).abs() <= scale
    }

    /// Whether F is concave in parameter `i` in the whole box, so that there is no minimum along it.
    pub(super) fn is_concave_along(&self, i: usize) -> bool {
        self.curvature(i) < -self.change[2 * i]
    }

    /// Whether each component of the gradient increases in the directions of both parameters, in the whole box.
    /// `sign` is the product of the signs of the two directions.
    pub(super) fn increases(&self, sign: f64) -> bool {
        let SquaredDistance { a, b, a_bar, .. } = self.squared_distance;
        let [da, db, da_bar] = self.change;
        a > da && -a_bar > da_bar && -sign * b > db
    }

    /// The second derivative of F in parameter `i`: a or -a_bar.
    fn curvature(&self, i: usize) -> f64 {
        if i == 0 { self.squared_distance.a } else { -self.squared_distance.a_bar }
    }
}

#[cfg(test)]
mod tests;
