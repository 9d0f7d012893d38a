//! The functions that any curve has: the variations, the matrices, and the routes of automatic differentiation.

use super::expansion::Expansion;
use super::linearized::{D, every_scalar, read, unwritten, without_slips};
use super::returned::{Answers, Returned};
use crate::closest_point::ClosestPoint;
use crate::linearization::ad::{
    Route, chord, expand_by_orders, expand_by_rows, expand_by_sweep, expand_by_vector_dual,
    expand_d_by_orders, vary,
};
use crate::linearization::closed_form::kernel::{DistanceAlone, Full, PairAtPoint, write_d_batch};
use crate::linearization::closed_form::{self, Matrices, PartialVariations, VectorQuantity};
use crate::linearization::{COMPONENTS, Derivatives, Quantities, Quantity, Varied};
use crate::number::{HyperDualRow, Lanes};
use crate::pair::{Contact, DofVector, Pair};
use crate::variant::read::along;
use nalgebra::Vector3;
use num_dual::{Dual2SVec64, HyperDual64};

/// The directions a and b of both beams.
const DIRECTIONS: [[f64; 4]; 2] = [[1.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 1.0]];
/// The dofs of a row that are differentiated at once: three of four, so that there is a remainder.
const AT_ONCE: usize = 3;
/// The components of the scalars: those with matrices, and g_N.
const PICKED: std::ops::Range<usize> = Quantity::D.component()..COMPONENTS;

fn picked<S>(all: Quantities<S>) -> [S; 8] {
    let Quantities { d, t, t_bar, xi, xi_bar, g_n, g_t, g_t_bar, .. } = all;
    [d, t, t_bar, xi, xi_bar, g_n, g_t, g_t_bar]
}

pub(super) fn each(quantities: &Quantities<Varied<f64>>) -> Answers {
    let parts = (*quantities).components().map(|varied| varied.parts().map(Some));
    parts.into_iter().enumerate().collect()
}

/// Of curves without shape functions: the scalars in each way, and the vectors.
fn by_matrices(
    pair: &Pair<Expansion, Expansion, 2, 2>,
    q: &DofVector<f64, 2, 2>,
    point: &ClosestPoint,
) -> Vec<Returned> {
    let directions = DIRECTIONS.map(|direction| direction.to_vec());
    let linearized = pair.linearize(q, point);
    let mut one = unwritten();
    pair.write(q, point, DistanceAlone { d: &mut one });
    let mut first = [unwritten(); 5];
    pair.write(q, point, without_slips(&mut first));
    let mut lanes = [Full::<Lanes, 4>::zeros()];
    write_d_batch(&[PairAtPoint { pair, q, point }], &mut lanes);
    let in_lanes = directions.each_ref().map(|of| of.iter().map(|&x| Lanes([x; 4])).collect());
    let of_lane = along(&lanes[0], &in_lanes).map(|number| number.map(|Lanes([first, ..])| first));

    let (jet, jet_bar) = closed_form::jets(pair, q, (point.xi, point.xi_bar));
    let matrices = Matrices::new(&jet, &jet_bar, point.held());
    let parameters = [&linearized.xi, &linearized.xi_bar];
    let component = |(i, quantity): (usize, VectorQuantity)| {
        let w = Vector3::ith(i % 3, 1.0);
        (i, along(&matrices.vector(quantity, &w, parameters), &directions))
    };
    let vectors =
        [VectorQuantity::X, VectorQuantity::XBar, VectorQuantity::D, VectorQuantity::T, VectorQuantity::TBar];
    let components = vectors.into_iter().flat_map(|quantity| [quantity; 3]).enumerate();
    vec![
        Returned::new("linearize, by matrices", every_scalar(&linearized, &directions)),
        Returned::new("write DistanceAlone, by matrices", vec![(D, along(&one, &directions))]),
        Returned::new("write WithoutSlips, by matrices", read(&first, &directions)),
        Returned::new("write_d_batch, by matrices", vec![(D, of_lane)]),
        Returned::new("Matrices::vector", components.map(component).collect()),
    ]
}

fn expanded(derivatives: &[Derivatives<f64, 2, 2>]) -> Answers {
    let directions = DIRECTIONS.map(|direction| direction.to_vec());
    let of = |(i, derivatives): (usize, &Derivatives<f64, 2, 2>)| (i, along(derivatives, &directions));
    PICKED.zip(derivatives).map(of).collect()
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
    let mut closed =
        vec![Returned::new("closed_form::vary", each(&closed_form::vary(&pair, &q, point, &dq, &linear_dq)))];
    closed.extend(by_matrices(&pair, &q, point));
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
