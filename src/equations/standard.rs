//! The standard case: two Hermite beams and two directions, for which every equation is evaluated in numbers.

use super::point::{Point, quantities, vector};
use super::worked::{Worked, worked};
use crate::closest_point::{ClosestPoint, Held, ProjectionError};
use crate::curve::{Curve, Geometry, Hermite};
use crate::linearization::ad::{Perturbed, newton, seeded};
use crate::linearization::closed_form::PartialVariations;
use crate::pair::{Contact, DofVector, Pair};
use nalgebra::SVector;
use num_dual::HyperDual64;

type Dofs = DofVector<f64, 12, 12>;
type Lifted<'a> = Perturbed<'a, Hermite, HyperDual64, 12>;

/// Two Hermite beams with one closest point inside both, and two directions.
#[derive(Clone, Debug, PartialEq)]
pub struct StandardCase {
    /// The curves, with radii and reference parameters.
    pub pair: Pair<Hermite, Hermite, 12, 12>,
    /// The dofs: point, tangent, point, tangent.
    pub q: Dofs,
    /// The direction of delta.
    pub dq: Dofs,
    /// The direction of Delta.
    pub linear_dq: Dofs,
}

impl Default for StandardCase {
    fn default() -> Self {
        let contact = Contact { radius: 0.12, radius_bar: 0.12, xi_0: -0.25, xi_bar_0: 0.25 };
        let dofs = |beam: [f64; 12], bar: [f64; 12]| Dofs::from((beam, bar));
        Self {
            pair: Pair::new(Hermite::new(), Hermite::new()).with_contact(contact),
            q: dofs(
                [-1.4, 0.0, 0.35, 1.2, 0.1, 0.35, 1.4, 0.0, 0.35, 1.2, -0.1, -0.35],
                [-0.7, -1.2, -0.45, 0.5, 1.1, -0.1, 0.7, 1.2, -0.45, 0.5, 1.1, 0.1],
            ),
            dq: dofs(
                [0.1, -0.2, 0.3, 0.0, 0.4, -0.3, 0.2, 0.1, 0.4, -0.1, 0.2, 0.3],
                [-0.3, 0.1, -0.2, 0.2, 0.0, 0.3, 0.1, -0.1, -0.4, 0.3, 0.1, -0.2],
            ),
            linear_dq: dofs(
                [-0.2, 0.3, 0.1, 0.2, -0.1, 0.4, 0.3, -0.2, -0.1, 0.1, 0.3, -0.4],
                [0.2, 0.1, 0.3, -0.1, 0.3, 0.1, -0.2, 0.4, 0.1, 0.0, -0.3, 0.2],
            ),
        }
    }
}

impl StandardCase {
    /// Its closest point.
    ///
    /// # Errors
    /// None: the beams have one closest point, inside both beams.
    pub fn closest_point(&self) -> Result<ClosestPoint, ProjectionError> {
        Ok(*self.pair.closest_points(&self.q)?.interior()?)
    }

    /// The same beams, moved by `delta` and `linear` along the two directions.
    #[must_use]
    pub fn moved(&self, delta: f64, linear: f64) -> Dofs {
        self.q.plus(delta, &self.dq).plus(linear, &self.linear_dq)
    }

    /// All equations of the paper in numbers.
    ///
    /// # Errors
    /// None, as for [`StandardCase::closest_point`].
    pub fn worked(&self) -> Result<Vec<Worked>, ProjectionError> {
        Ok(worked(&self.point()?))
    }

    /// The beams as operands of the equations. The finite change is a step of one along the direction of Delta.
    fn point(&self) -> Result<Point<f64>, ProjectionError> {
        let here = self.closest_point()?;
        let moved = Self { q: self.moved(0.0, 1.0), ..self.clone() };
        let there = moved.pair.refine(&moved.q, (here.xi, here.xi_bar), Held::default())?;
        let at = (here.xi, here.xi_bar);
        let beams = self.lifted();
        let others = moved.lifted();
        let after = newton(&others[0], &others[1], (there.xi, there.xi_bar), Held::default());
        let after = quantities([&others[0], &others[1]], after, &self.pair.contact);
        let jet = |q: &SVector<f64, 12>, dq: &SVector<f64, 12>, linear: &SVector<f64, 12>, xi: f64| {
            PartialVariations::new(&Hermite::new().jet(q, xi), dq, linear)
        };
        let (q, dq, linear) = (&self.q, &self.dq, &self.linear_dq);
        Ok(Point::new(
            [&beams[0], &beams[1]],
            [jet(&q.beam, &dq.beam, &linear.beam, at.0), jet(&q.bar, &dq.bar, &linear.bar, at.1)],
            newton(&beams[0], &beams[1], at, Held::default()),
            [straight(&q.beam, at.0), straight(&q.bar, at.1)],
            &self.pair.contact,
            [vector::<f64>(after.d_vector), vector(after.t_vector)],
        ))
    }

    fn lifted(&self) -> [Lifted<'_>; 2] {
        let Self { pair, q, dq, linear_dq } = self;
        [
            Perturbed { curve: &pair.curve, q: seeded(&q.beam, &dq.beam, &linear_dq.beam) },
            Perturbed { curve: &pair.curve_bar, q: seeded(&q.bar, &dq.bar, &linear_dq.bar) },
        ]
    }
}

/// The reference configuration X of a beam: straight between its ends, except a small bend, so that no derivative is zero.
fn straight(q: &SVector<f64, 12>, xi: f64) -> Geometry<f64> {
    let mut reference = *q;
    let half = (q.fixed_rows::<3>(6) - q.fixed_rows::<3>(0)) * 0.5;
    for (i, bend) in [(3, 0.1), (9, -0.2)] {
        for c in 0..3 {
            reference[i + c] = half[c] + bend;
        }
    }
    Hermite::new().jet(&reference, xi).geometry
}
