//! A drawn beam without its type and size, so that later code is compiled once and not once per pair of families.

use super::exact::{Exact, ExactBeam};
use super::padded::{FEW_DOFS, Padded, PaddedBeam};
use crate::closest_point::{Centroid, SearchFault, is_injected};
use crate::curve::{Curve, DofDerivatives, Geometry};
use crate::linearization::ad::{Perturbed, PositionAt};
use crate::linearization::closed_form::PartialVariations;
use crate::number::{
    Bits, DoubleDouble, Dual, Extends, Faulty, HyperDual, PrimeField, Real, RunningError, RunningErrorBy,
    TaylorSeries, Traced,
};
use nalgebra::{SVector, Vector3};
use num_dual::{Dual2SVec, DualSVec, HyperDual64};
use std::fmt::Debug;

/// A number with two bounds. The first is valid if the parameters of the closest point are as accurate as
/// double-double makes them, the second if they are as accurate as `f64` makes them.
pub(crate) type RunningError2 = RunningErrorBy<[f64; 2]>;

/// The methods that the check needs of a beam.
pub(crate) trait AnyBeam:
    Centroid
    + PositionAt<num_dual::Dual<HyperDual64>>
    + PositionAt<num_dual::Dual<DualSVec<HyperDual64, 2>>>
    + PositionAt<Dual2SVec<HyperDual64, 2>>
    + PositionAt<Dual<HyperDual<RunningError2>>>
    + PositionAt<Dual<Dual<RunningError2>>>
    + PositionAt<TaylorSeries>
    + Debug
    + Send
    + Sync
{
    /// The number of dofs.
    fn dofs(&self) -> usize;

    /// Its dofs and the two directions.
    fn numbers(&self) -> [&[f64]; 3];

    /// The same curve with other dofs and directions, in the same number.
    fn with_numbers(&self, numbers: &[Vec<f64>; 3]) -> Box<dyn AnyBeam>;

    /// The beam moved by a vector; nothing if its points are not known.
    fn translated(&self, by: &Vector3<f64>) -> Option<Box<dyn AnyBeam>>;

    /// Point and tangent at any parameter, also beyond the ends.
    fn geometry_at(&self, xi: RunningError) -> Geometry<RunningError>;

    /// The same in double-double.
    fn geometry_precise(&self, xi: DoubleDouble) -> Geometry<DoubleDouble>;

    /// The variations at a fixed parameter, with bounds on their error.
    fn partial_variations(&self, xi: RunningError2) -> PartialVariations<RunningError2>;

    /// The same in plain `f64`.
    fn partial_variations_plain(&self, xi: f64) -> PartialVariations<f64>;

    /// The variations in double-double.
    fn partial_variations_precise(&self, xi: DoubleDouble) -> PartialVariations<DoubleDouble>;

    /// The beam in double-double at q + `along`\[0\] dq + `along`\[1\] Dq.
    fn moved(&self, along: [DoubleDouble; 2]) -> Box<dyn PositionAt<DoubleDouble> + '_>;

    /// The jet with its dofs padded to a common number, and the two directions padded in the same way.
    fn padded(&self, xi: RunningError) -> PaddedBeam<RunningError>;

    /// The same for a beam with few dofs.
    fn padded_few(&self, xi: RunningError) -> PaddedBeam<RunningError, FEW_DOFS>;

    /// A beam of the same family and parameters, with random dofs and directions over the prime field.
    fn residues(&self, random: &mut dyn FnMut() -> PrimeField) -> Box<dyn ExactBeam<PrimeField>>;

    /// The jet of such a curve with all its derivatives, as a function of the parameter, over a scalar that injects
    /// faults into operations.
    fn jets(&self, random: &mut dyn FnMut() -> Traced) -> Box<dyn Fn(Traced) -> Vec<u64> + Send + Sync>;
}

/// A curve with its dofs and the two directions of variation.
#[derive(Clone, Debug)]
pub(crate) struct Drawn<C, const N: usize> {
    pub(crate) curve: C,
    pub(crate) q: SVector<f64, N>,
    pub(crate) dq: SVector<f64, N>,
    pub(crate) linear_dq: SVector<f64, N>,
    /// The indices in `q` where the points start: the triples that change when the beam is moved.
    pub(crate) points: Vec<usize>,
}

impl<C: Curve<N>, const N: usize> Drawn<C, N> {
    fn lift<T: Real>(&self) -> [SVector<T, N>; 3] {
        [&self.q, &self.dq, &self.linear_dq].map(|v| v.map(T::from))
    }

    fn partial_variations_in<T: Real>(&self, xi: T) -> PartialVariations<T> {
        let [q, dq, linear_dq] = self.lift();
        PartialVariations::new(&self.curve.jet(&q, xi), &dq, &linear_dq)
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

    fn filled_up<const D: usize>(&self, xi: RunningError) -> PaddedBeam<RunningError, D> {
        let [q, dq, linear_dq] = self.lift();
        let jet = self.curve.jet(&q, xi);
        if N > D {
            return Padded::along(&jet, &dq, &linear_dq);
        }
        (Padded::fill(&jet), [q, dq, linear_dq].map(|v| Padded::fill_vector(&v)))
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
        if is_injected(SearchFault::BoundOfFirstDof) {
            return self.curve.third_derivative_bound(&SVector::repeat(self.q[0]));
        }
        self.curve.third_derivative_bound(&self.q)
    }

    fn is_cubic(&self) -> bool {
        self.curve.is_cubic()
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

impl<C: Curve<N>, const N: usize> PositionAt<Dual<HyperDual<RunningError2>>> for Drawn<C, N> {
    fn position_at(&self, xi: Dual<HyperDual<RunningError2>>) -> Vector3<Dual<HyperDual<RunningError2>>> {
        let seed = |q, dq, linear_dq| {
            let [q, dq, linear_dq] = [q, dq, linear_dq].map(RunningError2::from);
            HyperDual::new(q, dq, linear_dq, RunningError2::from(0.0))
        };
        self.seeded(seed).position_at(xi)
    }
}

impl<C: Curve<N>, const N: usize> PositionAt<Dual<Dual<RunningError2>>> for Drawn<C, N> {
    fn position_at(&self, xi: Dual<Dual<RunningError2>>) -> Vector3<Dual<Dual<RunningError2>>> {
        self.seeded(|q, _, _| RunningError2::from(q)).position_at(xi)
    }
}

impl<C: Curve<N>, const N: usize> PositionAt<TaylorSeries> for Drawn<C, N> {
    fn position_at(&self, xi: TaylorSeries) -> Vector3<TaylorSeries> {
        self.seeded(|q, _, _| q).position_at(xi)
    }
}

impl<C: Curve<N> + Clone + Debug + Send + Sync + 'static, const N: usize> AnyBeam for Drawn<C, N> {
    fn dofs(&self) -> usize {
        N
    }

    fn numbers(&self) -> [&[f64]; 3] {
        [&self.q, &self.dq, &self.linear_dq].map(nalgebra::Matrix::as_slice)
    }

    fn with_numbers(&self, numbers: &[Vec<f64>; 3]) -> Box<dyn AnyBeam> {
        let [q, dq, linear_dq] = numbers.each_ref().map(|v| SVector::from_column_slice(v));
        Box::new(Self { q, dq, linear_dq, ..self.clone() })
    }

    fn translated(&self, by: &Vector3<f64>) -> Option<Box<dyn AnyBeam>> {
        let mut moved = self.clone();
        for &start in &moved.points {
            for c in 0..3 {
                moved.q[start + c] += by[c];
            }
        }
        (!self.points.is_empty()).then(|| Box::new(moved) as _)
    }

    fn geometry_at(&self, xi: RunningError) -> Geometry<RunningError> {
        self.curve.jet(&self.q.map(RunningError::from), xi).geometry
    }

    fn geometry_precise(&self, xi: DoubleDouble) -> Geometry<DoubleDouble> {
        self.curve.jet(&self.q.map(DoubleDouble::from), xi).geometry
    }

    fn partial_variations(&self, xi: RunningError2) -> PartialVariations<RunningError2> {
        self.partial_variations_in(xi)
    }

    fn partial_variations_plain(&self, xi: f64) -> PartialVariations<f64> {
        self.partial_variations_in(xi)
    }

    fn partial_variations_precise(&self, xi: DoubleDouble) -> PartialVariations<DoubleDouble> {
        self.partial_variations_in(xi)
    }

    fn moved(&self, [along, linear]: [DoubleDouble; 2]) -> Box<dyn PositionAt<DoubleDouble> + '_> {
        let [q, dq, linear_dq] = self.lift::<DoubleDouble>();
        Box::new(Perturbed { curve: &self.curve, q: q + dq * along + linear_dq * linear })
    }

    fn padded(&self, xi: RunningError) -> PaddedBeam<RunningError> {
        self.filled_up(xi)
    }

    fn padded_few(&self, xi: RunningError) -> PaddedBeam<RunningError, FEW_DOFS> {
        self.filled_up(xi)
    }

    fn residues(&self, random: &mut dyn FnMut() -> PrimeField) -> Box<dyn ExactBeam<PrimeField>> {
        Box::new(self.exact(random))
    }

    fn jets(&self, random: &mut dyn FnMut() -> Traced) -> Box<dyn Fn(Traced) -> Vec<u64> + Send + Sync> {
        let mut vector = || SVector::<_, N>::from_fn(|_, _| Faulty(random()));
        let (curve, q, dq, linear_dq) = (self.curve.clone(), vector(), vector(), vector());
        let w = Vector3::from_fn(|_, _| Faulty(random()));
        Box::new(move |xi| {
            let jet = curve.jet(&q, Faulty(xi));
            let PartialVariations { geometry, delta_u, linear_u, second_u } =
                PartialVariations::new(&jet, &dq, &linear_dq);
            let Geometry { x, t, t_xi, t_xixi } = geometry;
            let mut all = Vec::new();
            let mut write = |numbers: &[Faulty<Traced>]| all.extend(numbers.iter().map(|n| n.0.bits()));
            for v in [x, t, t_xi, t_xixi].iter().chain(&delta_u).chain(&linear_u).chain(&second_u) {
                write(v.as_slice());
            }
            for k in 0..3 {
                write(jet.dofs.gradient(k, &w).as_slice());
                write(jet.dofs.jacobian(k).as_slice());
            }
            for k in 0..2 {
                write(jet.dofs.hessian(k, &w).as_slice());
            }
            for k in 0..4 {
                write(jet.dofs.shapes(k).unwrap_or_default());
            }
            all
        })
    }
}
