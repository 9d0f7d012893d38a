//! Fault injection as Markdown, from the record alone.

use super::faults::{Faults, OperationsRow, SampledRow, UndetectedOperations};
use super::number::error;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

impl Faults {
    /// The page; the same record always makes the same page.
    pub fn to_markdown(&self) -> String {
        let faults: usize = self.kinds.iter().map(|(_, count)| count).sum();
        let verdict = if self.holds { "detects all of them" } else { "DOES NOT DETECT ALL OF THEM" };
        let mut page = format!(
            "# Faults\n\nThis report measures which checks detect wrong formulas. {faults} faults are injected into the terms \
             of the closed form, one at a time, in the library's own code. The gate **{verdict}**, in every regime. It \
             rejects none of {} formulas that are written in another way and are right.\n\n",
            self.rewrites.len()
        );
        page.push_str("| kind of fault | faults |\n|---|---:|\n");
        for (kind, count) in &self.kinds {
            let _ = writeln!(page, "| {kind} | {count} |");
        }
        page.push_str("\n## Detection rate of each check\n\n| check | what it does |\n|---|---|\n");
        for (check, what) in &self.checks {
            let _ = writeln!(page, "| {check} | {what} |");
        }
        page.push_str(
            "\nAll checks evaluate the same closest points. *Points rejected*: points at which the check rejects the \
             unmodified closed form; the check is not asked there again. *False positives*: equivalent formulas that the \
             check rejects at some point. The exact check and the gate compare matrices as well. The other checks compare \
             variations only, so no fault of the matrices is injected for them.\n\n\
             | check | regime | faults detected | pairs of faults detected | points rejected | false positives |\n\
             |---|---|---:|---:|---:|---:|\n",
        );
        for row in &self.rows {
            let _ = writeln!(
                page,
                "| {} | {} | {} of {} | {} of {} | {} of {} | {} of {} |",
                row.check,
                row.regime,
                row.detected,
                row.planted,
                row.pairs_detected,
                row.pairs,
                row.rejected,
                row.points,
                row.false_positives.len(),
                self.rewrites.len()
            );
        }
        page.push_str(&self.missed());
        page.push_str(&self.single_operations());
        page.push_str(&self.sampled_operations());
        page.push_str(&self.detection_limits());
        let _ = write!(
            page,
            "\n## How it was made\n\n{}| seed | {:#x} |\n\n`faults.json` lists the faults that each check does \
             not detect in each regime, and the detection limits of all terms. This page is made from it alone. \
             `beamgap faults --list` lists the names of the faults. `beamgap check --plant NAME` injects one.\n",
            self.environment.rows(),
            self.seed
        );
        page
    }

    /// What other checks would have missed, in the regime that suits them best.
    fn missed(&self) -> String {
        let mut text = String::from(
            "\n## Undetected faults\n\nFor each check the regime in which it detects the most faults, and the formulas of \
             the faults that it does not detect there.\n\n| check | regime | undetected | of the formulas |\n\
             |---|---|---:|---|\n",
        );
        for (check, _) in &self.checks {
            let of_check = self.rows.iter().filter(|row| row.check == *check);
            let Some(row) = of_check.min_by_key(|row| row.planted - row.detected) else { continue };
            if row.detected == row.planted {
                continue;
            }
            let mut formulas: BTreeMap<&str, usize> = BTreeMap::new();
            for fault in self.undetected_by(row) {
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
                row.planted - row.detected,
                row.planted,
                listed.join(", ")
            );
        }
        text
    }

    /// What became of single operations.
    fn single_operations(&self) -> String {
        let mut text = String::from(
            "\n## Single operations\n\nThe code runs over a prime field. One operation is made wrong: its sign is changed, its \
             result is zero, doubled or one too large, or it is the result of another run. The other runs have the \
             directions exchanged, the beams exchanged, the beam in place of the bar beam, or other parameters. A fault is \
             detected if a result changes, as the proof compares results by `==`.\n\n\
             | code | place | operations | faults | detected | reason of those not detected |\n|---|---|---:|---:|---:|---|\n",
        );
        for row in &self.operations {
            let reason = |undetected: &UndetectedOperations| {
                undetected.reason.clone().unwrap_or("NOT COVERED".to_owned())
            };
            let reasons: BTreeSet<String> = row.undetected.iter().map(reason).collect();
            let why = reasons.into_iter().collect::<Vec<_>>().join("; ");
            let OperationsRow { code, place, operations, faults, detected, .. } = row;
            let _ = writeln!(text, "| {code} | {place} | {operations} | {faults} | {detected} | {why} |");
        }
        text
    }

    /// What became of a sample of operations in `f64`.
    fn sampled_operations(&self) -> String {
        let mut text = String::from(
            "\n## Single operations in f64\n\nA sample of the operations, spread evenly over the code and the points of each \
             regime. The result of an operation is multiplied by -1, 0 and 2. A fault is detected if a number exceeds its \
             tolerance. A fault that is not detected changes all numbers by less than rounding does. The second table shows \
             detection limits: the smallest relative error of an operation that exceeds a tolerance. It is the median over \
             the operations that a quantity depends on.\n\n\
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
             point where it is smallest.\n\n| regime | median of all terms | largest | of the term |\n|---|---:|---:|---|\n",
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
