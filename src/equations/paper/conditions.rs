//! Section 5.1, variational forms of the orthogonality conditions: (43) to (48).

use crate::equations::point::Point;
use crate::equations::table::{Order, Table};
use crate::number::Real;

pub(super) fn enter<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let (s, r, d, t, zero) = (&p.beam, &p.bar, &p.d, &p.beam.t, T::zero());
    let [d_after, t_after] = &p.after;

    // (43): d·t + δd·t + d·δt + δd·δt = 0, all increments finite
    let (delta_d, delta_t) = (d_after.value - d.value, t_after.value - t.value);
    let expanded = |delta_d: nalgebra::Vector3<T>, delta_t: nalgebra::Vector3<T>| {
        d.value.dot(&t.value) + delta_d.dot(&t.value) + d.value.dot(&delta_t) + delta_d.dot(&delta_t)
    };
    table.state(
        43,
        "orthogonality after a step",
        r"\mathbf{d}\cdot\mathbf{t} = 0 \;\Rightarrow\; (\mathbf{d} + \delta\mathbf{d})\cdot(\mathbf{t} + \delta\mathbf{t}) = 0
\;\Rightarrow\; \mathbf{d}\cdot\mathbf{t} + \delta\mathbf{d}\cdot\mathbf{t} + \mathbf{d}\cdot\delta\mathbf{t}
+ \delta\mathbf{d}\cdot\delta\mathbf{t} = 0",
    )
    .remark("With first variations for increments δd·δt remains, of second order.")
    .part(Order::Finite, "")
    .printed(
        [d.value.dot(&t.value), (d.value + delta_d).dot(&(t.value + delta_t)), expanded(delta_d, delta_t)],
        [zero; 3],
    )
    .other("with first variations", [expanded(d.delta, t.delta)], [zero]);

    // (44): δd·t + d·δt = 0, δ(d·t) = 0
    table
        .state(
            44,
            "orthogonality varied",
            r"\delta\mathbf{d}\cdot\mathbf{t} + \mathbf{d}\cdot\delta\mathbf{t} = 0 \;\Rightarrow\;
\delta(\mathbf{d}\cdot\mathbf{t}) = 0",
        )
        .part(Order::First, "")
        .printed([d.delta.dot(&t.value) + d.value.dot(&t.delta), p.orthogonality(s).delta], [zero; 2]);

    // (45): δ(d + Δd)·(t + Δt) + (d + Δd)·δ(t + Δt) = 0, Δ finite
    let (linear_d, linear_t) = (delta_d, delta_t);
    let (both_d, both_t) = (d_after.delta - d.delta, t_after.delta - t.delta);
    let step = |[linear_d, both_d, linear_t, both_t]: [nalgebra::Vector3<T>; 4]| {
        (d.delta + both_d).dot(&(t.value + linear_t)) + (d.value + linear_d).dot(&(t.delta + both_t))
    };
    let (finite, varied) = ([linear_d, both_d, linear_t, both_t], [d.linear, d.second, t.linear, t.second]);
    table
        .state(
            45,
            "varied orthogonality after a step",
            r"\delta(\mathbf{d} + \Delta\mathbf{d})\cdot(\mathbf{t} + \Delta\mathbf{t})
+ (\mathbf{d} + \Delta\mathbf{d})\cdot\delta(\mathbf{t} + \Delta\mathbf{t}) = 0",
        )
        .remark("With variations for increments δΔd·Δt + Δd·δΔt remains, of third order; so for (46).")
        .part(Order::Finite, "")
        .printed([step(finite)], [zero])
        .other("with variations", [step(varied)], [zero]);

    // (46): δd·t + δd·Δt + δΔd·t + δΔd·Δt + d·δt + d·δΔt + Δd·δt + Δd·δΔt = 0
    let terms = |[linear_d, both_d, linear_t, both_t]: [nalgebra::Vector3<T>; 4]| {
        d.delta.dot(&t.value)
            + d.delta.dot(&linear_t)
            + both_d.dot(&t.value)
            + both_d.dot(&linear_t)
            + d.value.dot(&t.delta)
            + d.value.dot(&both_t)
            + linear_d.dot(&t.delta)
            + linear_d.dot(&both_t)
    };
    table.state(
        46,
        "(45) expanded",
        r"\delta\mathbf{d}\cdot\mathbf{t} + \delta\mathbf{d}\cdot\Delta\mathbf{t} + \delta\Delta\mathbf{d}\cdot\mathbf{t}
+ \delta\Delta\mathbf{d}\cdot\Delta\mathbf{t} + \mathbf{d}\cdot\delta\mathbf{t} + \mathbf{d}\cdot\delta\Delta\mathbf{t}
+ \Delta\mathbf{d}\cdot\delta\mathbf{t} + \Delta\mathbf{d}\cdot\delta\Delta\mathbf{t} = 0",
    )
    .part(Order::Finite, "")
    .printed([terms(finite)], [zero])
    .other("with variations", [terms(varied)], [zero]);

    // (47): δΔd·t + δd·Δt + Δd·δt + d·δΔt = 0, Δδ(d·t) = 0
    table
        .state(
            47,
            "orthogonality varied twice",
            r"\delta\Delta\mathbf{d}\cdot\mathbf{t} + \delta\mathbf{d}\cdot\Delta\mathbf{t}
+ \Delta\mathbf{d}\cdot\delta\mathbf{t} + \mathbf{d}\cdot\delta\Delta\mathbf{t} = 0 \;\Rightarrow\;
\Delta\delta(\mathbf{d}\cdot\mathbf{t}) = 0",
        )
        .part(Order::Second, "")
        .printed(
            [
                d.second.dot(&t.value)
                    + d.delta.dot(&t.linear)
                    + d.linear.dot(&t.delta)
                    + d.value.dot(&t.second),
                p.orthogonality(s).second,
            ],
            [zero; 2],
        );

    // (48)
    let (f, f_bar) = (p.orthogonality(s), p.orthogonality(r));
    table.state(
        48,
        "orthogonality, resumed",
        r"\begin{cases}\mathbf{d}\cdot\mathbf{t} = 0 \\ \mathbf{d}\cdot\bar{\mathbf{t}} = 0\end{cases} \quad
\begin{cases}\delta(\mathbf{d}\cdot\mathbf{t}) = 0 \\ \delta(\mathbf{d}\cdot\bar{\mathbf{t}}) = 0\end{cases} \quad
\begin{cases}\Delta\delta(\mathbf{d}\cdot\mathbf{t}) = 0 \\ \Delta\delta(\mathbf{d}\cdot\bar{\mathbf{t}}) = 0\end{cases}",
    )
    .remark("The scan has integral signs for braces, and (40) for (48).")
    .part(Order::Value, "d·t, d·t̄")
    .printed([f.value, f_bar.value], [zero; 2])
    .part(Order::First, "δ")
    .printed([f.delta, f_bar.delta], [zero; 2])
    .part(Order::Second, "Δδ")
    .printed([f.second, f_bar.second], [zero; 2]);
}
