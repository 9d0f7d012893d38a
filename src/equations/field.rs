//! Draws over the prime field.

use super::paper;
use super::point::{Point, quantities, vector};
use super::table::Table;
use super::tally::Tally;
use crate::closest_point::Held;
use crate::curve::Geometry;
use crate::linearization::ad::Chord;
use crate::number::{HyperDual, PrimeField};
use crate::pair::Contact;
use crate::test_beam::{AnyBeam, ExactBeam, Family, stationary};
use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const CONTACT: Contact = Contact { radius: 0.125, radius_bar: 0.25, xi_0: 0.5, xi_bar_0: -0.75 };

/// Evaluates all equations at a stationary pair of these families.
pub(super) fn draw(seed: u64, families: [Family; 2], draw: u64) -> Tally {
    let mut rng = stream(seed, families, draw);
    let models = families.map(|family| family.model(&mut rng));
    let nonlinear = !families.into_iter().all(Family::is_linear);
    let point = stationary_point(&models, &mut rng);
    // Random operands, which belong to no pair of beams.
    let mut numbers = ChaCha8Rng::from_rng(&mut rng);
    let random =
        point.map(&mut |_| residue(&mut numbers), &mut |_| Vector3::from_fn(|_, _| residue(&mut rng)));
    let books =
        |point: &Point<PrimeField>| [paper::read(point), paper::read(&point.exchanged())].map(Box::new);
    let ([point, exchanged], [random, random_exchanged]) = (&books(&point), &books(&random));
    Tally::of_draw(nonlinear, [point, exchanged], [random, random_exchanged])
}

/// The texts of all equations. They are the same at every point.
pub(super) fn words() -> Table<PrimeField> {
    let mut rng = stream(0, [Family::Segment; 2], 0);
    let models = [Family::Segment; 2].map(|family| family.model(&mut rng));
    paper::read(&stationary_point(&models, &mut rng))
}

fn stream(seed: u64, families: [Family; 2], draw: u64) -> ChaCha8Rng {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream((draw * 256 + families[0] as u64) * 256 + families[1] as u64);
    rng
}

fn residue(rng: &mut ChaCha8Rng) -> PrimeField {
    PrimeField::new(rng.random())
}

/// A pair that is stationary by construction. Its finite increments lead to another pair of the same families.
fn stationary_point(models: &[Box<dyn AnyBeam>; 2], rng: &mut ChaCha8Rng) -> Point<PrimeField> {
    let (beams, at) = stationary(models, Held::default(), rng);
    let (others, other_at) = stationary(models, Held::default(), rng);
    let after = quantities(both(&others), lifted(both(&others), other_at), &CONTACT);
    let mut reference = || {
        let mut vector = || Vector3::from_fn(|_, _| residue(rng));
        Geometry { x: vector(), t: vector(), t_xi: vector(), t_xixi: vector() }
    };
    let references = [reference(), reference()];
    let beams = both(&beams);
    let jets = [beams[0].partial_variations(at.0), beams[1].partial_variations(at.1)];
    let after = [vector(after.d_vector), vector(after.t_vector)];
    Point::new(beams, jets, lifted(beams, at), references, &CONTACT, after)
}

fn both(beams: &[Box<dyn ExactBeam<PrimeField>>; 2]) -> [&dyn ExactBeam<PrimeField>; 2] {
    [&*beams[0], &*beams[1]]
}

/// Two chord steps. They are exact, because the neglected terms are nilpotent.
fn lifted(
    [beam, bar]: [&dyn ExactBeam<PrimeField>; 2],
    at: (PrimeField, PrimeField),
) -> (HyperDual<PrimeField>, HyperDual<PrimeField>) {
    Chord::<PrimeField>::new(beam, bar, at, Held::default()).lift(beam, bar, at, 2)
}
