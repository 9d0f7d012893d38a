//! The closed form under check: unmodified, with faults, or with a formula rewritten equivalently.
//!
//! Every check takes a [`Variant`] and runs the library's own code with it. It must fail for each fault of the
//! [`catalogue`] and pass for each [`Rewrite`].

mod catalogue;
mod fault;
mod functions;
mod invariance;
mod kernel;
mod layouts;
mod planted;
mod point;
mod read;
mod rewrite;
mod rewrites;
mod rewritten;

pub use catalogue::{catalogue, catalogue_in_parts, with_faults};
pub(crate) use catalogue::{classes, labels, terms};
pub use fault::{Fault, Kind, UnknownFault};
pub use rewrite::Rewrite;

pub(crate) use functions::{ROUTE_ENTRIES, Returned, kernel_entries, kernel_functions, of_curves, routes};
pub(crate) use invariance::by_invariance;
pub(crate) use kernel::{Layouts, bounded_kernel, every_layout, kernel};
pub(crate) use layouts::Second;
pub(crate) use planted::Step;
pub(crate) use point::{CONTACT, Point};
pub(crate) use read::Contracted;

use crate::linearization::closed_form::{Formulation, Matrices, PartialVariations, variations_in};
use crate::linearization::{Linearization, Quantities, Quantity, Varied};
use crate::number::{Bits, Change, Faulty, Label, Real, with_operation};
use crate::pair::{Contact, DofVector};
use crate::test_beam::PaddedBeam;
use planted::{Planted, mistaken};

/// The number of scalar quantities that have matrices.
pub(crate) const SCALARS: usize = 7;

/// The component g_N.
pub(crate) const G_N: usize = Quantity::GN.component();

/// The components (of the variations) that have matrices.
pub(crate) const SCALAR_COMPONENTS: [usize; SCALARS] = [
    Quantity::D.component(),
    Quantity::T.component(),
    Quantity::TBar.component(),
    Quantity::Xi.component(),
    Quantity::XiBar.component(),
    Quantity::GT.component(),
    Quantity::GTBar.component(),
];

/// The scalar whose derivatives a component has: g_N has those of d.
pub(crate) fn scalar_of(component: usize) -> Option<usize> {
    let of = if component == G_N { SCALAR_COMPONENTS[0] } else { component };
    SCALAR_COMPONENTS.iter().position(|&scalar| scalar == of)
}

/// The closed form under check.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Variant {
    /// Without a change.
    #[default]
    Unmodified,
    /// With all of these faults at once.
    Faulty(Vec<Fault>),
    /// With one formula replaced by an equal one.
    Rewritten(Rewrite),
    /// With one term multiplied.
    Weighted(Label, f64),
    /// With the result of one operation multiplied.
    Operation(Code, usize, f64),
}

enumeration! {
    /// The code that an operation belongs to.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Code {
        /// The paper's equations.
        Equations => "equations",
        /// Gradients and Hessians.
        Matrices => "matrices",
    }
}

impl Variant {
    /// The faults that are injected into these terms; nothing if there are none.
    fn planted(&self, terms: &[Label]) -> Option<Vec<(Label, Planted)>> {
        let mut planted: Vec<_> = match self {
            Self::Unmodified | Self::Rewritten(_) | Self::Operation(..) => return None,
            Self::Faulty(faults) => {
                faults.iter().map(|fault| (fault.label, Planted::from(fault.kind))).collect()
            }
            Self::Weighted(label, factor) => vec![(*label, Planted::Times(*factor))],
        };
        planted.retain(|(label, _)| terms.contains(label));
        (!planted.is_empty()).then_some(planted)
    }

    /// Whether the variant differs from the unmodified closed form where these terms are evaluated.
    pub(crate) fn changes(&self, terms: &[Label]) -> bool {
        matches!(self, Self::Rewritten(_) | Self::Operation(..)) || self.planted(terms).is_some()
    }

    /// The operation of this code that is multiplied.
    fn operation(&self, of: Code) -> Option<(usize, f64)> {
        match self {
            &Self::Operation(code, number, factor) if code == of => Some((number, factor)),
            _ => None,
        }
    }

    /// All quantities with their variations, of beams at fixed parameters, over a scalar that allows fault injection.
    pub(crate) fn quantities<T: Bits>(
        &self,
        partial: impl Fn(Step) -> [PartialVariations<T>; 2],
        at: (T, T),
        form: Formulation,
        contact: &Contact,
    ) -> Quantities<Varied<T>> {
        let (faults, operation) = (self.planted(&terms()[0]), self.operation(Code::Equations));
        if faults.is_none() && operation.is_none() {
            return self.formulas(&partial(Step::Now), at, form, contact);
        }
        let run = |kind| mistaken_quantities(kind, &partial, at, form, *contact);
        let quantities = match operation {
            Some((number, factor)) => with_operation(number, Change::Times(factor), || run(None)),
            None => planted::with(&faults.unwrap_or_default(), run),
        };
        quantities.map(|varied| varied.map(|Faulty(number)| number))
    }

    /// The same with the value of each term, with its fault, in the order of evaluation. Only faults are injected.
    pub(crate) fn terms(
        &self,
        partial: impl Fn(Step) -> [PartialVariations<f64>; 2],
        at: (f64, f64),
        form: Formulation,
        contact: &Contact,
    ) -> (Quantities<Varied<f64>>, Vec<(Label, f64)>) {
        let faults = self.planted(&terms()[0]).unwrap_or_default();
        let run = |kind| mistaken_quantities(kind, &partial, at, form, *contact);
        let (quantities, labels, values) = planted::recorded(&faults, run);
        let values = values.into_iter().map(f64::from_bits);
        (
            quantities.map(|varied| varied.map(|Faulty(number)| number)),
            labels.into_iter().zip(values).collect(),
        )
    }

    /// The same over any scalar, without the faults.
    pub(crate) fn formulas<T: Real>(
        &self,
        [beam, bar]: &[PartialVariations<T>; 2],
        at: (T, T),
        form: Formulation,
        contact: &Contact,
    ) -> Quantities<Varied<T>> {
        match self {
            Self::Rewritten(rewrite) => rewrite.variations([beam, bar], at, form, contact),
            _ => variations_in(form, beam, bar, at, contact),
        }
    }

    /// Gradients (along both directions) and Hessians of the scalars, contracted, of padded beams; nothing if the
    /// variant does not change them.
    pub(crate) fn matrices<T: Bits, const D: usize>(
        &self,
        padded: impl Fn(Step) -> [PaddedBeam<Faulty<T>, D>; 2],
        (xi, xi_bar): (T, T),
        form: Formulation,
        contact: &Contact,
    ) -> Option<[[T; 3]; SCALARS]> {
        let rows = self.of_beams(padded, (xi, xi_bar), form, contact, contracted)?;
        Some(rows.map(|row| row.map(|Faulty(number)| number)))
    }

    /// The same, not contracted.
    pub(crate) fn linearized<T: Bits, const D: usize>(
        &self,
        padded: impl Fn(Step) -> [PaddedBeam<Faulty<T>, D>; 2],
        at: (T, T),
        form: Formulation,
        contact: &Contact,
    ) -> Option<Box<Linearization<Faulty<T>, D, D>>> {
        self.of_beams(padded, at, form, contact, linearized)
    }

    /// The result of `of` for padded beams if terms of the matrices have faults; nothing if none has.
    fn of_beams<T: Bits, R, const D: usize>(
        &self,
        padded: impl Fn(Step) -> [PaddedBeam<Faulty<T>, D>; 2],
        (xi, xi_bar): (T, T),
        form: Formulation,
        contact: &Contact,
        of: impl Fn(&[PaddedBeam<Faulty<T>, D>; 2], (Faulty<T>, Faulty<T>), Formulation, &Contact) -> R,
    ) -> Option<R> {
        let run = |kind: Option<Kind>| {
            let (beams, at, contact) = mistaken(kind, &padded, (Faulty(xi), Faulty(xi_bar)), *contact);
            of(&beams, at, form, &contact)
        };
        Some(match self.operation(Code::Matrices) {
            Some((number, factor)) => with_operation(number, Change::Times(factor), || run(None)),
            None => planted::with(&self.planted(&terms()[1])?, run),
        })
    }
}

/// All quantities with their variations, with operands that a mistake of this kind replaces.
fn mistaken_quantities<T: Bits>(
    kind: Option<Kind>,
    partial: &impl Fn(Step) -> [PartialVariations<T>; 2],
    at: (T, T),
    form: Formulation,
    contact: Contact,
) -> Quantities<Varied<Faulty<T>>> {
    let ([mut beam, mut bar], (xi, xi_bar), contact) = mistaken(kind, partial, at, contact);
    if kind == Some(Kind::Transposed) {
        (beam, bar) = (beam.exchanged(), bar.exchanged());
    }
    let [beam, bar] = [beam, bar].map(|partial| partial.map(|v| v.map(Faulty)));
    variations_in(form, &beam, &bar, (Faulty(xi), Faulty(xi_bar)), &contact)
}

/// Gradients and Hessians of the scalars, of padded beams.
#[expect(clippy::unnecessary_box_returns, reason = "a hundred thousand bytes")]
pub(crate) fn linearized<T: Real, const D: usize>(
    [(jet, _), (jet_bar, _)]: &[PaddedBeam<T, D>; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
) -> Box<Linearization<T, D, D>> {
    let mut all = Box::new(Linearization::zeros());
    Matrices::in_formulation(jet, jet_bar, form).write_all(at, contact, &mut all);
    all
}

/// Gradients (along both directions) and Hessians of the scalars, contracted, of padded beams.
pub(crate) fn contracted<T: Real, const D: usize>(
    [(jet, [_, dq, linear_dq]), (jet_bar, [_, dq_bar, linear_dq_bar])]: &[PaddedBeam<T, D>; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
) -> [[T; 3]; SCALARS] {
    let mut all = Linearization::zeros();
    Matrices::in_formulation(jet, jet_bar, form).write_all(at, contact, &mut all);
    let dq = DofVector { beam: *dq, bar: *dq_bar };
    let linear_dq = DofVector { beam: *linear_dq, bar: *linear_dq_bar };
    [&all.d, &all.t, &all.t_bar, &all.xi, &all.xi_bar, &all.g_t, &all.g_t_bar]
        .map(|e| [e.gradient.along(&dq), e.gradient.along(&linear_dq), e.hessian.along(&dq, &linear_dq)])
}
