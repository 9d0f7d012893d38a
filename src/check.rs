//! The gate: random pairs of beams, in regimes that are known to hide faults, through both linearizations.
//!
//! A case is drawn from its number alone, its closest points are searched for, and at each of them the closed form is
//! compared with automatic differentiation, in the [`Formulation`](crate::linearization::closed_form::Formulation) that the library takes
//! there: every quantity's value, first and second variations, the symmetry of the second, and the matrices contracted with
//! the same directions.
//!
//! # The tolerance
//! Both sides are also run over [`RunningError`](crate::number::RunningError), which yields for every number a bound on its
//! distance from exact arithmetic: each operation contributes half an ulp of its result, and passes on what its
//! operands have. The closest point is refined in double-double, so that its parameters enter with little more than their
//! own half ulp; routes that solve for it in `f64` again are held to the bound that their residual and the conditioning
//! of the projection give. |closed - AD| must not exceed the sum of the two bounds. So the tolerance is a multiple of
//! epsilon derived from the number of operations and the conditioning of the case, entry by entry; no entry is
//! compared with an absolute number.
//!
//! # The third oracle
//! Central differences of the value in double-double share no derivative with either side, and bring their own estimate
//! of their error. They are asked for a sample of the cases ([`Oracles`]), and wherever closed form and AD disagree: then
//! they say which of the two is wrong ([`Arbitration`]). Oracles that disagree among themselves condemn the check, not
//! the closed form.
//!
//! # What is shown
//! What is *shown* is the error relative to its scale, the sum of the absolute values of the closed form's terms
//! ([`TermScale`](crate::number::TermScale)), with the vectors that enter it counted by their length and a parameter by
//! its range. The scale knows nothing of rounding in the curves themselves: an arc bent by 1e-6 has its centre a
//! million lengths away, and its points lose six digits, which the tolerance knows.
//!
//! # What cannot be compared
//! A case without a minimum that has derivatives, or whose bounds exceed a thousandth of its scales, is counted under
//! its reason. It is never passed.
//!
//! # What does not agree
//! A mismatch is named by its first wrong number ([`Diagnosis`]), shrunk while it keeps that name ([`shrink`]), and
//! written as a test ([`test_source`]) or as numbers ([`CaseData`]).

mod accuracy;
mod arbitration;
mod bounds;
mod candidate;
mod case_data;
mod compare;
mod config;
mod diagnosis;
mod distribution;
mod draw;
mod evaluation_point;
mod oracle;
mod own;
mod pasted;
mod regime;
mod root_enclosure;
mod run;
mod shrink;
mod summary;
mod verdict;

pub use accuracy::{Accuracy, Errors, Level, accuracy};
pub use arbitration::Arbitration;
pub use bounds::{Bounds, Measured, Points, Side, Violation, bounds};
pub use candidate::{Answer, CAREFUL, Candidate, Digits, Example, Found, Situation, linearization};
pub use case_data::CaseData;
pub(crate) use compare::{Closed, References, judged};
pub use compare::{Compared, compare};
pub use config::{CheckConfig, Oracles};
pub use diagnosis::{Diagnosis, Finding, look_at};
pub use distribution::Distribution;
pub use draw::{Case, Selection};
pub(crate) use evaluation_point::EvaluationPoint;
pub use own::{JetFinding, OwnCurve, curve};
pub use pasted::test_source;
pub use regime::Regime;
pub use run::run;
pub use shrink::{Shrunk, shrink, shrink_mismatches};
pub use summary::{Cell, Differences, MismatchKind, Summary, Tally};
pub use verdict::{Comparison, Inconclusive, Order, Verdict};

pub use crate::test_beam::{Family, TestBeam, TestBeamError};
