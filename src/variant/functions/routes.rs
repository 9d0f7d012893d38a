//! The functions that any curve has: the variations, the matrices, and the routes of automatic differentiation.

use super::expansion::Expansion;
use super::linearized::every_scalar;
use super::{Answers, Returned};
use crate::closest_point::ClosestPoint;
use crate::linearization::ad::{
    Route, chord, expand_by_orders, expand_by_rows, expand_by_sweep, expand_by_vector_dual,
    expand_d_by_orders, vary,
};
use crate::linearization::closed_form::{self, PartialVariations};
use crate::linearization::{Derivatives, Quantities, Varied};
use crate::number::HyperDualRow;
use crate::pair::{Contact, DofVector, Pair};
use crate::variant::read::along;
use num_dual::{Dual2SVec64, HyperDual64};

/// The directions a and b of both beams.
const DIRECTIONS: [[f64; 4]; 2] = [[1.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 1.0]];
/// The dofs of a row that are differentiated at once: three of four, so that there is a remainder.
const AT_ONCE: usize = 3;
/// The scalars with matrices, and g_N.
const PICKED: [usize; 8] = [15, 16, 17, 18, 19, 20, 21, 22];

fn picked<S>(all: Quantities<S>) -> [S; 8] {
    let Quantities { d, t, t_bar, xi, xi_bar, g_n, g_t, g_t_bar, .. } = all;
    [d, t, t_bar, xi, xi_bar, g_n, g_t, g_t_bar]
}

pub(super) fn each(quantities: &Quantities<Varied<f64>>) -> Answers {
    let parts = (*quantities).components().map(|varied| varied.parts().map(Some));
    parts.into_iter().enumerate().collect()
}

fn expanded(derivatives: &[Derivatives<f64, 2, 2>]) -> Answers {
    let directions = DIRECTIONS.map(|direction| direction.to_vec());
    let of = |(i, derivatives): (usize, &Derivatives<f64, 2, 2>)| (i, along(derivatives, &directions));
    PICKED.into_iter().zip(derivatives).map(of).collect()
}

/// Of the closed form, and of automatic differentiation.
pub(crate) fn routes(
    [beam, bar]: [PartialVariations<f64>; 2],
    point: &ClosestPoint,
    contact: Contact,
) -> [Vec<Returned>; 2] {
    let (curve, curve_bar) = (Expansion { at: point.xi, of: beam }, Expansion { at: point.xi_bar, of: bar });
    let pair = Pair { curve, curve_bar, contact };
    let q = DofVector::zeros();
    let [dq, linear_dq] = DIRECTIONS.map(|[a, b, a_bar, b_bar]| DofVector::<f64, 2, 2> {
        beam: [a, b].into(),
        bar: [a_bar, b_bar].into(),
    });
    let closed = vec![
        Returned::new("closed_form::vary", each(&closed_form::vary(&pair, &q, point, &dq, &linear_dq))),
        Returned::new(
            "linearize, by matrices",
            every_scalar(&pair.linearize(&q, point), &DIRECTIONS.map(|direction| direction.to_vec())),
        ),
    ];
    let chord = chord(&pair, &q, point);
    let by = |route| each(&vary(route, &pair, &q, point, &dq, &linear_dq));
    let by_sweep = expand_by_sweep(Route::Stationary, &pair, &q, point, picked::<HyperDual64>);
    let at_once =
        expand_by_vector_dual::<_, _, 2, 2, 4, 8>(chord, 2, &pair, &q, point, picked::<Dual2SVec64<4>>);
    let by_rows = expand_by_rows(chord, 2, &pair, &q, point, picked::<HyperDualRow<AT_ONCE>>);
    let by_orders = expand_by_orders(&pair, &q, point, picked::<HyperDualRow<AT_ONCE>>);
    let d_by_orders = expand_d_by_orders::<_, _, 2, 2, AT_ONCE>(&pair, &q, point);
    let differentiated = vec![
        Returned::new("ad::vary, Newton", by(Route::Newton)),
        Returned::new("ad::vary, stationary", by(Route::Stationary)),
        Returned::new("ad::vary, chord", by(Route::Chord(chord, 2))),
        Returned::new("expand_by_sweep", expanded(&by_sweep)),
        Returned::new("expand_by_vector_dual", expanded(&at_once)),
        Returned::new("expand_by_rows", expanded(&by_rows)),
        Returned::new("expand_by_orders", expanded(&by_orders)),
        Returned::new("expand_d_by_orders", expanded(&[d_by_orders])),
    ];
    [closed, differentiated]
}
