//! The comparison of the search for closest points with the independent search, in words.

use super::arguments::program;
use super::case_file;
use super::checked::{Checked, SHOWN};
use super::count::count;
use super::outcome::{Entry, Source, State};
use super::terminal::folded;
use super::words::repeat;
use beamgap::check::{Case, CaseData, SearchFinding, SearchTally, Searched};
use std::fmt::Write;

/// The table of a run: what was compared, and what differs.
pub(super) fn table(checked: &Checked) -> String {
    let search = &checked.found.search;
    let SearchTally { pairs, certain, minima, regions, .. } = search;
    if *pairs == 0 {
        return String::new();
    }
    let mut text = format!(
        "  {} of beams, {certain} of them with certainty\n  {}, {}\n",
        count(*pairs, "pair"),
        count(*minima, "minimum"),
        count(*regions, "open region")
    );
    let all = search.differing();
    if all > 0 {
        let _ = writeln!(text, "  {} in which the two searches differ", count(all, "pair"));
    }
    for (words, finding, command) in differences(checked).take(SHOWN) {
        text += &folded(&format!("{words}: {finding}."), "  ", "    ");
        let _ = write!(text, "\n    repeat with:\n    {command}\n");
    }
    match usize::try_from(all).unwrap_or(usize::MAX).saturating_sub(SHOWN) {
        0 => {}
        rest => drop(writeln!(text, "  and {rest} more")),
    }
    text
}

/// The pairs of beams in which the searches differ: in words, the first difference, and the command that repeats it.
fn differences(checked: &Checked) -> impl Iterator<Item = (String, &SearchFinding, String)> {
    let seed = checked.seed;
    let SearchTally { differences, differences_of_pairs, .. } = &checked.found.search;
    let of_cases = differences.iter().map(move |(&number, finding)| {
        let Case { regime, families: [beam, bar], .. } = Case::draw(seed, number);
        let words = format!("case {number} ({}, {} and {})", regime.name(), beam.name(), bar.name());
        (words, finding, repeat(seed, number))
    });
    let of_pairs = differences_of_pairs.iter().filter_map(move |(&number, finding)| {
        let pair = CaseData::of_search(seed, number)?;
        let [beam, bar] = pair.test_beams.each_ref().map(|beam| beam.family.name());
        let words = format!("pair of case {number} ({beam} and {bar})");
        Some((words, finding, case_file::command(&pair)))
    });
    of_cases.chain(of_pairs)
}

/// The first difference in a line of the verdict.
pub(super) fn verdict(checked: &Checked) -> Option<String> {
    let search = &checked.found.search;
    let (words, finding, command) = differences(checked).next()?;
    Some(words_of(search.differing(), search.pairs, &format!("{words}: {finding}"), &command))
}

/// The verdict on so many pairs.
fn words_of(differing: u64, pairs: u64, first: &str, command: &str) -> String {
    let differs = if differing == 1 { "differs" } else { "differ" };
    let first = folded(&format!("First: {first}."), "", "  ");
    let all = format!(
        "DISAGREE: the search for closest points {differs} from the independent search at {differing} of"
    );
    format!(
        "{}\n{first}\nRepeat: {command}",
        folded(&format!("{all} {} of beams.", count(pairs, "pair")), "", "  ")
    )
}

/// The verdict on one case.
pub(super) fn of_case(Searched { findings, .. }: &Searched) -> Option<String> {
    findings.first()?;
    let mut text = "DISAGREE: the search for closest points differs from the independent search.".to_owned();
    for finding in findings {
        let _ = write!(text, "\n{}", folded(&format!("{finding}."), "", "  "));
    }
    Some(text)
}

/// The result of one case in a few lines.
pub(super) fn in_words(Searched { minima, regions, is_compared, is_certain, findings }: &Searched) -> String {
    if !is_compared {
        return "\nindependent search\n  not compared: the search for closest points failed\n".to_owned();
    }
    let certain = if *is_certain { "with certainty" } else { "not with certainty: boxes were left open" };
    format!(
        "\nindependent search\n  {} and {} found by both searches, {certain}\n  {}\n",
        count(*minima, "minimum"),
        count(*regions, "open region"),
        count(findings.len(), "difference")
    )
}

/// The entry of a result.
pub(super) fn entry(pairs: u64, differing: u64) -> Entry {
    Entry {
        group: "search".to_owned(),
        name: "closest points".to_owned(),
        state: State::of(pairs, differing),
        message: format!(
            "the search for closest points differs from the independent search at {differing} of {} of beams",
            count(pairs, "pair")
        ),
        source: Some(Source { file: "src/closest_point.rs".to_owned(), line: 1 }),
    }
}

/// The command that writes the record of the counts.
pub(super) fn recording() -> String {
    format!("{} check --write-counts src/check/counts.json", program())
}
