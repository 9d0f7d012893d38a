//! Equivalent formulas: they equal those of the library, so a check must accept them.

use super::invariance::by_invariance;
use super::rewrites::by_term;
use crate::linearization::closed_form::{Formulation, PartialVariations, variations_in};
use crate::linearization::{Quantities, Varied};
use crate::number::Real;
use crate::pair::Contact;

/// The equivalent formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rewrite {
    /// delta d with all terms of (36), of which orthogonality removes two.
    AllTermsOfD,
    /// Delta-delta d as the second variation of any norm, (35).
    SecondDAsNorm,
    /// Delta-delta d by (39), corrected.
    SecondDLinearized,
    /// Delta-delta d with the bracket of (40) in a, b and a_bar, which shows its symmetry.
    SecondDSymmetric,
    /// Delta-delta d by the projector on the plane normal to d.
    SecondDProjected,
    /// The same, with the projector where the vector is normal to d already.
    SecondDProjectedTwice,
    /// delta xi by elimination instead of Cramer's rule.
    System,
    /// delta xi by the symmetric matrix, the Hessian of half the squared distance.
    SymmetricMatrix,
    /// delta xi by unit tangents.
    UnitTangents,
    /// D by the cross product of the tangents.
    CrossProduct,
    /// delta t along the unit tangent.
    UnitTangentOfT,
    /// Delta-delta t by the projector on the plane normal to t.
    SecondTProjected,
    /// Delta-delta t as the derivative of a quotient, (34).
    SecondTAsQuotient,
    /// Delta-delta t with the cube of t, (58) corrected.
    SecondTCubed,
    /// The norms of vectors of a ninth the length.
    NormsOfNinths,
    /// Delta-delta g_T with its terms in another order.
    SlipReordered,
    /// x_bar as x minus d.
    XBarFromD,
    /// Delta and delta exchanged, and their results too.
    DirectionsExchanged,
    /// The mean with the directions exchanged.
    Symmetrized,
    /// Beam and bar beam exchanged, and their results too.
    BeamsExchanged,
    /// Lengths in a ninth of the unit.
    Ninths,
    /// Both beams moved.
    Moved,
    /// Both beams rotated.
    Turned,
    /// The beam with its direction reversed.
    Reversed,
    /// The beam with another unit of its parameter.
    Reparametrized,
    /// Directions of three times the length.
    LongDirections,
}

impl Rewrite {
    /// All rewrites.
    pub const ALL: [Self; 26] = [
        Self::AllTermsOfD,
        Self::SecondDAsNorm,
        Self::SecondDLinearized,
        Self::SecondDSymmetric,
        Self::SecondDProjected,
        Self::SecondDProjectedTwice,
        Self::System,
        Self::SymmetricMatrix,
        Self::UnitTangents,
        Self::CrossProduct,
        Self::UnitTangentOfT,
        Self::SecondTProjected,
        Self::SecondTAsQuotient,
        Self::SecondTCubed,
        Self::NormsOfNinths,
        Self::SlipReordered,
        Self::XBarFromD,
        Self::DirectionsExchanged,
        Self::Symmetrized,
        Self::BeamsExchanged,
        Self::Ninths,
        Self::Moved,
        Self::Turned,
        Self::Reversed,
        Self::Reparametrized,
        Self::LongDirections,
    ];

    /// The name of the rewrite.
    pub fn name(self) -> &'static str {
        match self {
            Self::AllTermsOfD => "dd by (36), with the terms that orthogonality removes",
            Self::SecondDAsNorm => "Ddd by (35), as of any norm",
            Self::SecondDLinearized => "Ddd by (39), corrected",
            Self::SecondDSymmetric => "Ddd with its bracket in a, b and a_bar",
            Self::SecondDProjected => "Ddd by the projector normal to d",
            Self::SecondDProjectedTwice => "Ddd with the projector on what is normal to d already",
            Self::System => "dxi by elimination",
            Self::SymmetricMatrix => "dxi by the symmetric matrix",
            Self::UnitTangents => "dxi by unit tangents",
            Self::CrossProduct => "dxi with D by the cross product of the tangents",
            Self::UnitTangentOfT => "dt along the unit tangent",
            Self::SecondTProjected => "Ddt by the projector normal to t",
            Self::SecondTAsQuotient => "Ddt by (34), as of a quotient",
            Self::SecondTCubed => "Ddt by (58), corrected, with the cube of t",
            Self::NormsOfNinths => "d and t as norms of a ninth of the vectors",
            Self::SlipReordered => "Ddg_T with its terms in another order",
            Self::XBarFromD => "x_bar as x less d",
            Self::DirectionsExchanged => "directions exchanged, and back",
            Self::Symmetrized => "the mean with the directions exchanged",
            Self::BeamsExchanged => "beams exchanged, and back",
            Self::Ninths => "lengths in a ninth of the unit, and back",
            Self::Moved => "both beams moved, and back",
            Self::Turned => "both beams turned, and back",
            Self::Reversed => "the beam reversed, and back",
            Self::Reparametrized => "the beam's parameter in another unit, and back",
            Self::LongDirections => "directions of three times the length, and back",
        }
    }

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
