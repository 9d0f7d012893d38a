//! The first four terms of a power series in the parameter of a curve, each with two bounds on its error.

use super::{Extends, Real, RunningErrorBy, field_from_operators};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A coefficient. The first bound is on rounding at the centre. The second bound is on the change over an interval, too.
type Coefficient = RunningErrorBy<[f64; 2]>;

/// The number of terms.
const TERMS: usize = 4;

/// A truncated power series: x, x', x''/2 and x'''/6.
///
/// With [`TaylorSeries::about`], a curve's position yields the coefficients about the centre of an interval. The value of
/// a coefficient with the second bound contains the coefficient about every other point of the interval, because each
/// operation passes on the bounds of its operands (ball arithmetic).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TaylorSeries {
    coefficients: [Coefficient; TERMS],
    /// The number of coefficients that may differ from zero, at least 1. It saves products by zero.
    count: usize,
}

impl TaylorSeries {
    /// The parameter itself, about the centre of an interval of half-width `half`.
    pub(crate) fn about(centre: f64, half: f64) -> Self {
        let centre = Coefficient::new(centre, [0.0, half]);
        Self::of(2, |k| if k == 0 { centre } else { Coefficient::from(1.0) })
    }

    /// The coefficient of the k-th power.
    pub(crate) fn coefficient(&self, k: usize) -> Coefficient {
        self.coefficients[k]
    }

    /// Whether no power above the first occurs, without rounding.
    pub(crate) fn is_linear(&self) -> bool {
        self.count <= 2
    }

    /// The series of the first `count` coefficients.
    fn of(count: usize, coefficient: impl Fn(usize) -> Coefficient) -> Self {
        let mut series = Self::from(0.0);
        series.count = count.clamp(1, TERMS);
        for k in 0..series.count {
            series.coefficients[k] = coefficient(k);
        }
        series
    }
}

impl From<f64> for TaylorSeries {
    #[inline]
    fn from(value: f64) -> Self {
        let mut coefficients = [Coefficient::from(0.0); TERMS];
        coefficients[0] = value.into();
        Self { coefficients, count: 1 }
    }
}

impl Extends<f64> for TaylorSeries {
    #[inline]
    fn constant(value: f64) -> Self {
        value.into()
    }
}

impl Add for TaylorSeries {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let (mut sum, other) = if self.count < other.count { (other, self) } else { (self, other) };
        for k in 0..other.count {
            sum.coefficients[k] += other.coefficients[k];
        }
        sum
    }
}

impl Sub for TaylorSeries {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for TaylorSeries {
    type Output = Self;
    #[inline]
    fn neg(mut self) -> Self {
        for k in 0..self.count {
            self.coefficients[k] = -self.coefficients[k];
        }
        self
    }
}

impl Mul for TaylorSeries {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::of(self.count + other.count - 1, |k| {
            let first = (k + 1).saturating_sub(other.count);
            let last = k.min(self.count - 1);
            let product = |i: usize| self.coefficients[i] * other.coefficients[k - i];
            (first + 1..=last).fold(product(first), |sum, i| sum + product(i))
        })
    }
}

impl Div for TaylorSeries {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let count = if other.count == 1 { self.count } else { TERMS };
        let mut quotient = Self::from(0.0);
        quotient.count = count;
        for k in 0..count {
            let known = (1..=k.min(other.count - 1)).fold(self.coefficients[k], |sum, j| {
                sum - other.coefficients[j] * quotient.coefficients[k - j]
            });
            quotient.coefficients[k] = known / other.coefficients[0];
        }
        quotient
    }
}

field_from_operators!([] TaylorSeries);

impl Real for TaylorSeries {
    fn sqrt(self) -> Self {
        let mut root = Self::from(0.0);
        root.count = if self.count == 1 { 1 } else { TERMS };
        root.coefficients[0] = self.coefficients[0].sqrt();
        for k in 1..root.count {
            // 2 r₀ rₖ = aₖ - Σ rⱼ rₖ₋ⱼ, 0 < j < k
            let known = (1..k)
                .fold(self.coefficients[k], |sum, j| sum - root.coefficients[j] * root.coefficients[k - j]);
            root.coefficients[k] = known / (root.coefficients[0] + root.coefficients[0]);
        }
        root
    }

    fn sin_cos(self) -> (Self, Self) {
        let (mut sin, mut cos) = (Self::from(0.0), Self::from(0.0));
        let count = if self.count == 1 { 1 } else { TERMS };
        (sin.count, cos.count) = (count, count);
        (sin.coefficients[0], cos.coefficients[0]) = self.coefficients[0].sin_cos();
        let mut index = 0.0;
        for k in 1..count {
            // k sₖ = Σ j xⱼ cₖ₋ⱼ   k cₖ = -Σ j xⱼ sₖ₋ⱼ, 0 < j <= k
            index += 1.0;
            let mut sums = [Coefficient::from(0.0); 2];
            let mut times = 0.0;
            for j in 1..=k {
                times += 1.0;
                let slope = self.coefficients[j] * Coefficient::from(times);
                sums[0] += slope * cos.coefficients[k - j];
                sums[1] += slope * sin.coefficients[k - j];
            }
            sin.coefficients[k] = sums[0] / Coefficient::from(index);
            cos.coefficients[k] = -sums[1] / Coefficient::from(index);
        }
        (sin, cos)
    }
}

#[cfg(test)]
mod tests {
    use super::TaylorSeries;
    use crate::number::Real;

    fn assert_near(found: &TaylorSeries, expected: [f64; 4]) {
        for (k, expected) in expected.into_iter().enumerate() {
            let found = found.coefficient(k);
            assert!((found.value - expected).abs() <= found.bound[0] + 1e-15, "{k}: {found:?}, {expected}");
            assert!(found.bound[0] < 1e-14 * (1.0 + expected.abs()), "{k}: {found:?}");
        }
    }

    #[test]
    fn series_of_elementary_functions_are_known() {
        let x = TaylorSeries::about(2.0, 0.0);
        assert_near(&(x * x * x), [8.0, 12.0, 6.0, 1.0]);
        assert!(!(x * x).is_linear() && (x - TaylorSeries::from(3.0)).is_linear());
        // 1 / x about 2
        assert_near(&(TaylorSeries::from(1.0) / x), [0.5, -0.25, 0.125, -0.0625]);
        // The root of x² about 2 is x, the root of x about 4 is 2 + h/4 - h²/64 + h³/512.
        assert_near(&(x * x).sqrt(), [2.0, 1.0, 0.0, 0.0]);
        assert_near(&TaylorSeries::about(4.0, 0.0).sqrt(), [2.0, 0.25, -1.0 / 64.0, 1.0 / 512.0]);
        let (sin, cos) = TaylorSeries::about(0.0, 0.0).sin_cos();
        assert_near(&sin, [0.0, 1.0, 0.0, -1.0 / 6.0]);
        assert_near(&cos, [1.0, 0.0, -0.5, 0.0]);
    }

    #[test]
    fn the_second_bound_holds_the_coefficients_about_every_point_of_the_interval() {
        let curve = |x: TaylorSeries| {
            let (sin, cos) = (x + x).sin_cos();
            (sin * x - cos) / (x * x + TaylorSeries::from(1.0)).sqrt()
        };
        let whole = curve(TaylorSeries::about(0.25, 0.125));
        for k in 0..4 {
            let all = whole.coefficient(k);
            let off = |i: i32| {
                let here = curve(TaylorSeries::about(0.125 + f64::from(i) / 32.0, 0.0));
                (all.value - here.coefficient(k).value).abs()
            };
            let farthest = (0..=8).map(off).fold(0.0, f64::max);
            assert!(farthest <= all.bound[1], "{k}: {farthest:e} {all:?}");
            // The bound is not far above the difference.
            assert!(all.bound[0] < 1e-13 && all.bound[1] < 4.0 * farthest, "{k}: {farthest:e} {all:?}");
        }
    }
}
