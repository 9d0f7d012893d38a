//! The check: random pairs of beams through the closed form and through automatic differentiation.
//!
//! A case is drawn from its number alone. Its closest points are searched for. At each closest point the closed form is
//! compared with automatic differentiation, in the
//! [`Formulation`](crate::linearization::closed_form::Formulation) that the library uses there. The comparison covers the value
//! and the first and second variations of every quantity, the symmetry of the second variations, the matrices, and the
//! kernel in every layout. Matrices are contracted with the directions of the variations.
//!
//! # The tolerance
//! Both sides are also evaluated over [`RunningError`](crate::number::RunningError). It yields for every number a bound on its
//! distance from exact arithmetic: each operation adds half an ulp of its result and propagates the bounds of its
//! operands. The closest point is refined in double-double, so its parameters are known to about half an ulp. Routes that
//! solve for the closest point in `f64` again get a larger bound, from their residual and the conditioning of the
//! projection. |closed - AD| must not exceed the sum of the two bounds. No tolerance is tuned, and no number is compared
//! with an absolute tolerance.
//!
//! # The third oracle
//! Central differences of the value in double-double share no derivative with either side. They estimate their own error.
//! They are computed for a sample of the cases ([`Oracles`]), and wherever closed form and AD disagree. There they decide
//! which side is wrong ([`Arbitration`]). If the oracles disagree among themselves, the check is not trusted, and the closed
//! form is not rejected.
//!
//! # Errors in the tables
//! Tables show the error divided by its scale. The scale is the sum of the absolute values of the closed form's terms
//! ([`TermScale`](crate::number::TermScale)). A vector counts by its length, a parameter by its range. The scale does not
//! include rounding in the curves; the tolerance does. Example: an arc bent by 1e-6 has its centre a million lengths away,
//! and its points lose six digits.
//!
//! # What is not compared
//! A case is not compared if no minimum has derivatives, or if a bound exceeds a thousandth of its scale. It is counted under
//! its reason. It is never counted as a pass.
//!
//! # Mismatches
//! The wrong term is looked for ([`likely_cause`]). A mismatch is identified by its first wrong number ([`Diagnosis`]). It is shrunk while this number stays the first
//! ([`shrink`]). It is written as a test ([`test_source`]) or as numbers ([`CaseData`]).

mod accuracy;
mod arbitration;
mod bounds;
mod candidate;
mod case_data;
mod cause;
mod compare;
mod config;
mod counts;
mod coverage;
mod diagnosis;
mod distribution;
mod draw;
mod element;
mod evaluation_point;
pub mod external;
mod independent_search;
mod left_out;
mod oracle;
mod own;
mod pasted;
mod regime;
mod root_enclosure;
mod run;
pub(crate) mod serialized;
mod shard;
mod shrink;
mod summary;
mod verdict;

pub use accuracy::{Accuracy, Errors, Level, accuracy};
pub use arbitration::Arbitration;
pub use bounds::{Bounds, Measured, Points, Side, Violation, bounds};
pub use candidate::{Answer, CAREFUL, Candidate, Digits, Example, Found, Situation, linearization};
pub use case_data::{ByTerm, CaseData};
pub use cause::{LikelyCause, likely_cause};
pub(crate) use compare::{Closed, References, compares_routes, judged};
pub use compare::{Compared, compare};
pub use config::{CheckConfig, Oracles};
pub use counts::{Count, Counts, Moved};
pub(crate) use coverage::geometry;
pub use coverage::{Coverage, Symmetry};
pub use diagnosis::{Diagnosis, Finding, layer, look_at};
pub use distribution::Quantiles;
pub use draw::{Case, Selection};
pub(crate) use element::ElementAt;
pub use element::{ContactSituation, ElementData};
pub(crate) use evaluation_point::{ELEMENT_ENTRIES, EvaluationPoint};
pub(crate) use independent_search::{IndependentSearch, pair_of};
pub use independent_search::{SearchFinding, SearchFindingKind, SearchTally, Searched};
pub use left_out::{LARGEST_SHARE, LeftOut, left_out_warning};
pub use own::{JetFinding, OwnCurve, curve, jet};
pub use pasted::test_source;
pub use regime::Regime;
pub use run::{run, run_part};
pub use shard::Shard;
pub use shrink::{Shrunk, shrink, shrink_mismatches};
pub use summary::{Cell, Differences, ElementCells, Mismatch, MismatchKind, NotCompared, Summary, Tally};
pub use verdict::{Comparison, Inconclusive, Order, Verdict};

pub use crate::test_beam::{Family, TestBeam, TestBeamError};
