//! The regimes: the kinds of pairs that the check draws.

use super::serialized::by_name;
use crate::pair::Contact;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{FRAC_PI_2, PI};

enumeration! {
    /// A kind of pair, chosen for the faults that other kinds do not detect.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Regime {
        /// Lengths near 1, moderate bending, crossing at a wide angle.
        Generic => "generic",
        /// A distance of 1e-4 to 1e-2 of the length.
        Slender => "slender",
        /// Bent by 1e-6 to 1e-3 radians only. Arcs and helices are then wound about an axis far away.
        NearlyStraight => "nearly-straight",
        /// Bent by 2 to 5 radians.
        StronglyCurved => "strongly-curved",
        /// Crossing at an angle of 1e-4 to 1e-1 radians.
        NearlyParallel => "nearly-parallel",
        /// A distance of 1e-8 to 1e-3 of the length.
        NearlyCrossing => "nearly-crossing",
        /// The crossing within 1e-6 to 1e-1 of an end of one beam or both, or beyond it.
        NearEnd => "near-end",
        /// A fibre measured in metres: lengths near 1e-6.
        Metres => "metres",
        /// Measured in millimetres: lengths near 1e3.
        Millimetres => "millimetres",
        /// A generic pair with up to three of its dofs, and of its directions, times 1e-8 to 1e8, some of them negative: one
        /// control point far away, say, or end parameters within 1e-9 of an end.
        BadlyScaled => "badly-scaled",
    }
}

/// The drawn numbers of a regime.
///
/// Each symmetry of the problem has a sign that is drawn, or a distribution that the symmetry does not change; the
/// beams are drawn in random frames. So both sides of each [`Symmetry`](super::Symmetry) are equally frequent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Draw {
    /// Length of a beam.
    pub(super) length: f64,
    /// Distance of the centroids over the length.
    pub(super) gap: f64,
    /// 1 if d points along t × t_bar at the crossing, -1 if it points against it.
    pub(super) side: f64,
    /// Whether the surfaces penetrate at the crossing.
    pub(super) closed: bool,
    /// Angle between the tangents, acute or obtuse.
    pub(super) angle: f64,
    /// The sign of the torsion of each beam.
    pub(super) hand: [f64; 2],
    /// Turning angle of each beam.
    pub(super) bend: [f64; 2],
    /// Parameters of the crossing.
    pub(super) at: [f64; 2],
}

by_name!(Regime);

impl Regime {
    /// The regime of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|regime| regime.name() == name)
    }

    /// The pairs of beams that it draws, in words.
    pub fn what(self) -> &'static str {
        match self {
            Self::Generic => "lengths near 1, moderate bending, crossing at a wide angle",
            Self::Slender => "a distance of 1e-4 to 1e-2 of the length",
            Self::NearlyStraight => "bent by 1e-6 to 1e-3 radians only",
            Self::StronglyCurved => "bent by 2 to 5 radians",
            Self::NearlyParallel => "crossing at an angle of 1e-4 to 1e-1 radians",
            Self::NearlyCrossing => "a distance of 1e-8 to 1e-3 of the length",
            Self::NearEnd => "the crossing within 1e-6 to 1e-1 of an end of one beam or both, or beyond it",
            Self::Metres => "a fibre measured in metres: lengths near 1e-6",
            Self::Millimetres => "measured in millimetres: lengths near 1e3",
            Self::BadlyScaled => {
                "up to three dofs and direction entries times 1e-8 to 1e8, or parameters within 1e-9 of an end"
            }
        }
    }

    /// Draws the numbers of a case.
    pub(super) fn draw(self, rng: &mut ChaCha8Rng) -> Draw {
        let length = rng.random_range(0.7..1.4);
        let is_obtuse: bool = rng.random();
        let mut generic = Draw {
            length,
            gap: rng.random_range(0.02..0.3),
            side: sign(rng),
            closed: rng.random(),
            angle: rng.random_range(0.5..FRAC_PI_2),
            hand: [sign(rng), sign(rng)],
            bend: [rng.random_range(0.05..1.0), rng.random_range(0.05..1.0)],
            at: crossing(rng),
        };
        let mut power = |low: f64, high: f64| 10_f64.powf(rng.random_range(low..high));
        if self == Self::NearlyParallel {
            generic.angle = power(-4.0, -1.0);
        }
        if is_obtuse {
            generic.angle = PI - generic.angle;
        }
        match self {
            Self::Generic | Self::NearlyParallel => generic,
            Self::BadlyScaled => {
                let mut near_end = generic;
                if rng.random_ratio(1, 4) {
                    let distance = 10_f64.powf(rng.random_range(-9.0..-6.0));
                    near_end.at[rng.random_range(0..2)] = sign(rng) * (1.0 - distance);
                }
                near_end
            }
            Self::Slender => Draw { gap: power(-4.0, -2.0), ..generic },
            Self::NearlyStraight => Draw { bend: [power(-6.0, -3.0), power(-6.0, -3.0)], ..generic },
            Self::StronglyCurved => {
                Draw { bend: [rng.random_range(2.0..5.0), rng.random_range(2.0..5.0)], ..generic }
            }
            Self::NearlyCrossing => Draw { gap: power(-8.0, -3.0), ..generic },
            Self::NearEnd => {
                // Within the beam for a positive distance, beyond its end for a negative one.
                let mut near = || {
                    let distance = 10_f64.powf(rng.random_range(-6.0..-1.0));
                    let inside = if rng.random() { 1.0 - distance } else { 1.0 + distance };
                    sign(rng) * inside
                };
                let (one, other) = (near(), near());
                let at = match rng.random_range(0..3) {
                    0 => [one, generic.at[1]],
                    1 => [generic.at[0], other],
                    _ => [one, other],
                };
                Draw { at, ..generic }
            }
            Self::Metres => Draw { length: 1e-6 * length, ..generic },
            Self::Millimetres => Draw { length: 1e3 * length, ..generic },
        }
    }
}

impl Draw {
    /// Radii and reference parameters. The surfaces penetrate at the crossing, where the centroids have this distance,
    /// if `closed` says so.
    pub(super) fn contact(&self, length: f64, distance: f64, rng: &mut ChaCha8Rng) -> Contact {
        let gap = self.gap * length;
        let radii = if self.closed {
            distance * rng.random_range(1.05..1.5) + length * rng.random_range(0.01..0.1)
        } else {
            gap * rng.random_range(0.1..0.9)
        };
        let share = rng.random_range(0.1..0.9);
        Contact {
            radius: radii * share,
            radius_bar: radii * (1.0 - share),
            xi_0: rng.random_range(-1.0..1.0),
            xi_bar_0: rng.random_range(-1.0..1.0),
        }
    }
}

/// 1 or -1.
pub(super) fn sign(rng: &mut ChaCha8Rng) -> f64 {
    if rng.random() { 1.0 } else { -1.0 }
}

/// The crossing of the beams: mostly within both, in one of eight cases beyond an end of one, which is then held.
fn crossing(rng: &mut ChaCha8Rng) -> [f64; 2] {
    let mut at = [rng.random_range(-0.8..0.8), rng.random_range(-0.8..0.8)];
    if rng.random_ratio(1, 8) {
        let beyond = rng.random_range(1.02..1.3);
        at[rng.random_range(0..2)] = sign(rng) * beyond;
    }
    at
}
