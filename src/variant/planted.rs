//! Faults injected into terms: a factor, or the value that the term has in a run with other operands.

use super::fault::Kind;
use crate::number::{Label, Real, TermChange, recorded_terms, recorded_terms_with, with_terms};
use crate::pair::Contact;
use std::rc::Rc;

enumeration! {
    /// The beams and parameters of an evaluation.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub(crate) enum Step {
        /// Both at the closest point.
        Now,
        /// Both at the parameters of the step before.
        Before,
        /// At the closest point, but the beam in place of the bar beam.
        Forgotten,
    }
}

impl Step {
    /// The beams and parameters of this step, if the given ones are at their closest point.
    pub(crate) fn place<B: ?Sized, T: Real>(self, [beam, bar]: [&B; 2], at: (T, T)) -> ([&B; 2], (T, T)) {
        match self {
            Self::Now => ([beam, bar], at),
            Self::Before => ([beam, bar], before(at)),
            Self::Forgotten => ([beam, beam], at),
        }
    }
}

/// The distance of the parameters of a stale point from the current ones.
const LAG: f64 = 1.0 / 128.0;

/// The change of a term.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Planted {
    /// It is multiplied.
    Times(f64),
    /// It is computed from other operands.
    Operands(Kind),
}

impl From<Kind> for Planted {
    fn from(kind: Kind) -> Self {
        kind.factor().map_or(Self::Operands(kind), Self::Times)
    }
}

/// The beams, parameters and contact that replace the correct ones; the correct ones if nothing is replaced.
pub(super) fn mistaken<T: Real, B>(
    kind: Option<Kind>,
    beams: impl Fn(Step) -> [B; 2],
    (xi, xi_bar): (T, T),
    contact: Contact,
) -> ([B; 2], (T, T), Contact) {
    let Contact { radius, radius_bar, xi_0, xi_bar_0 } = contact;
    match kind {
        Some(Kind::Swapped) => {
            let [beam, bar] = beams(Step::Now);
            let contact = Contact { radius: radius_bar, radius_bar: radius, xi_0: xi_bar_0, xi_bar_0: xi_0 };
            ([bar, beam], (xi_bar, xi), contact)
        }
        Some(Kind::BarForgotten) => {
            let contact = Contact { radius, radius_bar: radius, xi_0, xi_bar_0: xi_0 };
            (beams(Step::Forgotten), (xi, xi_bar), contact)
        }
        Some(Kind::Stale) => (beams(Step::Before), before((xi, xi_bar)), contact),
        _ => (beams(Step::Now), (xi, xi_bar), contact),
    }
}

/// A run with faults; `run` runs the code with the given replacement of operands.
pub(super) fn with<R>(faults: &[(Label, Planted)], run: impl Fn(Option<Kind>) -> R) -> R {
    with_terms(changes(faults, &run), || run(None))
}

/// The same, with the names and the values of all terms, with their faults.
pub(super) fn recorded<R>(
    faults: &[(Label, Planted)],
    run: impl Fn(Option<Kind>) -> R,
) -> (R, Vec<Label>, Vec<u64>) {
    recorded_terms_with(changes(faults, &run), || run(None))
}

fn changes<R>(faults: &[(Label, Planted)], run: impl Fn(Option<Kind>) -> R) -> Vec<(Label, TermChange)> {
    let mut known: Vec<(Kind, Rc<[u64]>)> = Vec::new();
    let mut changes = Vec::with_capacity(faults.len());
    for &(label, planted) in faults {
        let kind = match planted {
            Planted::Times(factor) => {
                changes.push((label, TermChange::Times(factor)));
                continue;
            }
            Planted::Operands(kind) => kind,
        };
        let terms = known.iter().find(|(of, _)| *of == kind).map(|(_, terms)| Rc::clone(terms));
        let terms = terms.unwrap_or_else(|| {
            let terms: Rc<[u64]> = recorded_terms(|| run(Some(kind))).1.into();
            known.push((kind, Rc::clone(&terms)));
            terms
        });
        changes.push((label, TermChange::Instead(terms)));
        if kind == Kind::Transposed {
            changes.push((label, TermChange::Orders));
        }
    }
    changes
}

/// The parameters of the step before.
pub(crate) fn before<T: Real>((xi, xi_bar): (T, T)) -> (T, T) {
    (xi - T::from(LAG), xi_bar - T::from(LAG))
}
