//! Fault injection: whether a check fails when a term is wrong, and passes when a formula is only rewritten equivalently.
//!
//! Every fault of the [catalogue](crate::variant::catalogue) and every [`Rewrite`](crate::variant::Rewrite) is put
//! through the gate and through other common checks. All checks evaluate the same closest points in every
//! regime: inside both beams, in all four formulations of the closed form, and at the ends. The beams are linear in their
//! dofs or not. A fault is undetected if the check passes at every point. A rewrite that the check rejects at some point is
//! a false positive.

mod check;
mod differences;
mod elements;
mod exact;
mod gate;
mod limit;
mod operations;
mod own;
mod run;
mod sampled;
mod search;
mod sides;
mod steps;
mod test_points;

pub use check::Check;
pub use differences::Rule;
pub use elements::{ElementFaults, element_faults};
pub use gate::{Compared, Gate, gate};
pub use limit::{Limit, limits};
pub use operations::{Lost, Operations, Undetected, all_operations};
pub use own::{Formula, operations_of, operations_of_curve};
pub use run::{Detection, Injected, Missed, inject};
pub use sampled::{Limits, Sampled, sampled};
pub use search::{SearchDetection, SearchFaults, search_faults};
pub use sides::{OneSided, one_sided};
