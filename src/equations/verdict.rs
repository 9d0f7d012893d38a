//! Verdicts on equations.

use serde::{Deserialize, Serialize};

/// The verdict on an equation. Later verdicts are worse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// It is true by definition.
    Definition,
    /// It lists terms, and none is missing.
    List,
    /// It makes an assumption.
    Assumption,
    /// It is missing in the scan.
    NotInTheScan,
    /// Equal in every draw.
    Exact,
    /// Equal for finite increments, but not for variations, because it drops their products.
    ExactIfFinite,
    /// Equal for curves that are linear in their dofs.
    ExactIfLinear,
    /// Not equal to the quantity that it replaces.
    Approximation,
    /// Refuted as printed, equal as corrected.
    Misprint,
    /// Refuted as corrected, too: the table is not valid.
    Refuted,
}

/// Whether a formula of second order is unchanged when delta and Delta are exchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Symmetry {
    /// For any operands.
    ByForm,
    /// For the operands of a stationary point, by relations between them: the chain rule, or orthogonality.
    ByRelations,
    /// Not symmetric.
    Not,
}

impl Verdict {
    /// The verdict in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Definition => "definition",
            Self::List => "list",
            Self::Assumption => "assumption",
            Self::NotInTheScan => "not in the scan",
            Self::Exact => "exact",
            Self::ExactIfFinite => "exact, increments finite",
            Self::ExactIfLinear => "exact, dofs linear",
            Self::Approximation => "approximation",
            Self::Misprint => "misprint",
            Self::Refuted => "refuted",
        }
    }
}

impl Symmetry {
    /// The answer in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::ByForm => "by form",
            Self::ByRelations => "by relations",
            Self::Not => "no",
        }
    }
}
