//! The lengths of the tangents and the slips, with their variations.

use crate::linearization::Varied;
use crate::number::{Formula, Real, Which};
use nalgebra::Vector3;

/// t = |t|.
#[inline]
#[doc(alias = "Eq. (9)")]
pub fn length<T: Real>(which: Which, t: &Vector3<T>) -> T {
    // Eq. (9): t = ‖t‖
    which.named(Formula::T, "t.t", t.dot(t)).sqrt()
}

/// δt, of the length, from δt of the vector.
#[inline]
#[doc(alias = "Eq. (33)")]
#[doc(alias = "Eq. (41)")]
pub fn delta_length<T: Real>(which: Which, t: &Vector3<T>, length: T, delta_t: &Vector3<T>) -> T {
    // Eq. (33), (41): δt = t·δt/t
    which.named(Formula::DeltaT, "t.dt", t.dot(delta_t)) / length
}

/// Δδt, of the length, from its first variations `first` along delta and Delta, and from those of the vector.
#[inline]
#[doc(alias = "Eq. (35)")]
#[doc(alias = "Eq. (42)")]
#[doc(alias = "Eq. (58)")]
pub fn second_length<T: Real>(
    which: Which,
    t: &Vector3<T>,
    length: T,
    first: [T; 2],
    [delta_t, linear_t, second_t]: [&Vector3<T>; 3],
) -> T {
    // Eq. (35), (42), (58) corrected: Δδt = (t·Δδt + Δt·δt − δt Δt)/t, where the last term has lengths
    (which.named(Formula::SecondT, "t.Ddt", t.dot(second_t))
        + which.named(Formula::SecondT, "Dt.dt", linear_t.dot(delta_t))
        - which.named(Formula::SecondT, "dt Dt", first[0] * first[1]))
        / length
}

/// g_T, from the length t and `slip` = ξ_C − ξ_C₀.
#[inline]
#[doc(alias = "Eq. (14)")]
#[doc(alias = "Eq. (15)")]
pub fn slip<T: Real>(which: Which, t: T, slip: T) -> T {
    // Eq. (14), (15): g_T = t (ξ_C − ξ_C₀)
    which.named(Formula::GT, "t slip", t * slip)
}

/// δg_T.
#[inline]
#[doc(alias = "Eq. (20)")]
pub fn delta_slip<T: Real>(which: Which, t: T, slip: T, [delta_t, delta_xi]: [T; 2]) -> T {
    // Eq. (20): δg_T = δt (ξ_C − ξ_C₀) + t δξ_C
    which.named(Formula::DeltaGT, "dt slip", delta_t * slip)
        + which.named(Formula::DeltaGT, "t dxi", t * delta_xi)
}

/// Δδg_T.
#[inline]
#[doc(alias = "Eq. (21)")]
pub fn second_slip<T: Real>(which: Which, t: &Varied<T>, slip: T, xi: &Varied<T>) -> T {
    // Eq. (21): Δδg_T = Δδt (ξ_C − ξ_C₀) + δt Δξ_C + Δt δξ_C + t Δδξ_C
    which.named(Formula::SecondGT, "Ddt slip", t.second * slip)
        + which.named(Formula::SecondGT, "dt Dxi", t.delta * xi.linear)
        + which.named(Formula::SecondGT, "Dt dxi", t.linear * xi.delta)
        + which.named(Formula::SecondGT, "t Ddxi", t.value * xi.second)
}
