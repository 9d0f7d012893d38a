//! The linearization by automatic differentiation, from positions alone.
//!
//! The dofs are given perturbations (q + eps1 dq + eps2 Dq for two directions, or one per dof). The parameters of the
//! closest point are *lifted*: extended to the dual numbers that still satisfy the conditions of the closest point.
//! Then the definitions (4)-(15) are evaluated, and their dual parts are the variations.
//!
//! There are three routes of lifting. They differ in what they share:
//! - [`Route::Newton`]: orthogonality conditions d.t = d.t_bar = 0, by num-dual's `implicit_derivative_binary`;
//! - [`Route::Stationary`]: stationarity of the squared distance, as in num-dual's `implicit_derivative_sp`; shares no
//!   equation with the first;
//! - [`Route::Chord`]: orthogonality conditions, by Newton steps whose matrix stays real. Each step gains one order.
//!
//! Matrices need one direction for each dof. The sweeps differ in how many they take at once and in what they share:
//! - [`expand_by_sweep`]: one pair of dofs at a time, by any route;
//! - [`expand_by_vector_dual`]: all dofs at once; [`expand_by_rows`]: one dof against a few, both by chord steps;
//! - [`expand_by_orders`], [`expand_d_by_orders`]: the first order once, the second by the implicit function theorem.
//!   d alone needs no second order of the parameters, by the envelope theorem.

mod evaluate;
pub mod lift;
mod orders;
mod sweep;

pub use evaluate::{Perturbed, PositionAt, evaluate};
pub use lift::{Chord, newton, stationary};
pub use orders::{expand_by_orders, expand_by_rows, expand_d_by_orders};
pub use sweep::{HyperBeam, Route, chord, expand_by_sweep, expand_by_vector_dual, hyper_dual, seeded, vary};
