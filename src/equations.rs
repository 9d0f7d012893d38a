//! The equations of the paper, as printed and as corrected, and their verdicts.
//!
//! The table has each equation once, generic over the scalar, with the LaTeX of the print next to the formula. It is run
//! over the prime field of [`prove`](crate::prove), at stationary pairs of all families, and in `f64`, at closest points of
//! the [check](crate::check). The reference is hyper-dual differentiation. An equation uses reference values for everything
//! except itself, so each equation is judged alone.
//!
//! # Verdicts
//! - Exact: the print is equal in every draw.
//! - Exact if linear: the print is equal for curves that are linear in their dofs, and refuted for others. The paper drops
//!   terms that it calls of higher order; they are of the order of the terms that it keeps.
//! - Misprint: the print is refuted for linear curves too, and the correction is equal in every draw.
//! - Refuted: the correction is refuted. The table is then not valid.
//! - Definitions, lists, assumptions and equations that are missing in the scan need no evidence.
//!
//! A print without a meaning has several readings. Each reading is evaluated.
//!
//! # Symmetry
//! Formulas of second order are evaluated again with delta and Delta exchanged: at stationary pairs, and with independent
//! random numbers for all operands. A formula that is symmetric for random numbers is symmetric by its form. A formula that
//! is symmetric at stationary pairs only is symmetric by relations between its operands: (25) and (29) need the chain rule,
//! (34) needs (33), and (38), (39), (40) and (57) need that d is normal to both tangents.
//!
//! # Places
//! The lines that compute an equation are found in the source by `Eq. (40)` in a comment or in a doc alias.

mod arc;
mod claim;
mod field;
mod judgement;
mod list;
mod paper;
mod plain;
mod point;
mod record;
mod run;
mod source;
mod standard;
mod table;
mod tally;
mod verdict;
mod worked;

pub use arc::Arc;
pub use record::{Claim, Counts, EquationRow, EquationTable, Part, Run, Score};
pub use run::{CASES, DRAWS, equation_table};
pub use source::{Definition, Place, SOURCES, definition, named, places};
pub use standard::StandardCase;
pub use table::{Kind, Order, Reading};
pub use verdict::{Symmetry, Verdict};
pub use worked::{Worked, WorkedPart, WorkedReading, worked_at};
