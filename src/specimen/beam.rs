//! A drawn beam with its family and size forgotten, so that what follows is compiled once and not per pair of families.

use super::exact::{Exact, ExactBeam};
use super::padded::Padded;
use crate::closest_point::Centroid;
use crate::curve::{Curve, DofDerivatives, Geometry, Jet};
use crate::linearization::ad::{Perturbed, PositionAt};
use crate::linearization::closed_form::Frozen;
use crate::number::{Bounded, Degree, Dual, Extends, HyperDual, Real, Residue};
use nalgebra::{SVector, Vector3};
use num_dual::{Dual2SVec, DualSVec, HyperDual64};
use std::fmt::Debug;

/// What the gate asks of a beam.
pub(crate) trait AnyBeam:
    Centroid
    + PositionAt<num_dual::Dual<HyperDual64>>
    + PositionAt<num_dual::Dual<DualSVec<HyperDual64, 2>>>
    + PositionAt<Dual2SVec<HyperDual64, 2>>
    + PositionAt<Dual<HyperDual<Bounded>>>
    + PositionAt<Dual<Dual<Bounded>>>
    + Debug
    + Send
    + Sync
{
    /// Whether the curve is linear in its dofs.
    fn is_linear(&self) -> bool;

    /// Moves the whole beam.
    fn translate(&mut self, by: &Vector3<f64>);

    /// Point and tangent at any parameter, also beyond the ends.
    fn geometry_at(&self, xi: Bounded) -> Geometry<Bounded>;

    /// The variations at a frozen parameter, with a bound on their error.
    fn frozen(&self, xi: Bounded) -> Frozen<Bounded>;

    /// The same in plain `f64`.
    fn frozen_plain(&self, xi: f64) -> Frozen<f64>;

    /// The jet with its dofs filled up to a common number, and the two directions filled up alike.
    fn padded(
        &self,
        xi: Bounded,
    ) -> (Jet<Bounded, Padded<Bounded>>, [SVector<Bounded, { Padded::<Bounded>::DOFS }>; 2]);

    /// A beam of the same family and parameters, with random dofs and directions over the prime field.
    fn residues(&self, random: &mut dyn FnMut() -> Residue) -> Box<dyn ExactBeam<Residue>>;

    /// The same with every dof and direction a variable whose degree counts.
    fn degrees(&self) -> Box<dyn ExactBeam<Degree>>;

    /// All that was drawn, to be shown.
    fn shown(&self) -> Shown;
}

/// A drawn beam as numbers, to be shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// What describes the curve besides its dofs: knots, weights, angles.
    pub curve: String,
    /// The dofs.
    pub q: Vec<f64>,
    /// The variation.
    pub dq: Vec<f64>,
    /// The direction of linearization.
    pub linear_dq: Vec<f64>,
}

/// A curve with its dofs and the two directions of variation.
#[derive(Clone, Debug)]
pub(crate) struct Drawn<C, const N: usize> {
    pub(crate) curve: C,
    pub(crate) q: SVector<f64, N>,
    pub(crate) dq: SVector<f64, N>,
    pub(crate) linear_dq: SVector<f64, N>,
    /// Where in `q` the points start: the triples that move when the beam is moved.
    pub(crate) points: Vec<usize>,
}

impl<C: Curve<N>, const N: usize> Drawn<C, N> {
    fn lift<T: Real>(&self) -> [SVector<T, N>; 3] {
        [&self.q, &self.dq, &self.linear_dq].map(|v| v.map(T::from))
    }

    fn frozen_in<T: Real>(&self, xi: T) -> Frozen<T> {
        let [q, dq, linear_dq] = self.lift();
        Frozen::new(&self.curve.jet(&q, xi), &dq, &linear_dq)
    }

    /// The dofs perturbed in both directions.
    fn seeded<T: Real>(&self, seed: impl Fn(f64, f64, f64) -> T) -> Perturbed<'_, C, T, N> {
        let q = SVector::from_fn(|i, _| seed(self.q[i], self.dq[i], self.linear_dq[i]));
        Perturbed { curve: &self.curve, q }
    }

    fn exact<T: Real>(&self, random: &mut dyn FnMut() -> T) -> Exact<C, T, N>
    where
        C: Clone,
    {
        let mut vector = || SVector::from_fn(|_, _| random());
        let (q, dq, linear_dq) = (vector(), vector(), vector());
        Exact { curve: self.curve.clone(), q, dq, linear_dq, points: self.points.clone() }
    }

    fn hyper_dual<S: Extends<HyperDual64>>(&self, xi: S) -> Vector3<S> {
        self.seeded(|q, dq, linear_dq| HyperDual64::new(q, dq, linear_dq, 0.0)).position_at(xi)
    }
}

impl<C: Curve<N>, const N: usize> Centroid for Drawn<C, N> {
    fn geometry(&self, xi: f64) -> Geometry<f64> {
        self.curve.jet(&self.q, xi).geometry
    }

    fn third_derivative_bound(&self) -> f64 {
        self.curve.third_derivative_bound(&self.q)
    }
}

macro_rules! hyper_dual_position {
    ($($scalar:ty),*) => {$(
        impl<C: Curve<N>, const N: usize> PositionAt<$scalar> for Drawn<C, N> {
            fn position_at(&self, xi: $scalar) -> Vector3<$scalar> {
                self.hyper_dual(xi)
            }
        }
    )*};
}
hyper_dual_position!(num_dual::Dual<HyperDual64>, num_dual::Dual<DualSVec<HyperDual64, 2>>, Dual2SVec<HyperDual64, 2>);

impl<C: Curve<N>, const N: usize> PositionAt<Dual<HyperDual<Bounded>>> for Drawn<C, N> {
    fn position_at(&self, xi: Dual<HyperDual<Bounded>>) -> Vector3<Dual<HyperDual<Bounded>>> {
        let seed = |q, dq, linear_dq| {
            let [q, dq, linear_dq] = [q, dq, linear_dq].map(Bounded::from);
            HyperDual::new(q, dq, linear_dq, Bounded::from(0.0))
        };
        self.seeded(seed).position_at(xi)
    }
}

impl<C: Curve<N>, const N: usize> PositionAt<Dual<Dual<Bounded>>> for Drawn<C, N> {
    fn position_at(&self, xi: Dual<Dual<Bounded>>) -> Vector3<Dual<Dual<Bounded>>> {
        self.seeded(|q, _, _| Bounded::from(q)).position_at(xi)
    }
}

impl<C: Curve<N> + Clone + Debug + Send + Sync + 'static, const N: usize> AnyBeam for Drawn<C, N> {
    fn is_linear(&self) -> bool {
        <C::Dofs<f64> as DofDerivatives<f64, N>>::LINEAR
    }

    fn translate(&mut self, by: &Vector3<f64>) {
        for &start in &self.points {
            for c in 0..3 {
                self.q[start + c] += by[c];
            }
        }
    }

    fn geometry_at(&self, xi: Bounded) -> Geometry<Bounded> {
        self.curve.jet(&self.q.map(Bounded::from), xi).geometry
    }

    fn frozen(&self, xi: Bounded) -> Frozen<Bounded> {
        self.frozen_in(xi)
    }

    fn frozen_plain(&self, xi: f64) -> Frozen<f64> {
        self.frozen_in(xi)
    }

    fn padded(
        &self,
        xi: Bounded,
    ) -> (Jet<Bounded, Padded<Bounded>>, [SVector<Bounded, { Padded::<Bounded>::DOFS }>; 2]) {
        let [q, dq, linear_dq] = self.lift();
        (Padded::fill(&self.curve.jet(&q, xi)), [dq, linear_dq].map(|v| Padded::fill_vector(&v)))
    }

    fn residues(&self, random: &mut dyn FnMut() -> Residue) -> Box<dyn ExactBeam<Residue>> {
        Box::new(self.exact(random))
    }

    fn degrees(&self) -> Box<dyn ExactBeam<Degree>> {
        Box::new(self.exact(&mut || Degree::VARIABLE))
    }

    fn shown(&self) -> Shown {
        let [q, dq, linear_dq] = [&self.q, &self.dq, &self.linear_dq].map(|v| v.iter().copied().collect());
        Shown { curve: format!("{:?}", self.curve), q, dq, linear_dq }
    }
}
