//! The example of the derivation: two elastic beams in contact, solved by Newton's method.
//!
//! `examples/newton.rs` prints the effect of a missing or wrong term of the tangent. The page of the derivation draws
//! it.
//!
//! # The tangent of a contact element in five minutes
//! A penalty gives the energy E = eps g_N²/2 of a stiff spring in the gap. Its gradient is the force, its Hessian the
//! tangent:
//!
//! ```text
//! ∇E = eps g_N ∇g_N        Hess E = eps (∇g_N ∇g_Nᵀ + g_N Hess g_N)        g_N = d − (r + r̄)
//! ```
//!
//! The closest points slide along the beams as the dofs Q vary. Their parameters p = (ξ, ξ̄) are functions of Q, and
//! d(Q) = f(p(Q), Q) with f,p = 0. The envelope theorem follows by the chain rule:
//!
//! ```text
//! ∇d = f,Q        Hess d = f,QQ + f,Qp ∇p        f,pp ∇p = −f,pQ
//! ```
//!
//! The gradient needs no derivative of the parameters. The Hessian needs the first derivatives. The slip g_T = t (ξ − ξ₀) of
//! friction contains ξ itself, so its Hessian needs Hess ξ. For this the paper derives second variations of ξ. Normal
//! contact does not need them.
//!
//! ```
//! use beamgap::teaching::{Problem, Tangent};
//!
//! let problem = Problem::default();
//! let iterations = |tangent| problem.solve(tangent).iterations();
//! assert!(iterations(Tangent::Exact) < 6);
//! assert!(iterations(Tangent::NoCurvature) > 10);
//! assert!(!problem.solve(Tangent::FrozenProjection).converged());
//! ```

pub mod chains;
#[cfg(feature = "check")]
mod contact;
#[cfg(feature = "check")]
mod effect;
mod elastic;
#[cfg(feature = "check")]
pub mod published;
#[cfg(feature = "check")]
mod solve;
pub mod terms;

#[cfg(feature = "check")]
pub use contact::{Contribution, Tangent, contact};
#[cfg(feature = "check")]
pub use effect::{Effect, SELF_CHECKS, SelfCheck};
pub use elastic::{Beam, DOFS, FREE, Material};
#[cfg(feature = "check")]
pub use solve::{Equilibrium, Iterate, Problem};
