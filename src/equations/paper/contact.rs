//! Section 2.2, contact variables: (11) to (22).

use crate::equations::point::Point;
use crate::equations::table::{Kind, Order, Table};
use crate::number::Real;

pub(super) fn enter<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let (s, r) = (&p.beam, &p.bar);
    let (d, t, t_bar, xi) = (&p.distance, &s.length, &r.length, &s.xi);
    let slipped = xi.value - s.xi_0;
    let slipped_bar = r.xi.value - r.xi_0;

    // (11)
    table
        .define(11, "normal gap", r"g_N = d - (r + \bar r)")
        .remark("Never below −(r + r̄): that centroids have passed through each other is not seen.")
        .part(Order::Value, "")
        .printed([p.gap.value], [d.value - (s.radius + r.radius)]);

    table
        .define(
            12,
            "slip as arc length",
            r"g_T = \int_{\xi_{C_0}}^{\xi_C} \lVert \mathbf{x}_{,\xi} \rVert \,\mathrm{d}\xi",
        )
        .remark(
            "The program computes (14) in its place; the integral is computed here only, to measure (14).",
        );

    table.enter(13, Kind::Assumption, "small slip", r"\xi_C - \xi_{C_0} \approx \mathrm{d}\xi");

    // (14): g_T = t (ξ_C − ξ_C₀)
    table.state(
        14,
        "slip along the tangent",
        r"g_T = \lVert \mathbf{t} \rVert \int_{\xi_{C_0}}^{\xi_{C_0} + \mathrm{d}\xi} \mathrm{d}\xi
= t \,\mathrm{d}\xi = t\,(\xi_C - \xi_{C_0})",
    )
    .remark("As a definition it is compared with the slip that the program varies, which is this one. As an approximation it is compared with the arc length (12).")
    .part(Order::Value, "")
    .printed([s.slip.value], [t.value * slipped]);

    // (15)
    table
        .define(
            15,
            "contact variables, resumed",
            r"g_N = d - (r + \bar r) \quad g_T = t\,(\xi_C - \xi_{C_0}) \quad
\bar g_T = \bar t\,(\bar\xi_{\bar C} - \bar\xi_{\bar C_0})",
        )
        .part(Order::Value, "")
        .printed(
            [p.gap.value, s.slip.value, r.slip.value],
            [d.value - (s.radius + r.radius), t.value * slipped, t_bar.value * slipped_bar],
        );

    table.enter(
        16,
        Kind::List,
        "terms required",
        r"\delta g_N, \ \Delta g_N, \ \Delta \delta g_N, \ \delta g_T, \ \Delta g_T, \ \Delta \delta g_T, \
\Delta \bar{g}_T, \ \Delta \delta \bar{g}_T",
    )
    .corrected_to(
        r"\delta g_N, \ \Delta g_N, \ \Delta \delta g_N, \ \delta g_T, \ \Delta g_T, \ \Delta \delta g_T, \
\delta \bar{g}_T, \ \Delta \bar{g}_T, \ \Delta \delta \bar{g}_T",
    )
    .remark("Each variable of (15) needs each of the three variations.");

    table
        .enter(
            17,
            Kind::List,
            "terms to be computed",
            r"\delta g_N, \ \Delta \delta g_N, \ \delta g_T, \ \Delta \delta g_T",
        )
        .remark("Δg_N and Δg_T are δg_N and δg_T along the second direction. The terms of ḡ_T are those of g_T with the beams exchanged. So these four terms give all nine.");

    // (18)
    table
        .state(18, "variation of g_N", r"\delta g_N = \delta d")
        .part(Order::First, "")
        .printed([p.gap.delta], [d.delta]);

    // (19)
    table
        .state(19, "second variation of g_N", r"\Delta\delta g_N = \Delta\delta d")
        .part(Order::Second, "")
        .printed([p.gap.second], [d.second]);

    // (20): δg_T = δt (ξ_C − ξ_C₀) + t δξ_C
    table
        .state(20, "variation of g_T", r"\delta g_T = \delta t\,(\xi_C - \xi_{C_0}) + t\,\delta\xi_C")
        .remark("The variation of (15), not of the arc length (12).")
        .part(Order::First, "")
        .printed([s.slip.delta], [t.delta * slipped + t.value * xi.delta]);

    // (21): Δδg_T = Δδt (ξ_C − ξ_C₀) + δt Δξ_C + Δt δξ_C + t Δδξ_C
    table.state(
        21,
        "second variation of g_T",
        r"\Delta\delta g_T = \Delta\delta t\,(\xi_C - \xi_{C_0}) + \delta t\,\Delta\xi_C + \Delta t\,\delta\xi_C
+ t\,\Delta\delta\xi_C",
    )
    .part(Order::Second, "")
    .printed([s.slip.second], [
        t.second * slipped + t.delta * xi.linear + t.linear * xi.delta + t.value * xi.second,
    ]);

    table.enter(
        22,
        Kind::List,
        "what the terms need",
        r"\delta g_N \Rightarrow \delta d \quad \Delta \delta g_N \Rightarrow \Delta \delta d \quad
\delta g_T \Rightarrow \delta t, \ \delta \xi_C \quad \Delta \delta g_T \Rightarrow \Delta \delta t, \ \Delta \delta \xi_C",
    )
    .remark("By (21) Δδg_T also needs δt, Δt, δξ and Δξ. The entry of δg_T lists δt and δξ, and Δt and Δξ are the same along the second direction. So no term is missing.");
}
