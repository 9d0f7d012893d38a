//! The unit of length of the search: a power of two, so that no product of lengths overflows or underflows.
//!
//! Determinants are products of four lengths. Pairs of the usual size are searched in the unit of the user. All others
//! are scaled once, which changes no bit of a number except by the power of two.

use super::{Centroid, ProjectionError};
use crate::curve::Geometry;

/// Lengths between 2^-200 and 2^200 are of the usual size.
const USUAL: f64 = 1.606_938_044_258_990_3e60;
/// The exponents of the sizes of two curves may differ by this. The fourth powers of both are then representable.
const RATIO: i32 = 500;
/// The largest exponent of a size. The bounds of curves contain squares, which are then representable.
const LARGEST: i32 = 500;

/// Whether a pair of curves of this size needs no other unit.
#[inline]
pub(super) fn is_usual(size: f64) -> bool {
    (1.0 / USUAL..=USUAL).contains(&size)
}

/// Whether a pair needs no other unit, from a sum of squares of lengths.
#[inline]
pub(super) fn is_usual_square(square: f64) -> bool {
    (1.0 / USUAL / USUAL..=USUAL * USUAL).contains(&square)
}

/// A curve in another unit of length.
pub(super) struct Scaled<'a> {
    curve: &'a dyn Centroid,
    factor: f64,
}

impl Centroid for Scaled<'_> {
    fn geometry(&self, xi: f64) -> Geometry<f64> {
        let Geometry { x, t, t_xi, t_xixi } = self.curve.geometry(xi);
        let factor = self.factor;
        Geometry { x: x * factor, t: t * factor, t_xi: t_xi * factor, t_xixi: t_xixi * factor }
    }

    fn third_derivative_bound(&self) -> f64 {
        self.curve.third_derivative_bound() * self.factor
    }

    fn is_cubic(&self) -> bool {
        self.curve.is_cubic()
    }
}

/// Both curves in a unit between their sizes, and this unit.
///
/// # Errors
/// [`ProjectionError::NonFinite`] if a curve is not finite, if both are too large or too small, or if their sizes are too
/// unlike.
pub(super) fn scaled(curves: [&dyn Centroid; 2]) -> Result<([Scaled<'_>; 2], f64), ProjectionError> {
    let [first, second] = curves.map(exponent);
    let (first, second) = (first?, second?);
    let (one, other) = (first.or(second).unwrap_or(0), second.or(first).unwrap_or(0));
    if (one - other).abs() > RATIO || one.max(other).abs() > LARGEST {
        return Err(ProjectionError::NonFinite);
    }
    let unit = f64::exp2(f64::from(i32::midpoint(one, other)));
    Ok((curves.map(|curve| Scaled { curve, factor: 1.0 / unit }), unit))
}

/// The exponent of the size of a curve; nothing if all its numbers are zero.
fn exponent(curve: &dyn Centroid) -> Result<Option<i32>, ProjectionError> {
    let mut size = curve.third_derivative_bound();
    for xi in [-1.0, 0.0, 1.0] {
        let Geometry { x, t, t_xi, t_xixi } = curve.geometry(xi);
        for number in [x, t, t_xi, t_xixi].iter().flatten() {
            if !number.is_finite() {
                return Err(ProjectionError::NonFinite);
            }
            size = size.max(number.abs());
        }
    }
    if !size.is_finite() {
        return Err(ProjectionError::NonFinite);
    }
    #[expect(clippy::cast_possible_truncation, reason = "the logarithm of a finite number is small")]
    let exponent = size.log2().floor() as i32;
    Ok((size > 0.0).then_some(exponent))
}
