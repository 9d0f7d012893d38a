//! The check for linearizations in any language: cases out, answers in, through the comparison of
//! [`linearization`](super::linearization).
//!
//! [`Vector`]s are written for another program ([`VectorWriter`]). It answers some of the quantities that they allow
//! ([`Answers`]).

mod answers;
mod conventions;
mod error;
mod evaluate;
mod json;
mod lines;
mod number;
mod vectors;

pub use answers::{ANSWERS, AnswerReader, Answers};
pub use conventions::{Conventions, Dofs, Length, Penalty, Range};
pub use evaluate::{Evaluator, Formulas};
pub use error::{ExternalError, Place};
pub use number::{NotANumber, hex, parse};
pub use vectors::{Drawing, Expected, Outcome, VECTORS, Vector, VectorReader, VectorWriter};
