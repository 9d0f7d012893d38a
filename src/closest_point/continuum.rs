//! Why a region stays open: the kinds of continua of equally near points.

use super::{ClosestPoint, Degeneracy, SquaredDistance};
use crate::curve::Geometry;
use crate::number::Which;
use nalgebra::Vector3;
use std::fmt;

/// Sines below this are those of parallel vectors, and components of an eigenvector below this vanish.
const PARALLEL: f64 = 1e-5;
/// Points with a residual below this are part of a continuum of stationary points.
const STATIONARY: f64 = 1e-7;
/// Curvatures below this, times the half-length of the curve, are those of straight curves.
const STRAIGHT: f64 = 1e-6;

/// Why the search left a region open, judged at its nearest point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Continuum {
    /// Straight centroids that are parallel to rounding and apart.
    Parallel,
    /// Straight centroids that overlap on one line.
    Collinear,
    /// Curved centroids that bend about one axis.
    Concentric,
    /// Curved centroids that coincide along a part of their length.
    Coincident,
    /// A point of the other beam is at the centre of an arc of this one, so that the arc is equally near all along.
    CentreOfArc {
        /// The beam of the arc.
        which: Which,
    },
    /// Other centroids at a constant distance.
    Equidistant,
    /// A tangent has no length, so that the distance does not change to first order.
    ZeroTangent {
        /// The beam of the tangent.
        which: Which,
    },
    /// No continuum: the search ended at its limits.
    Undecided,
}

impl fmt::Display for Continuum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let other = |which: Which| if which == Which::Beam { Which::Bar } else { Which::Beam };
        match *self {
            Self::Parallel => f.write_str("the centroids are parallel"),
            Self::Collinear => f.write_str("the centroids are collinear and overlap"),
            Self::Concentric => f.write_str("the centroids are concentric"),
            Self::Coincident => f.write_str("the centroids coincide"),
            Self::CentreOfArc { which } => {
                write!(f, "a point of the {} is at the centre of an arc of the {which}", other(which))
            }
            Self::Equidistant => f.write_str("the centroids have a constant distance"),
            Self::ZeroTangent { which } => write!(f, "the tangent of the {which} has no length"),
            Self::Undecided => f.write_str("the search ended at its limits"),
        }
    }
}

impl Continuum {
    /// The kind of continuum at a point.
    pub(super) fn at(point: &ClosestPoint, [x, x_bar]: [&Geometry<f64>; 2]) -> Self {
        let p = SquaredDistance::new(x, x_bar);
        match point.degeneracy() {
            Some(Degeneracy::ZeroTangent { which }) => return Self::ZeroTangent { which },
            Some(Degeneracy::Singular { .. }) if point.residual < STATIONARY => {}
            _ => return Self::Undecided,
        }
        let held = point.held();
        let [first, second] = match (held.xi, held.xi_bar) {
            (false, true) => [1.0, 0.0],
            (true, _) => [0.0, 1.0],
            (false, false) => p.valley(),
        };
        if second.abs() < PARALLEL {
            return Self::CentreOfArc { which: Which::Beam };
        }
        if first.abs() < PARALLEL {
            return Self::CentreOfArc { which: Which::Bar };
        }
        let [bend, bend_bar] = [x, x_bar].map(curvature);
        let straight = |bend: &Vector3<f64>, x: &Geometry<f64>| bend.norm() * x.t.norm() < STRAIGHT;
        let (t, t_bar) = (x.t.normalize(), x_bar.t.normalize());
        if t.cross(&t_bar).norm() > PARALLEL {
            return Self::Equidistant;
        }
        match (straight(&bend, x), straight(&bend_bar, x_bar), p.is_crossing()) {
            (true, true, true) => Self::Collinear,
            (true, true, false) => Self::Parallel,
            (false, false, true) => Self::Coincident,
            (false, false, false) => {
                let centre = |x: &Geometry<f64>, bend: &Vector3<f64>| x.x + bend / bend.norm_squared();
                let between = centre(x, &bend) - centre(x_bar, &bend_bar);
                let axis = t.cross(&bend).normalize();
                let size = p.distance + 1.0 / bend.norm() + 1.0 / bend_bar.norm();
                let is_one = axis.cross(&t_bar.cross(&bend_bar).normalize()).norm() < PARALLEL
                    && between.cross(&axis).norm() < PARALLEL * size;
                if is_one { Self::Concentric } else { Self::Equidistant }
            }
            _ => Self::Equidistant,
        }
    }
}

/// The curvature vector: the part of t,xi normal to t, divided by t².
fn curvature(x: &Geometry<f64>) -> Vector3<f64> {
    let square = x.t.norm_squared();
    (x.t_xi - x.t * (x.t.dot(&x.t_xi) / square)) / square
}
