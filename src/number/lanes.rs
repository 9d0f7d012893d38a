//! Four numbers side by side: one formula for four cases at once.

use super::{Real, field_from_operators};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Four numbers. Every operation applies to each of them.
///
/// It is as wide as the vectors of common machines. The compiler uses vector instructions where the target allows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub struct Lanes(pub [f64; 4]);

/// Implements an operator lane by lane.
macro_rules! lane_by_lane {
    ($trait:ident, $function:ident, $operator:tt) => {
        impl $trait for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                let (Self([a, b, c, d]), Self([e, f, g, h])) = (self, other);
                Self([a $operator e, b $operator f, c $operator g, d $operator h])
            }
        }
    };
}
lane_by_lane!(Add, add, +);
lane_by_lane!(Sub, sub, -);
lane_by_lane!(Mul, mul, *);
lane_by_lane!(Div, div, /);

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let Self([a, b, c, d]) = self;
        Self([-a, -b, -c, -d])
    }
}

impl From<f64> for Lanes {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Self([value; 4])
    }
}

field_from_operators!([] Lanes);

impl Real for Lanes {
    #[inline(always)]
    fn sqrt(self) -> Self {
        let Self([a, b, c, d]) = self;
        Self([a.sqrt(), b.sqrt(), c.sqrt(), d.sqrt()])
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (mut sin, mut cos) = (self, self);
        for (angle, (sin, cos)) in self.0.into_iter().zip(sin.0.iter_mut().zip(&mut cos.0)) {
            (*sin, *cos) = angle.sin_cos();
        }
        (sin, cos)
    }
}
