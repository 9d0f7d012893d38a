//! The scalars: one trait, [`Real`], over which every curve and every formula is written.
//!
//! `Real` is a field with a square root and with sine and cosine, and it has *no order*. Without an order the
//! geometry cannot branch. Every scalar therefore runs the same operations as `f64`, and what is shown for one scalar
//! is valid for all of them. Everything that iterates, branches or fails stays in `f64`, in
//! [`closest_point`](crate::closest_point).

mod double_double;
mod dual;
mod extension;
#[cfg(feature = "check")]
mod faulty;
mod formula;
mod hyper_dual;
mod hyper_dual_row;
mod lanes;
mod named;
mod operation_count;
mod polynomial_degree;
mod prime_field;
mod running_error;
#[cfg(feature = "check")]
mod taylor_series;
mod term_scale;
#[cfg(feature = "check")]
mod traced;

pub use double_double::DoubleDouble;
pub use dual::{Differentiable, Dual};
pub use extension::Extends;
#[cfg(feature = "check")]
pub(crate) use faulty::{
    Bits, Change, Faulty, TermChange, counted, locate, operations, terms as recorded_terms,
    terms_with as recorded_terms_with, with_operation, with_terms,
};
pub use formula::Formula;
pub use hyper_dual::HyperDual;
pub use hyper_dual_row::HyperDualRow;
pub use lanes::Lanes;
pub use named::{Label, Term, Which};
pub(crate) use named::{named, orders};
pub use operation_count::OperationCount;
pub use polynomial_degree::PolynomialDegree;
pub use prime_field::PrimeField;
pub use running_error::{Bound, RunningError, RunningErrorBy};
#[cfg(feature = "check")]
pub(crate) use taylor_series::TaylorSeries;
pub use term_scale::TermScale;
#[cfg(feature = "check")]
pub(crate) use traced::Traced;

use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign, Scalar};
use num_dual::DualNum;
use num_traits::{One, Zero};
use std::ops::Neg;

/// A number type for the geometry of contact: a field with `sqrt` and `sin_cos`, and without an order.
///
/// It is implemented for `f64` and every (nested) dual number of the crate `num_dual`, by one blanket implementation, and for
/// the scalars of this module. A user-defined scalar implements the operators, [`Zero`], [`One`], `From<f64>`,
/// [`Real::sqrt`] and [`Real::sin_cos`], nothing else.
///
/// `==` on dual numbers compares the real part only; compare the parts instead.
pub trait Real:
    Scalar
    + Copy
    + Zero
    + One
    + Neg<Output = Self>
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
    + From<f64>
{
    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Sine and cosine at once.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);

    /// This number as a term of a formula. A scalar for fault injection returns a wrong number.
    #[inline(always)]
    #[must_use]
    fn named(self, _: Label) -> Self {
        self
    }

    /// The orders of two Jacobians whose product is a term. A scalar for fault injection exchanges them.
    #[inline(always)]
    fn orders(_: Label, orders: [usize; 2]) -> [usize; 2] {
        orders
    }
}

impl<T: DualNum<Primitive = f64> + Copy> Real for T {
    #[inline]
    fn sqrt(self) -> Self {
        DualNum::sqrt(&self)
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        DualNum::sin_cos(&self)
    }
}

/// Derives the assigning operators, `Zero`, `One` and `From<f64>` of a scalar from its `+ - * /`, its
/// `constant(f64)` and its `is_exact_zero`. The generics come first, in brackets.
macro_rules! field_from_operators {
    ([$($generics:tt)*] $type:ty) => {
        impl<$($generics)*> std::ops::AddAssign for $type {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }
        impl<$($generics)*> std::ops::SubAssign for $type {
            #[inline]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }
        impl<$($generics)*> std::ops::MulAssign for $type {
            #[inline]
            fn mul_assign(&mut self, other: Self) {
                *self = *self * other;
            }
        }
        impl<$($generics)*> std::ops::DivAssign for $type {
            #[inline]
            fn div_assign(&mut self, other: Self) {
                *self = *self / other;
            }
        }
        impl<$($generics)*> num_traits::Zero for $type {
            #[inline]
            fn zero() -> Self {
                Self::from(0.0)
            }
            #[inline]
            fn is_zero(&self) -> bool {
                *self == Self::from(0.0)
            }
        }
        impl<$($generics)*> num_traits::One for $type {
            #[inline]
            fn one() -> Self {
                Self::from(1.0)
            }
        }
    };
}
use field_from_operators;
