//! Wrong parts of a contact element: its residual, and both parts of its tangent.

use crate::check::external::conventions::Conventions;
use crate::linearization::Varied;

/// The factors on the residual k g ∇g and on the two parts of the tangent k ∇g ∇gᵀ + k g H, with the stiffness k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Element {
    pub(super) residual: f64,
    pub(super) material: f64,
    pub(super) geometric: f64,
}

pub(super) const CORRECT: Element = Element { residual: 1.0, material: 1.0, geometric: 1.0 };

impl Element {
    /// Applies the factors to the energy, after the conventions. `gap` is g_N before the conventions.
    pub(super) fn apply(self, energy: &mut Varied<f64>, gap: &Varied<f64>, conventions: &Conventions) {
        let Some(material) = material(energy.second, [gap.delta, gap.linear], conventions) else { return };
        energy.delta *= self.residual;
        energy.linear *= self.residual;
        energy.second = self.material * material + self.geometric * (energy.second - material);
    }

    /// Whether all parts have the same factor, as with a wrong stiffness.
    fn stiffness(self) -> Option<f64> {
        let is_same = |factor: f64| (factor - self.residual).abs() <= 1e-9 * factor.abs();
        (is_same(self.material) && is_same(self.geometric)).then_some(self.residual)
    }

    /// The complexity: a part that is missing is as simple as a simplification.
    pub(super) fn class(self) -> usize {
        if self.words_of_missing().is_some() { 1 } else { 2 }
    }

    fn words_of_missing(self) -> Option<[&'static str; 2]> {
        if self == (Self { geometric: 0.0, ..CORRECT }) {
            return Some([
                "geometric-stiffness-missing",
                "the geometric part of the tangent of the contact element, the penalty times g_N H, is missing",
            ]);
        }
        (self == Self { material: 0.0, ..CORRECT }).then_some([
            "material-stiffness-missing",
            "the part of the tangent of the contact element with the product of the gradients is missing",
        ])
    }

    /// The factors other than one, each with its name and its words.
    pub(super) fn factors(self) -> impl Iterator<Item = ([&'static str; 2], f64)> {
        let all = [
            (["residual", "the residual of the contact element"], self.residual),
            (
                ["material-stiffness", "the part of its tangent with the product of the gradients"],
                self.material,
            ),
            (["geometric-stiffness", "the geometric part of its tangent, g_N H,"], self.geometric),
        ];
        all.into_iter().filter(|(_, factor)| (factor - 1.0).abs() > 1e-12)
    }

    pub(super) fn name(self) -> String {
        if let Some([name, _]) = self.words_of_missing() {
            return name.into();
        }
        if let Some(factor) = self.stiffness() {
            return format!("penalty-stiffness = times {factor:.6}");
        }
        let factors = self.factors().map(|([name, _], factor)| format!("{name} = times {factor:.6}"));
        factors.collect::<Vec<_>>().join(" and ")
    }

    pub(super) fn words(self) -> String {
        if let Some([_, words]) = self.words_of_missing() {
            return words.into();
        }
        if let Some(factor) = self.stiffness() {
            return format!("the penalty stiffness is {factor:.6} times the stated one");
        }
        let factors =
            self.factors().map(|([_, words], factor)| format!("{words} is multiplied by {factor:.6}"));
        factors.collect::<Vec<_>>().join("; and ")
    }
}

/// The part of the tangent with the product of the gradients of the gap, contracted with the directions. Nothing
/// without an element.
pub(super) fn material(second: f64, [delta, linear]: [f64; 2], conventions: &Conventions) -> Option<f64> {
    let sign = if conventions.tangent_is_negative { -1.0 } else { 1.0 };
    let stiffness = conventions.penalty?.stiffness;
    // An element that is not active has no tangent.
    Some(if second == 0.0 { 0.0 } else { sign * stiffness * delta * linear })
}
