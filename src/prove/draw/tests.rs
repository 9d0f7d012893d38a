//! Tests that the draws reach every branch that depends on a sign.

use super::{Draw, Place, has_matrices};
use crate::linearization::closed_form::formulation::System;
use crate::number::PrimeField;
use crate::prove::Layer;
use crate::test_beam::Family;
use crate::variant::Variant;
use std::collections::BTreeSet;

/// The draws of a pair of families that `beamgap prove` makes if no number is given.
const DRAWS: u64 = 1000;

/// A branch: the end at which each parameter is held, the sign of the normal, and whether the system is solved by cross
/// products. At an end the formulations do not differ.
type Branch = ([Option<i8>; 2], Option<i8>, bool);

fn branch(Place { at, form, .. }: &Place) -> Branch {
    let end = |is_held: bool, xi: PrimeField| {
        is_held.then(|| match xi.fraction(1) {
            Some((1, 1)) => 1,
            Some((-1, 1)) => -1,
            _ => panic!("{xi:?} is held, and is no end"),
        })
    };
    let sign = form.sign().map(|sign| if sign > 0.0 { 1 } else { -1 });
    let crosses = form.uses_cross_products() && form.system == System::CrossProducts;
    ([end(form.held.xi, at.0), end(form.held.xi_bar, at.1)], sign, crosses)
}

/// All of them.
fn branches() -> BTreeSet<Branch> {
    let ends = [None, Some(-1), Some(1)];
    let held = ends.iter().flat_map(|&end| ends.map(|other| ([end, other], None, false)));
    let inside = ends.iter().flat_map(|&sign| [false, true].map(|crosses| ([None; 2], sign, crosses)));
    held.chain(inside).collect()
}

#[test]
fn every_branch_is_drawn_with_and_without_matrices() {
    assert_eq!(branches().len(), 8 + 6);
    for families in [[Family::Segment, Family::Arc], [Family::Arc, Family::Segment], [Family::Hermite; 2]] {
        let (with, without): (Vec<u64>, Vec<u64>) = (0..DRAWS).partition(|&number| has_matrices(number));
        for numbers in [with, without] {
            let drawn: BTreeSet<_> =
                numbers.into_iter().map(|number| branch(&Place::new(0x5eed, families, number))).collect();
            assert_eq!(drawn, branches(), "{families:?}");
        }
    }
}

/// The golden files and the tests of the faults prove with few draws.
#[test]
fn eight_draws_have_all_combinations_of_held_parameters_and_all_formulations() {
    let places = (0..8).map(|number| Place::new(0x5eed, [Family::Hermite; 2], number));
    let kinds = places.map(|Place { form, .. }| {
        (form.held.xi, form.held.xi_bar, form.sign().is_some(), form.uses_cross_products())
    });
    assert_eq!(kinds.collect::<BTreeSet<_>>().len(), 3 + 4);
}

/// Each state of a contact element is drawn, with every formulation of the geometry.
#[test]
fn a_contact_element_is_drawn_in_every_state() {
    let draws = (0..DRAWS).filter(|&number| has_matrices(number));
    let drawn: BTreeSet<_> = draws
        .filter_map(|number| {
            let Draw { held, entries, .. } =
                Draw::new(&Variant::Unmodified, 0x5eed, [Family::Segment, Family::Arc], number);
            let element = entries.into_iter().find(|entry| entry.layer == Layer::Tangent)?;
            assert!(element.is_equal());
            Some((element.candidate, held.xi, held.xi_bar))
        })
        .collect();
    // Stick and slip need a parameter that is free.
    assert_eq!(drawn.len(), 3 * 3 + 1, "{drawn:?}");
}
