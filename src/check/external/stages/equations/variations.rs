//! The vectors of the equations: variations of points and tangents.

use super::equation::XI;
use crate::check::external::stages::terms::{
    Beam, Number, Part, Side, Sum, Terms, Vector, all_tagged, dot, minus, tagged, times, vector,
};
use crate::linearization::Quantity;

pub(super) fn of(quantity: Quantity, part: Part) -> Number {
    Number::Of(quantity, part)
}

pub(super) fn d() -> Sum {
    vector(Vector::D)
}

pub(super) fn t(beam: Beam) -> Sum {
    vector(Vector::T(beam, 0))
}

/// delta x or Delta x of a beam, eq. (25).
pub(super) fn delta_x(side: Side, beam: Beam) -> Sum {
    let along = times(&[of(XI[beam], 1 + side)], Vector::T(beam, 0));
    let fixed = vector(Vector::U(side, beam, 0));
    let along = tagged(["t dxi of dx", "t_bar dxi_bar of dx_bar"][beam], along);
    let fixed = tagged(["du of dx", "du_bar of dx_bar"][beam], fixed);
    let one_sided = [["dx", "dx_bar"], ["Dx", "Dx_bar"]][side][beam];
    all_tagged(&[["x_C", "x_bar_C"][beam], one_sided], [along, fixed].concat())
}

/// delta d or Delta d, eq. (32).
pub(super) fn delta_d(side: Side) -> Sum {
    let of = |beam: Beam| tagged(["dx of dd", "dx_bar of dd"][beam], delta_x(side, beam));
    all_tagged(&[["dd", "Dd"][side], "dd and Dd"], [of(0), minus(of(1))].concat())
}

/// delta t or Delta t, eq. (32).
pub(super) fn delta_t(side: Side, beam: Beam) -> Sum {
    let along = times(&[of(XI[beam], 1 + side)], Vector::T(beam, 1));
    let fixed = vector(Vector::U(side, beam, 1));
    let along = tagged(["t,xi dxi of dt", "t_bar,xi dxi_bar of dt_bar"][beam], along);
    let fixed = tagged(["du,xi of dt", "du_bar,xi of dt_bar"][beam], fixed);
    let one_sided = [["dt", "dt_bar"], ["Dt", "Dt_bar"]][side][beam];
    all_tagged(&[one_sided, ["dt and Dt", "dt_bar and Dt_bar"][beam]], [along, fixed].concat())
}

/// The k-th derivative of x by xi varied twice, eq. (27) and (30), without the second variation of xi.
pub(super) fn second(beam: Beam, k: usize) -> Sum {
    let xi = XI[beam];
    let of_x = [
        ["t,xi dxi Dxi of Ddx", "t_bar,xi dxi_bar Dxi_bar of Ddx_bar"],
        ["t,xixi dxi Dxi of Ddt", "t_bar,xixi dxi_bar Dxi_bar of Ddt_bar"],
    ][k][beam];
    let mixed = [
        ["dxi Du,xi and Dxi du,xi of Ddx", "dxi_bar Du_bar,xi and Dxi_bar du_bar,xi of Ddx_bar"],
        ["dxi Du,xixi and Dxi du,xixi of Ddt", "dxi_bar Du_bar,xixi and Dxi_bar du_bar,xixi of Ddt_bar"],
    ][k][beam];
    let one = [
        ["dxi Du,xi of Ddx", "dxi_bar Du_bar,xi of Ddx_bar"],
        ["dxi Du,xixi of Ddt", "dxi_bar Du_bar,xixi of Ddt_bar"],
    ][k][beam];
    let other = [
        ["Dxi du,xi of Ddx", "Dxi_bar du_bar,xi of Ddx_bar"],
        ["Dxi du,xixi of Ddt", "Dxi_bar du_bar,xixi of Ddt_bar"],
    ][k][beam];
    let rest = [["Ddu of Ddx", "Ddu_bar of Ddx_bar"], ["Ddu,xi of Ddt", "Ddu_bar,xi of Ddt_bar"]][k][beam];
    let of_delta = ["dxi Du of the beam", "dxi_bar Du_bar of the bar beam"][beam];
    let of_linear = ["Dxi du of the beam", "Dxi_bar du_bar of the bar beam"][beam];
    let sum = [
        tagged(of_x, times(&[of(xi, 1), of(xi, 2)], Vector::T(beam, k + 1))),
        all_tagged(&[one, of_delta, "dxi Du of all", mixed], times(&[of(xi, 1)], Vector::U(1, beam, k + 1))),
        all_tagged(
            &[other, of_linear, "Dxi du of all", mixed],
            times(&[of(xi, 2)], Vector::U(0, beam, k + 1)),
        ),
        tagged(rest, vector(Vector::Mixed(beam, k))),
    ]
    .concat();
    let all = tagged([["Ddx", "Ddx_bar"], ["Ddt", "Ddt_bar"]][k][beam], sum);
    if k == 0 { tagged(["x_C", "x_bar_C"][beam], all) } else { all }
}

pub(super) fn second_d() -> Sum {
    tagged("Ddd", [second(0, 0), minus(second(1, 0))].concat())
}

pub(super) fn u_hat(side: Side) -> Sum {
    [vector(Vector::U(side, 0, 0)), minus(vector(Vector::U(side, 1, 0)))].concat()
}

pub(super) fn mixed() -> Terms {
    dot(&d(), &[vector(Vector::Mixed(0, 0)), minus(vector(Vector::Mixed(1, 0)))].concat())
}
