//! The functions of a pair of given curves.

use super::linearized::{every_scalar, nowhere};
use super::returned::Returned;
use super::routes::each;
use crate::closest_point::ClosestPoint;
use crate::curve::Curve;
use crate::linearization::{ad, closed_form};
use crate::pair::{DofVector, Pair};
use crate::test_beam::AnyBeam;
use nalgebra::SVector;

/// What the functions return for two beams on the curves of this pair.
pub(crate) fn of_curves<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    beams: [&dyn AnyBeam; 2],
    point: &ClosestPoint,
) -> Vec<Returned> {
    let [numbers, numbers_bar] = beams.map(AnyBeam::numbers);
    let [q, dq, linear_dq] = [0, 1, 2].map(|i| DofVector::<f64, N, M> {
        beam: SVector::from_column_slice(numbers[i]),
        bar: SVector::from_column_slice(numbers_bar[i]),
    });
    let directions = [1, 2].map(|i| [numbers[i], numbers_bar[i]].concat());
    let mut into = nowhere();
    pair.linearize_into(&q, point, &mut into);
    let differentiated = ad::vary(ad::Route::Newton, pair, &q, point, &dq, &linear_dq);
    vec![
        Returned::new("linearize, of your curve", every_scalar(&pair.linearize(&q, point), &directions)),
        Returned::new("linearize_into, of your curve", every_scalar(&into, &directions)),
        Returned::new(
            "closed_form::vary, of your curve",
            each(&closed_form::vary(pair, &q, point, &dq, &linear_dq)),
        ),
        Returned::new("ad::vary, of your curve", each(&differentiated)),
    ]
}
