//! Programs that were verified as a page, from the record alone.

use super::number::count;
use super::page::{Block, Page};
use super::verify::{Verify, VerifyRun};

impl Verify {
    /// The page; the same record always makes the same page.
    pub fn page(&self) -> Page {
        let mut blocks = vec![
            Block::text(
                "`beamgap verify` checks programs that others wrote. This report says what was run and what came out. The \
                 programs that ask them for answers are in `examples/verify/public`.",
            ),
            Block::table(
                &["program", "version", "#cases", "#compared", "#wrong", "#not answered"],
                self.runs.iter().map(VerifyRun::row).collect(),
            ),
            Block::text(
                "Not answered: the lines of the IPC Toolkit are infinite, so cases with a parameter at an end have no answer; where \
                 CasADi's iteration does not converge, it gives none. Compared: closest points at which a number was compared. Wrong: those at which a number differs by more than \
                 a careful evaluation of the textbook formulas loses.",
            ),
        ];
        blocks.extend(self.runs.iter().flat_map(VerifyRun::blocks));
        blocks.extend([
            Block::heading("How it was made"),
            Block::text("All numbers are in `verify.json`, from which alone this page is made."),
            self.environment.table(Vec::new()),
        ]);
        Page::new("Programs of others, verified", blocks)
    }
}

/// Decimal digits of a relative error.
fn digits(error: Option<f64>) -> String {
    error.map_or_else(|| "none".into(), |error| format!("{:.1}", (-error.log10()).clamp(0.0, 16.0)))
}

impl VerifyRun {
    fn row(&self) -> Vec<String> {
        let counts = [self.cases, self.compared, self.wrong, self.missing + self.unanswered].map(count);
        let name = self.program.name.clone() + &self.asked();
        [name, self.program.version.clone()].into_iter().chain(counts).collect()
    }

    /// The digits that were asked for, if some were.
    fn asked(&self) -> String {
        self.digits.map_or_else(String::new, |digits| format!(", {digits} digits asked for"))
    }

    fn blocks(&self) -> Vec<Block> {
        let regimes = self.regimes.iter().map(|of| {
            let worst = of.largest_error.as_ref();
            let number = |of: &super::verify::VerifyNumber| format!("{} of {}", of.part, of.quantity);
            vec![
                of.regime.clone(),
                count(of.compared),
                count(of.wrong),
                count(of.losing_digits),
                worst.map_or_else(String::new, |of| digits(of.error)),
                worst.map_or_else(String::new, |of| digits(of.attainable)),
                worst.map_or_else(String::new, |of| number(&of.comparison)),
                of.largest_loss
                    .as_ref()
                    .and_then(|of| of.digits)
                    .map_or_else(String::new, |of| format!("{of:.1}")),
            ]
        });
        let parts = self.parts.iter().map(|of| {
            let counts = [of.numbers, of.wrong, of.losing_digits].map(count);
            [of.quantity.clone(), of.order.clone()].into_iter().chain(counts).collect()
        });
        let mut blocks = vec![
            Block::heading(&format!("{} {}{}", self.program.name, self.program.version, self.asked())),
            Block::text(&format!("Run as `{}`{}. Verdict: {}.", self.answers, self.asked(), self.verdict)),
            Block::table(
                &[
                    "regime",
                    "#compared",
                    "#wrong",
                    "#fewer digits",
                    "#digits kept",
                    "#attainable",
                    "of",
                    "#digits lost",
                ],
                regimes.collect(),
            ),
            Block::text(
                "Digits kept: of the number with the largest error over its size; attainable: those that the best formulas keep \
                 there at least. The size of a gradient or a Hessian along the directions is the sum of the absolute values \
                 of what is summed. Fewer digits: closest points at which a number is right, but has lost digits that the \
                 best formulas keep; digits lost: at most.",
            ),
            Block::table(&["quantity", "order", "#numbers", "#wrong", "#fewer digits"], parts.collect()),
        ];
        let reasons = self.not_compared.iter().map(|(reason, of)| format!("{}: {reason}", count(*of)));
        let reasons: Vec<_> = reasons.collect();
        if !reasons.is_empty() {
            blocks.push(Block::text(&format!("Not compared: {}.", reasons.join("; "))));
        }
        if let Some(words) = &self.agrees_if {
            blocks.push(Block::text(&format!("The answers agree if {words}.")));
        }
        blocks
    }
}
