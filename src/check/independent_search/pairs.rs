//! Pairs of beams that are hard to search: with many minima, or with infinitely many nearest points.
//!
//! The regimes draw beams that cross once, and mildly curved. A search that misses minima, or that gives a wrong distance for
//! parallel beams, may pass all of them. So every 20th case of a regime brings one more pair, for the search alone.

use crate::check::CaseData;
use crate::check::draw::{Case, place_in_regime};
use crate::pair::Contact;
use crate::test_beam::{Family, TestBeam, Unit};
use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Every so many cases of a regime bring a pair.
const EVERY: u64 = 20;
/// The offset of the streams of random numbers, which no case has.
const STREAM: u64 = 1 << 50;

/// The pair that the case of this number brings, if it brings one.
pub(crate) fn pair_of(seed: u64, number: u64) -> Option<CaseData> {
    let place = place_in_regime(number);
    place.is_multiple_of(EVERY).then(|| pair(seed, number, place / EVERY))
}

fn pair(seed: u64, number: u64, place: u64) -> CaseData {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(STREAM + number);
    let test_beams = match place % 16 {
        1 => parallel(&mut rng),
        9 => concentric(&mut rng),
        i if i % 2 == 0 => [bent_twice(&mut rng), bent_twice(&mut rng)],
        // The families of the cases reach all pairs, because the step from one of these cases to the next is coprime to 121.
        _ => Case::draw(seed, number).test_beams.map(|beam| tangled(beam, &mut rng)),
    };
    CaseData { test_beams, contact: Contact::default() }
}

/// A beam of the same family that turns back on itself.
fn tangled(mut beam: TestBeam, rng: &mut ChaCha8Rng) -> TestBeam {
    let is_round = matches!(beam.family, Family::Arc | Family::Helix);
    for (dof, unit) in beam.q.iter_mut().zip(beam.family.units()) {
        *dof = match (unit, is_round) {
            (Unit::Point, false) => rng.random_range(-1.0..1.0),
            (Unit::Point, true) => rng.random_range(-0.5..0.5),
            (Unit::Length, false) => rng.random_range(-3.0..3.0),
            (Unit::Length, true) => rng.random_range(0.3..1.0),
            (Unit::Pure, _) => *dof,
        };
    }
    match beam.family {
        Family::Arc | Family::Helix => beam.parameters = vec![rng.random_range(1.0..4.0)],
        Family::HermiteScaled => {
            let numbers = beam.q.iter_mut().enumerate();
            for (_, dof) in numbers.filter(|(i, _)| i % 6 > 2) {
                *dof = rng.random_range(-3.0..3.0) / beam.parameters[0];
            }
        }
        _ => {}
    }
    beam
}

/// A cubic c0 + c1 xi + c3 xi³. In its middle the second derivative vanishes: the third derivative alone bends it, so that
/// a search with a wrong bound of it misses minima.
fn bent_twice(rng: &mut ChaCha8Rng) -> TestBeam {
    let mut vector = |size: f64| Vector3::from_fn(|_, _| size * rng.random_range(-1.0..1.0));
    let [c0, c1, c3] = [0.5, 0.5, 2.0].map(&mut vector);
    let at = |xi: f64| c0 + c1 * xi + c3 * (xi * xi * xi);
    let slope = c1 + c3 * 3.0;
    let (family, vectors) = if rng.random() {
        (Family::Cubic, [at(-1.0), at(-1.0 / 3.0), at(1.0 / 3.0), at(1.0)])
    } else {
        (Family::Hermite, [at(-1.0), slope, at(1.0), slope])
    };
    beam(family, Vec::new(), vectors.iter().flat_map(|vector| vector.iter().copied()).collect())
}

fn beam(family: Family, parameters: Vec<f64>, q: Vec<f64>) -> TestBeam {
    let none = vec![0.0; q.len()];
    TestBeam { family, parameters, q, dq: none.clone(), linear_dq: none }
}

/// Two parallel segments, side by side along a part of their lengths or one after the other, some of them on one line.
fn parallel(rng: &mut ChaCha8Rng) -> [TestBeam; 2] {
    let axis = rng.random_range(0..3);
    let gap = if rng.random_ratio(1, 4) { 0.0 } else { rng.random_range(0.001..0.5) };
    let reversed = rng.random();
    let segment = |start: f64, end: f64, gap: f64| {
        let mut q = vec![0.0; 6];
        (q[axis], q[axis + 3]) = if reversed && gap != 0.0 { (end, start) } else { (start, end) };
        (q[(axis + 1) % 3], q[(axis + 1) % 3 + 3]) = (gap, gap);
        beam(Family::Segment, Vec::new(), q)
    };
    let (length, start) = (rng.random_range(0.5..2.0), rng.random_range(-1.0..1.5));
    [segment(0.0, 1.0, 0.0), segment(start, start + length, gap)]
}

/// Two arcs about one axis in one plane. Their angles overlap.
fn concentric(rng: &mut ChaCha8Rng) -> [TestBeam; 2] {
    let centre = [0; 3].map(|_| rng.random_range(-1.0..1.0));
    let orientation = [0; 4].map(|_| rng.random_range(0.1..1.0));
    let mut arc = |radius: f64| {
        let (half_angle, phase) = (rng.random_range(0.3..1.2), rng.random_range(-0.5..0.5));
        let q = [&centre[..], &[radius], &orientation, &[phase]].concat();
        beam(Family::Arc, vec![half_angle], q)
    };
    [arc(1.0), arc(1.25)]
}

#[cfg(test)]
mod tests {
    use super::pair_of;
    use crate::check::{Regime, Selection};
    use crate::closest_point::{Search, closest_points};
    use crate::test_beam::Family;
    use std::collections::BTreeSet;

    #[test]
    fn the_pairs_have_many_minima_or_open_regions() {
        let numbers = Selection { regimes: vec![Regime::Generic], family: None, cases: 2000 }.numbers();
        let pairs: Vec<_> = numbers.into_iter().filter_map(|number| pair_of(3, number)).collect();
        assert_eq!(pairs.len(), 100);
        let mut families: BTreeSet<Family> = BTreeSet::new();
        let (mut minima, mut open) = (0, 0);
        for pair in &pairs {
            families.extend(pair.test_beams.each_ref().map(|beam| beam.family));
            let [beam, bar] = pair.beams().unwrap();
            if let Ok(found) = closest_points(&*beam, &*bar, &Search::default()) {
                minima += found.minima.len();
                open += usize::from(!found.is_complete());
            }
        }
        assert_eq!(families.len(), Family::ALL.len());
        assert!(minima >= 150 && open >= 8, "{minima} {open}");
    }
}
