//! What is told of answers with few digits.

use crate::cli::terminal::folded;
use beamgap::check::external::{FewDigits, FewKind};

/// That the answers have few digits.
pub(super) fn of_few(few: &FewDigits) -> String {
    let FewDigits { digits, kind, is_all, agree } = few;
    let whose = if *is_all { "All answers" } else { "The wrong answers" };
    let what = match kind {
        FewKind::Significant => format!("{whose} have at most {digits} significant digits"),
        FewKind::Decimals => format!("{whose} have at most {digits} decimals"),
        FewKind::Single(_) => format!("{whose} are numbers of single precision"),
    };
    let others = if *is_all { String::new() } else { "Other answers have more digits.\n".to_owned() };
    match kind {
        FewKind::Decimals => {
            let found = if *agree {
                "To so many decimals the wrong cases that were tried agree."
            } else {
                "They differ in these decimals too."
            };
            let advice = "Print significant digits, as %.17g does: small numbers have few of them now.";
            folded(&format!("{what}. {found} {advice}"), "", "  ") + "\n" + &others
        }
        FewKind::Single(regimes) if !*agree && *is_all => {
            format!("{what}.\n{}", of_single(regimes))
        }
        _ if *agree => {
            format!(
                "{what}. If {digits} are required,\nthe wrong cases that were tried agree: --digits {digits}.\n{others}"
            )
        }
        _ => format!("{what}.\nThey differ in the first {digits} digits too.\n{others}"),
    }
}

/// The regimes in which answers in single precision agree, and those in which they do not.
fn of_single([agree, explained, others]: &[Vec<String>; 3]) -> String {
    let mut text = String::new();
    let mut add = |words: String| text += &(folded(&words, "", "  ") + "\n");
    if !agree.is_empty() {
        add(format!("They agree to 6 digits in {}.", agree.join(", ")));
    }
    if !explained.is_empty() {
        add(format!(
            "Rounding in single precision explains the differences in {}: single precision can do no better there.",
            explained.join(", ")
        ));
    }
    if !others.is_empty() {
        add("They differ in the first 6 digits too.".to_owned());
        add(format!(
            "Rounding in single precision does not explain the differences in {}.",
            others.join(", ")
        ));
    }
    text
}
