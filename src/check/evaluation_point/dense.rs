//! Gradients and Hessians of the scalars, entry by entry.

use super::{EvaluationPoint, of_value};
use crate::contact::closed_form::write;
use crate::contact::{Contribution, Decision, History, Law, Values};
use crate::linearization::Quantity;
use crate::linearization::{BlockHessian, Derivatives, Linearization};
use crate::number::{Faulty, Real, RunningError};
use crate::pair::DofVector;
use crate::test_beam::{DOFS, map_padded};
use crate::variant::{SCALAR_COMPONENTS, Step, Variant, linearized};

/// A scalar with its gradient and its Hessian, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::check) struct Dense {
    pub(in crate::check) quantity: Quantity,
    pub(in crate::check) value: f64,
    pub(in crate::check) gradient: Vec<f64>,
    pub(in crate::check) hessian: Vec<f64>,
}

impl EvaluationPoint<'_> {
    /// Value, gradient and Hessian of each scalar; g_N is not among them.
    ///
    /// Nothing if a curve has more dofs than the padding allows. No family has.
    pub(in crate::check) fn dense(&self, variant: &Variant) -> Vec<Dense> {
        let (at, form, contact) = ((self.at.0.value, self.at.1.value), self.form, self.contact);
        let read = |Faulty(number): Faulty<f64>| number;
        if self.has_few_dofs() {
            let faulty = |step| self.padded_few(step).each_ref().map(|beam| map_padded(beam, of_value));
            let linearized = variant.linearized(faulty, at, form, contact);
            return linearized.map_or_else(|| self.dense_bounded(|n| n.value), |all| self.listed(&all, read));
        }
        let faulty = |step| self.padded(step).each_ref().map(|beam| map_padded(beam, of_value));
        let linearized = variant.linearized(faulty, at, form, contact);
        linearized.map_or_else(|| self.dense_bounded(|n| n.value), |all| self.listed(&all, read))
    }

    /// The bounds on the rounding of [`EvaluationPoint::dense`] without faults.
    pub(in crate::check) fn dense_bounds(&self) -> Vec<Dense> {
        self.dense_bounded(|number| number.bound)
    }

    fn dense_bounded(&self, read: impl Fn(RunningError) -> f64) -> Vec<Dense> {
        let (form, contact) = (self.form, self.contact);
        if self.has_few_dofs() {
            self.listed(&linearized(self.padded_few(Step::Now), self.sharp(), form, contact), read)
        } else {
            self.listed(&linearized(self.padded(Step::Now), self.sharp(), form, contact), read)
        }
    }

    /// Residual and tangent of a contact element in closed form, without a fault; the tangent row by row.
    pub(in crate::check) fn element(
        &self,
        decision: &Decision<'_, Law>,
    ) -> (Vec<f64>, Vec<f64>, Values<f64>) {
        let beams = self.padded(Step::Now).each_ref().map(|beam| map_padded(beam, |number| number.value));
        let [(jet, _), (jet_bar, _)] = &beams;
        let mut to = Box::new(Contribution::zeros());
        let values = write(decision, (jet, jet_bar), (self.at.0.value, self.at.1.value), &mut to);
        let dofs = self.places::<DOFS>();
        let entries = dofs.iter().flat_map(|&i| dofs.iter().map(move |&j| (i, j)));
        let tangent = entries.map(|(i, j)| to.tangent.entry(i, j)).collect();
        (dofs.iter().map(|&i| to.residual.entry(i)).collect(), tangent, values)
    }

    /// The history that a converged contact leaves to the next step.
    pub(in crate::check) fn next_history(&self, decision: &Decision<'_, Law>) -> History {
        let at = (self.at.0.value, self.at.1.value);
        decision.next_history(&self.points(), at, &self.element(decision).2)
    }

    /// The places of the dofs of both beams among the padded ones.
    fn places<const D: usize>(&self) -> Vec<usize> {
        let [beam, bar] = self.beams.map(super::AnyBeam::dofs);
        (0..beam).chain((0..bar).map(|i| D + i)).collect()
    }

    /// Removes the padding of the beams.
    fn listed<T: Real, const D: usize>(
        &self,
        all: &Linearization<T, D, D>,
        read: impl Fn(T) -> f64,
    ) -> Vec<Dense> {
        let dofs = self.places::<D>();
        let list = |(quantity, of): (Quantity, &Derivatives<T, D, D>)| {
            let (gradient, hessian): (&DofVector<T, D, D>, &BlockHessian<T, D, D>) =
                (&of.gradient, &of.hessian);
            let entries = dofs.iter().flat_map(|&i| dofs.iter().map(move |&j| (i, j)));
            Dense {
                quantity,
                value: read(of.value),
                gradient: dofs.iter().map(|&i| read(gradient.entry(i))).collect(),
                hessian: entries.map(|(i, j)| read(hessian.entry(i, j))).collect(),
            }
        };
        let quantities = SCALAR_COMPONENTS.map(Quantity::of_component);
        let scalars = [&all.d, &all.t, &all.t_bar, &all.xi, &all.xi_bar, &all.g_t, &all.g_t_bar];
        quantities.into_iter().zip(scalars).map(list).collect()
    }
}
