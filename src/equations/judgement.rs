//! From evidence to verdicts.

use super::record::{Counts, EquationRow, Part, Run};
use super::table::{Kind, Order, Reading};
use super::verdict::{Symmetry, Verdict};

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
