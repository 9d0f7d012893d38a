//! Bounds of the gradient and the Hessian of half the squared distance over a box of both parameters.

use super::piece::Piece;
use nalgebra::Vector3;

/// A bound on the relative rounding of the sums of this file: each has fewer than 200 operations.
const ROUNDING: f64 = 100.0 * f64::EPSILON;

/// A component of the gradient of this size relative to the tangent and the distance makes an end weakly held.
const WEAK: f64 = 1e-12;

/// F = ‖d‖²/2 over a box.
///
/// # Derivation
/// At the distances u and v from the centre, |u| <= h and |v| <= k,
///
/// ```math
/// d = d0 + t u + w u² - t' v - w' v² + ..      x,xi = t + 2 w u + ..      x,xixi = 2 w + ..
/// ```
///
/// where a prime marks the bar beam, and the remainders of the beam are at most rest h³, 3 rest h² and 6 rest h. The
/// products d·x,xi, x,xi·x,xi + d·x,xixi and x,xi·x_bar,xi are multiplied out. The linear terms of the gradient are those
/// of the Hessian at the centre. Every other term is bounded by its size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Enclosure {
    half: [f64; 2],
    pub(super) d: Vector3<f64>,
    /// F,xi and F,xi_bar at the centre.
    pub(super) gradient: [f64; 2],
    /// F,xixi, F,xixi_bar and F,xi_barxi_bar at the centre.
    pub(super) hessian: [f64; 3],
    /// Bounds on the difference of the gradient from its linear part, with all rounding.
    pub(super) rest: [f64; 2],
    /// Bounds on the change of the Hessian.
    change: [f64; 3],
    /// The largest change of d that is not along t or t', with its rounding.
    sag: f64,
    along: [f64; 2],
    /// The change of the gradient by an error of one in the position and the tangent.
    pub(super) reach: [f64; 2],
    /// The components of the gradient that the library takes for zero at an end, which it then calls weakly held.
    pub(super) weak: [f64; 2],
}

/// A sign, if it is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    Negative,
    Positive,
    Unknown,
}

impl Sign {
    /// The sign of all numbers within `radius` of `value`.
    fn of(value: f64, radius: f64) -> Self {
        match () {
            () if value > radius => Self::Positive,
            () if value < -radius => Self::Negative,
            () => Self::Unknown,
        }
    }
}

/// The largest ‖x,xi‖ of a piece, and the bounds on its rounding and on that of the position.
fn fastest(Piece { half: h, size: [t, w], error: [x, dt, dw], rest, .. }: &Piece) -> (f64, [f64; 2]) {
    (t + 2.0 * w * h + 3.0 * rest * h * h, [x + dt * h + dw * h * h, dt + 2.0 * dw * h])
}

impl Enclosure {
    pub(super) fn new(one: &Piece, other: &Piece) -> Self {
        let d = one.x - other.x;
        let (h, k) = (one.half, other.half);
        let ([m, m2], [n, n2]) = (one.size, other.size);
        let (r, s) = (one.rest * h * h * h, other.rest * k * k * k);
        let ((fast, [dx, dt]), (fast_bar, [dx_bar, dt_bar])) = (fastest(one), fastest(other));
        let sag = m2 * h * h + n2 * k * k + r + s + dx + dx_bar;
        let reach = d.norm() + m * h + n * k + sag;
        let (b, tw, tw_bar) = (one.t.dot(&other.t), one.t.dot(&one.w), other.t.dot(&other.w));
        let (wt_bar, tw_other) = (one.w.dot(&other.t).abs(), one.t.dot(&other.w).abs());
        let ww = one.w.dot(&other.w).abs();
        let own = |p: &Piece, d_w: f64| p.size[0] * p.size[0] + 2.0 * d_w;
        // d·x,xi: the terms u², uv, v², u³, v²u, and the remainders.
        let gradient_rest =
            |[h, k]: [f64; 2], [tw, wt, tw_other, m2]: [f64; 4], fast: f64, rest: f64, [dt, dx]: [f64; 2]| {
                3.0 * tw.abs() * h * h
                    + 2.0 * wt * h * k
                    + tw_other * k * k
                    + 2.0 * m2 * m2 * h * h * h
                    + 2.0 * ww * h * k * k
                    + reach * (3.0 * rest * h * h + dt)
                    + fast * (r + s + dx)
                    + ROUNDING * reach * fast
            };
        // x,xi·x,xi + d·x,xixi: the terms u, v, u², v², and the remainders.
        let curvature_change =
            |p: &Piece, [h, k]: [f64; 2], [tw, wt]: [f64; 2], fast: f64, [dt, dx]: [f64; 2]| {
                let bend = 2.0 * p.size[1] + 6.0 * p.rest * h;
                let quick = 3.0 * p.rest * h * h + dt;
                6.0 * tw.abs() * h
                    + 2.0 * wt * k
                    + 6.0 * p.size[1] * p.size[1] * h * h
                    + 2.0 * ww * k * k
                    + 2.0 * fast * quick
                    + reach * (6.0 * p.rest * h + 2.0 * p.error[2])
                    + bend * (r + s + dx)
                    + ROUNDING * (fast * fast + reach * bend)
            };
        let dx = dx + dx_bar;
        Self {
            half: [h, k],
            d,
            gradient: [d.dot(&one.t), -d.dot(&other.t)],
            hessian: [own(one, d.dot(&one.w)), -b, own(other, -d.dot(&other.w))],
            rest: [
                gradient_rest([h, k], [tw, wt_bar, tw_other, m2], fast, one.rest, [dt, dx]),
                gradient_rest([k, h], [tw_bar, tw_other, wt_bar, n2], fast_bar, other.rest, [dt_bar, dx]),
            ],
            change: [
                curvature_change(one, [h, k], [tw, wt_bar], fast, [dt, dx]),
                2.0 * wt_bar * h
                    + 2.0 * tw_other * k
                    + 4.0 * ww * h * k
                    + fast_bar * (3.0 * one.rest * h * h + dt)
                    + fast * (3.0 * other.rest * k * k + dt_bar)
                    + ROUNDING * fast * fast_bar,
                curvature_change(other, [k, h], [tw_bar, tw_other], fast_bar, [dt_bar, dx]),
            ],
            sag: sag + ROUNDING * (one.x.norm() + other.x.norm()),
            reach: [fast + reach, fast_bar + reach],
            weak: [one, other].map(|piece| {
                // Near a point where the curve stands still, the tangent is small only there.
                let about = piece.size[0].hypot(2.0 * piece.size[1]);
                WEAK * (piece.size[0] * piece.size[0] + about * d.norm())
            }),
            along: if d.norm() > 0.0 {
                [d.dot(&one.t).abs() * h, d.dot(&other.t).abs() * k].map(|along| along / d.norm())
            } else {
                [m * h, n * k]
            },
        }
    }

    /// ‖d‖ at the centre.
    pub(super) fn distance(&self) -> f64 {
        self.d.norm()
    }

    /// A lower bound of ‖d‖ in the box: that of its component along d at the centre.
    pub(super) fn least_distance(&self) -> f64 {
        (self.distance() - self.along[0] - self.along[1] - self.sag).max(0.0)
    }

    /// The bound on the rounding of the distance, for a box without width.
    pub(super) fn distance_error(&self) -> f64 {
        self.sag
    }

    /// The sign of component `i` of the gradient in the whole box.
    pub(super) fn sign(&self, i: usize) -> Sign {
        let [h, k] = [self.half[i], self.half[1 - i]];
        Sign::of(self.gradient[i], self.hessian[2 * i].abs() * h + self.hessian[1].abs() * k + self.rest[i])
    }

    /// The sign of the second derivative in parameter `i` in the whole box.
    pub(super) fn curvature(&self, i: usize) -> Sign {
        Sign::of(self.hessian[2 * i], self.change[2 * i])
    }

    /// The sign of the determinant of the Hessian in the whole box, if F is convex in each parameter.
    pub(super) fn determinant(&self) -> Sign {
        let ([a, b, c], [da, db, dc]) = (self.hessian, self.change);
        let least = (a - da) * (c - dc) - (b.abs() + db).powi(2);
        let most = (a + da) * (c + dc) - (b.abs() - db).max(0.0).powi(2);
        let rounding = ROUNDING * (a * c + b * b);
        match () {
            () if least > rounding => Sign::Positive,
            () if most < -rounding => Sign::Negative,
            () => Sign::Unknown,
        }
    }

    /// Whether the gradient vanishes nowhere in the box, because its linear part multiplied by the inverse of the Hessian
    /// at the centre vanishes outside only.
    pub(super) fn excludes_stationary_points(&self) -> bool {
        let ([a, b, c], [g, g_bar], [r, r_bar], [h, k]) = (self.hessian, self.gradient, self.rest, self.half);
        let det = a * c - b * b;
        if det.abs() <= ROUNDING * ((a * c).abs() + b * b) {
            return false;
        }
        // det H⁻¹ = [[c, -b], [-b, a]]
        let rounding = 1.0 + 0.01;
        let steps = [
            (c * g - b * g_bar, h, c.abs() * r + b.abs() * r_bar),
            (a * g_bar - b * g, k, b.abs() * r + a.abs() * r_bar),
        ];
        steps.into_iter().any(|(step, half, rest)| step.abs() > rounding * (det.abs() * half + rest))
    }

    /// The Newton step in the free parameters. It is not finite if their Hessian is singular.
    pub(super) fn step(&self, free: [bool; 2]) -> [f64; 2] {
        let ([a, b, c], [g, g_bar]) = (self.hessian, self.gradient);
        match free {
            [true, true] => {
                let det = a * c - b * b;
                [(b * g_bar - c * g) / det, (b * g - a * g_bar) / det]
            }
            [true, false] => [-g / a, 0.0],
            [false, true] => [0.0, -g_bar / c],
            [false, false] => [0.0; 2],
        }
    }

    /// Bounds on the errors of free parameters at which the gradient vanishes up to rounding, if F is convex there.
    pub(super) fn parameter_errors(&self, free: [bool; 2]) -> [f64; 2] {
        let ([a, b, c], [r, r_bar]) = (self.hessian, self.rest);
        match free {
            [true, true] => {
                let det = (a * c - b * b).abs();
                [(c.abs() * r + b.abs() * r_bar) / det, (b.abs() * r + a.abs() * r_bar) / det]
            }
            [true, false] => [r / a.abs(), 0.0],
            [false, true] => [0.0, r_bar / c.abs()],
            [false, false] => [0.0; 2],
        }
    }

    /// The parameters that can move without an increase of F, within these limits.
    pub(super) fn moves(&self, at: [f64; 2], within: [[f64; 2]; 2]) -> [bool; 2] {
        [0, 1].map(|i| {
            let [low, high] = within[i];
            !(low >= high
                || (at[i] <= low && self.gradient[i] > 0.0)
                || (at[i] >= high && self.gradient[i] < 0.0))
        })
    }

    /// Whether F is convex in these parameters, in the whole box.
    pub(super) fn is_convex(&self, free: [bool; 2]) -> bool {
        (0..2).all(|i| !free[i] || self.curvature(i) == Sign::Positive)
            && (free != [true; 2] || self.determinant() == Sign::Positive)
    }

    /// Newton's step if F is convex, and none otherwise.
    pub(super) fn descent_step(&self, free: [bool; 2]) -> [f64; 2] {
        let step = self.step(free);
        let is_usable = self.is_convex(free) && step.iter().all(|step| step.is_finite());
        if is_usable { step } else { [0.0; 2] }
    }

    /// A step against the gradient, for curves with these squares of their tangents.
    pub(super) fn slope_step(&self, free: [bool; 2], squares: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| if free[i] && squares[i] > 0.0 { -self.gradient[i] / squares[i] } else { 0.0 })
    }
}
