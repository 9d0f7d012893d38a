//! Which parameters are held, and the limits below which a point counts as degenerate.

/// Scaled eigenvalues below this are rounding: the point is singular.
pub(super) const SINGULAR: f64 = 1.4e-14;
/// Tangents shorter than this, relative to the change of the tangent along the beam, have no length.
pub(super) const STANDSTILL: f64 = 9e-13;
/// Scaled multipliers below this are zero: the end is weakly held.
pub(super) const WEAK: f64 = 9e-13;

/// Which parameters are held at an end, and hence do not vary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Held {
    /// xi is held.
    pub xi: bool,
    /// xi_bar is held.
    pub xi_bar: bool,
}
