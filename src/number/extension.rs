//! Which scalar contains which. The constants of a dual number are the numbers it is built over.

use super::{Dual, HyperDual, HyperDualRow, Real};
use num_dual::{Dual2SVec, Dual2SVec64, DualSVec, HyperDual64};
use num_traits::Zero;

/// A scalar that contains the scalar `T` as its constants.
pub trait Extends<T>: Real {
    /// The number `value` with all derivatives zero.
    fn constant(value: T) -> Self;
}

impl<T: Real> Extends<T> for T {
    #[inline]
    fn constant(value: T) -> Self {
        value
    }
}

impl<T: Real> Extends<T> for Dual<T> {
    #[inline]
    fn constant(value: T) -> Self {
        Self::new(value, T::zero())
    }
}

impl<T: Real> Extends<T> for Dual<Dual<T>> {
    #[inline]
    fn constant(value: T) -> Self {
        Self::new(Dual::new(value, T::zero()), Dual::zero())
    }
}

impl<T: Real> Extends<T> for HyperDual<T> {
    #[inline]
    fn constant(value: T) -> Self {
        Self::new(value, T::zero(), T::zero(), T::zero())
    }
}

impl<const C: usize> Extends<f64> for HyperDualRow<C> {
    #[inline]
    fn constant(value: f64) -> Self {
        Self::from(value)
    }
}

/// The numbers and the traits of num-dual are foreign, so each pair in use has its own implementation.
macro_rules! extends_by_from_re {
    ($([$($generics:tt)*] $inner:ty => $outer:ty, $($from_re:path),+;)*) => {$(
        impl<$($generics)*> Extends<$inner> for $outer {
            #[inline]
            fn constant(value: $inner) -> Self {
                $(let value = $from_re(value);)+
                value
            }
        }
    )*};
}
extends_by_from_re! {
    [] f64 => num_dual::Dual<f64>, num_dual::Dual::from_re;
    [] f64 => num_dual::Dual<num_dual::Dual<f64>>, num_dual::Dual::from_re, num_dual::Dual::from_re;
    [] f64 => HyperDual64, HyperDual64::from_re;
    [] HyperDual64 => num_dual::Dual<HyperDual64>, num_dual::Dual::from_re;
    [] HyperDual64 => num_dual::Dual<DualSVec<HyperDual64, 2>>, DualSVec::from_re, num_dual::Dual::from_re;
    [] HyperDual64 => Dual2SVec<HyperDual64, 2>, Dual2SVec::from_re;
    [const M: usize] f64 => Dual2SVec64<M>, Dual2SVec64::from_re;
    [const M: usize] Dual2SVec64<M> => num_dual::Dual<Dual2SVec64<M>>, num_dual::Dual::from_re;
}
