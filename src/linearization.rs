//! First and second variations of the contact geometry, in closed form and by automatic differentiation.
//!
//! Both compute the same results. [`closed_form`] evaluates the formulas of the paper with the jets of the curves. [`ad`]
//! differentiates positions and uses no formula of the paper. Both take the closest point as given. They do not iterate to a
//! tolerance, and they return a result for every input.

pub mod ad;
pub mod closed_form;
mod derivatives;
pub(crate) mod dispatch;
mod quantities;
mod reused;

pub use derivatives::{BlockHessian, Derivatives, Linearization};
pub use quantities::{COMPONENTS, Quantities, Quantity, Varied};
pub use reused::Linearized;
