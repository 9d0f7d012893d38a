//! Section 4, norms of the vectors: (33) to (42).

use super::squared;
use crate::equations::point::{Point, Side};
use crate::equations::table::{Order, Table};
use crate::linearization::Varied;
use crate::number::Real;
use nalgebra::Vector3;

pub(super) fn enter<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    generic(p, table);
    distance(p, table);
    tangent(p, table);
}

/// A norm and its vector.
type Norm<T> = (Varied<T>, Varied<Vector3<T>>);

/// (33) to (35): the norm of any vector, for the three vectors d, t and t_bar.
fn generic<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let norms = [(p.distance, p.d), (p.beam.length, p.beam.t), (p.bar.length, p.bar.t)];
    let of = |f: fn(&Norm<T>) -> T| norms.each_ref().map(f);

    // (33): δv = v·δv/v
    let first = |(v, w): &Norm<T>| w.value.dot(&w.delta) / v.value;
    table
        .state(
            33,
            "variation of a norm",
            r"\delta v = \delta\lVert\mathbf{v}\rVert = \delta\sqrt{\mathbf{v}\cdot\mathbf{v}}
= \frac{1}{v}\mathbf{v}\cdot\delta\mathbf{v}",
        )
        .remark("Run for d, t and t̄, as (34) and (35) are.")
        .part(Order::First, "")
        .printed(of(|(v, _)| v.delta), of(first));

    // (34): Δδv = [v (Δv·δv + v·Δδv) − Δv v·δv]/v²
    table.state(
        34,
        "linearization of (33)",
        r"\Delta\delta\lVert\mathbf{v}\rVert = \Delta\left(\frac{1}{v}\mathbf{v}\cdot\delta\mathbf{v}\right)
= \frac{1}{v^2}\left[v\left(\Delta\mathbf{v}\cdot\delta\mathbf{v} + \mathbf{v}\cdot\Delta\delta\mathbf{v}\right)
- \Delta v\,\mathbf{v}\cdot\delta\mathbf{v}\right]",
    )
    .part(Order::Second, "")
    .printed(
        of(|(v, _)| v.second),
        of(|(v, w)| {
            (v.value * (w.linear.dot(&w.delta) + w.value.dot(&w.second)) - v.linear * w.value.dot(&w.delta))
                / (v.value * v.value)
        }),
    );

    // (35): Δδv = (v·Δδv + Δv·δv)/v − (δv·v)(v·Δv)/v³
    table.state(
        35,
        "variations of a norm",
        r"\delta v = \frac{1}{v}\mathbf{v}\cdot\delta\mathbf{v} \qquad
\Delta\delta v = \frac{1}{v}\left(\mathbf{v}\cdot\Delta\delta\mathbf{v} + \Delta\mathbf{v}\cdot\delta\mathbf{v}\right)
- \frac{1}{v^3}\,\delta\mathbf{v}\cdot\mathbf{v}\;\mathbf{v}\cdot\Delta\mathbf{v}",
    )
    .part(Order::First, "δv")
    .printed(of(|(v, _)| v.delta), of(first))
    .part(Order::Second, "Δδv")
    .printed(
        of(|(v, _)| v.second),
        of(|(v, w)| {
            (w.value.dot(&w.second) + w.linear.dot(&w.delta)) / v.value
                - w.delta.dot(&w.value) * w.value.dot(&w.linear) / (v.value * v.value * v.value)
        }),
    );
}

/// Δû_C in the last terms of (39), (40) and (57): total as printed, or partial as corrected.
struct Hat<T> {
    /// Δu_C − Δū_C with Δu_C = u_C,ξ Δξ + Δᵤu_C.
    total: Vector3<T>,
    /// Δᵤu_C − Δᵤū_C.
    partial: Vector3<T>,
}

impl<T: Real> Hat<T> {
    fn new(p: &Point<T>) -> Self {
        let u = |s: &Side<T>| (s.jet.geometry.t - s.reference.t) * s.xi.linear + s.jet.linear_u[0];
        Self { total: u(&p.beam) - u(&p.bar), partial: p.beam.jet.linear_u[0] - p.bar.jet.linear_u[0] }
    }
}

/// δᵤû_C.
pub(super) fn delta_u_hat<T: Real>(p: &Point<T>) -> Vector3<T> {
    p.beam.jet.delta_u[0] - p.bar.jet.delta_u[0]
}

/// t Δξ − t̄ Δξ̄.
fn slid<T: Real>(p: &Point<T>) -> Vector3<T> {
    p.beam.t.value * p.beam.xi.linear - p.bar.t.value * p.bar.xi.linear
}

/// d·(δᵤu_C,ξ Δξ − δᵤū_C̄,ξ̄ Δξ̄).
fn turned<T: Real>(p: &Point<T>) -> T {
    let of = |s: &Side<T>| s.jet.delta_u[1] * s.xi.linear;
    p.d.value.dot(&(of(&p.beam) - of(&p.bar)))
}

/// d·(Δᵤδᵤu_C − Δᵤδᵤū_C̄)/d, which (39), (40) and (57) drop.
pub(super) fn dropped<T: Real>(p: &Point<T>) -> T {
    p.d.value.dot(&(p.beam.jet.second_u[0] - p.bar.jet.second_u[0])) / p.distance.value
}

/// (40) and (57), with a reading of Δû_C.
pub(super) fn second_distance<T: Real>(p: &Point<T>, hat: &Vector3<T>) -> T {
    let (d, delta_u) = (p.distance.value, delta_u_hat(p));
    // [δᵤû·(t Δξ − t̄ Δξ̄) + d·(..)]/d + [δᵤû·Δû]/d − [δᵤû·d d·Δû]/d³
    (delta_u.dot(&slid(p)) + turned(p)) / d + delta_u.dot(hat) / d
        - delta_u.dot(&p.d.value) * p.d.value.dot(hat) / (d * d * d)
}

/// The readings of Δδd with Δû_C: the same for (40) and (57).
pub(super) fn readings<T: Real>(
    equation: &mut crate::equations::table::Equation<T>,
    p: &Point<T>,
    formula: impl Fn(&Vector3<T>) -> T,
) {
    let hat = Hat::new(p);
    let (left, corrected) = ([p.distance.second], formula(&hat.partial));
    equation
        .read("Δû_C = Δu_C − Δū_C̄, total", left, [formula(&hat.total)])
        .other("Δû_C = Δd", left, [formula(&p.d.linear)])
        .corrected("Δᵤû_C for Δû_C", left, [corrected])
        .complete("and with d·Δᵤδᵤû_C/d", left, [corrected + dropped(p)]);
}

/// (36) to (40): the norm of d.
fn distance<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let (s, r) = (&p.beam, &p.bar);
    let (d, vector, delta_u) = (&p.distance, &p.d, delta_u_hat(p));

    // (36): δd = d·δd/d = d·(t δξ − t̄ δξ̄ + δᵤu − δᵤū)/d
    let slid_delta = s.t.value * s.xi.delta - r.t.value * r.xi.delta;
    table.state(
        36,
        "variation of d",
        r"\delta d = \frac{1}{d}\mathbf{d}\cdot\delta\mathbf{d} = \frac{1}{d}\mathbf{d}\cdot\left(\mathbf{t}\delta\xi
- \bar{\mathbf{t}}\delta\bar\xi + \delta_u\mathbf{u}_C - \delta_u\bar{\mathbf{u}}_{\bar C}\right)",
    )
    .part(Order::First, "")
    .printed([d.delta; 2], [
        vector.value.dot(&vector.delta) / d.value,
        vector.value.dot(&(slid_delta + delta_u)) / d.value,
    ]);

    // (37): δd = d·δᵤû/d
    table.state(
        37,
        "variation of d, orthogonality used",
        r"\delta d = \frac{1}{d}\mathbf{d}\cdot\left(\delta_u\mathbf{u}_C - \delta_u\bar{\mathbf{u}}_{\bar C}\right)
= \frac{1}{d}\mathbf{d}\cdot\delta_u\hat{\mathbf{u}}_C",
    )
    .part(Order::First, "")
    .printed([d.delta], [vector.value.dot(&delta_u) / d.value]);

    // (38): Δδd = [Δd·δᵤû + d·(δᵤu,ξ Δξ + Δᵤδᵤu − δᵤū,ξ̄ Δξ̄ − Δᵤδᵤū)]/d − [Δd d·δᵤû]/d²
    table.state(
        38,
        "linearization of (37)",
        r"\begin{aligned}\Delta\delta d = {} & \frac{1}{d}\left[\Delta\mathbf{d}\cdot(\delta_u\mathbf{u}_C
- \delta_u\bar{\mathbf{u}}_{\bar C}) + \mathbf{d}\cdot(\delta_u\mathbf{u}_{C,\xi}\Delta\xi + \Delta_u\delta_u\mathbf{u}_C
- \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\Delta\bar\xi - \Delta_u\delta_u\bar{\mathbf{u}}_{\bar C})\right] \\
& - \frac{1}{d^2}\left[\Delta d\,\mathbf{d}\cdot(\delta_u\mathbf{u}_C - \delta_u\bar{\mathbf{u}}_{\bar C})\right]\end{aligned}",
    )
    .part(Order::Second, "")
    .printed([d.second], [
        (vector.linear.dot(&delta_u) + turned(p)) / d.value + dropped(p)
            - d.linear * vector.value.dot(&delta_u) / (d.value * d.value),
    ]);

    // (39): Δδd = [δᵤû·(t Δξ − t̄ Δξ̄ + Δᵤu − Δᵤū) + d·(..)]/d − [δᵤû·d d·Δû]/d³
    let partial = Hat::new(p).partial;
    let formula = |hat: &Vector3<T>| {
        (delta_u.dot(&(slid(p) + partial)) + turned(p)) / d.value
            - delta_u.dot(&vector.value) * vector.value.dot(hat) / (d.value * d.value * d.value)
    };
    let equation = table.state(
        39,
        "second variation of d",
        r"\Delta\delta d = \frac{1}{d}\left[\delta_u\hat{\mathbf{u}}_C\cdot\left(\mathbf{t}\Delta\xi
- \bar{\mathbf{t}}\Delta\bar\xi + \Delta_u\mathbf{u}_C - \Delta_u\bar{\mathbf{u}}_{\bar C}\right)
+ \mathbf{d}\cdot\left(\delta_u\mathbf{u}_{C,\xi}\Delta\xi - \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\Delta\bar\xi\right)\right]
- \frac{1}{d^3}\left[\delta_u\hat{\mathbf{u}}_C\cdot\mathbf{d}\;\mathbf{d}\cdot\Delta\hat{\mathbf{u}}_C\right]",
    );
    equation
        .corrected_to(
            r"\Delta\delta d = \ldots - \frac{1}{d^3}\left[\delta_u\hat{\mathbf{u}}_C\cdot\mathbf{d}\;
\mathbf{d}\cdot\Delta_u\hat{\mathbf{u}}_C\right] + \frac{1}{d}\mathbf{d}\cdot\Delta_u\delta_u\hat{\mathbf{u}}_C",
        )
        .remark("The paper does not define Δû_C. Read as a total variation, it is that of u_C − ū_C̄ with u = x − X and a random X. Read as Δd, the last term is equal here, since d is normal to t and t̄; in (40) it is not.")
        .part(Order::Second, "");
    readings(equation, p, formula);

    // (40)
    let equation = table.state(
        40,
        "second variation of d, rearranged",
        r"\Delta\delta d = \frac{1}{d}\left[\delta_u\hat{\mathbf{u}}_C\cdot\left(\mathbf{t}\Delta\xi
- \bar{\mathbf{t}}\Delta\bar\xi\right) + \mathbf{d}\cdot\left(\delta_u\mathbf{u}_{C,\xi}\Delta\xi
- \delta_u\bar{\mathbf{u}}_{\bar C,\bar\xi}\Delta\bar\xi\right)\right]
+ \frac{1}{d}\left[\delta_u\hat{\mathbf{u}}_C\cdot\Delta\hat{\mathbf{u}}_C\right]
- \frac{1}{d^3}\left[\delta_u\hat{\mathbf{u}}_C\cdot\mathbf{d}\;\mathbf{d}\cdot\Delta\hat{\mathbf{u}}_C\right]",
    );
    equation
        .corrected_to(
            r"\Delta\delta d = \ldots + \frac{1}{d}\left[\delta_u\hat{\mathbf{u}}_C\cdot\Delta_u\hat{\mathbf{u}}_C\right]
- \frac{1}{d^3}\left[\delta_u\hat{\mathbf{u}}_C\cdot\mathbf{d}\;\mathbf{d}\cdot\Delta_u\hat{\mathbf{u}}_C\right]
+ \frac{1}{d}\mathbf{d}\cdot\Delta_u\delta_u\hat{\mathbf{u}}_C",
        )
        .part(Order::Second, "");
    readings(equation, p, |hat| second_distance(p, hat));
}

/// t·(t,ξξ δξΔξ + t,ξ Δδξ + Δᵤu,ξξ δξ + δᵤu,ξξ Δξ), the bracket of (42) and (58).
pub(super) fn bracket<T: Real>(s: &Side<T>) -> T {
    let x = s.jet.geometry;
    let sum = x.t_xixi * squared(s) + x.t_xi * s.xi.second + super::mixed(s, 2);
    s.t.value.dot(&sum)
}

/// t,ξ δξ + δᵤu,ξ and t,ξ Δξ + Δᵤu,ξ.
pub(super) fn tangents_varied<T: Real>(s: &Side<T>) -> [Vector3<T>; 2] {
    let t_xi = s.jet.geometry.t_xi;
    [t_xi * s.xi.delta + s.jet.delta_u[1], t_xi * s.xi.linear + s.jet.linear_u[1]]
}

/// (41) and (42): the norm of t.
fn tangent<T: Real>(p: &Point<T>, table: &mut Table<T>) {
    let s = &p.beam;
    let (t, vector) = (s.length.value, s.t.value);
    let [delta, linear] = tangents_varied(s);

    // (41): δt = t·δt/t = t·(t,ξ δξ + δᵤu,ξ)/t
    table
        .state(
            41,
            "variation of t",
            r"\delta t = \frac{1}{t}\mathbf{t}\cdot\delta\mathbf{t}
= \frac{1}{t}\mathbf{t}\cdot(\mathbf{t}_{,\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi})",
        )
        .part(Order::First, "")
        .printed([s.length.delta; 2], [vector.dot(&s.t.delta) / t, vector.dot(&delta) / t]);

    // (42): no + before Δt·δt, and Δt·t·δt in place of (Δt·t)(t·δt)
    let left = [s.length.second];
    let (bracket, product) = (bracket(s), linear.dot(&delta));
    let cube = t * t * t;
    let last = linear.dot(&vector) * vector.dot(&delta) / cube;
    let last_by_length = t * product / cube;
    let corrected = (bracket + product) / t - last;
    table.state(
        42,
        "second variation of t",
        r"\begin{aligned}\Delta\delta t = {} & \frac{1}{t}\left[\mathbf{t}\cdot(\mathbf{t}_{,\xi\xi}\delta\xi\Delta\xi
+ \mathbf{t}_{,\xi}\Delta\delta\xi + \Delta_u\mathbf{u}_{C,\xi\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi\xi}\Delta\xi)\right]
\left(\mathbf{t}_{,\xi}\Delta\xi + \Delta_u\mathbf{u}_{C,\xi}\right)\cdot
\left(\mathbf{t}_{,\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi}\right) \\
& - \frac{1}{t^3}\left(\mathbf{t}_{,\xi}\Delta\xi + \Delta_u\mathbf{u}_{C,\xi}\right)\cdot\mathbf{t}\cdot
\left(\mathbf{t}_{,\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi}\right)\end{aligned}",
    )
    .corrected_to(
        r"\Delta\delta t = \frac{1}{t}\left[\mathbf{t}\cdot(\mathbf{t}_{,\xi\xi}\delta\xi\Delta\xi
+ \mathbf{t}_{,\xi}\Delta\delta\xi + \Delta_u\mathbf{u}_{C,\xi\xi}\delta\xi + \delta_u\mathbf{u}_{C,\xi\xi}\Delta\xi
+ \Delta_u\delta_u\mathbf{u}_{C,\xi}) + \Delta\mathbf{t}\cdot\delta\mathbf{t}\right]
- \frac{1}{t^3}(\Delta\mathbf{t}\cdot\mathbf{t})(\mathbf{t}\cdot\delta\mathbf{t})",
    )
    .remark(
        "Two misprints: a sign is missing between the bracket and Δt·δt, and the last term, a product of three vectors with \
         two dots, is not defined: it lacks a t. Each has two readings. Each is also kept while the other is corrected.",
    )
    .part(Order::Second, "")
    .read("[..] times Δt·δt; Δt·t t·δt", left, [bracket / t * product - last])
    .read("[..] times Δt·δt; t (Δt·δt)", left, [bracket / t * product - last_by_length])
    .read("+ outside [..]; Δt·t t·δt", left, [bracket / t + product - last])
    .read("+ outside [..]; t (Δt·δt)", left, [bracket / t + product - last_by_length])
    .read("+ inside [..]; t (Δt·δt)", left, [(bracket + product) / t - last_by_length])
    .corrected("+ inside [..]; Δt·t t·δt", left, [corrected])
    .complete("and with t·Δᵤδᵤu_C,ξ/t", left, [corrected + vector.dot(&s.jet.second_u[1]) / t]);
}
