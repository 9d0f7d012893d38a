//! The curve families of the check: their names, their parameters, and the units of their dofs.

enumeration! {
    /// A family of curves.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Family {
        /// Straight segment, 6 dofs.
        Segment => "segment",
        /// Quadratic Lagrange, 9 dofs.
        Quadratic => "quadratic",
        /// Cubic Lagrange, 12 dofs.
        Cubic => "cubic",
        /// Cubic Hermite with tangents d x/d xi, 12 dofs.
        Hermite => "hermite",
        /// Cubic Hermite with tangents scaled by a reference length, 12 dofs.
        HermiteScaled => "hermite-scaled",
        /// Bezier of degree 5, 18 dofs.
        Bezier => "bezier",
        /// Span of a cubic B-spline, 12 dofs.
        BSpline => "bspline",
        /// Span of a quadratic NURBS with fixed weights, 9 dofs.
        Nurbs => "nurbs",
        /// Span of a cubic NURBS with its weights as dofs, 16 dofs.
        NurbsWeighted => "nurbs-weighted",
        /// Circular arc, 9 dofs.
        Arc => "arc",
        /// Helix, 10 dofs.
        Helix => "helix",
    }
}

impl Family {
    /// Whether its curves are linear in their dofs.
    pub fn is_linear(self) -> bool {
        !matches!(self, Self::NurbsWeighted | Self::Arc | Self::Helix)
    }

    /// The family of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|family| family.name() == name)
    }

    /// The fixed parameters of the curve: the name and the count of numbers of each.
    pub fn parameters(self) -> &'static [(&'static str, usize)] {
        match self {
            Self::Segment | Self::Quadratic | Self::Cubic | Self::Hermite | Self::Bezier => &[],
            Self::HermiteScaled => &[("length", 1)],
            Self::BSpline | Self::NurbsWeighted => &[("knots", 6)],
            Self::Nurbs => &[("knots", 4), ("weights", 3)],
            Self::Arc | Self::Helix => &[("half_angle", 1)],
        }
    }

    /// The indices of the dofs where the points start.
    pub(crate) fn points(self) -> Vec<usize> {
        let coordinates = self.units().into_iter().enumerate().filter(|(_, unit)| *unit == Unit::Point);
        coordinates.map(|(i, _)| i).step_by(3).collect()
    }

    /// The indices of the dofs where the vectors start, points and others: these dofs change when the beam is rotated.
    pub(crate) fn vectors(self) -> Vec<usize> {
        match self {
            Self::Hermite | Self::HermiteScaled => vec![0, 3, 6, 9],
            _ => self.points(),
        }
    }

    /// The index of the dof where the quaternion starts, if there is one.
    pub(crate) fn quaternion(self) -> Option<usize> {
        match self {
            Self::Arc => Some(4),
            Self::Helix => Some(3),
            _ => None,
        }
    }

    /// The unit of each dof.
    pub fn units(self) -> Vec<Unit> {
        use Unit::{Length, Point, Pure};
        let repeated = |node: &[Unit], nodes: usize| node.repeat(nodes);
        match self {
            Self::Segment => repeated(&[Point; 3], 2),
            Self::Quadratic | Self::Nurbs => repeated(&[Point; 3], 3),
            Self::Cubic | Self::BSpline => repeated(&[Point; 3], 4),
            Self::Bezier => repeated(&[Point; 3], 6),
            Self::Hermite => repeated(&[Point, Point, Point, Length, Length, Length], 2),
            Self::HermiteScaled => repeated(&[Point, Point, Point, Pure, Pure, Pure], 2),
            Self::NurbsWeighted => repeated(&[Point, Point, Point, Pure], 4),
            Self::Arc => vec![Point, Point, Point, Length, Pure, Pure, Pure, Pure, Pure],
            Self::Helix => vec![Point, Point, Point, Pure, Pure, Pure, Pure, Length, Length, Pure],
        }
    }
}

/// The unit of a dof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A coordinate of a point, three in a row: a length that changes when the beam is moved.
    Point,
    /// Any other length, or a component of a vector of lengths.
    Length,
    /// A number without unit.
    Pure,
}
