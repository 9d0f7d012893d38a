//! What the checks made of planted faults, as Markdown, from the record alone.

use super::number::error;
use super::teeth::{OperationsRow, SampledRow, Teeth, UnseenRow};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

impl Teeth {
    /// The page; the same record always makes the same page.
    pub fn to_markdown(&self) -> String {
        let faults: usize = self.kinds.iter().map(|(_, count)| count).sum();
        let verdict = if self.holds { "shows every one" } else { "DOES NOT SHOW EVERY ONE" };
        let mut page = format!(
            "# Teeth\n\nA check that was never seen to fail proves nothing. Every term of the closed form was made wrong \
             in every way that makes a difference: {faults} faults, each planted in the library's own code. The gate \
             **{verdict}**, in every regime, and accuses none of {} correct rewrites of the formulas.\n\n",
            self.rewrites.len()
        );
        page.push_str("| kind of fault | faults |\n|---|---:|\n");
        for (kind, count) in &self.kinds {
            let _ = writeln!(page, "| {kind} | {count} |");
        }
        page.push_str("\n## What each check shows\n\n| check | what it does |\n|---|---|\n");
        for (check, what) in &self.checks {
            let _ = writeln!(page, "| {check} | {what} |");
        }
        page.push_str(
            "\nFaults shown of faults planted, at the same closest points for all. What a check says at a point where it \
             accuses the closed form as it is (wrongly: *accused*) counts for nothing; *false alarms* are correct \
             rewrites accused anywhere. The checks other than the first two look at the variations, so faults of the \
             matrices alone were not planted for them.\n\n\
             | check | regime | faults shown | pairs of faults | points accused | false alarms |\n\
             |---|---|---:|---:|---:|---:|\n",
        );
        for row in &self.rows {
            let _ = writeln!(
                page,
                "| {} | {} | {} of {} | {} of {} | {} of {} | {} of {} |",
                row.check,
                row.regime,
                row.killed,
                row.planted,
                row.pairs_killed,
                row.pairs,
                row.accused,
                row.points,
                row.false_alarms.len(),
                self.rewrites.len()
            );
        }
        page.push_str(&self.missed());
        page.push_str(&self.single_operations());
        page.push_str(&self.sampled_operations());
        page.push_str(&self.detection_limits());
        let _ = write!(
            page,
            "\n## How it was made\n\n{}| seed | {:#x} |\n\nThe faults that each check does not show in each regime, and the limits of all terms, are in \
             `teeth.json`, from which alone this page is made. `beamgap teeth --list` names the faults, and \
             `beamgap check --plant NAME` plants one.\n",
            self.environment.rows(),
            self.seed
        );
        page
    }

    /// What other checks would have missed, in the regime that suits them best.
    fn missed(&self) -> String {
        let mut text = String::from(
            "\n## What the others miss\n\nIn the regime in which each misses least, the formulas of the faults that it \
             does not show.\n\n| check | regime | missed | of the formulas |\n|---|---|---:|---|\n",
        );
        for (check, _) in &self.checks {
            let of_check = self.rows.iter().filter(|row| row.check == *check);
            let Some(row) = of_check.min_by_key(|row| row.planted - row.killed) else { continue };
            if row.killed == row.planted {
                continue;
            }
            let mut formulas: BTreeMap<&str, usize> = BTreeMap::new();
            for fault in self.unshown_by(row) {
                *formulas.entry(fault.split(':').next().unwrap_or(fault)).or_default() += 1;
            }
            let mut formulas: Vec<_> = formulas.into_iter().collect();
            formulas.sort_by_key(|&(name, count)| (usize::MAX - count, name));
            let listed: Vec<_> = formulas
                .iter()
                .map(|(name, count)| format!("{} ({count})", name.replace('|', "\\|")))
                .collect();
            let _ = writeln!(
                text,
                "| {} | {} | {} of {} | {} |",
                row.check,
                row.regime,
                row.planted - row.killed,
                row.planted,
                listed.join(", ")
            );
        }
        text
    }

    /// What became of single operations.
    fn single_operations(&self) -> String {
        let mut text = String::from(
            "\n## Single operations\n\nThe code itself, over a prime field, with one operation wrong: by its sign, lost, \
             doubled, one too large, or with the result that it has in a run with the directions exchanged, the beams \
             exchanged, the beam in place of the bar beam, or other parameters. Shown is what changes a number that comes \
             out, as the proof compares these by `==`.\n\n\
             | code | place | operations | faults | shown | not shown, and why |\n|---|---|---:|---:|---:|---|\n",
        );
        for row in &self.operations {
            let reason = |unseen: &UnseenRow| unseen.reason.clone().unwrap_or("NOT COVERED".to_owned());
            let reasons: BTreeSet<String> = row.unseen.iter().map(reason).collect();
            let why = reasons.into_iter().collect::<Vec<_>>().join("; ");
            let OperationsRow { code, place, operations, faults, shown, .. } = row;
            let _ = writeln!(text, "| {code} | {place} | {operations} | {faults} | {shown} | {why} |");
        }
        text
    }

    /// What became of a sample of operations in `f64`.
    fn sampled_operations(&self) -> String {
        let mut text = String::from(
            "\n## Single operations in f64\n\nA sample of the operations, spread evenly over the code and the points of each \
             regime, each multiplied by -1, 0 and 2. Detected is what exceeds a tolerance of the gate. A fault that is \
             not detected changes a number by less than rounding does. The detection limit of an operation is the \
             smallest relative error of it that exceeds a tolerance; of the operations that a quantity depends on, the \
             median is shown, of the equations and of the matrices.\n\n\
             | regime | code | operations | faults | detected |\n|---|---|---:|---:|---:|\n",
        );
        for SampledRow { regime, code, operations, faults, detected, .. } in &self.sampled {
            let _ = writeln!(text, "| {regime} | {code} | {operations} | {faults} | {detected} |");
        }
        let mut quantities: Vec<&str> = Vec::new();
        for (name, ..) in self.sampled.iter().flat_map(|row| &row.limits) {
            if !quantities.contains(&name.as_str()) {
                quantities.push(name);
            }
        }
        let _ = writeln!(text, "\n| regime | code | {} |", quantities.join(" | "));
        let _ = writeln!(text, "|---|---|{}", "---:|".repeat(quantities.len()));
        for row in &self.sampled {
            let median = |quantity: &&str| {
                let of = row.limits.iter().find(|(name, ..)| name == quantity);
                of.map_or_else(|| "-".to_owned(), |(_, _, [median, _])| error(Some(*median)))
            };
            let medians: Vec<_> = quantities.iter().map(median).collect();
            let _ = writeln!(text, "| {} | {} | {} |", row.regime, row.code, medians.join(" | "));
        }
        text
    }

    fn detection_limits(&self) -> String {
        let mut text = String::from(
            "\n## Detection limits of the gate\n\nThe smallest relative error of a term that exceeds a tolerance, at the \
             point that shows it best.\n\n| regime | median of all terms | largest | of the term |\n|---|---:|---:|---|\n",
        );
        for (i, regime) in self.regimes.iter().enumerate() {
            let mut limits: Vec<(f64, &str)> = self
                .limits
                .iter()
                .filter_map(|(term, limits)| Some(((*limits.get(i)?)?, term.as_str())))
                .collect();
            limits.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (Some(middle), Some(last)) = (limits.get(limits.len() / 2), limits.last()) else { continue };
            let _ = writeln!(
                text,
                "| {regime} | {} | {} | {} |",
                error(Some(middle.0)),
                error(Some(last.0)),
                last.1.replace('|', "\\|")
            );
        }
        text
    }
}
