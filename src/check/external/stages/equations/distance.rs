//! The forms of the second variation of d, eq. (39) and (40).

use super::equation::XI;
use super::system::{a, b};
use super::variations::{d, delta_d, delta_t, mixed, of, second_d, t, u_hat};
use crate::check::external::stages::terms::{
    Beam, Number, Side, Terms, Vector, dot, minus, numbers, product, scaled, tag, tagged, times, vector,
};
use crate::linearization::Quantity::D;

pub(super) fn left() -> Terms {
    [numbers(1.0, &[of(D, 0), of(D, 3)]), tag("dd Dd", numbers(1.0, &[of(D, 1), of(D, 2)]))].concat()
}

/// d Ddd + dd Dd = dd.Dd + d.(Ddd), valid at any point.
pub(super) fn general() -> Terms {
    [
        left(),
        scaled(-1.0, &tag("dd.Dd", dot(&delta_d(0), &delta_d(1)))),
        scaled(-1.0, &tag("d.Ddd", dot(&d(), &second_d()))),
    ]
    .concat()
}

/// The form of eq. (40) that has (51) in it.
pub(super) fn symmetric() -> Terms {
    let pair = |i: Beam, j: Beam| numbers(1.0, &[of(XI[i], 1), of(XI[j], 2)]);
    [
        left(),
        scaled(-1.0, &tag("du_hat.Du_hat", dot(&u_hat(0), &u_hat(1)))),
        tag("a dxi Dxi and a_bar dxi_bar Dxi_bar", tag("a dxi Dxi", product(&a(0), &pair(0, 0)))),
        tag(
            "both b dxi Dxi_bar",
            [
                tag("b dxi Dxi_bar", scaled(-1.0, &product(&b(), &pair(0, 1)))),
                tag("b dxi_bar Dxi", scaled(-1.0, &product(&b(), &pair(1, 0)))),
            ]
            .concat(),
        ),
        tag(
            "a dxi Dxi and a_bar dxi_bar Dxi_bar",
            tag("a_bar dxi_bar Dxi_bar", scaled(-1.0, &product(&a(1), &pair(1, 1)))),
        ),
        scaled(-1.0, &mixed()),
    ]
    .concat()
}

/// The form of eq. (40) that is printed.
pub(super) fn printed() -> Terms {
    let along = |beam: Beam| {
        let one = ["du_hat.t Dxi", "du_hat.t_bar Dxi_bar"][beam];
        tagged(one, times(&[of(XI[beam], 2)], Vector::T(beam, 0)))
    };
    let turned = |beam: Beam| times(&[of(XI[beam], 2)], Vector::U(0, beam, 1));
    [
        left(),
        scaled(-1.0, &tag("du_hat.Du_hat", dot(&u_hat(0), &u_hat(1)))),
        scaled(
            -1.0,
            &tag("du_hat.(t Dxi - t_bar Dxi_bar)", dot(&u_hat(0), &[along(0), minus(along(1))].concat())),
        ),
        scaled(
            -1.0,
            &tag("d.(du,xi Dxi - du_bar,xi Dxi_bar)", dot(&d(), &[turned(0), minus(turned(1))].concat())),
        ),
        scaled(-1.0, &mixed()),
    ]
    .concat()
}

/// The form by the normal n = (t x t_bar)/|t x t_bar|, times the fourth power of this length.
pub(super) fn normal() -> Terms {
    let c = vector(Vector::Cross);
    let length = Number::Length(Vector::Cross);
    let turn = |side: Side, beam: Beam| {
        let tags = ["dt.n of the change of the normal", "dt_bar.n of the change of the normal"];
        let one = [["dt.n", "dt_bar.n"], ["Dt.n", "Dt_bar.n"]][side][beam];
        dot(&c, &tagged(tags[beam], tagged(one, delta_t(side, beam))))
    };
    let squares = |beam: Beam| dot(&t(beam), &t(beam));
    let change = [
        tag("t_bar^2 of the change of the normal", product(&squares(1), &product(&turn(0, 0), &turn(1, 0)))),
        tag("t^2 of the change of the normal", product(&squares(0), &product(&turn(0, 1), &turn(1, 1)))),
        tag(
            "both b of the change of the normal",
            scaled(
                -1.0,
                &product(
                    &b(),
                    &[product(&turn(0, 0), &turn(1, 1)), product(&turn(0, 1), &turn(1, 0))].concat(),
                ),
            ),
        ),
    ]
    .concat();
    [
        numbers(1.0, &[length, length, length, length, of(D, 3)]),
        scaled(-1.0, &tag("n.Ddd", product(&numbers(1.0, &[length, length, length]), &dot(&c, &second_d())))),
        scaled(-1.0, &tag("the change of the normal", product(&numbers(1.0, &[of(D, 0)]), &change))),
    ]
    .concat()
}
