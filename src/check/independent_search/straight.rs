//! The closest points of two straight segments, from all nine candidates in double-double.
//!
//! F = ‖d‖²/2 is a convex quadratic in both parameters, d = d₀ + a u - b v. So the point at which no component of the
//! gradient leads down into the square is the minimum. It is the centre line's crossing, a foot on one of the four edges,
//! or one of the four corners. If a and b are not parallel, there is one such point.

use super::branch::{Minimum, Survey};
use crate::linearization::ad::PositionAt;
use crate::number::{DoubleDouble, Real};
use nalgebra::Vector3;

/// A straight segment: its centre and half of the vector from its first end to its last.
type Segment = [Vector3<DoubleDouble>; 2];

/// The closest points of two segments.
#[derive(Clone, Copy, Debug)]
pub(super) struct Straight {
    /// The closest point of the nine candidates.
    pub(super) at: [f64; 2],
    /// The smallest distance.
    pub(super) distance: f64,
    /// Whether infinitely many points have it: parallel segments side by side.
    pub(super) is_continuum: bool,
}

/// The relative rounding of the products of three vectors in double-double, with a margin.
const ROUNDING: f64 = 1e-29;

fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from(x)
}

fn segment(position: &dyn PositionAt<DoubleDouble>, within: [f64; 2]) -> Segment {
    let [first, last] = within.map(|xi| position.position_at(number(xi)));
    let half = number(0.5);
    [(last + first) * half, (last - first) * half]
}

/// The closest points of the parts of two segments within these parameters; nothing if a part is a point.
pub(super) fn closest(
    [beam, bar]: [&dyn PositionAt<DoubleDouble>; 2],
    within: [[f64; 2]; 2],
) -> Option<Straight> {
    let [centre, a] = segment(beam, within[0]);
    let [centre_bar, b] = segment(bar, within[1]);
    let d0 = centre - centre_bar;
    let dot = |x: &Vector3<DoubleDouble>, y: &Vector3<DoubleDouble>| x.dot(y);
    let (aa, ab, bb) = (dot(&a, &a), dot(&a, &b), dot(&b, &b));
    if aa.value() <= 0.0 || bb.value() <= 0.0 || !(aa.value() * bb.value()).is_finite() {
        return None;
    }
    let normal = a.cross(&b);
    let det = dot(&normal, &normal);
    let is_parallel = det.value() <= ROUNDING * aa.value() * bb.value();
    let (da, db) = (dot(&d0, &a), dot(&d0, &b));
    let one = number(1.0);
    let is_inside = |x: DoubleDouble| x.abs() <= one;
    let mut candidates = Vec::with_capacity(9);
    if !is_parallel {
        // aa u - ab v = -da, -ab u + bb v = db
        let crossing = [(db * ab - da * bb) / det, (db * aa - da * ab) / det];
        candidates.extend(crossing.into_iter().all(is_inside).then_some(crossing));
    }
    for end in [-one, one] {
        let (v, u) = ((db + ab * end) / bb, (ab * end - da) / aa);
        candidates.extend(is_inside(v).then_some([end, v]));
        candidates.extend(is_inside(u).then_some([u, end]));
        candidates.extend([-one, one].map(|other| [end, other]));
    }
    let square = |[u, v]: [DoubleDouble; 2]| {
        let d = d0 + a * u - b * v;
        dot(&d, &d)
    };
    let nearest = candidates
        .into_iter()
        .min_by(|&p, &q| square(p).partial_cmp(&square(q)).unwrap_or(std::cmp::Ordering::Equal))?;
    let distance = square(nearest).sqrt().value();
    // Side by side: the bar's ends, seen from the beam, cover a part of it with a length.
    let feet = [-one, one].map(|end| (ab * end - da) / aa);
    let (low, high) = if feet[0] < feet[1] { (feet[0], feet[1]) } else { (feet[1], feet[0]) };
    let overlap = (if high < one { high } else { one }) - (if low > -one { low } else { -one });
    let is_continuum = is_parallel && overlap.value() > ROUNDING;
    let whole = |i: usize| {
        let [low, high] = within[i].map(number);
        ((low + high) + (high - low) * nearest[i]) * number(0.5)
    };
    Some(Straight { at: [0, 1].map(|i| whole(i).value()), distance, is_continuum })
}

impl Straight {
    /// The survey, with the distance and the bound on its rounding in its units; `error` is that of the positions.
    pub(super) fn survey(&self, factor: f64, error: f64) -> Survey {
        let minimum = Minimum {
            at: self.at,
            error: [0.0; 2],
            distance: [self.distance * factor, error],
            is_weak: self.is_continuum,
            within: [[-1.0, 1.0]; 2],
        };
        Survey { minima: vec![minimum], open: Vec::new(), boxes: 0 }
    }
}

#[cfg(test)]
mod tests {
    use super::closest;
    use crate::curve::Segment;
    use crate::linearization::ad::Perturbed;
    use crate::number::DoubleDouble;
    use nalgebra::SVector;

    fn of(p: [f64; 6], q: [f64; 6]) -> ([f64; 2], f64, bool) {
        let curve = Segment::new();
        let [p, q] = [p, q].map(|q| Perturbed { curve: &curve, q: SVector::from(q).map(DoubleDouble::from) });
        let found = closest([&p, &q], [[-1.0, 1.0]; 2]).unwrap();
        (found.at, found.distance, found.is_continuum)
    }

    /// The values are exact rationals, or roots of them.
    #[test]
    fn each_of_the_nine_candidates_is_found() {
        let x = [-1.0, 0.0, 0.0, 1.0, 0.0, 0.0];
        // Crossing inside: the bar from (0, -1, 3) to (1, 3, 3) passes over (1/4, 0) at a quarter of its length.
        assert_eq!(of(x, [0.0, -1.0, 3.0, 1.0, 3.0, 3.0]), ([0.25, -0.5], 3.0, false));
        // An end of the bar, over the inside of the beam.
        assert_eq!(of(x, [0.5, 2.0, 0.0, 0.5, 4.0, 1.0]), ([0.5, -1.0], 2.0, false));
        // An end of the beam, beside the inside of the bar: the foot of (1, 0, 0) on (3, t, 0).
        assert_eq!(of(x, [3.0, -1.0, 0.0, 3.0, 3.0, 0.0]), ([1.0, -0.5], 2.0, false));
        // A corner: 3-4-5.
        assert_eq!(of(x, [4.0, 4.0, 0.0, 5.0, 7.0, 0.0]), ([1.0, -1.0], 5.0, false));
        // Parallel beams from a public report: the distance is 0.001, at infinitely many points.
        let (_, distance, is_continuum) =
            of([0.0, 0.0, 0.0, 1.0, 0.0, 0.0], [0.999, 0.001, 0.0, 10.999, 0.001, 0.0]);
        assert!((distance - 0.001).abs() < 1e-18 && is_continuum);
        // On one line with a gap of 1/2: one pair of ends.
        assert_eq!(of(x, [1.5, 0.0, 0.0, 2.0, 0.0, 0.0]), ([1.0, -1.0], 0.5, false));
    }
}
