//! Section 3, virtual quantities: (23) to (32).

use super::{mixed, squared};
use crate::equations::point::Point;
use crate::equations::table::{Order, Table};
use crate::number::Real;
use nalgebra::Vector3;

pub(super) fn enter<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    coordinates(p, table);
    tangents(p, table);
    resume(p, table);
    geometry(p, table);
}

/// (23) to (27): x_C, with x = X + u.
fn coordinates<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let s = &p.beam;
    let (xi, big) = (&s.xi, &s.reference);
    let [x0, x1, _] = &s.moving_reference;
    let (t, t_xi) = (s.jet.geometry.t, s.jet.geometry.t_xi);
    let (u_xi, u_xixi) = (t - big.t, t_xi - big.t_xi);
    let (delta_u, linear_u, second_u) = (&s.jet.delta_u, &s.jet.linear_u, &s.jet.second_u);

    // (23): δx_C = δX_C + δu_C, where δu_C = u,ξ δξ + δᵤu_C
    table
        .state(
            23,
            "variation of x_C, term by term",
            r"\delta\mathbf{x}_C = \delta\mathbf{X}_C(\xi) + \delta\mathbf{u}_C(\xi, \mathbf{u})",
        )
        .part(Order::First, "")
        .printed(s.x.delta, x0.delta + (u_xi * xi.delta + delta_u[0]));

    // (24): .. = X_C,ξ δξ + u_C,ξ δξ + δᵤu_C = x_C,ξ δξ + δᵤu_C
    table
        .state(
            24,
            "variation of x_C",
            r"\delta\mathbf{x}_C = \delta\mathbf{X}_C + \delta\mathbf{u}_C = \mathbf{X}_{C,\xi}\delta\xi
+ \mathbf{u}_{C,\xi}\delta\xi + \delta_u\mathbf{u}_C = \mathbf{x}_{C,\xi}\delta\xi + \delta_u\mathbf{u}_C",
        )
        .part(Order::First, "")
        .printed(
            [s.x.delta; 2],
            [big.t * xi.delta + u_xi * xi.delta + delta_u[0], t * xi.delta + delta_u[0]],
        );

    // (25): Δδx_C = ΔX_C,ξ δξ + X_C,ξ Δδξ + Δu_C,ξ δξ + u_C,ξ Δδξ + Δδᵤu_C
    let linear_u_xi = s.t.linear - x1.linear;
    table
        .state(
            25,
            "linearization of (24)",
            r"\Delta\delta\mathbf{x}_C = \Delta\mathbf{X}_{C,\xi}\delta\xi + \mathbf{X}_{C,\xi}\Delta\delta\xi
+ \Delta\mathbf{u}_{C,\xi}\delta\xi + \mathbf{u}_{C,\xi}\Delta\delta\xi + \Delta\delta_u\mathbf{u}_C",
        )
        .part(Order::Second, "")
        .printed(
            s.x.second,
            x1.linear * xi.delta
                + big.t * xi.second
                + linear_u_xi * xi.delta
                + u_xi * xi.second
                + s.moving_u[0].linear,
        );

    // (26): .. = X,ξξ δξΔξ + X,ξ Δδξ + u,ξξ δξΔξ + Δᵤu,ξ δξ + u,ξ Δδξ + δᵤu,ξ Δξ + Δᵤδᵤu
    table.state(
        26,
        "second variation of x_C, all terms",
        r"\Delta\delta\mathbf{x}_C = \mathbf{X}_{C,\xi\xi}\delta\xi\Delta\xi + \mathbf{X}_{C,\xi}\Delta\delta\xi
+ \mathbf{u}_{C,\xi\xi}\delta\xi\Delta\xi + \Delta_u\mathbf{u}_{C,\xi}\delta\xi + \mathbf{u}_{C,\xi}\Delta\delta\xi
+ \delta_u\mathbf{u}_{C,\xi}\Delta\xi + \Delta_u\delta_u\mathbf{u}_C",
    )
    .part(Order::Second, "")
    .printed(
        s.x.second,
        big.t_xi * squared(s)
            + big.t * xi.second
            + u_xixi * squared(s)
            + linear_u[1] * xi.delta
            + u_xi * xi.second
            + delta_u[1] * xi.linear
            + second_u[0],
    );

    // (27): .. = x,ξξ δξΔξ + x,ξ Δδξ + δξ Δᵤu,ξ + δᵤu,ξ Δξ
    let kept = t_xi * squared(s) + t * xi.second + mixed(s, 1);
    table.state(
        27,
        "second variation of x_C",
        r"\Delta\delta\mathbf{x}_C = \mathbf{x}_{C,\xi\xi}\delta\xi\Delta\xi + \mathbf{x}_{C,\xi}\Delta\delta\xi
+ \delta\xi\,\Delta_u\mathbf{u}_{C,\xi} + \delta_u\mathbf{u}_{C,\xi}\Delta\xi",
    )
    .corrected_to(
        r"\Delta\delta\mathbf{x}_C = \mathbf{x}_{C,\xi\xi}\delta\xi\Delta\xi + \mathbf{x}_{C,\xi}\Delta\delta\xi
+ \delta\xi\,\Delta_u\mathbf{u}_{C,\xi} + \delta_u\mathbf{u}_{C,\xi}\Delta\xi + \Delta_u\delta_u\mathbf{u}_C",
    )
    .part(Order::Second, "")
    .printed(s.x.second, kept)
    .complete("with Δᵤδᵤu_C", s.x.second, kept + second_u[0]);
}

/// (28) to (30): x_C,xi.
fn tangents<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let s = &p.beam;
    let (xi, big) = (&s.xi, &s.reference);
    let x2 = &s.moving_reference[2];
    let (t_xi, t_xixi) = (s.jet.geometry.t_xi, s.jet.geometry.t_xixi);
    let (u_xixi, u_xixixi) = (t_xi - big.t_xi, t_xixi - big.t_xixi);
    let (delta_u, linear_u, second_u) = (&s.jet.delta_u, &s.jet.linear_u, &s.jet.second_u);

    // (28): δx_C,ξ = X,ξξ δξ + u,ξξ δξ + δᵤu,ξ = x,ξξ δξ + δᵤu,ξ
    table.state(
        28,
        "variation of x_C,ξ",
        r"\delta\mathbf{x}_{C,\xi} = \delta\mathbf{X}_{C,\xi} + \delta\mathbf{u}_{C,\xi} = \mathbf{X}_{C,\xi\xi}\delta\xi
+ \mathbf{u}_{C,\xi\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi} = \mathbf{x}_{C,\xi\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi}",
    )
    .part(Order::First, "")
    .printed([s.t.delta; 2], [
        big.t_xi * xi.delta + u_xixi * xi.delta + delta_u[1],
        t_xi * xi.delta + delta_u[1],
    ]);

    // (29): Δδx_C,ξ = ΔX,ξξ δξ + X,ξξ Δδξ + Δu,ξξ δξ + u,ξξ Δδξ + Δδᵤu,ξ
    let linear_u_xixi = s.moving_x_xixi.linear - x2.linear;
    table.state(
        29,
        "linearization of (28)",
        r"\Delta\delta\mathbf{x}_{C,\xi} = \Delta\mathbf{X}_{C,\xi\xi}\delta\xi + \mathbf{X}_{C,\xi\xi}\Delta\delta\xi
+ \Delta\mathbf{u}_{C,\xi\xi}\delta\xi + \mathbf{u}_{C,\xi\xi}\Delta\delta\xi + \Delta\delta_u\mathbf{u}_{C,\xi}",
    )
    .part(Order::Second, "")
    .printed(
        s.t.second,
        x2.linear * xi.delta
            + big.t_xi * xi.second
            + linear_u_xixi * xi.delta
            + u_xixi * xi.second
            + s.moving_u[1].linear,
    );

    // (30): first with Δᵤδᵤu,ξ, then without
    let kept = t_xixi * squared(s) + t_xi * xi.second + mixed(s, 2);
    table.state(
        30,
        "second variation of x_C,ξ",
        r"\begin{aligned}\Delta\delta\mathbf{x}_{C,\xi} &= \mathbf{X}_{C,\xi\xi\xi}\delta\xi\Delta\xi
+ \mathbf{X}_{C,\xi\xi}\Delta\delta\xi + \mathbf{u}_{C,\xi\xi\xi}\delta\xi\Delta\xi + \Delta_u\mathbf{u}_{C,\xi\xi}\delta\xi
+ \mathbf{u}_{C,\xi\xi}\Delta\delta\xi + \delta_u\mathbf{u}_{C,\xi\xi}\Delta\xi + \Delta_u\delta_u\mathbf{u}_{C,\xi} \\
&= \mathbf{x}_{C,\xi\xi\xi}\delta\xi\Delta\xi + \mathbf{x}_{C,\xi\xi}\Delta\delta\xi
+ \delta\xi\,\Delta_u\mathbf{u}_{C,\xi\xi} + \delta_u\mathbf{u}_{C,\xi\xi}\Delta\xi\end{aligned}",
    )
    .corrected_to(
        r"\Delta\delta\mathbf{x}_{C,\xi} = \mathbf{x}_{C,\xi\xi\xi}\delta\xi\Delta\xi
+ \mathbf{x}_{C,\xi\xi}\Delta\delta\xi + \delta\xi\,\Delta_u\mathbf{u}_{C,\xi\xi} + \delta_u\mathbf{u}_{C,\xi\xi}\Delta\xi
+ \Delta_u\delta_u\mathbf{u}_{C,\xi}",
    )
    .part(Order::Second, "first equality")
    .printed(
        s.t.second,
        big.t_xixi * squared(s)
            + big.t_xi * xi.second
            + u_xixixi * squared(s)
            + linear_u[2] * xi.delta
            + u_xixi * xi.second
            + delta_u[2] * xi.linear
            + second_u[1],
    )
    .part(Order::Second, "last equality")
    .printed(s.t.second, kept)
    .complete("with Δᵤδᵤu_C,ξ", s.t.second, kept + second_u[1]);
}

/// (31).
fn resume<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let s = &p.beam;
    let (t, t_xi, t_xixi) = (s.jet.geometry.t, s.jet.geometry.t_xi, s.jet.geometry.t_xixi);
    let second_u = &s.jet.second_u;
    let row_2 = t_xi * squared(s) + t * s.xi.second + mixed(s, 1);
    let row_4 = t_xixi * squared(s) + t_xi * s.xi.second + mixed(s, 2);
    table
        .state(
            31,
            "variations of x_C and x_C,ξ",
            r"\begin{aligned}\delta\mathbf{x}_C &= \mathbf{t}\delta\xi + \delta_u\mathbf{u}_C \\
\Delta\delta\mathbf{x}_C &= \mathbf{t}_{,\xi}\delta\xi\Delta\xi + \mathbf{t}\Delta\delta\xi
+ \delta\xi\,\Delta_u\mathbf{u}_{C,\xi} + \delta_u\mathbf{u}_{C,\xi}\Delta\xi \\
\delta\mathbf{x}_{C,\xi} &= \mathbf{t}_{,\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi} \\
\Delta\delta\mathbf{x}_{C,\xi} &= \mathbf{t}_{,\xi\xi}\delta\xi\Delta\xi + \mathbf{t}_{,\xi}\Delta\delta\xi
+ \delta\xi\,\Delta_u\mathbf{u}_{C,\xi\xi} + \delta_u\mathbf{u}_{C,\xi\xi}\Delta\xi\end{aligned}",
        )
        .corrected_to(
            r"\begin{aligned}\Delta\delta\mathbf{x}_C &= \ldots + \Delta_u\delta_u\mathbf{u}_C \\
\Delta\delta\mathbf{x}_{C,\xi} &= \ldots + \Delta_u\delta_u\mathbf{u}_{C,\xi}\end{aligned}",
        )
        .part(Order::First, "δx_C")
        .printed(s.x.delta, t * s.xi.delta + s.jet.delta_u[0])
        .part(Order::Second, "Δδx_C")
        .printed(s.x.second, row_2)
        .complete("with Δᵤδᵤu_C", s.x.second, row_2 + second_u[0])
        .part(Order::First, "δx_C,ξ")
        .printed(s.t.delta, t_xi * s.xi.delta + s.jet.delta_u[1])
        .part(Order::Second, "Δδx_C,ξ")
        .printed(s.t.second, row_4)
        .complete("with Δᵤδᵤu_C,ξ", s.t.second, row_4 + second_u[1]);
}

/// (32).
fn geometry<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let (s, r) = (&p.beam, &p.bar);
    let (x, y) = (s.jet.geometry, r.jet.geometry);
    let (k, k_bar) = (&s.jet.second_u, &r.jet.second_u);
    // Δδd = t Δδξ − t̄ Δδξ̄ + t,ξ δξΔξ − t̄,ξ̄ δξ̄Δξ̄ + (δξ Δᵤu,ξ + δᵤu,ξ Δξ) − (δξ̄ Δᵤū,ξ̄ + δᵤū,ξ̄ Δξ̄)
    let d = x.t * s.xi.second - y.t * r.xi.second + x.t_xi * squared(s) - y.t_xi * squared(r) + mixed(s, 1)
        - mixed(r, 1);
    let t = x.t_xixi * squared(s) + x.t_xi * s.xi.second + mixed(s, 2);
    // δt̄, printed with a stray −δξ̄
    let delta_t_bar = y.t_xi * r.xi.delta + r.jet.delta_u[1];
    // Δδt̄, printed with t̄,ξ̄ for t̄,ξ̄ξ̄
    let rest_t_bar = y.t_xi * r.xi.second + mixed(r, 2);
    let t_bar = y.t_xixi * squared(r) + rest_t_bar;
    table.state(
        32,
        "variations of d, t and t̄, vectors",
        r"\begin{aligned}\delta\mathbf{d} &= \mathbf{t}\delta\xi - \bar{\mathbf{t}}\delta\bar\xi + \delta_u\mathbf{u}_C
- \delta_u\bar{\mathbf{u}}_{\bar C} \\
\Delta\delta\mathbf{d} &= \mathbf{t}\Delta\delta\xi - \bar{\mathbf{t}}\Delta\delta\bar\xi
+ \mathbf{t}_{,\xi}\delta\xi\Delta\xi - \bar{\mathbf{t}}_{,\bar\xi}\delta\bar\xi\Delta\bar\xi
+ (\delta\xi\,\Delta_u\mathbf{u}_{C,\xi} + \delta_u\mathbf{u}_{C,\xi}\Delta\xi)
- (\delta\bar\xi\,\Delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi} + \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\Delta\bar\xi) \\
\delta\mathbf{t} &= \mathbf{t}_{,\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi} \\
\Delta\delta\mathbf{t} &= \mathbf{t}_{,\xi\xi}\delta\xi\Delta\xi + \mathbf{t}_{,\xi}\Delta\delta\xi
+ (\delta\xi\,\Delta_u\mathbf{u}_{C,\xi\xi} + \delta_u\mathbf{u}_{C,\xi\xi}\Delta\xi) \\
\delta\bar{\mathbf{t}} &= \bar{\mathbf{t}}_{,\bar\xi}\delta\bar\xi - \delta\bar\xi
+ \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi} \\
\Delta\delta\bar{\mathbf{t}} &= \bar{\mathbf{t}}_{,\bar\xi}\delta\bar\xi\Delta\bar\xi
+ \bar{\mathbf{t}}_{,\bar\xi}\Delta\delta\bar\xi + (\delta\bar\xi\,\Delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi\bar\xi}
+ \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi\bar\xi}\Delta\bar\xi)\end{aligned}",
    )
    .corrected_to(
        r"\begin{aligned}\delta\bar{\mathbf{t}} &= \bar{\mathbf{t}}_{,\bar\xi}\delta\bar\xi
+ \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi} \\
\Delta\delta\bar{\mathbf{t}} &= \bar{\mathbf{t}}_{,\bar\xi\bar\xi}\delta\bar\xi\Delta\bar\xi
+ \bar{\mathbf{t}}_{,\bar\xi}\Delta\delta\bar\xi + (\delta\bar\xi\,\Delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi\bar\xi}
+ \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi\bar\xi}\Delta\bar\xi) + \Delta_u\delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi} \\
\Delta\delta\mathbf{d} &= \ldots + \Delta_u\delta_u\mathbf{u}_C - \Delta_u\delta_u\bar{\mathbf{u}}_{\bar C} \\
\Delta\delta\mathbf{t} &= \ldots + \Delta_u\delta_u\mathbf{u}_{C,\xi}\end{aligned}",
    )
    .remark("The stray −δξ̄ in δt̄ is a number among vectors: what is printed has no meaning, and three are tried.")
    .part(Order::First, "δd")
    .printed(p.d.delta, x.t * s.xi.delta - y.t * r.xi.delta + s.jet.delta_u[0] - r.jet.delta_u[0])
    .part(Order::Second, "Δδd")
    .printed(p.d.second, d)
    .complete("with Δᵤδᵤu_C − Δᵤδᵤū_C̄", p.d.second, d + (k[0] - k_bar[0]))
    .part(Order::First, "δt")
    .printed(s.t.delta, x.t_xi * s.xi.delta + s.jet.delta_u[1])
    .part(Order::Second, "Δδt")
    .printed(s.t.second, t)
    .complete("with Δᵤδᵤu_C,ξ", s.t.second, t + k[1])
    .part(Order::First, "δt̄")
    .read("−δξ̄ off each component", r.t.delta, delta_t_bar - Vector3::repeat(r.xi.delta))
    .read("−δξ̄ times t̄", r.t.delta, delta_t_bar - y.t * r.xi.delta)
    .read("t̄,ξ̄ (δξ̄ − δξ̄)", r.t.delta, r.jet.delta_u[1])
    .corrected("without −δξ̄", r.t.delta, delta_t_bar)
    .part(Order::Second, "Δδt̄")
    .printed(r.t.second, y.t_xi * squared(r) + rest_t_bar)
    .corrected("t̄,ξ̄ξ̄ δξ̄Δξ̄", r.t.second, t_bar)
    .complete("and with Δᵤδᵤū_C̄,ξ̄", r.t.second, t_bar + k_bar[1]);
}
