//! Equivalent formulas: they equal those of the library, so a check must accept them.

enumeration! {
    /// The equivalent formula.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Rewrite {
        /// delta d with all terms of (36), of which orthogonality removes two.
        AllTermsOfD => "dd by (36), with the terms that orthogonality removes",
        /// Delta-delta d as the second variation of any norm, (35).
        SecondDAsNorm => "Ddd by (35), as of any norm",
        /// Delta-delta d by (39), corrected.
        SecondDLinearized => "Ddd by (39), corrected",
        /// Delta-delta d with the bracket of (40) in a, b and a_bar, which shows its symmetry.
        SecondDSymmetric => "Ddd with its bracket in a, b and a_bar",
        /// Delta-delta d by the projector on the plane normal to d.
        SecondDProjected => "Ddd by the projector normal to d",
        /// The same, with the projector where the vector is normal to d already.
        SecondDProjectedTwice => "Ddd with the projector on what is normal to d already",
        /// delta xi by elimination instead of Cramer's rule.
        System => "dxi by elimination",
        /// delta xi by the symmetric matrix, the Hessian of half the squared distance.
        SymmetricMatrix => "dxi by the symmetric matrix",
        /// delta xi by unit tangents.
        UnitTangents => "dxi by unit tangents",
        /// D by the cross product of the tangents.
        CrossProduct => "dxi with D by the cross product of the tangents",
        /// delta t along the unit tangent.
        UnitTangentOfT => "dt along the unit tangent",
        /// Delta-delta t by the projector on the plane normal to t.
        SecondTProjected => "Ddt by the projector normal to t",
        /// Delta-delta t as the derivative of a quotient, (34).
        SecondTAsQuotient => "Ddt by (34), as of a quotient",
        /// Delta-delta t with the cube of t, (58) corrected.
        SecondTCubed => "Ddt by (58), corrected, with the cube of t",
        /// The norms of vectors of a ninth the length.
        NormsOfNinths => "d and t as norms of a ninth of the vectors",
        /// Delta-delta g_T with its terms in another order.
        SlipReordered => "Ddg_T with its terms in another order",
        /// x_bar as x minus d.
        XBarFromD => "x_bar as x less d",
        /// Delta and delta exchanged, and their results too.
        DirectionsExchanged => "directions exchanged, and back",
        /// The mean with the directions exchanged.
        Symmetrized => "the mean with the directions exchanged",
        /// Beam and bar beam exchanged, and their results too.
        BeamsExchanged => "beams exchanged, and back",
        /// Lengths in a ninth of the unit.
        Ninths => "lengths in a ninth of the unit, and back",
        /// Both beams moved.
        Moved => "both beams moved, and back",
        /// Both beams rotated.
        Turned => "both beams turned, and back",
        /// The beam with its direction reversed.
        Reversed => "the beam reversed, and back",
        /// The beam with another unit of its parameter.
        Reparametrized => "the beam's parameter in another unit, and back",
        /// Directions of three times the length.
        LongDirections => "directions of three times the length, and back",
    }
}
