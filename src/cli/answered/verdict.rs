//! The verdict on the answers: what is wrong, what is missing, and the share that was compared.

use super::verified::Verified;
use crate::cli::count::count as counted;
use crate::cli::exit::Exit;
use crate::cli::outcome::Verdict;
use crate::cli::terminal::folded;
use beamgap::check::external::{Report, is_of_element};

/// The verdict on the answers.
pub(in crate::cli) fn verdict(Verified { report, allow_missing, .. }: &Verified) -> Verdict {
    let Report { compared, wrong, doubted, declined, search, .. } = report;
    let open = lines(&[missing(report).map(|of| format!("Not answered: {of}.")), partly(report)]);
    let points = counted(*compared, "closest point");
    if *compared == 0 && *declined == 0 {
        let cases = counted(report.vectors, "case");
        let words = format!("NOTHING COMPARED: no answer to {cases} could be compared.{open}");
        return Verdict::new(Exit::Nothing, "nothing-compared", words);
    }
    if let Some((case, finding)) = &search.first {
        let cases = counted(search.compared, "case");
        let words = format!(
            "UNTRUSTED: the search for closest points differs from the independent search at {} of {cases}.\nFirst: case {case}: {finding}.{open}",
            search.differing
        );
        return Verdict::new(Exit::Untrusted, "untrusted", folded_lines(&words));
    }
    if *wrong > 0 && wrong == doubted && *declined == 0 {
        let words = format!("UNTRUSTED: at {doubted} of {points} the references disagree.{open}");
        return Verdict::new(Exit::Untrusted, "untrusted", words);
    }
    if *wrong > 0 {
        let words = format!("DISAGREE: at {wrong} of {points}.{}{open}", lines(&[denied(report)]));
        return Verdict::new(Exit::Disagree, "disagree", folded_lines(&words));
    }
    if let Some(denied) = denied(report) {
        let words = format!("DISAGREE: {}{open}", lowered(&denied));
        return Verdict::new(Exit::Disagree, "disagree", folded_lines(&words));
    }
    if !report.is_complete() && !allow_missing {
        return incomplete(report);
    }
    let words = format!("AGREE: at {}{}{}", share(report), right(report), lines(&[partly(report)]));
    let verdict = Verdict::new(Exit::Agree, "agree", words).warned(report.warning());
    Verdict { words: folded_lines(&verdict.words), ..verdict }
}

/// What is said of numbers that are not wrong.
fn right(report: &Report) -> String {
    let losing: u64 = report.regimes.values().map(|of| of.losing).sum();
    match losing {
        0 => "nothing differs beyond rounding.".to_owned(),
        _ => format!("no number is wrong; at {losing} of them digits are lost."),
    }
}

/// The verdict if answers are missing.
fn incomplete(report: &Report) -> Verdict {
    let never = never(report);
    let first = match (missing(report), &never) {
        (Some(cases), _) => format!("no answer to {cases}."),
        (None, Some(never)) => format!("{never}."),
        (None, None) => "a quantity is answered at some cases and not at others.".to_owned(),
    };
    let has_never = never.is_some();
    let second = never.filter(|_| report.open() > 0).map(|never| format!("{never}."));
    let mut kept = right(report);
    if let Some(first) = kept.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    let only = report.coverage.words().iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(",");
    let hint = if report.coverage.is_stated() || !has_never {
        "Partial answers are accepted with --allow-missing.".to_owned()
    } else {
        format!(
            "If the program answers no more, state \"only\":[{only}] in the first line of the answers, or use --allow-missing."
        )
    };
    let rest = lines(&[
        second.map(|text| capital(&text)),
        partly(report),
        Some(format!("Of what is answered: {}", lowered(&kept))),
        Some(hint),
    ]);
    let words = format!("INCOMPLETE: {}{rest}", lowered(&first));
    Verdict::new(Exit::Nothing, "incomplete", folded_lines(&words))
}

/// The share that was compared, if it is not all.
fn share(report: &Report) -> String {
    let of = report.asked + report.not_asked;
    let points = if report.open() + report.not_asked == 0 {
        counted(report.compared, "closest point")
    } else {
        format!("{} of {}", report.compared, counted(of, "closest point"))
    };
    let [whole, part, none] = report.coverage.quantities();
    if part + none == 0 {
        return format!("{points} ");
    }
    let mut what = Vec::new();
    if whole + part > 0 {
        let in_part = if part > 0 { format!(" ({part} in part)") } else { String::new() };
        what.push(format!("{} of {} quantities{in_part}", whole + part, whole + part + none));
    }
    what.extend(report.coverage.words().into_iter().filter(|word| is_of_element(word)));
    let last = what.pop().unwrap_or_default();
    let others = if what.is_empty() { String::new() } else { what.join(", ") + " and " };
    format!("{points}, for {others}{last}, ")
}

/// The cases that are not answered, and why.
fn missing(report: &Report) -> Option<String> {
    let Report { missing, unanswered, first_missing, .. } = report;
    let open = report.open();
    if open == 0 {
        return None;
    }
    let reason = match (missing, first_missing, report.coverage.ends_after()) {
        (1.., _, Some(last)) => format!(": the answers end after case {last}"),
        (1.., Some(first), None) => format!(": the first is {first}"),
        _ => String::new(),
    };
    let empty = match unanswered {
        0 => String::new(),
        _ if *missing == 0 => ": their answers have no number".to_owned(),
        _ => format!("; {unanswered} of them have an answer without a number"),
    };
    Some(format!("{open} of {}{reason}{empty}", counted(report.asked, "case")))
}

/// The quantities that are never answered.
fn never(report: &Report) -> Option<String> {
    let parts = report.coverage.open_parts();
    let never = parts.values().filter(|count| **count == 0).count();
    if report.coverage.is_of_element() && never > 0 {
        let names = parts.iter().filter(|(_, count)| **count == 0).map(|((_, _, name), _)| *name);
        let verb = if never == 1 { "is" } else { "are" };
        return Some(format!("the {} {verb} never answered", names.collect::<Vec<_>>().join(" and the ")));
    }
    let [_, _, none] = report.coverage.quantities();
    let words = match (never, none) {
        (0, _) => return None,
        (_, 0) => "values or variations of some quantities are never answered".to_owned(),
        (_, none) => format!("{none} of 13 quantities are never answered"),
    };
    Some(words)
}

/// The parts that are answered at some cases alone.
fn partly(report: &Report) -> Option<String> {
    let partly = report.coverage.partly();
    let list = partly.iter().map(|(part, count)| format!("{part} at {count}")).collect::<Vec<_>>().join(", ");
    let of = counted(report.coverage.cases(), "answered case");
    (!partly.is_empty()).then(|| format!("Answered at some cases and not at others: {list} of {of}."))
}

/// The answers that deny a regular closest point.
fn denied(report: &Report) -> Option<String> {
    let (case, place) = report.first_declined.as_ref()?;
    let cases = counted(report.declined, "case");
    Some(format!("At {cases} a regular closest point is denied. The first is case {case}, {place}."))
}

fn lines(parts: &[Option<String>]) -> String {
    parts.iter().flatten().flat_map(|line| ["\n", line]).collect()
}

fn lowered(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Lines that fit a terminal.
fn folded_lines(text: &str) -> String {
    text.lines().map(|line| folded(line, "", "  ")).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::super::verified::Verified;
    use super::verdict;
    use crate::cli::exit::Exit;
    use beamgap::check::external::{Demands, Report, SearchFound};
    use beamgap::check::{SearchFinding, SearchFindingKind};

    #[test]
    fn a_search_that_differs_is_not_trusted() {
        let finding = SearchFinding {
            kind: SearchFindingKind::NotListed,
            at: [0.5, -1.0],
            listed: 2.0,
            independent: 1.0,
        };
        let of = |first| {
            let report = Report {
                vectors: 3,
                compared: 3,
                search: SearchFound { compared: 3, differing: 1, first },
                ..Report::default()
            };
            let demands = Demands::default();
            verdict(&Verified { report, demands, command: String::new(), reason: None, allow_missing: true })
        };
        let untrusted = of(Some(("7".to_owned(), finding)));
        assert_eq!(untrusted.exit, Exit::Untrusted);
        let lines: Vec<&str> = untrusted.words.lines().collect();
        assert!(lines[0].starts_with("UNTRUSTED: the search for closest points differs"), "{lines:?}");
        assert!(lines[2].starts_with("First: case 7: xi = 5e-1, xi_bar = -1e0"), "{lines:?}");
        assert_eq!(of(None).exit, Exit::Agree);
    }
}
