//! Which element owns a contact, and which history belongs to it.

use super::super::{Chain, Chains, Link, Owned, Owners, Place};
use super::{Beam, NODES, REVERSED, line, minima_of_elements};
use crate::closest_point::{ClosestPoint, End, Held, Side};
use crate::contact::{History, Slips};
use crate::curve::{Hermite, Segment};
use crate::pair::{DofVector, Pair};
use nalgebra::{SVector, Vector3};

#[test]
fn a_neighbour_of_equal_length_shifts_by_two() {
    let link = |is_reversed| Link { tangents: [0.5; 3], is_reversed };
    let chain = Chain::new([false, false, false, true].map(link).to_vec()).unwrap();
    let carried = |element, to| chain.carry(Place { element, xi: 0.25 }, to).unwrap();
    assert_eq!(carried(0, 1), (-1.75, 1.0));
    assert_eq!(carried(1, 0), (2.25, 1.0));
    assert_eq!(carried(0, 2), (-3.75, 1.0));
    // The reversed element has its upper end at the boundary.
    assert_eq!(carried(2, 3), (1.75, -1.0));
    assert_eq!(carried(3, 2), (1.75, -1.0));
    assert_eq!(carried(3, 3), (0.25, 1.0));
    assert!(chain.carry(Place { element: 4, xi: 0.0 }, 0).is_err());
    assert!(Chain::new(vec![Link { tangents: [0.5, 0.0, 0.5], is_reversed: false }]).is_err());
}

#[test]
fn an_element_owns_its_first_end_and_the_chain_holds_at_its_ends() {
    let link = |is_reversed| Link { tangents: [1.0; 3], is_reversed };
    let chain = Chain::new([true, false, true].map(link).to_vec()).unwrap();
    let at = |element, xi: f64, strict: Option<bool>| {
        let side = if xi < 0.0 { Side::Lower } else { Side::Upper };
        let end = strict.map(|strict| End { side, strict, multiplier: 0.0 });
        chain.owns(Place { element, xi }, end.as_ref()).unwrap()
    };
    for strict in [None, Some(false), Some(true)] {
        let is_free = strict != Some(true);
        // Of each element the first end, then the last one.
        let owned = [(0, 1.0), (0, -1.0), (1, -1.0), (1, 1.0), (2, 1.0), (2, -1.0)];
        let owned = owned.map(|(element, xi)| at(element, xi, strict));
        assert_eq!(owned, [true, false, is_free, false, is_free, true]);
    }
    assert!(at(1, 0.5, None));
}

#[test]
fn a_history_goes_to_the_nearest_minimum_and_a_new_one_begins() {
    let beam = Beam::new(line, &NODES, &REVERSED, 1.0);
    let rigid = Chain::new(vec![Link { tangents: [1.0; 3], is_reversed: false }]).unwrap();
    let chains = Chains { beam: &beam.chain, bar: &rigid };
    let pair = Pair::new(Hermite::new(), Segment::new());
    let point = |element: usize, s: f64| -> (Owners, ClosestPoint) {
        let bar = SVector::from([s, -1.0, -0.25, s, 1.0, -0.25]);
        let q = DofVector { beam: beam.dofs[element], bar };
        (Owners { beam: element, bar: 0 }, pair.closest_points(&q).unwrap().minima[0])
    };
    let before = |element: usize, s: f64, e: f64| {
        let (owners, point) = point(element, s);
        let slips = Slips { xi: point.xi, xi_bar: point.xi_bar, e, cosine: 0.5, ..Slips::default() };
        Owned { owners, at: (point.xi, point.xi_bar), history: History { normal: None, slips: Some(slips) } }
    };
    let now = [point(0, 0.95), point(1, 1.15), point(3, 3.5)];
    let owned = chains.hand_on(&[before(0, 0.9, 1.0), before(0, 0.975, 2.0)], &now, 0.5).unwrap();
    // The second contact is the nearer one to the first minimum. The first contact is left with the reversed element.
    let slips = owned.iter().map(|of| of.history.slips.map(|slips| (slips.e, slips.cosine)));
    assert_eq!(slips.collect::<Vec<_>>(), [Some((2.0, 0.5)), Some((-1.0, -0.5)), None]);
    // An open contact has a normal alone, and keeps it over a boundary.
    let (owners, point) = point(0, 0.975);
    let open = Owned {
        owners,
        at: (point.xi, point.xi_bar),
        history: History { normal: Some(Vector3::z()), slips: None },
    };
    let owned = chains.hand_on(&[open], &now, 0.5).unwrap();
    let normals = owned.iter().map(|of| of.history.normal);
    assert_eq!(normals.collect::<Vec<_>>(), [Some(Vector3::z()), None, None]);
}

/// A bar across two straight elements that meet at an angle, on both sides of the kink.
#[test]
fn a_kink_that_points_to_the_bar_is_one_contact_with_a_held_parameter() {
    let beam = |height: f64, reversed: [bool; 2]| {
        let nodes = [-1.0, 0.0, 1.0].map(|s: f64| Vector3::new(s, 0.0, height * s.abs()));
        let dofs = [0, 1].map(|k| {
            let ends = if reversed[k] { [nodes[k + 1], nodes[k]] } else { [nodes[k], nodes[k + 1]] };
            let half = (ends[1] - ends[0]) * 0.5;
            SVector::<f64, 12>::from_iterator([ends[0], half, ends[1], half].iter().flatten().copied())
        });
        let link = |k: usize| Link::new(&Hermite::new(), &dofs[k], reversed[k]);
        (dofs, Chain::new(vec![link(0), link(1)]).unwrap())
    };
    let rigid = Chain::new(vec![Link { tangents: [1.0; 3], is_reversed: false }]).unwrap();
    let bar = SVector::from([0.0, -1.0, -0.25, 0.0, 1.0, -0.25]);
    for reversed in [[false, false], [false, true], [true, false], [true, true]] {
        let of = |height| {
            let (dofs, chain) = beam(height, reversed);
            let chains = Chains { beam: &chain, bar: &rigid };
            chains.minima(&minima_of_elements(&dofs, bar)).unwrap()
        };
        // Pointing down: both elements hold xi at the kink.
        let found = of(0.5);
        assert_eq!(found.len(), 1, "{found:?}");
        let (owners, point) = found[0];
        assert_eq!((owners.beam, point.held()), (1, Held { xi: true, xi_bar: false }));
        assert_eq!((point.xi, point.distance), (if reversed[1] { 1.0 } else { -1.0 }, 0.25));
        // Pointing up: each element has a minimum beside the kink.
        let found = of(-0.2);
        assert_eq!(found.iter().map(|of| of.0.beam).collect::<Vec<_>>(), [0, 1], "{found:?}");
        assert!(found.iter().all(|(_, point)| point.is_interior() && point.distance < 0.25));
    }
}
