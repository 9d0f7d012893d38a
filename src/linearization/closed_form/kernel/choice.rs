//! The choice of the formulation at a point, and its results.

use super::arithmetic::Arithmetic;
use super::products::Products;
use super::side::Point;
use super::solution::Solution;
use crate::closest_point::Held;
use crate::linearization::closed_form::formulation::System;
use crate::linearization::closed_form::{Formulation, Points};
use crate::number::{Lanes, Real};
use crate::source_fault::source_fault;

/// A choice between the formulations.
pub(super) trait Choice<T: Real>: Copy {
    /// The result of the chosen formulation, and the lanes, as bits, that need another one; nothing if all lanes do.
    fn solve<A: Arithmetic<T>>(
        self,
        f: A,
        at: (&Point<A::Vector>, &Point<A::Vector>),
        products: &Products<T, A::Vector>,
    ) -> Option<(Solution<T, A::Vector>, u8)>;
}

/// The formulation that loses the fewest digits.
#[derive(Clone, Copy)]
pub(super) struct Best(pub(super) Held);

impl Choice<f64> for Best {
    /// The common normal and the paper's system in vectors, inside both beams and at wide angles; otherwise one by one.
    #[inline(always)]
    fn solve<A: Arithmetic<f64>>(
        self,
        f: A,
        at: (&Point<A::Vector>, &Point<A::Vector>),
        products: &Products<f64, A::Vector>,
    ) -> Option<(Solution<f64, A::Vector>, u8)> {
        let solution = if self.0 == Held::default() && products.squares(f, at).is_regular() {
            Solution::regular(f, at, products, 1.0_f64.copysign(products.c_d))
        } else {
            best(&points(f, at), self.0).into_vectors(f)
        };
        Some((solution, 0))
    }
}

/// The solution at ends, at small angles and beyond the radius of curvature.
#[cold]
#[inline(never)]
fn best(points: &Points<f64>, held: Held) -> Solution<f64, [f64; 3]> {
    Solution::in_formulation(points, Formulation::at(points, held))
}

/// The common normal and the paper's system, in each lane where no other formulation keeps more digits.
#[derive(Clone, Copy)]
pub(super) struct Regular;

impl Choice<Lanes> for Regular {
    #[inline(always)]
    fn solve<A: Arithmetic<Lanes>>(
        self,
        f: A,
        at: (&Point<A::Vector>, &Point<A::Vector>),
        products: &Products<Lanes, A::Vector>,
    ) -> Option<(Solution<Lanes, A::Vector>, u8)> {
        let squares = products.squares(f, at);
        let mut exceptions = 0;
        let mut sign = Lanes([1.0; 4]);
        for lane in 0..4 {
            let regular = squares.map(
                #[inline(always)]
                |x| x.0[lane],
            );
            exceptions |= u8::from(!regular.is_regular()) << lane;
            sign.0[lane] = sign.0[lane].copysign(squares.c_d.0[source_fault!("normal-of-lane": 0, lane)]);
        }
        (exceptions != ALL).then(
            #[inline(always)]
            || (Solution::regular(f, at, products, sign), exceptions),
        )
    }
}

/// All four lanes.
pub(super) const ALL: u8 = 0b1111;

/// The given formulation.
#[derive(Clone, Copy)]
pub(super) struct Given(pub(super) Formulation);

impl<T: Real> Choice<T> for Given {
    #[inline(always)]
    fn solve<A: Arithmetic<T>>(
        self,
        f: A,
        at: (&Point<A::Vector>, &Point<A::Vector>),
        products: &Products<T, A::Vector>,
    ) -> Option<(Solution<T, A::Vector>, u8)> {
        let Self(form) = self;
        let solution = match (form.sign(), form.system) {
            (Some(sign), System::Determinants) => {
                let sign = source_fault!("normal-with-determinants": -sign, sign);
                Solution::regular(f, at, products, T::from(sign))
            }
            _ => Solution::in_formulation(&points(f, at), form).into_vectors(f),
        };
        Some((solution, 0))
    }
}

/// Both beams at their contact points.
#[inline(always)]
pub(super) fn points<T: Real, A: Arithmetic<T>>(
    f: A,
    (beam, bar): (&Point<A::Vector>, &Point<A::Vector>),
) -> Points<T> {
    Points::new(&beam.geometry(f), &bar.geometry(f))
}
