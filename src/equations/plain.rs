//! Closest points of the check, in `f64`.

use super::arc::{Arc, Arcs};
use super::paper;
use super::point::{Point, quantities, vector};
use super::tally::Tally;
use crate::check::{Case, CaseData, Regime, Selection};
use crate::closest_point::{ClosestPoint, Held, Search, closest_points, refine};
use crate::curve::Geometry;
use crate::linearization::Varied;
use crate::linearization::ad::newton;
use crate::number::TermScale;
use crate::pair::Contact;
use crate::parallel;
use crate::test_beam::{AnyBeam, Family};
use nalgebra::Vector3;
use num_dual::HyperDual64;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Regimes with well-conditioned closest points inside both beams, in three units of length.
const REGIMES: [Regime; 4] = [Regime::Generic, Regime::StronglyCurved, Regime::Metres, Regime::Millimetres];
/// The smallest scaled eigenvalue of a well-conditioned projection.
const CONDITIONING: f64 = 0.1;
/// The displacement of one beam for a finite increment, over the distance.
const MOVED: f64 = 0.1;

/// Evaluates all equations at closest points of `cases` cases of each regime, and measures slips.
pub(super) fn cases(seed: u64, cases: u64) -> (Tally, Vec<Arc>) {
    let numbers = Selection { regimes: REGIMES.to_vec(), family: None, cases }.numbers();
    let results = parallel::filter_map(&numbers, |&number| case(seed, number));
    let mut arcs = Arcs::default();
    let mut tally = Tally::default();
    for (of_case, of_beams) in results {
        tally = tally.merge(of_case);
        for beam in of_beams {
            arcs.add(beam);
        }
    }
    (tally, arcs.found())
}

/// One case; none if it has no well-conditioned closest point inside, before and after the displacement.
fn case(seed: u64, number: u64) -> Option<(Tally, [super::arc::Measured; 2])> {
    let case = Case::draw(seed, number);
    let beams = case.beams();
    let found = closest_points(beams[0], beams[1], &Search::default()).ok()?;
    let good = |point: &&ClosestPoint| {
        point.is_interior() && point.degeneracy().is_none() && point.conditioning >= CONDITIONING
    };
    let point = found.minima.iter().find(good)?;
    let at = (point.xi, point.xi_bar);

    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(number);
    let mut random = |size: f64| Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0) * size);
    let mut reference = |beam: &dyn AnyBeam, xi: f64| {
        let size = beam.geometry(xi).t.norm();
        Geometry { x: random(size), t: random(size), t_xi: random(size), t_xixi: random(size) }
    };
    let references = [reference(beams[0], at.0), reference(beams[1], at.1)];

    let mut moved = case.test_beams[0].clone();
    moved.translate(&random(MOVED * point.distance));
    let after = after([&*moved.beam().ok()?, beams[1]], &case.contact, at)?;
    let point = Point::new(
        beams,
        [beams[0].partial_variations_plain(at.0), beams[1].partial_variations_plain(at.1)],
        lifted(beams, at),
        references,
        &case.contact,
        after,
    );
    let sized = point.map(&mut TermScale::from, &mut TermScale::vector);
    let nonlinear = !case.families.into_iter().all(Family::is_linear);
    let tally = Tally::of_point(nonlinear, &paper::read(&sized));
    let measured = [0, 1].map(|i| super::arc::measure(case.families[i], beams[i], [at.0, at.1][i]));
    Some((tally, measured))
}

/// A closest point of any case. The reference configuration may be any: it is made of sums of x, t and t,xi here.
pub(super) fn point(case: &CaseData, point: &ClosestPoint) -> Option<Point<f64>> {
    if !point.is_interior() || point.degeneracy().is_some() {
        return None;
    }
    let beams = case.beams().ok()?;
    let [beam, bar] = beams.each_ref().map(|beam| &**beam);
    let at = (point.xi, point.xi_bar);
    let mut moved = case.test_beams[0].clone();
    moved.translate(&(Vector3::new(1.0, 2.0, 2.0) * (MOVED * point.distance / 3.0)));
    let after = after([&*moved.beam().ok()?, bar], &case.contact, at)?;
    let reference = |beam: &dyn AnyBeam, xi: f64| {
        let Geometry { x, t, t_xi, t_xixi } = beam.geometry(xi);
        let [x, t, t_xi, t_xixi] = [x + t, t + t_xi, t_xi + t, t_xixi + t].map(|v| v * 0.5);
        Geometry { x, t, t_xi, t_xixi }
    };
    Some(Point::new(
        [beam, bar],
        [beam.partial_variations_plain(at.0), bar.partial_variations_plain(at.1)],
        lifted([beam, bar], at),
        [reference(beam, at.0), reference(bar, at.1)],
        &case.contact,
        after,
    ))
}

fn lifted([beam, bar]: [&dyn AnyBeam; 2], at: (f64, f64)) -> (HyperDual64, HyperDual64) {
    newton(beam, bar, at, Held::default())
}

/// d and t of the moved beams at their closest point, which is found from the old one.
fn after(
    beams: [&dyn AnyBeam; 2],
    contact: &Contact,
    start: (f64, f64),
) -> Option<[Varied<Vector3<f64>>; 2]> {
    let point = refine(beams[0], beams[1], start, Held::default()).ok()?;
    let all = quantities(beams, lifted(beams, (point.xi, point.xi_bar)), contact);
    Some([vector(all.d_vector), vector(all.t_vector)])
}
