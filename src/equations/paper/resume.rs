//! Section 6, conclusions: (57) to (59).

use super::norms::{bracket, delta_u_hat, readings, second_distance, tangents_varied};
use super::projection::{System, first_sides, second_sides};
use crate::equations::point::Point;
use crate::equations::table::{Order, Table};
use crate::number::Real;

pub(super) fn enter<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let s = &p.beam;

    // (57): δd = [δᵤû·d]/d, and (40) once more
    let equation = table.state(
        57,
        "variations of d",
        r"\begin{aligned}\delta d = {} & \frac{1}{d}\left[\delta_u\hat{\mathbf{u}}_C\cdot\mathbf{d}\right] \\
\Delta\delta d = {} & \frac{1}{d}\left[\delta_u\hat{\mathbf{u}}_C\cdot\left(\mathbf{t}\Delta\xi
- \bar{\mathbf{t}}\Delta\bar\xi\right) + \mathbf{d}\cdot\left(\delta_u\mathbf{u}_{C,\xi}\Delta\xi
- \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\Delta\bar\xi\right)\right] \\
& + \frac{1}{d}\left[\delta_u\hat{\mathbf{u}}_C\cdot\Delta\hat{\mathbf{u}}_C\right]
- \frac{1}{d^3}\left[\delta_u\hat{\mathbf{u}}_C\cdot\mathbf{d}\;\mathbf{d}\cdot\Delta\hat{\mathbf{u}}_C\right]\end{aligned}",
    );
    equation
        .corrected_to(
            r"\Delta\delta d = \ldots + \frac{1}{d}\left[\delta_u\hat{\mathbf{u}}_C\cdot\Delta_u\hat{\mathbf{u}}_C\right]
- \frac{1}{d^3}\left[\delta_u\hat{\mathbf{u}}_C\cdot\mathbf{d}\;\mathbf{d}\cdot\Delta_u\hat{\mathbf{u}}_C\right]
+ \frac{1}{d}\mathbf{d}\cdot\Delta_u\delta_u\hat{\mathbf{u}}_C",
        )
        .part(Order::First, "δd")
        .printed([p.distance.delta], [delta_u_hat(p).dot(&p.d.value) / p.distance.value])
        .part(Order::Second, "Δδd");
    readings(equation, p, |hat| second_distance(p, hat));

    // (58): 1/t³ in place of 1/t before δt·Δt, and δt·t·Δt in place of (δt·t)(t·Δt)
    let [delta, linear] = tangents_varied(s);
    let (t, vector) = (s.length.value, s.t.value);
    let (cube, product) = (t * t * t, delta.dot(&linear));
    let left = [s.length.second];
    let last = delta.dot(&vector) * vector.dot(&linear) / cube;
    let last_by_length = t * product / cube;
    let corrected = bracket(s) / t + product / t - last;
    table.state(
        58,
        "variations of t",
        r"\begin{aligned}\delta t = {} & \frac{1}{t}\left[(\delta\xi\,\mathbf{t}_{,\xi} + \delta_u\mathbf{u}_{C,\xi})\cdot\mathbf{t}\right] \\
\Delta\delta t = {} & \frac{1}{t}\left[(\mathbf{t}_{,\xi\xi}\delta\xi\Delta\xi + \mathbf{t}_{,\xi}\Delta\delta\xi
+ \delta\xi\,\Delta_u\mathbf{u}_{C,\xi\xi} + \delta_u\mathbf{u}_{C,\xi\xi}\Delta\xi)\cdot\mathbf{t}\right] \\
& + \frac{1}{t^3}\left[(\delta\xi\,\mathbf{t}_{,\xi} + \delta_u\mathbf{u}_{C,\xi})\cdot
(\mathbf{t}_{,\xi}\Delta\xi + \Delta_u\mathbf{u}_{C,\xi})\right] \\
& - \frac{1}{t^3}\left[(\delta\xi\,\mathbf{t}_{,\xi} + \delta_u\mathbf{u}_{C,\xi})\cdot\mathbf{t}\cdot
(\mathbf{t}_{,\xi}\Delta\xi + \Delta_u\mathbf{u}_{C,\xi})\right]\end{aligned}",
    )
    .corrected_to(
        r"\Delta\delta t = \frac{1}{t}\left[\ldots + \Delta_u\delta_u\mathbf{u}_{C,\xi}\cdot\mathbf{t}\right]
+ \frac{1}{t}\,\delta\mathbf{t}\cdot\Delta\mathbf{t}
- \frac{1}{t^3}(\delta\mathbf{t}\cdot\mathbf{t})(\mathbf{t}\cdot\Delta\mathbf{t})",
    )
    .remark("Two misprints, not those of (42): 1/t³ for 1/t, and again a t too few in the last term.")
    .part(Order::First, "δt")
    .printed([s.length.delta], [delta.dot(&vector) / t])
    .part(Order::Second, "Δδt")
    .read("1/t³; δt·t t·Δt", left, [bracket(s) / t + product / cube - last])
    .read("1/t³; t (δt·Δt)", left, [bracket(s) / t + product / cube - last_by_length])
    .read("1/t; t (δt·Δt)", left, [bracket(s) / t + product / t - last_by_length])
    .corrected("1/t; δt·t t·Δt", left, [corrected])
    .complete("and with t·Δᵤδᵤu_C,ξ/t", left, [corrected + vector.dot(&s.jet.second_u[1]) / t]);

    // (59): (52) and (56), with the bars
    let system = System::new(p);
    let (xi, xi_bar) = (&s.xi, &p.bar.xi);
    let second = [xi.second, xi_bar.second];
    table
        .state(
            59,
            "variations of ξ and ξ̄",
            r"\begin{aligned}\delta\xi &= \frac{\bar a R_\delta + b\bar R_\delta}{D} &
\delta\bar\xi &= \frac{-b R_\delta + a\bar R_\delta}{D} \\
\Delta\delta\xi &= \frac{\bar a R_{\Delta\delta} + b\bar R_{\Delta\delta}}{D} &
\Delta\delta\bar\xi &= \frac{-b R_{\Delta\delta} + a\bar R_{\Delta\delta}}{D}\end{aligned}",
        )
        .remark("The right-hand sides are those of (50) and (55).")
        .part(Order::First, "δξ, δξ̄")
        .printed([xi.delta, xi_bar.delta], system.solve(first_sides(p)))
        .part(Order::Second, "Δδξ, Δδξ̄")
        .read("R from (54)", second, system.solve(second_sides(p, false)))
        .complete("R with Δᵤδᵤu", second, system.solve(second_sides(p, true)));
}
