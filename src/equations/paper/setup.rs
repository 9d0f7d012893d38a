//! Section 2.1, geometry: (1) to (10).

use super::norm;
use crate::equations::point::{Point, Side};
use crate::equations::table::{Kind, Order, Table};
use crate::number::Real;

pub(super) fn enter<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let (s, r) = (&p.beam, &p.bar);
    let (x, x_bar) = (s.jet.geometry, r.jet.geometry);
    let zero = T::zero();

    // (1): x = X + u, where u is the difference of x and X
    let (u, u_bar) = (x.x - s.reference.x, x_bar.x - r.reference.x);
    table
        .define(
            1,
            "current configuration",
            r"\mathbf{x}(\xi) = \mathbf{X}(\xi) + \mathbf{u}(\xi) \qquad
\bar{\mathbf{x}}(\bar\xi) = \bar{\mathbf{X}}(\bar\xi) + \bar{\mathbf{u}}(\bar\xi)",
        )
        .part(Order::Value, "")
        .printed([s.x.value, r.x.value], [s.reference.x + u, r.reference.x + u_bar]);

    // (2): the derivatives of ‖x − x̄‖²/2 vanish: d·t = 0, −d·t̄ = 0
    table.define(
        2,
        "minimal distance",
        r"d = \min \lVert \mathbf{x}(\xi) - \bar{\mathbf{x}}(\bar\xi) \rVert",
    )
    .remark("Evaluated as stationarity, which is what the paper uses of it. All that follows needs a nondegenerate minimum inside both beams.")
    .part(Order::Value, "")
    .printed([p.orthogonality(s).value, -p.orthogonality(r).value], [zero, zero]);

    // (3)
    table.define(
        3,
        "closest points",
        r"\mathbf{x}(\xi_C) = \mathbf{x}_C \qquad \bar{\mathbf{x}}(\bar\xi_{\bar C}) = \bar{\mathbf{x}}_{\bar C}",
    )
    .remark("The line above it prints ξ for ξ̄ in ξ̄ = ξ̄_C̄.")
    .part(Order::Value, "")
    .printed([s.x.value, r.x.value], [x.x, x_bar.x]);

    // (4)
    table.define(
        4,
        "distance",
        r"d = \lVert \mathbf{d} \rVert = \lVert \mathbf{x}(\xi_C) - \bar{\mathbf{x}}(\bar\xi_{\bar C}) \rVert
= \lVert \mathbf{x}_C - \bar{\mathbf{x}}_{\bar C} \rVert",
    )
    .part(Order::Value, "")
    .printed([p.distance.value; 2], [norm(&p.d.value), norm(&(x.x - x_bar.x))]);

    // (5)
    table
        .define(5, "distance vector", r"\mathbf{d} = \mathbf{x}_C - \bar{\mathbf{x}}_{\bar C}")
        .part(Order::Value, "")
        .printed(p.d.value, x.x - x_bar.x);

    // (6)
    table
        .define(
            6,
            "tangents",
            r"\mathbf{t} = \mathbf{x}_{C,\xi} \qquad \bar{\mathbf{t}} = \bar{\mathbf{x}}_{\bar C,\bar\xi}",
        )
        .part(Order::Value, "")
        .printed([s.t.value, r.t.value], [x.t, x_bar.t]);

    // (7)
    table.define(
        7,
        "lengths of the tangents",
        r"t = \lVert \mathbf{x}_{C,\xi} \rVert \qquad \bar t = \lVert \bar{\mathbf{x}}_{\bar C,\bar\xi} \rVert",
    )
    .part(Order::Value, "")
    .printed([s.length.value, r.length.value], [norm(&x.t), norm(&x_bar.t)]);

    // (8)
    table.define(
        8,
        "vectors, resumed",
        r"\mathbf{d} = \mathbf{x}_C - \bar{\mathbf{x}}_{\bar C} \qquad \mathbf{t} = \mathbf{x}_{C,\xi} \qquad
\bar{\mathbf{t}} = \bar{\mathbf{x}}_{\bar C,\bar\xi}",
    )
    .part(Order::Value, "")
    .printed([p.d.value, s.t.value, r.t.value], [x.x - x_bar.x, x.t, x_bar.t]);

    // (9)
    table.define(
        9,
        "norms, resumed",
        r"d = \lVert \mathbf{d} \rVert \qquad t = \lVert \mathbf{t} \rVert \qquad \bar t = \lVert \bar{\mathbf{t}} \rVert",
    )
    .part(Order::Value, "")
    .printed(
        [p.distance.value, s.length.value, r.length.value],
        [norm(&p.d.value), norm(&s.t.value), norm(&r.t.value)],
    );

    let bilinear = |side: &Side<T>, k: usize| {
        let [none, delta, linear, both] = side.corners.map(|corner| corner[k]);
        both - delta - linear + none
    };
    // (10): t,ξ = x_C,ξξ   t,ξξ = x_C,ξξξ, the left from the jet, the right by differentiating the position
    table.enter(10, Kind::Lost, "derivatives of the tangents", "")
        .corrected_to(
            r"\mathbf{t}_{,\xi} = \mathbf{x}_{C,\xi\xi} \qquad \mathbf{t}_{,\xi\xi} = \mathbf{x}_{C,\xi\xi\xi} \qquad
\bar{\mathbf{t}}_{,\bar\xi} = \bar{\mathbf{x}}_{\bar C,\bar\xi\bar\xi} \qquad
\bar{\mathbf{t}}_{,\bar\xi\bar\xi} = \bar{\mathbf{x}}_{\bar C,\bar\xi\bar\xi\bar\xi}",
        )
        .remark("The sentence that announces it is there, the equation is not. This is what (31) and (32) take from it.")
        .part(Order::Value, "")
        .corrected("as reconstructed", [x.t_xi, x.t_xixi, x_bar.t_xi, x_bar.t_xixi], [bilinear(s, 0), bilinear(s, 1), bilinear(r, 0), bilinear(r, 1)]);
}
