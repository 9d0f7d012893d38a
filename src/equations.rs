//! The table: every equation of the paper, as printed and as corrected, and what became of it when it was run.
//!
//! Each equation is entered once, generic over the scalar, with the LaTeX of the print next to the formula that it
//! prints. It is run over the prime field of [`prove`](crate::prove), at stationary pairs of all families, where it is
//! equal to the truth or refuted; and in `f64`, at closest points of the [gate](crate::check), where its error has a
//! size. The truth is that of hyper-dual numbers; whatever an equation takes besides itself is true as well, so each is
//! judged alone.
//!
//! # Verdicts
//! A verdict follows from the evidence. Printed and always equal: exact. Printed, equal for curves that are linear in
//! their dofs and refuted for others: exact for those, since what the paper drops as of higher order is of the order of
//! what it keeps. Refuted for curves that are linear as well: a misprint, if the correction is equal everywhere; if it is
//! not, the table does not hold. Given, not found, is only what needs no proof: that an equation is a definition, a list
//! or an assumption, or that the scan has lost it. What is printed but has no meaning is read in several ways, and all are
//! run.
//!
//! # Symmetry
//! Everything of second order is run once more with delta and Delta exchanged: at stationary pairs, and with random
//! numbers for everything that it takes. What is symmetric there too is so by its form, the rest by orthogonality.
//!
//! # Where
//! That an equation is computed somewhere is read off the source: `Eq. (40)` in a comment or in a doc alias.

mod arc;
mod claim;
mod field;
mod list;
mod paper;
mod plain;
mod point;
mod record;
mod run;
mod source;
mod table;
mod tally;
mod verdict;

pub use arc::Arc;
pub use claim::Claim;
pub use record::{Counts, EquationRow, EquationTable, Part, Run, Score};
pub use run::{CASES, DRAWS, equation_table};
pub use source::{Place, SOURCES, named, places};
pub use table::{Kind, Order, Reading};
pub use verdict::{Symmetry, Verdict};
