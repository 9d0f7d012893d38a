//! The parts that answers contain.

use super::answers::Answers;
use super::only::{FORCES, PartKey, RESIDUAL, TANGENT, of_quantity};
use crate::check::verdict::Order;
use crate::linearization::Quantity;
use std::collections::BTreeSet;

/// The parts that answers contain. A vector is answered if all its components are.
pub(super) fn answered(answers: &Answers) -> BTreeSet<PartKey> {
    let of = |(order, quantity, _): &PartKey| {
        let has = |answer: &&crate::check::Answer| {
            let [delta, linear, second] = answer.variations;
            answer.quantity == *quantity
                && match order {
                    Order::Value => answer.value.is_some(),
                    Order::First => answer.gradient.is_some() || delta.is_some() || linear.is_some(),
                    _ => answer.hessian.is_some() || second.is_some(),
                }
        };
        let is_vector = super::answers::is_vector(*quantity);
        answers.answers.iter().filter(has).count() >= if is_vector { 3 } else { 1 }
    };
    let element = [(RESIDUAL, answers.residual.is_some()), (TANGENT, answers.tangent.is_some())];
    let forces = FORCES.into_iter().zip(answers.state_and_forces.map(|of| of.is_some()));
    let of_element =
        element.into_iter().chain(forces).filter_map(|(part, is_there)| is_there.then_some(part));
    Quantity::ALL.into_iter().flat_map(of_quantity).filter(of).chain(of_element).collect()
}
