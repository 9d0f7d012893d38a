//! Why some operations do not affect any output, and the reasons that are known.

use crate::number::{Change, Traced, with_operation};
use serde::{Deserialize, Serialize};

/// Why no output depends on an operation. Marking the result of the operation determines it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Lost {
    /// Nothing uses it.
    Unused,
    /// It is multiplied by zero.
    TimesZero,
    /// It enters the outputs, but cancels.
    Cancels,
}

impl Lost {
    /// Marks the result of an operation, and searches for the mark in the outputs.
    pub(super) fn of(operation: usize, run: impl FnOnce() -> Vec<u64>) -> Self {
        let (numbers, times_zero) = Traced::run(|| with_operation(operation, Change::Marked, run));
        if numbers.into_iter().any(Traced::is_marked) {
            Self::Cancels
        } else if times_zero {
            Self::TimesZero
        } else {
            Self::Unused
        }
    }
}

/// Operations that may be lost, and the reason.
struct Reason {
    /// Why no output depends on them.
    lost: Lost,
    /// The prefix of the names of their codes.
    code: &'static str,
    /// The suffix of the names of their places.
    place: &'static str,
    /// A part of a path in the source that leads to them. It is not compared if the build has no line numbers.
    file: &'static str,
    why: &'static str,
}

const fn of(
    lost: Lost,
    code: &'static str,
    place: &'static str,
    file: &'static str,
    why: &'static str,
) -> Reason {
    Reason { lost, code, place, file, why }
}

const KERNEL: &str = "closed_form/kernel/";
const HELD: &str = "the variation of a parameter that an end holds is zero, and multiplies it";
const RATES: &str = "the rates of a parameter that an end holds are not used";
const NORMAL: &str = "the common normal belongs to a form that is not taken here";
const ROW: &str = "whole vectors are computed, and the layout takes a part of the last one";
const ZERO: &str = "it multiplies a component of a unit vector that is zero";
const RISE: &str = "the derivative in the pitch is not used, because an arc has no pitch";
const ZERO_OR_PITCH: &str =
    "it multiplies a component of a unit vector that is zero, or the pitch, which is zero for an arc";

const HESS_T: &str = "the Hessian of |t| enters with the paper's work only";
const UNIT: &str = "the common normal has unit length, so a factor cancels";
const ONE_SLIP: &str = "the force of one slip alone is mu F_N, which does not depend on the slip";

const REASONS: [Reason; 22] = [
    of(Lost::TimesZero, "", " end", "", HELD),
    of(Lost::TimesZero, "", " ends", "", HELD),
    of(Lost::Unused, "equations", " end", "closed_form/", RATES),
    of(Lost::Unused, "equations", " ends", "closed_form/", RATES),
    of(Lost::Unused, "kernel", " end", KERNEL, NORMAL),
    of(Lost::Unused, "kernel", " ends", KERNEL, NORMAL),
    of(Lost::Unused, "kernel, full", "length, determinants", KERNEL, NORMAL),
    of(Lost::Unused, "kernel, full", "normal, cross", KERNEL, "two systems are computed, and one is taken"),
    of(Lost::Unused, "kernel, blocks", "", KERNEL, ROW),
    of(Lost::Unused, "kernel, packed", "", KERNEL, ROW),
    of(Lost::Unused, "kernel, gradient", "", KERNEL, "a gradient does not use what is of second order"),
    of(Lost::Unused, "contact element, stick", "", "closed_form/matrices.rs", HESS_T),
    of(Lost::Unused, "contact element, slip", "", "closed_form/matrices.rs", HESS_T),
    of(Lost::Cancels, "matrices", "", "closed_form/formulation.rs", "t x t_bar enters by its square"),
    of(Lost::Cancels, "contact element", "", "closed_form/formulation.rs", "t x t_bar enters by its square"),
    of(Lost::Cancels, "contact element", "", "contact/geometry.rs", UNIT),
    of(Lost::Cancels, "contact element", " end", "contact/closed_form/assemble.rs", ONE_SLIP),
    of(Lost::Cancels, "jet of nurbs", "", "curve/bspline.rs", "a factor of all basis functions cancels"),
    of(
        Lost::TimesZero,
        "jet of nurbs-weighted",
        "",
        "curve/nurbs",
        "it multiplies x relative to x, which is zero",
    ),
    of(Lost::TimesZero, "jet of helix", "", "curve/screw", ZERO),
    of(Lost::TimesZero, "jet of arc", "", "curve/screw", ZERO_OR_PITCH),
    of(Lost::Unused, "jet of arc", "", "curve/screw", RISE),
];

/// The reason why an operation may be lost, from the lines of the source that lead to it; none if it may not be lost.
pub(super) fn reason(lost: Lost, code: &str, place: &str, at: &[String]) -> Option<&'static str> {
    let is_there = |file: &str| at.is_empty() || at.iter().any(|line| line.contains(file));
    let holds = |of: &&Reason| {
        of.lost == lost && code.starts_with(of.code) && place.ends_with(of.place) && is_there(of.file)
    };
    REASONS.iter().find(holds).map(|of| of.why)
}

#[cfg(test)]
mod tests {
    use super::{Lost, reason};

    #[test]
    fn an_operation_that_nothing_uses_has_a_reason_in_its_place_only() {
        let at = [String::from("linearization/closed_form/kernel/frame.rs:46")];
        let of = |lost, code, place| reason(lost, code, place, &at).is_some();
        assert!(of(Lost::TimesZero, "matrices, other curves", "xi at an end"));
        assert!(!of(Lost::TimesZero, "matrices, other curves", "normal, determinants"));
        assert!(!of(Lost::Unused, "matrices, other curves", "xi at an end"));
        assert!(!of(Lost::Cancels, "equations", "both at ends"));
        assert!(of(Lost::Unused, "kernel, full", "length, determinants"));
        assert!(!of(Lost::Unused, "kernel, full", "normal, determinants"));
        let elsewhere = [String::from("linearization/closed_form/projection.rs:12")];
        assert_eq!(reason(Lost::Unused, "kernel, full", "length, determinants", &elsewhere), None);
    }
}
