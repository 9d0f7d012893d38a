//! The verification of programs as a page, from the record alone.

use super::number::count;
use super::page::{Block, Page};
use super::verify::{Verify, VerifyRun};
use crate::check::external::{Loss, Report};

impl Verify {
    /// The page. The same record always gives the same page.
    pub fn page(&self) -> Page {
        let mut blocks = vec![
            Block::text(&self.conclusion()),
            Block::table(
                &["program", "version", "#cases", "#compared", "#wrong", "#not answered"],
                self.runs.iter().map(VerifyRun::row).collect(),
            ),
            Block::list(&[
                "Compared: closest points at which a number was compared.",
                "Wrong: closest points at which a number differs by more than its tolerance. Each number has its own tolerance. It \
                 is a sum of three bounds on rounding: 8 times that of the textbook formulas, that of the closest point, and \
                 that of the reference. The factor 8 is a choice; it allows for another order of the sums.",
                "*Digits required*: a number is right if it agrees with the best formulas or with the reference to as many \
                 significant digits, or to the attainable digits, where these are fewer.",
                "Not answered: the lines of the IPC Toolkit are infinite, so it does not answer cases with a parameter at an end. \
                 CasADi does not answer cases in which its iteration does not converge.",
            ]),
            Block::heading("Regimes with wrong numbers or fewer digits"),
            Block::table(
                &[
                    "program",
                    "regime",
                    "#compared",
                    "#wrong",
                    "#fewer digits",
                    "worst number",
                    "#its digits",
                    "#bound",
                    "#lost",
                ],
                self.runs.iter().flat_map(VerifyRun::regimes_with_findings).collect(),
            ),
            Block::details(
                "How to read this table",
                vec![Block::list(&[
                    "*Fewer digits*: closest points at which a number is right, but has fewer digits than the bound of the best \
                     formulas there. *Lost*: the largest number of digits below this bound. It can belong to another number than \
                     the worst one.",
                    "*Worst number*: the number of the regime with the largest error over its size. The size of a gradient or a \
                     Hessian along the directions is the sum of the absolute values of what is summed.",
                    "*Its digits*: its correct digits. *Bound*: the digits that the best formulas keep at this point at least, by \
                     their rounding bound. Most numbers have more digits than this bound.",
                    "The worst number need not be wrong. A wrong number can have more digits than the worst number, at a point \
                     where more digits can be kept.",
                    "Gradients and Hessians are compared along two pairs of directions, so a closest point has four numbers of the \
                     first order and two of the second. Numbers whose tolerance exceeds a thousandth of their scale are not \
                     compared. The other regimes, and the counts for each quantity, are in `verify.json`.",
                ])],
            ),
        ];
        let runs = self.runs.iter().flat_map(VerifyRun::blocks).collect();
        blocks.push(Block::details("The runs one by one", runs));
        blocks.extend([
            Block::heading("How it was made"),
            Block::text("All numbers are in `verify.json`, from which alone this page is made."),
            self.environment.table(Vec::new()),
        ]);
        Page::new("Programs of others, verified", blocks)
    }

    /// The conclusion from all runs.
    fn conclusion(&self) -> String {
        let (agree, differ): (Vec<&VerifyRun>, Vec<&VerifyRun>) =
            self.runs.iter().partition(|run| run.report.wrong == 0);
        let counts = differ.iter().map(|run| {
            let Report { wrong, compared, .. } = &run.report;
            let name = run.name();
            format!("{name} at {} of {} closest points", count(*wrong), count(*compared))
        });
        let counts: Vec<_> = counts.collect();
        let differ = match differ.len() {
            0 => "no run has a wrong number".to_owned(),
            1 => format!("one has wrong numbers: {}", counts.join(", ")),
            n => format!("{} have wrong numbers: {}", count(n as u64), counts.join(", ")),
        };
        format!(
            "Are programs that others wrote right? **Of {} runs of such programs, {} agree with the reference; {differ}.** `beamgap verify` compared \
             them. The programs that ask them for answers are in `examples/verify/public`.",
            count(self.runs.len() as u64),
            count(agree.len() as u64),
        )
    }
}

/// Decimal digits of a relative error.
fn digits(error: f64) -> String {
    if error.is_finite() { format!("{:.1}", (-error.log10()).clamp(0.0, 16.0)) } else { "none".into() }
}

impl VerifyRun {
    fn row(&self) -> Vec<String> {
        let Report { program, vectors, compared, wrong, missing, unanswered, not_asked, .. } = &self.report;
        let counts = [*vectors, *compared, *wrong, missing + unanswered + not_asked].map(count);
        [self.name(), program.version.clone()].into_iter().chain(counts).collect()
    }

    fn name(&self) -> String {
        self.report.program.name.clone() + &self.asked()
    }

    /// A row for each regime in which a number is wrong or has fewer digits than it can have.
    fn regimes_with_findings(&self) -> impl Iterator<Item = Vec<String>> {
        let found = self.report.regimes.iter().filter(|(_, of)| of.wrong > 0 || of.losing > 0);
        found.map(|(regime, of)| {
            let of_worst = |show: fn(&Loss) -> String| of.worst.as_ref().map_or_else(String::new, show);
            vec![
                self.name(),
                regime.clone(),
                count(of.compared),
                count(of.wrong),
                count(of.losing),
                of_worst(|worst| {
                    let number = &worst.judged.comparison;
                    format!("{} of {}", number.part, number.quantity.name())
                }),
                of_worst(|worst| digits(worst.error())),
                of_worst(|worst| digits(worst.judged.attainable / worst.judged.size)),
                of.loss.as_ref().map_or_else(String::new, |loss| format!("{:.1}", loss.digits())),
            ]
        })
    }

    /// The digits that were requested, if any.
    fn asked(&self) -> String {
        self.digits.map_or_else(String::new, |digits| format!(", {digits} digits required"))
    }

    /// The wrong numbers, and their regimes.
    fn what_is_wrong(&self) -> String {
        let parts = self.report.parts.iter().filter(|(_, of)| of.wrong > 0);
        let parts = parts
            .map(|((_, quantity, order), of)| format!("{} of {}, {order}", count(of.wrong), quantity.name()));
        let regimes = self.report.regimes.iter().filter(|(_, of)| of.wrong > 0);
        let regimes = regimes.map(|(regime, of)| format!("{} in {regime}", count(of.wrong)));
        let [parts, regimes] = [parts.collect::<Vec<_>>(), regimes.collect()].map(|of| of.join("; "));
        if parts.is_empty() {
            return String::new();
        }
        format!(" Wrong numbers: {parts}. Closest points with a wrong number: {regimes}.")
    }

    fn blocks(&self) -> Vec<Block> {
        let Report { program, degenerate, .. } = &self.report;
        let mut blocks = vec![
            Block::Subheading(format!("{} {}{}", program.name, program.version, self.asked())),
            Block::text(&format!(
                "Run as `{}`{}. Verdict: {}.{}",
                self.answers,
                self.asked(),
                self.verdict,
                self.what_is_wrong()
            )),
        ];
        let reasons = degenerate.iter().map(|(reason, of)| format!("{} ({reason})", count(*of)));
        let reasons: Vec<_> = reasons.collect();
        if !reasons.is_empty() {
            blocks.push(Block::text(&format!("Closest points not compared: {}.", reasons.join(", "))));
        }
        if let Some(words) = &self.agrees_if {
            blocks.push(Block::text(&format!("The answers agree if {words}.")));
        }
        blocks
    }
}
