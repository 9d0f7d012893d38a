//! Where in the source an equation is: found in the text of the files, by what their comments say.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A line of the source that names an equation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// The file, below `src`.
    pub file: String,
    /// The function or type that the line belongs to.
    pub item: String,
    /// The line.
    pub line: usize,
}

macro_rules! sources {
    ($($file:literal),* $(,)?) => {
        /// The files that name equations, with their text.
        pub const SOURCES: &[(&str, &str)] = &[$(($file, include_str!(concat!("../", $file)))),*];
    };
}
// Those that compute come first.
sources![
    "linearization/closed_form/variations.rs",
    "linearization/closed_form/norms.rs",
    "linearization/closed_form/projection.rs",
    "linearization/closed_form/matrices.rs",
    "linearization/closed_form/matrices/parameters.rs",
    "linearization/closed_form/matrices/vector.rs",
    "linearization/closed_form/sums.rs",
    "linearization/closed_form/frozen.rs",
    "linearization/expansion.rs",
    "linearization/quantities.rs",
    "linearization/ad/evaluate.rs",
    "linearization/ad/lift.rs",
    "closest_point/half_square.rs",
    "check/site.rs",
    "curve.rs",
];

/// All places of all equations: lines that compute before items that are only tagged.
pub fn places() -> BTreeMap<u8, Vec<Place>> {
    let mut found: BTreeMap<u8, [Vec<Place>; 2]> = BTreeMap::new();
    for (file, text) in SOURCES {
        let lines: Vec<&str> = text.lines().collect();
        for (i, line) in lines.iter().enumerate() {
            for number in named(line) {
                let tag = line.trim_start().starts_with("#[doc(alias");
                let item = if tag { below(&lines, i) } else { above(&lines, i).or_else(|| below(&lines, i)) };
                let item = item.unwrap_or_default().to_owned();
                let kinds = found.entry(number).or_default();
                kinds[usize::from(tag)].push(Place { file: (*file).to_owned(), item, line: i + 1 });
            }
        }
    }
    found.into_iter().map(|(number, [lines, tags])| (number, [lines, tags].concat())).collect()
}

/// The equations that a line names: `Eq. (4), (5)`, `Eq. (4)-(15)`, `Eq. (40), from (38) and (39)`.
pub fn named(line: &str) -> Vec<u8> {
    const SEPARATORS: [&str; 5] = [", from ", " from ", " and ", ", ", "-"];
    let mut numbers = Vec::new();
    for mut rest in line.split("Eq. ").skip(1) {
        let mut range = false;
        while let Some((number, after)) = rest.strip_prefix('(').and_then(|rest| rest.split_once(')')) {
            let Ok(number) = number.parse::<u8>() else { break };
            let first = if range { numbers.last().map_or(number, |last| last + 1) } else { number };
            numbers.extend(first..=number);
            let Some(separator) = SEPARATORS.iter().find(|&&s| after.starts_with(&format!("{s}("))) else {
                break;
            };
            range = *separator == "-";
            rest = &after[separator.len()..];
        }
    }
    numbers
}

/// The name that a line introduces, if it begins an item.
fn name(line: &str) -> Option<&str> {
    let mut words =
        line.trim_start().split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
    let mut word = words.next()?;
    while ["pub", "crate", "super", "const"].contains(&word) {
        word = words.next()?;
    }
    ["fn", "struct", "enum", "trait", "type"].contains(&word).then(|| words.next())?
}

/// The function that a comment stands in: the nearest above it that is indented less.
fn above<'a>(lines: &[&'a str], at: usize) -> Option<&'a str> {
    let indent = |line: &str| line.len() - line.trim_start().len();
    lines[..at].iter().rev().filter(|line| indent(line) < indent(lines[at])).find_map(|line| name(line))
}

/// The item that a tag stands before.
fn below<'a>(lines: &[&'a str], at: usize) -> Option<&'a str> {
    lines[at + 1..].iter().find_map(|line| name(line))
}
