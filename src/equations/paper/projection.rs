//! Section 5.2, projection parameters: (49) to (56).

use super::norms::delta_u_hat;
use super::{mixed, squared};
use crate::equations::point::{Point, Side};
use crate::equations::table::{Order, Table};
use crate::number::Real;
use nalgebra::Vector3;

pub(super) fn enter<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    first_rows(p, table);
    first(p, table);
    second_rows(p, table);
    second(p, table);
}

/// The matrix [a, −b; b, ā] of (51).
pub(super) struct System<T> {
    a: T,
    b: T,
    a_bar: T,
}

impl<T: Real> System<T> {
    pub(super) fn new(p: &Point<T>) -> Self {
        let (x, y) = (p.beam.jet.geometry, p.bar.jet.geometry);
        let d = p.d.value;
        Self { a: x.t.dot(&x.t) + d.dot(&x.t_xi), b: x.t.dot(&y.t), a_bar: -y.t.dot(&y.t) + d.dot(&y.t_xi) }
    }

    fn times(&self, xi: T, xi_bar: T) -> [T; 2] {
        [self.a * xi - self.b * xi_bar, self.b * xi + self.a_bar * xi_bar]
    }

    /// (52): (ā R + b R̄)/D and (−b R + a R̄)/D with D = a ā + b², for any R and R̄.
    pub(super) fn solve(&self, [r, r_bar]: [T; 2]) -> [T; 2] {
        let Self { a, b, a_bar } = *self;
        let det = a * a_bar + b * b;
        [(a_bar * r + b * r_bar) / det, (-b * r + a * r_bar) / det]
    }
}

/// R_δ and R̄_δ, the right-hand side of (50).
pub(super) fn first_sides<T: Real>(p: &Point<T>) -> [T; 2] {
    let (hat, d) = (delta_u_hat(p), p.d.value);
    [&p.beam, &p.bar].map(|s| -hat.dot(&s.jet.geometry.t) - s.jet.delta_u[1].dot(&d))
}

/// The parts of Δδd and of Δδt, Δδt̄ that contain neither Δδξ nor Δδξ̄, with Δᵤδᵤu if `complete`.
fn rests<T: Real>(p: &Point<T>, complete: bool) -> (Vector3<T>, [Vector3<T>; 2]) {
    let kept = |s: &Side<T>, k: usize| if complete { s.jet.second_u[k] } else { Vector3::zeros() };
    let of_x = |s: &Side<T>| s.jet.geometry.t_xi * squared(s) + mixed(s, 1) + kept(s, 0);
    let of_t = |s: &Side<T>| s.jet.geometry.t_xixi * squared(s) + mixed(s, 2) + kept(s, 1);
    (of_x(&p.beam) - of_x(&p.bar), [&p.beam, &p.bar].map(of_t))
}

/// R_Δδ and R̄_Δδ: the right-hand side of (55), from (54).
pub(super) fn second_sides<T: Real>(p: &Point<T>, complete: bool) -> [T; 2] {
    let (rest_d, rest_t) = rests(p, complete);
    let of = |s: &Side<T>, rest_t: &Vector3<T>| {
        -(p.d.delta.dot(&s.t.linear) + p.d.linear.dot(&s.t.delta))
            - rest_d.dot(&s.jet.geometry.t)
            - p.d.value.dot(rest_t)
    };
    [of(&p.beam, &rest_t[0]), of(&p.bar, &rest_t[1])]
}

/// (49).
fn first_rows<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let (s, r, zero) = (&p.beam, &p.bar, T::zero());
    let (x, y, d) = (s.jet.geometry, r.jet.geometry, p.d.value);
    let (u_xi, u_bar_xi) = (s.jet.delta_u[1], r.jet.delta_u[1]);
    let varied = |s: &Side<T>| p.d.delta.dot(&s.t.value) + d.dot(&s.t.delta);
    let delta_d = x.t * s.xi.delta - y.t * r.xi.delta + delta_u_hat(p);
    let row_2 = |last: Vector3<T>| [varied(r), delta_d.dot(&y.t) + d.dot(&last)];
    // The repetition of the row in the scan: δξ for δξ̄ in δd and in δt̄, t for t̄ on the left.
    let again = |t_xi: Vector3<T>| {
        let delta_d = x.t * s.xi.delta - y.t * s.xi.delta + delta_u_hat(p);
        [varied(s), delta_d.dot(&y.t) + d.dot(&(t_xi * s.xi.delta + u_bar_xi))]
    };
    let none = [zero; 2];
    table.state(
        49,
        "orthogonality varied, expanded",
        r"\begin{cases}\delta\mathbf{d}\cdot\mathbf{t} + \mathbf{d}\cdot\delta\mathbf{t} = \left(\mathbf{t}\delta\xi
- \bar{\mathbf{t}}\delta\bar\xi + \delta_u\mathbf{u}_C - \delta_u\bar{\mathbf{u}}_{\bar C}\right)\cdot\mathbf{t}
+ \mathbf{d}\cdot\left(\mathbf{t}_{,\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi}\right) = 0 \\
\delta\mathbf{d}\cdot\bar{\mathbf{t}} + \mathbf{d}\cdot\delta\bar{\mathbf{t}} = \left(\mathbf{t}\delta\xi
- \bar{\mathbf{t}}\delta\bar\xi + \delta_u\mathbf{u}_C - \delta_u\bar{\mathbf{u}}_{\bar C}\right)\cdot\bar{\mathbf{t}}
+ \mathbf{d}\cdot\left(\bar{\mathbf{t}}_{,\xi}\delta\bar\xi + \delta_u\mathbf{u}_{C,\xi}\right) = 0 \\
\delta\mathbf{d}\cdot\mathbf{t} + \mathbf{d}\cdot\delta\mathbf{t} = \left(\mathbf{t}\delta\xi
- \bar{\mathbf{t}}\delta\xi + \delta_u\mathbf{u}_C - \delta_u\bar{\mathbf{u}}_{\bar C}\right)\cdot\bar{\mathbf{t}}
+ \mathbf{d}\cdot\left(\mathbf{t}_{,\bar\xi}\delta\xi + \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\right) = 0\end{cases}",
    )
    .corrected_to(
        r"\delta\mathbf{d}\cdot\bar{\mathbf{t}} + \mathbf{d}\cdot\delta\bar{\mathbf{t}} = \left(\mathbf{t}\delta\xi
- \bar{\mathbf{t}}\delta\bar\xi + \delta_u\mathbf{u}_C - \delta_u\bar{\mathbf{u}}_{\bar C}\right)\cdot\bar{\mathbf{t}}
+ \mathbf{d}\cdot\left(\bar{\mathbf{t}}_{,\bar\xi}\delta\bar\xi + \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\right) = 0",
    )
    .remark(
        "The third row is the second once more, as the scan repeats it without a number. One of the two has the bars of \
         the last sum on its first term, the other on its second, so that the fault may be the scan's.",
    )
    .part(Order::First, "row 1")
    .printed([varied(s), delta_d.dot(&x.t) + d.dot(&(x.t_xi * s.xi.delta + u_xi))], none)
    .part(Order::First, "row 2")
    .read("t̄,ξ is t̄,ξ̄", row_2(y.t_xi * r.xi.delta + u_xi), none)
    .read("t̄,ξ is 0", row_2(u_xi), none)
    .read("repeated row, t,ξ̄ is t̄,ξ̄", again(y.t_xi), none)
    .read("repeated row, t,ξ̄ is t,ξ", again(x.t_xi), none)
    .corrected("t̄,ξ̄ and δᵤū_C̄,ξ̄", row_2(y.t_xi * r.xi.delta + u_bar_xi), none);
}

/// (50) to (52).
fn first<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let (xi, xi_bar) = (&p.beam.xi, &p.bar.xi);
    let (x, y, d) = (p.beam.jet.geometry, p.bar.jet.geometry, p.d.value);
    let system = System::new(p);

    // (50)
    let rows = [
        (x.t.dot(&x.t) + d.dot(&x.t_xi)) * xi.delta - x.t.dot(&y.t) * xi_bar.delta,
        x.t.dot(&y.t) * xi.delta + (-y.t.dot(&y.t) + d.dot(&y.t_xi)) * xi_bar.delta,
    ];
    table.state(
        50,
        "system for δξ and δξ̄",
        r"\begin{bmatrix}\mathbf{t}\cdot\mathbf{t} + \mathbf{d}\cdot\mathbf{t}_{,\xi} & -\mathbf{t}\cdot\bar{\mathbf{t}} \\
\mathbf{t}\cdot\bar{\mathbf{t}} & -\bar{\mathbf{t}}\cdot\bar{\mathbf{t}} + \mathbf{d}\cdot\bar{\mathbf{t}}_{,\bar\xi}\end{bmatrix}
\begin{bmatrix}\delta\xi \\ \delta\bar\xi\end{bmatrix} = \begin{bmatrix}
-(\delta_u\mathbf{u}_C - \delta_u\bar{\mathbf{u}}_{\bar C})\cdot\mathbf{t} - \delta_u\mathbf{u}_{C,\xi}\cdot\mathbf{d} \\
-(\delta_u\mathbf{u}_C - \delta_u\bar{\mathbf{u}}_{\bar C})\cdot\bar{\mathbf{t}}
- \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\cdot\mathbf{d}\end{bmatrix}",
    )
    .part(Order::First, "")
    .printed(rows, first_sides(p));

    // (51)
    table.state(
        51,
        "(50) in short",
        r"\begin{bmatrix}a & -b \\ b & \bar a\end{bmatrix}\begin{bmatrix}\delta\xi \\ \delta\bar\xi\end{bmatrix}
= \begin{bmatrix}R_\delta \\ \bar R_\delta\end{bmatrix}",
    )
    .remark("ā is minus what a is with the beams exchanged.")
    .part(Order::First, "")
    .printed(system.times(xi.delta, xi_bar.delta), first_sides(p));

    // (52): δξ = (ā R + b R̄)/D   δξ̄ = (−b R + a R̄)/D
    table.state(
        52,
        "δξ and δξ̄",
        r"\delta\xi = \frac{\bar a R_\delta + b\bar R_\delta}{D} \qquad
\delta\bar\xi = \frac{-b R_\delta + a\bar R_\delta}{D}",
    )
    .remark(
        "D = aā + b². Where D is not 0, the closest points depend smoothly on the dofs. D is negative at a nondegenerate minimum, where the Hessian of the half squared distance is positive definite.",
    )
    .part(Order::First, "")
    .printed([xi.delta, xi_bar.delta], system.solve(first_sides(p)));
}

/// (53) and (54).
fn second_rows<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let d = &p.d;
    let right = [&p.beam, &p.bar].map(|s| -(d.delta.dot(&s.t.linear) + d.linear.dot(&s.t.delta)));

    // (53): Δδd·t + d·Δδt = −(δd·Δt + Δd·δt), barred likewise
    table.state(
        53,
        "orthogonality varied twice, term by term",
        r"\begin{cases}\Delta\delta(\mathbf{d}\cdot\mathbf{t}) = 0 \\ \Delta\delta(\mathbf{d}\cdot\bar{\mathbf{t}}) = 0\end{cases}
\Rightarrow \begin{cases}\Delta\delta\mathbf{d}\cdot\mathbf{t} + \mathbf{d}\cdot\Delta\delta\mathbf{t}
= -\left(\delta\mathbf{d}\cdot\Delta\mathbf{t} + \Delta\mathbf{d}\cdot\delta\mathbf{t}\right) \\
\Delta\delta\mathbf{d}\cdot\bar{\mathbf{t}} + \mathbf{d}\cdot\Delta\delta\bar{\mathbf{t}}
= -\left(\delta\mathbf{d}\cdot\Delta\bar{\mathbf{t}} + \Delta\mathbf{d}\cdot\delta\bar{\mathbf{t}}\right)\end{cases}",
    )
    .part(Order::Second, "")
    .printed([&p.beam, &p.bar].map(|s| d.second.dot(&s.t.value) + d.value.dot(&s.t.second)), right);

    // (54): the same with (32)
    let left = |complete| {
        let (rest_d, rest_t) = rests(p, complete);
        let slid = p.beam.t.value * p.beam.xi.second - p.bar.t.value * p.bar.xi.second;
        let of = |s: &Side<T>, rest_t: Vector3<T>| {
            (slid + rest_d).dot(&s.t.value) + d.value.dot(&(s.jet.geometry.t_xi * s.xi.second + rest_t))
        };
        [of(&p.beam, rest_t[0]), of(&p.bar, rest_t[1])]
    };
    table.state(
        54,
        "orthogonality varied twice, expanded",
        r"\begin{cases}\left(\mathbf{t}\Delta\delta\xi - \bar{\mathbf{t}}\Delta\delta\bar\xi
+ \mathbf{t}_{,\xi}\delta\xi\Delta\xi - \bar{\mathbf{t}}_{,\bar\xi}\delta\bar\xi\Delta\bar\xi
+ \Delta_u\mathbf{u}_{C,\xi}\delta\xi - \Delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\delta\bar\xi
+ \delta_u\mathbf{u}_{C,\xi}\Delta\xi - \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\Delta\bar\xi\right)\cdot\mathbf{t} \\
\quad + \mathbf{d}\cdot(\mathbf{t}_{,\xi\xi}\delta\xi\Delta\xi + \mathbf{t}_{,\xi}\Delta\delta\xi
+ \Delta_u\mathbf{u}_{C,\xi\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi\xi}\Delta\xi)
= -(\delta\mathbf{d}\cdot\Delta\mathbf{t} + \Delta\mathbf{d}\cdot\delta\mathbf{t}) \\
\left(\mathbf{t}\Delta\delta\xi - \bar{\mathbf{t}}\Delta\delta\bar\xi
+ \mathbf{t}_{,\xi}\delta\xi\Delta\xi - \bar{\mathbf{t}}_{,\bar\xi}\delta\bar\xi\Delta\bar\xi
+ \Delta_u\mathbf{u}_{C,\xi}\delta\xi - \Delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\delta\bar\xi
+ \delta_u\mathbf{u}_{C,\xi}\Delta\xi - \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\Delta\bar\xi\right)\cdot\bar{\mathbf{t}} \\
\quad + \mathbf{d}\cdot(\bar{\mathbf{t}}_{,\bar\xi\bar\xi}\delta\bar\xi\Delta\bar\xi
+ \bar{\mathbf{t}}_{,\bar\xi}\Delta\delta\bar\xi + \Delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi\bar\xi}\delta\bar\xi
+ \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi\bar\xi}\Delta\bar\xi)
= -(\delta\mathbf{d}\cdot\Delta\bar{\mathbf{t}} + \Delta\mathbf{d}\cdot\delta\bar{\mathbf{t}})\end{cases}",
    )
    .corrected_to(
        r"\begin{cases}\ldots + \Delta_u\delta_u\hat{\mathbf{u}}_C\cdot\mathbf{t}
+ \mathbf{d}\cdot\Delta_u\delta_u\mathbf{u}_{C,\xi} = \ldots \\
\ldots + \Delta_u\delta_u\hat{\mathbf{u}}_C\cdot\bar{\mathbf{t}}
+ \mathbf{d}\cdot\Delta_u\delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi} = \ldots\end{cases}",
    )
    .part(Order::Second, "")
    .printed(left(false), right)
    .complete("with Δᵤδᵤu", left(true), right);
}

/// (55) and (56).
fn second<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let (xi, xi_bar) = (&p.beam.xi, &p.bar.xi);
    let system = System::new(p);
    let (linear, complete) = (second_sides(p, false), second_sides(p, true));

    // (55)
    let rows = system.times(xi.second, xi_bar.second);
    table.state(
        55,
        "system for Δδξ and Δδξ̄",
        r"\begin{bmatrix}\mathbf{t}\cdot\mathbf{t} + \mathbf{d}\cdot\mathbf{t}_{,\xi} & -\mathbf{t}\cdot\bar{\mathbf{t}} \\
\mathbf{t}\cdot\bar{\mathbf{t}} & -\bar{\mathbf{t}}\cdot\bar{\mathbf{t}} + \mathbf{d}\cdot\bar{\mathbf{t}}_{,\bar\xi}\end{bmatrix}
\begin{bmatrix}\Delta\delta\xi \\ \Delta\delta\bar\xi\end{bmatrix}
= \begin{bmatrix}R_{\Delta\delta} \\ \bar R_{\Delta\delta}\end{bmatrix}",
    )
    .remark("The right-hand side is never given: it is what (54) leaves, without Δᵤδᵤu as printed and with it as corrected.")
    .part(Order::Second, "")
    .read("right-hand side from (54)", rows, linear)
    .complete("right-hand side with Δᵤδᵤu", rows, complete);

    // (56), printed without the bars of the second R and R
    let left = [xi.second, xi_bar.second];
    let barless = |[r, _]: [T; 2]| system.solve([r, r]);
    table
        .state(
            56,
            "Δδξ and Δδξ̄",
            r"\Delta\delta\xi = \frac{\bar a R_{\Delta\delta} + b R_{\Delta\delta}}{D} \qquad
\Delta\delta\bar\xi = \frac{-b R_{\Delta\delta} + a R_{\Delta\delta}}{D}",
        )
        .corrected_to(
            r"\Delta\delta\xi = \frac{\bar a R_{\Delta\delta} + b\bar R_{\Delta\delta}}{D} \qquad
\Delta\delta\bar\xi = \frac{-b R_{\Delta\delta} + a\bar R_{\Delta\delta}}{D}",
        )
        .remark("It contradicts (59), which has the bars.")
        .part(Order::Second, "")
        .read("R from (54)", left, barless(linear))
        .read("R with Δᵤδᵤu", left, barless(complete))
        .corrected("R̄ for the second R, from (54)", left, system.solve(linear))
        .complete("and with Δᵤδᵤu", left, system.solve(complete));
}
