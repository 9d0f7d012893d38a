//! The variations by an equivalent formula.

use super::Rewrite;
use super::invariance::by_invariance;
use super::rewrites::by_term;
use crate::linearization::closed_form::{Formulation, PartialVariations, variations_in};
use crate::linearization::{Quantities, Varied};
use crate::number::Real;
use crate::pair::Contact;

impl Rewrite {
    /// The variations, rewritten.
    pub(super) fn variations<T: Real>(
        self,
        beams: [&PartialVariations<T>; 2],
        at: (T, T),
        form: Formulation,
        contact: &Contact,
    ) -> Quantities<Varied<T>> {
        let unmodified = |[beam, bar]: [PartialVariations<T>; 2], at, form, contact: &Contact| {
            variations_in(form, &beam, &bar, at, contact)
        };
        by_invariance(self, &unmodified, beams, at, form, contact).unwrap_or_else(|| {
            by_term(self, beams, form.held, unmodified(beams.map(|beam| *beam), at, form, contact))
        })
    }
}
