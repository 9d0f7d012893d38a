//! A beam written as numbers, and made from them.

use super::beam::{AnyBeam, Drawn};
use super::{Family, Unit};
use crate::closest_point::Centroid;
use crate::curve::{
    Arc, BSpline, Bezier, Cubic, Curve, CurveError, Helix, Hermite, Nurbs, NurbsWeighted, Quadratic, Segment,
};
use nalgebra::{SVector, Vector3};
use std::fmt::Debug;
use thiserror::Error;

/// A beam as numbers: all its data.
#[derive(Clone, Debug, PartialEq)]
pub struct TestBeam {
    /// The family of its curve.
    pub family: Family,
    /// The fixed parameters of the curve, one after the other in the order of [`Family::parameters`].
    pub parameters: Vec<f64>,
    /// The dofs.
    pub q: Vec<f64>,
    /// The variation.
    pub dq: Vec<f64>,
    /// The direction of linearization.
    pub linear_dq: Vec<f64>,
}

/// The reason why numbers define no beam.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TestBeamError {
    /// There are too many or too few numbers.
    #[error("{what}: {expected} numbers expected for the family {}, found {found}", family.name())]
    Count {
        /// Parameters, q, dq or linear_dq.
        what: &'static str,
        /// The number that the family has.
        expected: usize,
        /// The number that was found.
        found: usize,
        /// The family.
        family: Family,
    },
    /// A number is not finite.
    #[error("{what}[{index}]: a finite number expected, found {value}")]
    NotFinite {
        /// Parameters, q, dq or linear_dq.
        what: &'static str,
        /// Its index, from 0.
        index: usize,
        /// The number.
        value: f64,
    },
    /// The parameters define no curve.
    #[error("the parameters make no curve")]
    Curve(#[from] CurveError),
}

impl TestBeam {
    /// The parameter with this name; empty if the family has no such parameter.
    pub fn parameter(&self, name: &str) -> &[f64] {
        let mut start = 0;
        for &(known, count) in self.family.parameters() {
            if known == name {
                return self.parameters.get(start..start + count).unwrap_or_default();
            }
            start += count;
        }
        &[]
    }

    /// The same beam with every length times 2^`power`: the same numbers in another unit.
    #[must_use]
    pub fn scaled(&self, power: i32) -> Self {
        let factor = 2.0_f64.powi(power);
        let units = self.family.units();
        let scaled = |numbers: &[f64]| -> Vec<f64> {
            let of = |(&number, &unit)| if unit == Unit::Pure { number } else { number * factor };
            numbers.iter().zip(&units).map(of).collect()
        };
        let parameters = match self.family {
            Family::HermiteScaled => self.parameters.iter().map(|length| length * factor).collect(),
            _ => self.parameters.clone(),
        };
        Self {
            family: self.family,
            parameters,
            q: scaled(&self.q),
            dq: scaled(&self.dq),
            linear_dq: scaled(&self.linear_dq),
        }
    }

    /// Moves the whole beam.
    pub(crate) fn translate(&mut self, by: &Vector3<f64>) {
        for start in self.family.points() {
            for c in 0..3 {
                self.q[start + c] += by[c];
            }
        }
    }

    /// Checks whether the numbers define a beam.
    ///
    /// # Errors
    /// [`TestBeamError`] gives the reason why they do not.
    pub fn validate(&self) -> Result<(), TestBeamError> {
        self.beam().map(drop)
    }

    /// The centroid, as the search for closest points uses it.
    ///
    /// # Errors
    /// [`TestBeamError`] if the numbers define no beam.
    pub fn centroid(&self) -> Result<Box<dyn Centroid>, TestBeamError> {
        Ok(self.beam()?)
    }

    /// The beam.
    pub(crate) fn beam(&self) -> Result<Box<dyn AnyBeam>, TestBeamError> {
        let (family, dofs) = (self.family, self.family.units().len());
        let parameters = family.parameters().iter().map(|(_, count)| count).sum();
        for (what, numbers, expected) in [
            ("parameters", &self.parameters, parameters),
            ("q", &self.q, dofs),
            ("dq", &self.dq, dofs),
            ("linear_dq", &self.linear_dq, dofs),
        ] {
            if numbers.len() != expected {
                return Err(TestBeamError::Count { what, expected, found: numbers.len(), family });
            }
            if let Some((index, &value)) = numbers.iter().enumerate().find(|(_, value)| !value.is_finite()) {
                return Err(TestBeamError::NotFinite { what, index, value });
            }
        }
        let (knots, first) = (self.parameter("knots"), self.parameters.first().copied().unwrap_or_default());
        Ok(match family {
            Family::Segment => self.of::<_, 6>(Segment::new()),
            Family::Quadratic => self.of::<_, 9>(Quadratic::new()),
            Family::Cubic => self.of::<_, 12>(Cubic::new()),
            Family::Hermite => self.of::<_, 12>(Hermite::new()),
            Family::HermiteScaled => self.of::<_, 12>(Hermite::scaled_by(first)),
            Family::Bezier => self.of::<_, 18>(Bezier::<6>::new()),
            Family::BSpline => self.of::<_, 12>(BSpline::<4>::new(knots)?),
            Family::Nurbs => {
                let weights = SVector::<f64, 3>::from_column_slice(self.parameter("weights"));
                self.of::<_, 9>(Nurbs::<3>::new(knots, weights.into())?)
            }
            Family::NurbsWeighted => self.of::<_, 16>(NurbsWeighted::<4>::new(knots)?),
            Family::Arc => self.of::<_, 9>(Arc::new(first)),
            Family::Helix => self.of::<_, 10>(Helix::new(first)),
        })
    }

    /// The beam on a curve. There are as many numbers as the curve has dofs.
    fn of<C: Curve<N> + Clone + Debug + Send + Sync + 'static, const N: usize>(
        &self,
        curve: C,
    ) -> Box<dyn AnyBeam> {
        let [q, dq, linear_dq] =
            [&self.q, &self.dq, &self.linear_dq].map(|numbers| SVector::from_column_slice(numbers));
        Box::new(Drawn { curve, q, dq, linear_dq, points: self.family.points() })
    }
}

#[cfg(test)]
mod tests;
