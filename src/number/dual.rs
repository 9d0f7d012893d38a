//! A dual number over any [`Real`], for one more derivative, and the choice of the dual number for each scalar.
//!
//! The tangent t = x,xi of a curve that is known by its position only is the eps part of its position at xi + eps.
//! For num-dual's numbers, num-dual's own `Dual` computes it. For all other scalars, the [`Dual`] of this file
//! computes it, because the primitive of num-dual must be a float.

use super::{
    Bound, DoubleDouble, HyperDual, HyperDualRow, PrimeField, Real, RunningErrorBy, field_from_operators,
};
use num_dual::DualNum;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// `re + eps * e` with e^2 = 0 over any [`Real`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T> {
    /// The value.
    pub re: T,
    /// The derivative.
    pub eps: T,
}

impl<T: Real> Dual<T> {
    /// The number with the given value and derivative.
    pub fn new(re: T, eps: T) -> Self {
        Self { re, eps }
    }
}

impl<T: Real> From<f64> for Dual<T> {
    #[inline]
    fn from(value: f64) -> Self {
        Self::new(T::from(value), T::zero())
    }
}

impl<T: Real> Add for Dual<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.eps + other.eps)
    }
}

impl<T: Real> Sub for Dual<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.eps - other.eps)
    }
}

impl<T: Real> Mul for Dual<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.re * other.re, self.re * other.eps + self.eps * other.re)
    }
}

impl<T: Real> Div for Dual<T> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let re = self.re / other.re;
        Self::new(re, (self.eps - re * other.eps) / other.re)
    }
}

impl<T: Real> Neg for Dual<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.eps)
    }
}

field_from_operators!([T: Real] Dual<T>);

impl<T: Real> Real for Dual<T> {
    fn sqrt(self) -> Self {
        let root = self.re.sqrt();
        Self::new(root, self.eps / (root + root))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.re.sin_cos();
        (Self::new(sin, cos * self.eps), Self::new(cos, -sin * self.eps))
    }
}

/// A scalar that can be differentiated once more.
pub trait Differentiable: Real {
    /// The dual number over this scalar.
    type Dual: Real;

    /// `self + slope * eps`.
    fn dual(self, slope: f64) -> Self::Dual;

    /// The value and the derivative.
    fn parts(dual: Self::Dual) -> (Self, Self);
}

impl<T: DualNum<Primitive = f64> + Copy> Differentiable for T {
    type Dual = num_dual::Dual<T>;

    #[inline]
    fn dual(self, slope: f64) -> Self::Dual {
        num_dual::Dual::new(self, <T as From<f64>>::from(slope))
    }

    #[inline]
    fn parts(dual: Self::Dual) -> (Self, Self) {
        (dual.re, dual.eps)
    }
}

macro_rules! differentiable_by_own_dual {
    ($([$($generics:tt)*] $type:ty),*) => {$(
        impl<$($generics)*> Differentiable for $type {
            type Dual = Dual<Self>;

            #[inline]
            fn dual(self, slope: f64) -> Self::Dual {
                Dual::new(self, Self::from(slope))
            }

            #[inline]
            fn parts(dual: Self::Dual) -> (Self, Self) {
                (dual.re, dual.eps)
            }
        }
    )*};
}
differentiable_by_own_dual!([B: Bound] RunningErrorBy<B>, [] DoubleDouble, [] PrimeField, [T: Real] Dual<T>, [T: Real] HyperDual<T>, [const C: usize] HyperDualRow<C>);
