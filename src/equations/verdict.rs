//! From evidence to verdicts.

use super::record::{Counts, EquationRow, Part, Run};
use super::table::{Kind, Order, Reading};
use serde::{Deserialize, Serialize};

/// What became of an equation, the worse the later.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// It is so by its words.
    Definition,
    /// It names terms, and none is missing.
    List,
    /// It supposes something.
    Assumption,
    /// The scan has lost it.
    NotInTheScan,
    /// Always equal.
    Exact,
    /// Equal for finite increments; not for variations, of which it drops products.
    ExactIfFinite,
    /// Equal for curves that are linear in their dofs.
    ExactIfLinear,
    /// Equal to what takes its place, which it measurably is not.
    Approximation,
    /// Refuted as printed, equal as corrected.
    Misprint,
    /// Refuted as corrected, too: the table does not hold.
    Refuted,
}

/// Whether what is of second order stays the same when delta and Delta are exchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Symmetry {
    /// Whatever its operands are.
    ByForm,
    /// At stationary points.
    ByOrthogonality,
    /// No.
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
            Self::ByOrthogonality => "by orthogonality",
            Self::Not => "no",
        }
    }
}

impl Counts {
    /// Whether there was something, and all of it was equal.
    pub fn all_equal(self) -> bool {
        self.refuted == 0 && self.equal > 0
    }
}

impl Run {
    fn is_equal(&self) -> bool {
        self.score.linear.all_equal() && self.score.nonlinear.all_equal()
    }

    /// Whether it is symmetric, if it is of second order.
    pub fn symmetry(&self) -> Option<Symmetry> {
        let [at_points, anywhere] = self.symmetric?;
        Some(match (at_points.all_equal(), anywhere.all_equal()) {
            (true, true) => Symmetry::ByForm,
            (true, false) => Symmetry::ByOrthogonality,
            (false, _) => Symmetry::Not,
        })
    }
}

impl Part {
    /// The last correction, or what is printed if there is none.
    pub fn corrected(&self) -> Option<&Run> {
        let of = |reading| self.runs.iter().find(|run| run.reading == reading);
        of(Reading::Complete).or_else(|| of(Reading::Corrected)).or_else(|| of(Reading::Printed))
    }

    /// What follows from the runs.
    pub fn verdict(&self) -> Verdict {
        let printed = || self.runs.iter().filter(|run| run.reading == Reading::Printed);
        let corrected = self.runs.iter().any(|run| run.reading == Reading::Corrected);
        if !self.corrected().is_some_and(Run::is_equal) {
            Verdict::Refuted
        } else if printed().any(Run::is_equal) || (printed().count() == 0 && corrected) {
            let others = || self.runs.iter().filter(|run| run.reading == Reading::Other);
            let only_finite = self.order == Order::Finite && others().any(|run| run.score.linear.refuted > 0);
            if only_finite { Verdict::ExactIfFinite } else { Verdict::Exact }
        } else if printed().any(|run| run.score.linear.all_equal()) {
            Verdict::ExactIfLinear
        } else {
            Verdict::Misprint
        }
    }
}

impl EquationRow {
    /// What follows from the parts, and from what the equation is.
    pub(super) fn judged(&self) -> Verdict {
        let parts = self.parts.iter().map(Part::verdict).max();
        if parts == Some(Verdict::Refuted) {
            return Verdict::Refuted;
        }
        match self.kind {
            Kind::Definition => Verdict::Definition,
            Kind::Assumption => Verdict::Assumption,
            Kind::Lost => Verdict::NotInTheScan,
            Kind::List if self.omitted.is_empty() => Verdict::List,
            Kind::List => Verdict::Misprint,
            Kind::Statement if self.arcs.iter().any(|arc| !arc.is_exact()) => Verdict::Approximation,
            Kind::Statement => parts.unwrap_or(Verdict::Refuted),
        }
    }
}
