//! First and second variations of the contact geometry, twice: in closed form and by automatic differentiation.
//!
//! The two are siblings with the same results. [`closed_form`] sees the jets of the curves and knows the formulas of
//! the paper; [`ad`] sees positions only and knows no formula. Both are total: they neither iterate to a tolerance
//! nor branch on values, and take the closest point as given.

pub mod ad;
pub mod closed_form;
mod derivatives;
mod dispatch;
mod quantities;

pub use derivatives::{BlockHessian, Derivatives, Linearization};
pub use quantities::{COMPONENTS, Quantities, Quantity, Varied};
