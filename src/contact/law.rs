//! The normal law: the contact force F_N as a function of the gap g_N.

use crate::number::Real;
use std::fmt::Debug;

/// A normal law F_N(g_N), piece by piece.
///
/// The piece is chosen once, in `f64`. After that every number type evaluates the same formulas. F_N must be continuous.
pub trait NormalLaw {
    /// The pieces of the law that have a force.
    type Piece: Copy + Debug + PartialEq;

    /// The piece at a gap, or `None` if F_N = 0 there: the contact is open.
    fn piece(&self, g_n: f64) -> Option<Self::Piece>;

    /// F_N, positive in compression.
    fn force<T: Real>(&self, piece: Self::Piece, g_n: T) -> T;

    /// k = −dF_N/dg_N.
    fn stiffness<T: Real>(&self, piece: Self::Piece, g_n: T) -> T;

    /// E with F_N = −dE/dg_N, if there is an energy.
    fn energy<T: Real>(&self, _piece: Self::Piece, _g_n: T) -> Option<T> {
        None
    }

    /// The gap at which the contact opens, a length.
    fn opening_gap(&self) -> f64;

    /// The first parameter that is out of range: its name and its value.
    fn invalid_parameter(&self) -> Option<(&'static str, f64)> {
        None
    }
}

/// The normal laws of this crate. The penalty `eps` is a force over a length.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Law {
    /// F_N = −eps g_N for g_N < 0.
    #[doc(alias = "penalty")]
    Linear {
        /// eps_N > 0.
        eps: f64,
    },
    /// A parabola for 0 < g_N < g_0 and a line below. F_N has a continuous derivative.
    #[doc(alias = "LinPosQuadPen")]
    Lpqp {
        /// eps_N > 0, the slope of the line.
        eps: f64,
        /// g_0 > 0, the gap at which the force begins, a length.
        g_0: f64,
    },
    /// F_N = lambda − eps g_N where this is positive: the linear law with a multiplier that is constant within a step.
    #[doc(alias = "Uzawa")]
    Augmented {
        /// eps_N > 0.
        eps: f64,
        /// lambda >= 0, a force.
        lambda: f64,
    },
}

/// The pieces of a [`Law`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Piece {
    /// F_N is linear in g_N.
    Line,
    /// F_N is quadratic in g_N.
    Parabola,
}

impl NormalLaw for Law {
    type Piece = Piece;

    fn piece(&self, g_n: f64) -> Option<Piece> {
        match *self {
            Self::Lpqp { g_0, .. } if g_n > 0.0 => (g_n < g_0).then_some(Piece::Parabola),
            Self::Lpqp { .. } => Some(Piece::Line),
            Self::Linear { .. } => (g_n < 0.0).then_some(Piece::Line),
            Self::Augmented { eps, lambda } => (lambda - eps * g_n > 0.0).then_some(Piece::Line),
        }
    }

    fn force<T: Real>(&self, piece: Piece, g_n: T) -> T {
        match *self {
            Self::Linear { eps } => -T::from(eps) * g_n,
            Self::Augmented { eps, lambda } => T::from(lambda) - T::from(eps) * g_n,
            Self::Lpqp { eps, g_0 } => {
                let (eps, g_0) = (T::from(eps), T::from(g_0));
                match piece {
                    Piece::Line => eps * (T::from(0.5) * g_0 - g_n),
                    Piece::Parabola => eps * (g_n - g_0) * (g_n - g_0) / (g_0 + g_0),
                }
            }
        }
    }

    fn stiffness<T: Real>(&self, piece: Piece, g_n: T) -> T {
        match (*self, piece) {
            (Self::Lpqp { eps, g_0 }, Piece::Parabola) => T::from(eps) * (T::from(g_0) - g_n) / T::from(g_0),
            (Self::Linear { eps } | Self::Lpqp { eps, .. } | Self::Augmented { eps, .. }, _) => T::from(eps),
        }
    }

    fn energy<T: Real>(&self, piece: Piece, g_n: T) -> Option<T> {
        let half = T::from(0.5);
        Some(match *self {
            Self::Linear { eps } => half * T::from(eps) * g_n * g_n,
            Self::Augmented { eps, lambda } => {
                let force = T::from(lambda) - T::from(eps) * g_n;
                half * force * force / T::from(eps)
            }
            Self::Lpqp { eps, g_0 } => {
                let (eps, g_0, six) = (T::from(eps), T::from(g_0), T::from(6.0));
                match piece {
                    Piece::Line => eps * (half * g_n * (g_n - g_0) + g_0 * g_0 / six),
                    Piece::Parabola => {
                        let rest = g_0 - g_n;
                        eps * rest * rest * rest / (six * g_0)
                    }
                }
            }
        })
    }

    fn opening_gap(&self) -> f64 {
        match *self {
            Self::Linear { .. } => 0.0,
            Self::Lpqp { g_0, .. } => g_0,
            Self::Augmented { eps, lambda } => lambda / eps,
        }
    }

    fn invalid_parameter(&self) -> Option<(&'static str, f64)> {
        let is_positive = |value: f64| value > 0.0 && value.is_finite();
        let (Self::Linear { eps } | Self::Lpqp { eps, .. } | Self::Augmented { eps, .. }) = *self;
        match *self {
            _ if !is_positive(eps) => Some(("eps_N", eps)),
            Self::Lpqp { g_0, .. } if !is_positive(g_0) => Some(("g_0", g_0)),
            Self::Augmented { lambda, .. } if !(lambda >= 0.0 && lambda.is_finite()) => {
                Some(("lambda", lambda))
            }
            _ => None,
        }
    }
}

impl Law {
    /// The law of the next cycle of Uzawa's method: lambda becomes F_N. Other laws stay as they are.
    #[must_use]
    pub fn updated(self, f_n: f64) -> Self {
        match self {
            Self::Augmented { eps, .. } => Self::Augmented { eps, lambda: f_n },
            _ => self,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Law, NormalLaw, Piece};
    use crate::number::{Differentiable, DoubleDouble};

    const LAWS: [Law; 3] = [
        Law::Linear { eps: 3.0 },
        Law::Lpqp { eps: 3.0, g_0: 0.25 },
        Law::Augmented { eps: 3.0, lambda: 0.75 },
    ];

    #[test]
    fn force_and_stiffness_are_derivatives() {
        for law in LAWS {
            for piece in [Piece::Line, Piece::Parabola] {
                for g_n in [-0.375, -0.0625, 0.125] {
                    let g_n = DoubleDouble::from(g_n).dual(1.0);
                    let (_, slope) = DoubleDouble::parts(law.energy(piece, g_n).unwrap());
                    let (force, slope_of_force) = DoubleDouble::parts(law.force(piece, g_n));
                    let stiffness = law.stiffness(piece, g_n.re);
                    assert!((force + slope).abs().value() < 1e-30, "{law:?} {piece:?}");
                    assert!((stiffness + slope_of_force).abs().value() < 1e-30, "{law:?} {piece:?}");
                }
            }
        }
    }

    #[test]
    fn the_force_is_continuous_and_zero_where_the_contact_opens() {
        for law in LAWS {
            assert_eq!(law.piece(law.opening_gap()), None, "{law:?}");
            let near = law.opening_gap() - 1e-9;
            let force = law.force(law.piece(near).unwrap(), near);
            assert!(force > 0.0 && force < 1e-8, "{law:?}");
        }
        let law = LAWS[1];
        let at_zero = |piece| (law.force(piece, 0.0), law.stiffness(piece, 0.0), law.energy(piece, 0.0));
        assert_eq!(at_zero(Piece::Line), at_zero(Piece::Parabola));
    }

    #[test]
    fn invalid_parameters_are_named() {
        let named = |law: Law| law.invalid_parameter().map(|(name, _)| name);
        assert_eq!(named(Law::Linear { eps: 0.0 }), Some("eps_N"));
        assert_eq!(named(Law::Lpqp { eps: 1.0, g_0: -1.0 }), Some("g_0"));
        assert_eq!(named(Law::Augmented { eps: 1.0, lambda: f64::NAN }), Some("lambda"));
        assert_eq!(named(Law::Linear { eps: 1.0 }), None);
    }
}
