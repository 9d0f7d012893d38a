//! From evidence to verdicts.

use super::record::{Counts, EquationRow, Part, Run};
use super::table::{Kind, Order, Reading};
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

impl Counts {
    /// Whether there were draws, and all were equal.
    pub fn all_equal(self) -> bool {
        self.refuted == 0 && self.equal > 0
    }
}

impl Run {
    fn is_equal(&self) -> bool {
        self.score.linear.all_equal() && self.score.nonlinear.all_equal()
    }

    /// The kind of reading, and what is read otherwise.
    pub fn name(&self) -> String {
        let reading = match self.reading {
            Reading::Printed => "as printed",
            Reading::Other => "read otherwise",
            Reading::Corrected => "corrected",
            Reading::Complete => "complete",
        };
        if self.words.is_empty() { reading.to_owned() } else { format!("{reading}: {}", self.words) }
    }

    /// Whether it is symmetric, if it is of second order.
    pub fn symmetry(&self) -> Option<Symmetry> {
        let [at_points, anywhere] = self.symmetric?;
        Some(match (at_points.all_equal(), anywhere.all_equal()) {
            (true, true) => Symmetry::ByForm,
            (true, false) => Symmetry::ByRelations,
            (false, _) => Symmetry::Not,
        })
    }
}

impl Part {
    /// The last correction, or the print if there is none.
    pub fn corrected(&self) -> Option<&Run> {
        let of = |reading| self.runs.iter().find(|run| run.reading == reading);
        of(Reading::Complete).or_else(|| of(Reading::Corrected)).or_else(|| of(Reading::Printed))
    }

    /// The verdict that follows from the runs.
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
    /// The title of the corrected LaTeX: whether it corrects the print, adds the terms that the paper drops, or both.
    pub fn correction(&self) -> &'static str {
        let is_completed = self.corrected.as_deref().is_some_and(|latex| latex.contains(r"\Delta_u\delta_u"));
        match (self.verdict, is_completed) {
            (Verdict::NotInTheScan, _) => "As reconstructed",
            (Verdict::ExactIfLinear, _) => "As completed",
            (_, true) => "As corrected and completed",
            (_, false) => "As corrected",
        }
    }

    /// The verdict that follows from the parts, and from the kind of the equation.
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
