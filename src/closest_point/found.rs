//! What the search finds.

use super::{ClosestPoint, Continuum, Degeneracy, ProjectionError};

/// The minima and the interior stationary points of the distance of two centroids.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ClosestPoints {
    /// The local minima, inside and at ends, the nearest first.
    pub minima: Vec<ClosestPoint>,
    /// The saddles and maxima inside the square, the nearest first.
    pub stationary: Vec<ClosestPoint>,
    /// Regions for which the search did not determine the number of stationary points.
    pub unresolved: Vec<Unresolved>,
    /// The cost of the search.
    pub statistics: Statistics,
}

/// A region that may contain more stationary points than are reported: infinitely many, if the centroids are parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Unresolved {
    /// The smallest and the largest xi.
    pub xi: [f64; 2],
    /// The smallest and the largest xi_bar.
    pub xi_bar: [f64; 2],
    /// The number of boxes that cover the region.
    pub boxes: usize,
    /// A point of the region at the smallest distance. Of a continuum of such points it is one in the middle.
    pub point: ClosestPoint,
    /// An interval that contains the smallest distance in the region. The upper end is the distance of [`Self::point`].
    pub distance: [f64; 2],
    /// Why the region is open.
    pub continuum: Continuum,
}

/// The cost of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct Statistics {
    /// The number of boxes examined inside the square.
    pub boxes: usize,
    /// The number of intervals examined on its edges.
    pub intervals: usize,
    /// The number of evaluations of a curve.
    pub evaluations: usize,
}

impl ClosestPoints {
    /// The nearest minimum with both parameters inside their beams.
    ///
    /// It is the nearest of the listed minima. [`Self::is_complete`] says whether others may exist.
    ///
    /// # Errors
    /// [`ProjectionError::Singular`] if a continuum of points is at least as near,
    /// [`ProjectionError::IllConditioned`] if rounding destroys most digits of the derivatives of its parameters,
    /// [`ProjectionError::NoInteriorMinimum`] if every minimum is at an end.
    pub fn interior(&self) -> Result<&ClosestPoint, ProjectionError> {
        let nearest = self.minima.iter().find(|point| point.is_interior());
        let limit = nearest.map_or(f64::INFINITY, |point| point.distance);
        for region in &self.unresolved {
            let is_near = region.point.is_interior() && region.point.distance <= limit;
            // Near a tangent without length, rounding decides about the eigenvalue, although no continuum is there.
            let is_still = matches!(region.continuum, Continuum::ZeroTangent { .. });
            if let (Some(Degeneracy::Singular { conditioning }), true) =
                (region.point.degeneracy(), is_near && !is_still)
            {
                return Err(ProjectionError::Singular { conditioning });
            }
        }
        let nearest = nearest.ok_or(ProjectionError::NoInteriorMinimum)?;
        match nearest.degeneracy() {
            Some(Degeneracy::Singular { conditioning }) => Err(ProjectionError::Singular { conditioning }),
            Some(Degeneracy::IllConditioned { conditioning, gradient_error }) => {
                Err(ProjectionError::IllConditioned { conditioning, gradient_error })
            }
            _ => Ok(nearest),
        }
    }

    /// The results of curves whose lengths were divided by `unit`.
    pub(super) fn in_unit(mut self, unit: f64) -> Self {
        for point in self.minima.iter_mut().chain(&mut self.stationary) {
            *point = point.in_unit(unit);
        }
        for region in &mut self.unresolved {
            region.point = region.point.in_unit(unit);
            region.distance = region.distance.map(|distance| distance * unit);
        }
        self
    }

    /// Whether no region was left open, so that all minima, saddles and maxima are listed.
    pub fn is_complete(&self) -> bool {
        self.unresolved.is_empty()
    }
}
