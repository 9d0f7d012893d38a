//! The forces and lengths of a contact.

use super::geometry::Gap;
use crate::number::Real;
use nalgebra::Vector3;

/// The forces and lengths of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Values<T> {
    /// g_N, a length.
    pub g_n: T,
    /// n, the unit normal from the bar beam to the beam.
    pub normal: Vector3<T>,
    /// F_N, positive in compression.
    pub f_n: T,
    /// T, the friction force on the beam; the bar beam has -T.
    pub traction: Vector3<T>,
    /// F = T·τ, the friction force along the beam; 0 if xi is held.
    pub f: T,
    /// F̄ = -T·τ̄; 0 if xi_bar is held.
    pub f_bar: T,
    /// g_T, the slip of the step along the beam, a length.
    pub g_t: T,
    /// g_T_bar, the slip of the step along the bar beam.
    pub g_t_bar: T,
    /// e, the elastic slip after the return.
    pub e: T,
    /// e_bar, the same along the bar beam.
    pub e_bar: T,
    /// rho, the factor of the return: 1 in stick, less in slip.
    pub rho: T,
    /// Phi/(mu F_N) with Phi = eps_T gamma - mu F_N: at most 0 in stick. -1 without friction.
    pub yield_ratio: T,
}

impl<T: Real> Values<T> {
    /// No force.
    pub(super) fn open(gap: &Gap<T>) -> Self {
        let zero = T::zero();
        Self {
            g_n: gap.g_n,
            normal: gap.n,
            f_n: zero,
            traction: Vector3::zeros(),
            f: zero,
            f_bar: zero,
            g_t: zero,
            g_t_bar: zero,
            e: zero,
            e_bar: zero,
            rho: T::one(),
            yield_ratio: -T::one(),
        }
    }
}
