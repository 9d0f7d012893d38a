//! A closest point at which both linearizations are evaluated, in every scalar that the check needs.

mod contact;
mod dense;
mod refined;
mod solved_again;
mod structure;

use super::case_data::ByTerm;
use super::root_enclosure;
use super::verdict::Inconclusive;
use crate::closest_point::{ClosestPoint, Degeneracy, Held};
use crate::linearization::ad::Chord;
use crate::linearization::closed_form::{Formulation, PartialVariations, Points, variations_in};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::{DoubleDouble, Faulty, RunningError, TermScale};
use crate::pair::Contact;
use crate::test_beam::{AnyBeam, FEW_DOFS, PaddedBeam, RunningError2, map_padded};
use crate::variant::{
    Contracted, Returned, SCALARS, Step, Variant, bounded_kernel, contracted, kernel_functions, routes, terms,
};
pub(crate) use contact::ELEMENT_ENTRIES;
pub(super) use contact::is_of_residual;
pub(super) use dense::Dense;
use refined::Refined;
use std::sync::OnceLock;
pub(super) use structure::Structure;

/// A closest point that has derivatives and is accurate enough.
#[derive(Debug)]
pub(crate) struct EvaluationPoint<'a> {
    pub(crate) beams: [&'a dyn AnyBeam; 2],
    pub(crate) contact: &'a Contact,
    pub(crate) held: Held,
    /// The closest point, with the parameters refined.
    pub(super) point: ClosestPoint,
    /// The formulas under check: those that the library uses here, unless others are given.
    pub(crate) form: Formulation,
    /// The parameters, refined in double-double and rounded, with bounds on their distance from the exact closest
    /// point. The second bounds are those of `f64`, for methods that solve for the closest point in `f64` again.
    pub(crate) at: (RunningError2, RunningError2),
    caches: [Cache; 3],
    unmodified: OnceLock<Box<Unmodified>>,
}

/// Both beams at some parameters, in the scalars that the check needs. Each is evaluated once, at the first request.
#[derive(Debug, Default)]
struct Cache {
    plain: OnceLock<[PartialVariations<f64>; 2]>,
    bounded: OnceLock<[PartialVariations<RunningError2>; 2]>,
    // Boxed, because it is large and the evaluation point is passed by value.
    padded: OnceLock<Box<[PaddedBeam<RunningError>; 2]>>,
    padded_few: OnceLock<Box<[PaddedBeam<RunningError, FEW_DOFS>; 2]>>,
}

/// The closed form without faults, with all results that the comparison needs.
#[derive(Clone, Debug)]
struct Unmodified {
    plain: [Varied<f64>; COMPONENTS],
    scales: [Varied<TermScale>; COMPONENTS],
    bounds: [Varied<RunningError2>; COMPONENTS],
    matrices: [[RunningError; 3]; SCALARS],
}

impl<'a> EvaluationPoint<'a> {
    /// A closest point of two beams, or the reason why it has no derivatives that can be compared.
    pub(crate) fn new(
        beams: [&'a dyn AnyBeam; 2],
        contact: &'a Contact,
        point: &ClosestPoint,
    ) -> Result<Self, Inconclusive> {
        match point.degeneracy() {
            // The tolerances account for the loss of digits.
            None | Some(Degeneracy::IllConditioned { .. }) => {}
            Some(Degeneracy::Crossing) => return Err(Inconclusive::Crossing),
            Some(Degeneracy::WeakEnd { .. }) => return Err(Inconclusive::WeakEnd),
            Some(Degeneracy::ZeroTangent { .. }) => return Err(Inconclusive::ZeroTangent),
            Some(_) => return Err(Inconclusive::Singular),
        }
        Self::regular(beams, contact, point)
    }

    /// A closest point that is known to have derivatives, or d = 0.
    fn regular(
        beams: [&'a dyn AnyBeam; 2],
        contact: &'a Contact,
        point: &ClosestPoint,
    ) -> Result<Self, Inconclusive> {
        let (xi, xi_bar) = root_enclosure::parameters(beams, point).ok_or(Inconclusive::IllConditioned)?;
        let at = [xi, xi_bar].map(|RunningError { value, bound }| RunningError2 { value, bound: [bound; 2] });
        let mut evaluation = Self {
            beams,
            contact,
            held: point.held(),
            point: *point,
            form: Formulation::default(),
            at: at.into(),
            caches: Default::default(),
            unmodified: OnceLock::new(),
        };
        if let Some(refined) = evaluation.refined() {
            evaluation.at = refined.map(Refined::rounded).into();
            (evaluation.point.xi, evaluation.point.xi_bar) = (evaluation.at.0.value, evaluation.at.1.value);
        }
        evaluation.widen();
        let form = Formulation::at(&evaluation.points(), evaluation.held);
        Ok(evaluation.in_formulation(form))
    }

    /// The evaluation point with these formulas.
    pub(crate) fn in_formulation(self, form: Formulation) -> Self {
        Self { form, unmodified: OnceLock::new(), ..self }
    }

    /// The points of both beams.
    pub(crate) fn points(&self) -> Points<f64> {
        let [beam, bar] = self.partial_variations(Step::Now);
        Points::new(&beam.geometry, &bar.geometry)
    }

    /// The parameters with the smaller bounds alone.
    fn sharp(&self) -> (RunningError, RunningError) {
        let sharp = |RunningError2 { value, bound: [bound, _] }| RunningError { value, bound };
        (sharp(self.at.0), sharp(self.at.1))
    }

    /// Both beams, at fixed parameters.
    pub(crate) fn partial_variations(&self, step: Step) -> [PartialVariations<f64>; 2] {
        let partial = || {
            let ([beam, bar], (xi, xi_bar)) = step.place(self.beams, (self.at.0.value, self.at.1.value));
            [beam.partial_variations_plain(xi), bar.partial_variations_plain(xi_bar)]
        };
        *self.caches[step as usize].plain.get_or_init(partial)
    }

    /// Both beams, at fixed parameters, with bounds on their errors.
    pub(crate) fn bounded(&self, step: Step) -> [PartialVariations<RunningError2>; 2] {
        let partial = || {
            let ([beam, bar], (xi, xi_bar)) = step.place(self.beams, self.at);
            [beam.partial_variations(xi), bar.partial_variations(xi_bar)]
        };
        *self.caches[step as usize].bounded.get_or_init(partial)
    }

    fn padded(&self, step: Step) -> &[PaddedBeam<RunningError>; 2] {
        let padded = || {
            let ([beam, bar], (xi, xi_bar)) = step.place(self.beams, self.sharp());
            Box::new([beam.padded(xi), bar.padded(xi_bar)])
        };
        self.caches[step as usize].padded.get_or_init(padded)
    }

    fn padded_few(&self, step: Step) -> &[PaddedBeam<RunningError, FEW_DOFS>; 2] {
        let padded = || {
            let ([beam, bar], (xi, xi_bar)) = step.place(self.beams, self.sharp());
            Box::new([beam.padded_few(xi), bar.padded_few(xi_bar)])
        };
        self.caches[step as usize].padded_few.get_or_init(padded)
    }

    /// Whether each beam is a sum of shape functions times control vectors.
    pub(super) fn have_shapes(&self) -> [bool; 2] {
        self.padded(Step::Now).each_ref().map(|(jet, _)| jet.dofs.all_shapes().is_some())
    }

    fn has_few_dofs(&self) -> bool {
        self.beams.iter().all(|beam| beam.dofs() <= FEW_DOFS)
    }

    /// The closed form.
    pub(crate) fn plain(&self, variant: &Variant) -> [Varied<f64>; COMPONENTS] {
        if !variant.changes(&terms()[0]) {
            return self.unmodified().plain;
        }
        let at = (self.at.0.value, self.at.1.value);
        variant.quantities(|step| self.partial_variations(step), at, self.form, self.contact).components()
    }

    /// The closed form, and the value of each of its terms in the order of evaluation.
    pub(super) fn by_term(&self, variant: &Variant) -> ByTerm {
        let at = (self.at.0.value, self.at.1.value);
        let partial = |step| self.partial_variations(step);
        let (quantities, terms) = variant.terms(partial, at, self.form, self.contact);
        ByTerm { components: quantities.components(), terms }
    }

    /// The closed form with the directions exchanged.
    pub(super) fn exchanged(&self, variant: &Variant) -> [Varied<f64>; COMPONENTS] {
        let at = (self.at.0.value, self.at.1.value);
        let partial = |step| self.partial_variations(step).map(PartialVariations::exchanged);
        variant.quantities(partial, at, self.form, self.contact).components()
    }

    /// The closed form with bounds on its error. The bounds are those of the formulas without faults.
    pub(crate) fn closed(&self, variant: &Variant) -> [Varied<RunningError2>; COMPONENTS] {
        let bounded = || {
            let partial = self.bounded(Step::Now);
            variant.formulas(&partial, self.at, self.form, self.contact).components()
        };
        if let Variant::Rewritten(_) = variant { bounded() } else { self.unmodified().bounds }
    }

    /// The size of the terms of the closed form without faults.
    pub(super) fn scales(&self, variant: &Variant) -> [Varied<TermScale>; COMPONENTS] {
        if let Variant::Rewritten(_) = variant { self.sized(variant) } else { self.unmodified().scales }
    }

    pub(super) fn sized(&self, variant: &Variant) -> [Varied<TermScale>; COMPONENTS] {
        let at = (TermScale::parameter(self.at.0.value), TermScale::parameter(self.at.1.value));
        // A position has at least the size of the curve, because the choice of the origin is no measure of rounding.
        let sized = |partial: PartialVariations<f64>| {
            let mut sizes = partial.map(TermScale::vector);
            let of_curve = sizes.geometry.t.map(|t| t.scale).min();
            for x in &mut sizes.geometry.x {
                x.scale = x.scale.max(of_curve);
            }
            sizes
        };
        let partial = self.partial_variations(Step::Now).map(sized);
        variant.formulas(&partial, at, self.form, self.contact).components()
    }

    /// Gradients and Hessians of the scalars, contracted with the directions, with bounds on their errors. The bounds
    /// are those of the formulas without faults.
    pub(super) fn matrices(&self, variant: &Variant) -> [[RunningError; 3]; SCALARS] {
        let (at, form, contact) = ((self.at.0.value, self.at.1.value), self.form, self.contact);
        let planted = if self.has_few_dofs() {
            let faulty = |step| self.padded_few(step).each_ref().map(|beam| map_padded(beam, of_value));
            variant.matrices(faulty, at, form, contact)
        } else {
            let faulty = |step| self.padded(step).each_ref().map(|beam| map_padded(beam, of_value));
            variant.matrices(faulty, at, form, contact)
        };
        let mut matrices = self.unmodified().matrices;
        for (row, planted) in matrices.iter_mut().zip(planted.into_iter().flatten()) {
            for (number, value) in row.iter_mut().zip(planted) {
                number.value = value;
            }
        }
        matrices
    }

    /// The functions of the kernel, and the kernel's numbers with bounds on their errors; nothing if a curve has no shape
    /// functions.
    ///
    /// The kernel chooses the formulation itself, so this only applies to evaluations in the chosen formulation.
    pub(super) fn kernel(&self) -> Option<(Vec<Returned>, Contracted<RunningError>)> {
        let beams = self.padded(Step::Now);
        let bounds = bounded_kernel(beams, self.sharp(), self.form, self.contact)?;
        let beams = beams.each_ref().map(|beam| map_padded(beam, |number| number.value));
        let dofs = self.beams.map(AnyBeam::dofs);
        Some((kernel_functions(&beams, dofs, &self.point, *self.contact), bounds))
    }

    /// The functions for any curve: of the closed form, and of automatic differentiation.
    pub(super) fn routes(&self) -> [Vec<Returned>; 2] {
        routes(self.partial_variations(Step::Now), &self.point, *self.contact)
    }

    fn unmodified(&self) -> &Unmodified {
        self.unmodified.get_or_init(|| {
            let Self { at, form, contact, .. } = self;
            let matrices = if self.has_few_dofs() {
                contracted(self.padded_few(Step::Now), self.sharp(), *form, contact)
            } else {
                contracted(self.padded(Step::Now), self.sharp(), *form, contact)
            };
            let bounds =
                Variant::Unmodified.formulas(&self.bounded(Step::Now), *at, *form, contact).components();
            let [beam, bar] = self.partial_variations(Step::Now);
            let plain = variations_in(*form, &beam, &bar, (at.0.value, at.1.value), contact).components();
            Box::new(Unmodified { plain, scales: self.sized(&Variant::Unmodified), bounds, matrices })
        })
    }

    /// Automatic differentiation in our own hyper-dual numbers, with bounds on its error.
    pub(crate) fn chord(&self) -> [Varied<RunningError2>; COMPONENTS] {
        let Self { beams: [beam, bar], contact, held, at, .. } = *self;
        let chord = Chord::<RunningError2>::new(beam, bar, at, held);
        chord.evaluate_by_orders(beam, bar, at, contact).map(Varied::from).components()
    }

    /// The closed form in double-double, at the closest point refined there. Its errors are measured against this.
    ///
    /// Nothing if Newton's method does not converge within the bounds of the parameters.
    pub(super) fn precise(&self) -> Option<[Varied<DoubleDouble>; COMPONENTS]> {
        let Self { beams: [beam, bar], contact, form, .. } = *self;
        let [xi, xi_bar] = self.refined()?.map(|refined| refined.value);
        let partial = [beam.partial_variations_precise(xi), bar.partial_variations_precise(xi_bar)];
        Some(variations_in(form, &partial[0], &partial[1], (xi, xi_bar), contact).components())
    }
}

fn of_value(number: RunningError) -> Faulty<f64> {
    Faulty(number.value)
}
