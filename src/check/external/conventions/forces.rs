//! The forces of a contact element in the conventions of another program.

use super::Conventions;
use crate::check::element::Forces;
use crate::linearization::Varied;
use crate::number::Real;

/// How a program gives the forces of a contact element with friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a choice of its own")]
pub struct ForceConventions {
    /// Whether `F_N` is negative in compression.
    pub compression_is_negative: bool,
    /// Whether F and `F_bar` are those of the force on the bar beam.
    pub on_bar: bool,
    /// Whether F and `F_bar` are contravariant components: T = F τ - `F_bar` `τ_bar` instead of F = T.τ and `F_bar` = -T.`τ_bar`.
    pub contravariant: bool,
    /// Whether `F_bar` belongs to `τ_bar` instead of -`τ_bar`.
    pub along_bar_tangent: bool,
}

impl ForceConventions {
    /// The state, and the forces in these conventions.
    pub(super) fn of<T: Real>(self, forces: &Forces<T>) -> [Varied<T>; 4] {
        let Forces { state, f_n, covariant, contravariant } = *forces;
        let [f, f_bar] = if self.contravariant { contravariant } else { covariant };
        let signed = |is_negative: bool, force: T| if is_negative { -force } else { force };
        [
            state,
            signed(self.compression_is_negative, f_n),
            signed(self.on_bar, f),
            signed(self.on_bar != self.along_bar_tangent, f_bar),
        ]
        .map(Varied::constant)
    }

    /// Other conventions that differ in one choice, each with its description.
    pub(super) fn others(self) -> [(Self, String); 4] {
        let told = |words: &str, key: &str, is_other: bool| {
            let value = Conventions::values(key)[usize::from(is_other)];
            format!("{words} (\"{key}\":\"{value}\")")
        };
        let Self { compression_is_negative, on_bar, contravariant, along_bar_tangent } = self;
        [
            (
                Self { compression_is_negative: !compression_is_negative, ..self },
                told("F_N has the other sign", "normal_force", !compression_is_negative),
            ),
            (
                Self { on_bar: !on_bar, ..self },
                told("the friction force is that on the other beam", "friction_force", !on_bar),
            ),
            (
                Self { contravariant: !contravariant, ..self },
                told("F and F_bar are other components", "friction_components", !contravariant),
            ),
            (
                Self { along_bar_tangent: !along_bar_tangent, ..self },
                told("F_bar has the other sign", "F_bar", !along_bar_tangent),
            ),
        ]
    }
}
