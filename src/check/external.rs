//! The check for linearizations in any language. It writes cases and compares the answers as in
//! [`linearization`](super::linearization).
//!
//! [`Vector`]s are written for another program ([`VectorWriter`]). It answers some of the quantities that they allow
//! ([`Answers`]).

mod answered;
mod answers;
mod compare;
mod conventions;
mod diagnose;
mod error;
mod evaluate;
mod explain;
mod few_digits;
mod json;
mod lines;
mod location;
mod matching;
mod no_dof;
mod number;
mod only;
mod process;
mod recent;
mod report;
mod shape;
mod stages;
mod vectors;
mod which_entries;

pub use answers::{ANSWERS, AnswerReader, Answers, Program};
pub use compare::{CaseFound, Demands, Judged, Judgement, compare_answers};
pub use conventions::{Conventions, Dofs, ForceConventions, Length, Penalty, Range, Triangle};
pub use diagnose::{OtherConventions, other_conventions};
pub use error::{ExternalError, Place};
pub use evaluate::{Evaluator, Formulas};
pub(crate) use explain::explain_own;
pub use explain::{
    Cause, ExplainedFault, Explanation, Naming, Programs, RunnerUp, explain, explained_faults,
};
pub use few_digits::{FewDigits, FewKind, Precision, few_digits};
pub use location::{Location, locate};
pub use matching::Matching;
pub use number::{NotANumber, hex, parse};
pub use only::{Only, PartKey, is_of_element};
pub use process::{InputState, ProcessError, Runner};
pub use report::{Coverage, Loss, PartFound, RegimeFound, Report, SearchFound};
pub use shape::Shape;
pub use stages::LIST_OF_FORMULAS;
pub use vectors::{Drawing, Expected, Outcome, StepDofs, VECTORS, Vector, VectorReader, VectorWriter};
