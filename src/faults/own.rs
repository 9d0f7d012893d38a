//! Faults in every operation of the user's own code, one at a time.

use super::operations::{Lost, Operations, Undetected, examined};
use crate::curve::Curve;
use crate::number::{Bits, Faulty, PrimeField, Real, Traced};
use crate::test_beam::{AnyBeam, Drawn};
use crate::variant::Kind;
use nalgebra::SVector;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::fmt;

/// Code that computes numbers from numbers, over any scalar. It must not branch on the numbers.
pub trait Formula: Sync {
    /// All outputs for these inputs.
    fn numbers<T: Real>(&self, inputs: &[T]) -> Vec<T>;
}

/// Injects faults into each operation of a formula, with `inputs` random inputs.
///
/// The outputs must include all numbers that a check compares. An operation that does not affect any output is
/// not covered by a check. Operands are also replaced by those at other inputs.
///
/// ```
/// use beamgap::number::Real;
/// use beamgap::faults::{Formula, operations_of};
///
/// struct Norm;
/// impl Formula for Norm {
///     fn numbers<T: Real>(&self, v: &[T]) -> Vec<T> {
///         vec![(v[0] * v[0] + v[1] * v[1]).sqrt()]
///     }
/// }
/// let found = operations_of(&Norm, 2);
/// assert!(found.undetected.is_empty(), "{found}");
/// assert_eq!(found.to_string(), "All of 4 operations are covered.");
/// ```
pub fn operations_of(formula: &impl Formula, inputs: usize) -> Operations {
    let mut rng = ChaCha8Rng::seed_from_u64(0x5eed);
    let mut random = || -> Vec<Faulty<Traced>> {
        (0..inputs).map(|_| Faulty(Traced::from(PrimeField::new(rng.random())))).collect()
    };
    let (now, before) = (random(), random());
    let run = |kind: Option<Kind>| {
        let numbers = formula.numbers(if kind.is_some() { &before } else { &now });
        numbers.into_iter().map(|number| number.0.bits()).collect()
    };
    examined("formula".to_owned(), "-", &[Kind::Stale], &run)
}

/// Injects faults into each operation of the jet of a curve, with random dofs and directions.
///
/// [`check::curve`](crate::check::curve()) compares all quantities that depend on the jet. An operation that does not affect
/// any number of the jet is not covered by a check.
pub fn operations_of_curve<C, const N: usize>(curve: &C) -> Operations
where
    C: Curve<N> + Clone + fmt::Debug + Send + Sync + 'static,
{
    let mut rng = ChaCha8Rng::seed_from_u64(0x5eed);
    let zero = SVector::<f64, N>::zeros();
    let drawn = Drawn { curve: curve.clone(), q: zero, dq: zero, linear_dq: zero, points: Vec::new() };
    let mut random = || Traced::from(PrimeField::new(rng.random()));
    let (jets, now, before) = (drawn.jets(&mut random), random(), random());
    let run = |kind: Option<Kind>| jets(if kind.is_some() { before } else { now });
    examined("jet".to_owned(), "-", &[Kind::Stale], &run)
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.undetected.is_empty() {
            return write!(f, "All of {} operations are covered.", self.operations);
        }
        let count: usize = self.undetected.iter().map(|of| of.operations).sum();
        write!(f, "Of {} operations, {count} are not covered:", self.operations)?;
        for Undetected { at, term, wrong, lost, operations, .. } in &self.undetected {
            let at = if at.is_empty() { "an unknown line" } else { at };
            let term = term.as_ref().map_or_else(String::new, |term| format!(", in the term `{term}`"));
            let lost = match lost {
                Lost::Unused => "not used",
                Lost::TimesZero => "multiplied by zero",
                Lost::Cancels => "it cancels",
            };
            write!(f, "\n  {operations} at {at}{term}: {wrong} fault changes no number, {lost}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Formula, operations_of, operations_of_curve};
    use crate::curve::Hermite;
    use crate::number::{self, Label, Real};

    /// The square of a length, with an unused product.
    struct Square;

    impl Formula for Square {
        fn numbers<T: Real>(&self, v: &[T]) -> Vec<T> {
            let label = Label::of_beam(number::Formula::T, "v.v");
            let _ = v[0] * v[1];
            vec![(v[0] * v[0] + v[1] * v[1]).named(label)]
        }
    }

    #[test]
    fn what_no_number_depends_on_is_told_with_the_term_that_follows() {
        let found = operations_of(&Square, 2);
        assert_eq!((found.operations, found.undetected.len()), (4, 1));
        let text = found.to_string();
        assert!(text.starts_with("Of 4 operations, 1 are not covered:\n  1 at "), "{text}");
        assert!(text.ends_with(", in the term `|t|: v.v`: any fault changes no number, not used"), "{text}");
    }

    #[test]
    fn the_jet_of_a_curve_is_covered() {
        let found = operations_of_curve(&Hermite::new());
        assert!(found.operations > 200 && found.undetected.is_empty(), "{found}");
    }
}
