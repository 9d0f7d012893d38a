//! The two sides of a comparison at a closest point: the closed form, and automatic differentiation.

use super::{MATRICES, ROUTES};
use crate::check::element::ContactSituations;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::verdict::{Comparison, Order};
use crate::linearization::ad::{evaluate, newton, stationary};
use crate::linearization::{COMPONENTS, Quantities, Quantity, Varied};
use crate::number::{RunningError, TermScale};
use crate::source_fault::source_fault;
use crate::test_beam::RunningError2;
use crate::variant::{SCALAR_COMPONENTS, SCALARS, Variant};
use num_dual::HyperDual64;

/// The closed form under check, with all results that the comparison needs.
pub(crate) struct Closed {
    pub(super) plain: [Varied<f64>; COMPONENTS],
    pub(super) exchanged: [Varied<f64>; COMPONENTS],
    pub(super) scales: [Varied<TermScale>; COMPONENTS],
    pub(super) bounds: [Varied<RunningError2>; COMPONENTS],
    pub(super) matrices: [[RunningError; 3]; SCALARS],
}

/// Automatic differentiation: two routes of num-dual, and our own numbers with bounds.
pub(crate) struct References {
    pub(super) newton: [Varied<f64>; COMPONENTS],
    pub(super) stationary: [Varied<f64>; COMPONENTS],
    pub(super) chord: [Varied<RunningError2>; COMPONENTS],
}

/// Products below this scale may have lost digits to underflow.
const SMALLEST: f64 = 1e-280;

fn is_finite(varied: &Varied<RunningError2>) -> bool {
    varied.parts().iter().all(|part| part.value.is_finite())
}

impl References {
    /// Whether some number overflows.
    pub(super) fn is_out_of_range(&self) -> bool {
        !self.chord.iter().all(is_finite)
    }

    /// Differentiates at a closest point.
    pub(crate) fn new(evaluation: &EvaluationPoint) -> Self {
        let EvaluationPoint { beams: [beam, bar], held, at: (xi, xi_bar), .. } = *evaluation;
        let at = (xi.value, xi_bar.value);
        Self {
            newton: hyper_dual(evaluation, newton(beam, bar, at, held)),
            stationary: hyper_dual(evaluation, stationary(beam, bar, at, held)),
            chord: evaluation.chord(),
        }
    }
}

impl Closed {
    /// Evaluates the closed form at a closest point.
    pub(crate) fn new(variant: &Variant, evaluation: &EvaluationPoint) -> Self {
        Self {
            plain: evaluation.plain(variant),
            exchanged: evaluation.exchanged(variant),
            scales: evaluation.scales(variant),
            bounds: evaluation.closed(variant),
            matrices: evaluation.matrices(variant),
        }
    }

    /// Whether some number of the closed form without faults overflows, or some term underflows.
    pub(super) fn is_out_of_range(&self) -> bool {
        let is_out =
            |scale: TermScale| !scale.scale.is_finite() || (scale.scale > 0.0 && scale.scale < SMALLEST);
        !self.bounds.iter().all(is_finite)
            || self.scales.iter().any(|scale| scale.parts().into_iter().any(is_out))
    }

    /// All comparisons at one closest point.
    pub(crate) fn compared_with(&self, references: &References) -> Vec<Comparison> {
        let mut entries = Vec::with_capacity(16 * COMPONENTS);
        for i in 0..COMPONENTS {
            let (quantity, axis) = (Quantity::of_component(i), Quantity::axis_of_component(i));
            let closed = self.plain[i].parts();
            let scale = self.scales[i].parts().map(|scale| scale.scale);
            let bounds = self.bounds[i].parts().map(|bounded| bounded.bound);
            let bound = bounds.map(|[bound, _]| bound);
            let own = references.chord[i].parts();
            let routes = [
                references.newton[i].parts(),
                references.stationary[i].parts(),
                own.map(|bounded| bounded.value),
            ];
            // num-dual solves for the closest point in `f64` again, so its bound includes the resulting error.
            let [near, far] =
                [0, 1].map(|l| std::array::from_fn::<f64, 4, _>(|k| bounds[k][l] + own[k].bound[l]));
            for ((against, other), tolerance) in ROUTES.into_iter().zip(routes).zip([far, far, near]) {
                for (k, order) in
                    [Order::Value, Order::First, Order::First, Order::Second].into_iter().enumerate()
                {
                    entries.push(Comparison {
                        quantity,
                        axis,
                        order,
                        part: Varied::<f64>::PARTS[k],
                        against,
                        closed: closed[k],
                        other: other[k],
                        scale: scale[k],
                        bound: bound[k],
                        tolerance: tolerance[k],
                        situations: ContactSituations::NONE,
                    });
                }
            }
            if !source_fault!("symmetry-left-out": true, false) {
                entries.push(self.symmetry(i));
            }
        }
        entries.extend((0..SCALARS).flat_map(|i| self.matrix(i)));
        entries
    }

    /// A second variation against itself with the directions exchanged.
    pub(crate) fn symmetry(&self, i: usize) -> Comparison {
        Comparison {
            quantity: Quantity::of_component(i),
            axis: Quantity::axis_of_component(i),
            order: Order::Symmetry,
            part: Varied::<f64>::PARTS[3],
            against: "itself, directions exchanged",
            closed: self.plain[i].second,
            other: self.exchanged[i].second,
            scale: self.scales[i].second.scale,
            bound: self.bounds[i].second.bound[0],
            tolerance: 2.0 * self.bounds[i].second.bound[0],
            situations: ContactSituations::NONE,
        }
    }

    /// Gradient and Hessian of a scalar, contracted with the directions, against the variations.
    fn matrix(&self, scalar: usize) -> [Comparison; 3] {
        [1, 2, 3].map(|k| self.contracted(MATRICES, [scalar, k], self.matrices[scalar][k - 1]))
    }

    /// A contracted part of a scalar, against the variation.
    fn contracted(&self, against: &'static str, [scalar, k]: [usize; 2], other: RunningError) -> Comparison {
        let i = SCALAR_COMPONENTS[scalar];
        let bound = self.bounds[i].parts()[k].bound[0];
        Comparison {
            quantity: Quantity::of_component(i),
            axis: None,
            order: Order::Matrix,
            part: Varied::<f64>::PARTS[k],
            against,
            closed: self.plain[i].parts()[k],
            other: other.value,
            scale: self.scales[i].parts()[k].scale,
            bound,
            tolerance: bound + other.bound,
            situations: ContactSituations::NONE,
        }
    }
}

fn hyper_dual(evaluation: &EvaluationPoint, lifted: (HyperDual64, HyperDual64)) -> [Varied<f64>; COMPONENTS] {
    let [beam, bar] = evaluation.beams;
    let quantities: Quantities<HyperDual64> = evaluate(beam, bar, lifted, evaluation.contact);
    quantities.map(Varied::from).components()
}
