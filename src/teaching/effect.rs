//! The effect of one wrong term: on the variations of the standard case, on a test of symmetry, and on Newton's method.

use super::{Problem, Tangent};
use crate::closest_point::ProjectionError;
use crate::curve::{Curve, Hermite};
use crate::equations::StandardCase;
use crate::linearization::closed_form::{Formulation, PartialVariations, variations_in};
use crate::linearization::{Quantities, Varied};
use crate::number::{Faulty, Formula, Label, TermChange, with_terms};
use serde::{Deserialize, Serialize};

/// A fault of the self-checks: a term and the factor that it is multiplied by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SelfCheck {
    /// The equation that contains the term.
    pub equation: u8,
    /// The term in the variations.
    pub term: Label,
    /// The same term in the Hessian of d, if the Hessian contains it.
    pub in_hessian: Option<Label>,
    /// The factor: 0 if the term is missing, -1 if its sign is wrong.
    pub factor: f64,
}

/// The effect of a fault.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Effect {
    /// The equation that contains the term.
    pub equation: u8,
    /// The term and its fault.
    pub fault: String,
    /// The relative deviations of Delta-delta d, Delta-delta xi, Delta-delta t and Delta-delta g_T.
    pub deviations: [f64; 4],
    /// Whether Delta-delta of all four is unchanged, up to rounding, when the directions are exchanged.
    pub is_symmetric: bool,
    /// The iterations of Newton's method with this fault in the Hessian of d, if it converged.
    pub iterations: Option<usize>,
    /// Why it did not converge.
    pub stopped: Option<String>,
    /// Whether the Hessian of d contains the term.
    pub in_hessian: bool,
}

/// The faults of the self-checks.
pub const SELF_CHECKS: [SelfCheck; 6] = [
    SelfCheck {
        equation: 50,
        term: Label::of_beam(Formula::A, "d.t,xi"),
        in_hessian: Some(Label::of_beam(Formula::A, "d.t,xi")),
        factor: 0.0,
    },
    SelfCheck {
        equation: 52,
        term: Label::of_beam(Formula::Xi, "b R_bar"),
        in_hessian: Some(Label::of_beam(Formula::Xi, "b R_bar")),
        factor: -1.0,
    },
    SelfCheck {
        equation: 40,
        term: Label::of_beam(Formula::SecondD, "d.turned"),
        in_hessian: None,
        factor: 0.0,
    },
    SelfCheck {
        equation: 40,
        term: Label::of_beam(Formula::SecondD, "dd Dd"),
        in_hessian: Some(Label::of_beam(Formula::HessianD, "G'nn'G")),
        factor: 0.0,
    },
    SelfCheck {
        equation: 42,
        term: Label::of_beam(Formula::SecondT, "Dt.dt"),
        in_hessian: None,
        factor: 0.0,
    },
    SelfCheck {
        equation: 54,
        term: Label::of_beam(Formula::SecondR, "Dd.dt"),
        in_hessian: None,
        factor: 0.0,
    },
];

impl SelfCheck {
    /// Injects the fault.
    ///
    /// # Errors
    /// None, as for [`StandardCase::closest_point`].
    pub fn effect(&self) -> Result<Effect, ProjectionError> {
        let case = StandardCase::default();
        let form = Formulation::paper(case.closest_point()?.held());
        let (right, wrong) = (self.seconds(&case, form, false)?, self.seconds(&case, form, true)?);
        let exchanged = StandardCase { dq: case.linear_dq, linear_dq: case.dq, ..case };
        let exchanged = self.seconds(&exchanged, form, true)?;
        let relative = |i: usize, other: [f64; 4]| ((wrong[i] - other[i]) / right[i]).abs();
        let run = self.in_hessian.map(|label| Problem::default().solve(Tangent::Term(label, self.factor)));
        let what = if self.factor == 0.0 { "missing" } else { "of the wrong sign" };
        Ok(Effect {
            equation: self.equation,
            fault: format!("{}, {what}", self.term),
            deviations: [0, 1, 2, 3].map(|i| relative(i, right)),
            is_symmetric: (0..4).all(|i| relative(i, exchanged) < 1e-12),
            iterations: run.as_ref().filter(|run| run.converged()).map(super::Equilibrium::iterations),
            stopped: run.and_then(|run| run.stopped),
            in_hessian: self.in_hessian.is_some(),
        })
    }

    /// Delta-delta of d, xi, t and g_T in a formulation, with the fault or without it.
    fn seconds(
        &self,
        case: &StandardCase,
        form: Formulation,
        with_fault: bool,
    ) -> Result<[f64; 4], ProjectionError> {
        let point = case.closest_point()?;
        let StandardCase { pair, q, dq, linear_dq } = case;
        let partial = |q: &_, dq: &_, linear: &_, xi| {
            PartialVariations::new(&Hermite::new().jet(q, xi), dq, linear).map(|v| v.map(Faulty))
        };
        let beam = partial(&q.beam, &dq.beam, &linear_dq.beam, point.xi);
        let bar = partial(&q.bar, &dq.bar, &linear_dq.bar, point.xi_bar);
        let factor = if with_fault { self.factor } else { 1.0 };
        let all: Quantities<Varied<Faulty<f64>>> =
            with_terms(vec![(self.term, TermChange::Times(factor))], || {
                let at = (Faulty(point.xi), Faulty(point.xi_bar));
                variations_in(form, &beam, &bar, at, &pair.contact)
            });
        Ok([all.d, all.xi, all.t, all.g_t].map(|varied| varied.second.0))
    }
}

#[cfg(test)]
mod tests {
    use super::SELF_CHECKS;
    use crate::closest_point::Held;
    use crate::equations::StandardCase;
    use crate::linearization::closed_form::Formulation;
    use crate::linearization::closed_form::formulation::{Distance, System};

    /// What the first exercise, the front page and the guides say about a test of symmetry.
    #[test]
    fn symmetry_shows_a_missing_curvature_term_only_by_cross_products_with_40() {
        let case = StandardCase::default();
        let exchanged = StandardCase { dq: case.linear_dq, linear_dq: case.dq, ..case };
        let alike = StandardCase { linear_dq: case.dq, ..case };
        for distance in [Distance::Length, Distance::Normal { reversed: false }] {
            for system in [System::Determinants, System::CrossProducts] {
                let form = Formulation { held: Held::default(), distance, system };
                let seconds = |case, fault| SELF_CHECKS[0].seconds(case, form, fault).unwrap();
                let differ = |one: [f64; 4], other: [f64; 4]| {
                    one.iter().zip(other).any(|(one, other)| (one / other - 1.0).abs() > 1e-11)
                };
                let detects = differ(seconds(&case, true), seconds(&exchanged, true));
                let is_both = distance == Distance::Length && system == System::CrossProducts;
                assert_eq!(detects, is_both, "{form:?}");
                assert!(!differ(seconds(&case, false), seconds(&exchanged, false)), "{form:?}");
                // A Taylor test of d along one direction.
                let [wrong, right] = [true, false].map(|fault| seconds(&alike, fault)[0]);
                assert!((wrong / right - 1.0).abs() > 1e-3, "{form:?}");
            }
        }
    }
}
