//! Teeth: whether a check turns red when a term is wrong, and stays green when it is only written another way.
//!
//! Every fault of the [catalogue](crate::variant::catalogue) and every [`Rewrite`](crate::variant::Rewrite) goes through
//! the gate and through the checks that are used elsewhere, in every regime, at the same closest points: inside, in both
//! forms of the closed form, and at the ends of beams that are linear in their dofs and of beams that are not. A fault that
//! no point shows survives; a rewrite, or the closed form as it is, that some point accuses is a false alarm.

mod check;
mod differences;
mod exact;
mod limit;
mod operations;
mod own;
mod run;
mod sampled;
mod test_points;

pub use check::Check;
pub use differences::Rule;
pub use limit::{Limit, limits};
pub use operations::{Lost, Operations, Unseen, all_operations};
pub use own::{Formula, operations_of, operations_of_curve};
pub use run::{Bite, Teeth, teeth};
pub use sampled::{Sampled, sampled};
