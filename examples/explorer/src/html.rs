//! HTML elements: numbers, verdicts, links to equations.

use std::fmt::Write;

/// A text in which the special characters of HTML are escaped.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// A number with seven digits.
pub(crate) fn number(x: f64) -> String {
    let text = match x.abs() {
        0.0 => "0".to_owned(),
        size if !size.is_finite() => return "not finite".to_owned(),
        size if (1e-4..1e5).contains(&size) => format!("{x:.7}"),
        _ => format!("{x:.4e}"),
    };
    text.replace('-', "−")
}

/// A number with two digits.
pub(crate) fn short(x: f64) -> String {
    if x == 0.0 { "0".to_owned() } else { format!("{x:.1e}").replace('-', "−") }
}

/// A large number without decimals.
pub(crate) fn whole(x: f64) -> String {
    if x.abs() < 1e9 { format!("{x:.0}").replace('-', "−") } else { short(x) }
}

/// The decimal digits of a relative error; beyond 13 they depend on the machine.
pub(crate) fn digits(relative: f64) -> String {
    let digits = -relative.log10();
    match digits {
        _ if relative == 0.0 || digits >= 13.0 => "13 or more".to_owned(),
        _ if digits > 0.0 => format!("{digits:.1}"),
        _ => "none".to_owned(),
    }
}

/// The outcome of comparisons.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Outcome {
    /// There were no comparisons.
    NotCompared,
    /// All comparisons agree.
    Agrees,
    /// Every difference can be a rounding error.
    Unclear,
    /// Some comparisons differ beyond rounding.
    Wrong,
}

impl Outcome {
    /// The outcome as a mark with a word, so that it does not depend on colour alone.
    pub(crate) fn html(self) -> &'static str {
        match self {
            Self::NotCompared => "<span class=\"muted\">not compared</span>",
            Self::Agrees => "<span class=\"good\">✓ agrees</span>",
            Self::Unclear => "<span class=\"muted\">? unclear</span>",
            Self::Wrong => "<span class=\"bad\">✗ WRONG</span>",
        }
    }
}

/// A text in which the numbers of equations are links to the page of the derivation.
pub(crate) fn linked(words: &str) -> String {
    let mut out = String::new();
    let mut rest = words;
    while let Some(at) = rest.find('(') {
        let (before, from) = rest.split_at(at);
        out += before;
        let number = from[1..].split(')').next().filter(|number| number.parse::<u8>().is_ok());
        let Some(number) = number else {
            out.push('(');
            rest = &from[1..];
            continue;
        };
        let _ = write!(out, "<a href=\"derivation.html#eq-{number}\">({number})</a>");
        rest = &from[number.len() + 2..];
    }
    out + rest
}

/// A table. On a page that is too narrow for it, the style makes blocks of its rows.
pub(crate) fn table(name: &str, heads: &[&str], rows: &str) -> String {
    let heads: Vec<_> = heads.iter().map(|head| format!("<th scope=\"col\">{head}</th>")).collect();
    let heads = heads.concat();
    format!(
        "<div class=\"wide\"><table aria-label=\"{name}\"><thead><tr>{heads}</tr></thead><tbody>\n{rows}</tbody></table></div>\n"
    )
}
