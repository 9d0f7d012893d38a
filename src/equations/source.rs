//! The places of an equation in the source, found by the comments in the text of the files.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A line of the source that names an equation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// The file, below `src`.
    pub file: String,
    /// The function or type that contains the line.
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
// Files that compute come first.
sources![
    "linearization/closed_form/paper/points.rs",
    "linearization/closed_form/paper/parameters.rs",
    "linearization/closed_form/paper/distance.rs",
    "linearization/closed_form/paper/lengths.rs",
    "linearization/closed_form/variations.rs",
    "linearization/closed_form/projection.rs",
    "linearization/closed_form/matrices.rs",
    "linearization/closed_form/matrices/distance.rs",
    "linearization/closed_form/matrices/parameters.rs",
    "linearization/closed_form/matrices/vector.rs",
    "linearization/closed_form/sums.rs",
    "linearization/closed_form/kernel/solution.rs",
    "linearization/closed_form/kernel/distance.rs",
    "linearization/closed_form/partial_variations.rs",
    "linearization/derivatives.rs",
    "linearization/quantities.rs",
    "linearization/ad/evaluate.rs",
    "linearization/ad/lift.rs",
    "linearization/ad/orders.rs",
    "closest_point/squared_distance.rs",
    "check/evaluation_point/refined.rs",
    "curve.rs",
];

/// All places of all equations: lines that compute before items that only have a tag.
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

/// The function that contains a comment: the nearest above it with less indentation.
fn above<'a>(lines: &[&'a str], at: usize) -> Option<&'a str> {
    let indent = |line: &str| line.len() - line.trim_start().len();
    lines[..at].iter().rev().filter(|line| indent(line) < indent(lines[at])).find_map(|line| name(line))
}

/// The item that follows a tag.
fn below<'a>(lines: &[&'a str], at: usize) -> Option<&'a str> {
    lines[at + 1..].iter().find_map(|line| name(line))
}

#[cfg(test)]
mod tests {
    use super::{SOURCES, above, below, name, named, places};

    #[test]
    fn the_first_word_after_what_begins_an_item_is_its_name() {
        assert_eq!(name("    pub(crate) const fn delta<T>(x: T) -> T {"), Some("delta"));
        assert_eq!(name("pub struct Closed_Form;"), Some("Closed_Form"));
        assert_eq!(name("pub(super) trait Terms: Copy {"), Some("Terms"));
        for line in ["", "    // fn", "let fn_like = 1;", "impl Terms for Unmodified {", "pub use fnord;"] {
            assert_eq!(name(line), None, "{line}");
        }
    }

    #[test]
    fn a_comment_belongs_to_the_function_around_it_and_a_tag_to_the_item_below() {
        let lines = [
            "fn before() {}",
            "impl A {",
            "    fn around() {",
            "        fn beside() {}",
            "        // Eq. (1)",
            "        let a = 1;",
            "    }",
            "    fn after() {}",
        ];
        assert_eq!(above(&lines, 4), Some("around"));
        assert_eq!(below(&lines, 4), Some("after"));
        assert_eq!((above(&lines, 0), below(&lines, 7)), (None, None));
        assert_eq!(below(&lines, 1), Some("around"));
    }

    #[test]
    fn places_are_where_they_are_said_to_be() {
        let places = places();
        assert_eq!(places.keys().copied().collect::<Vec<u8>>(), (1..=59).collect::<Vec<u8>>());
        let mut found = 0;
        for (number, places) in places {
            let mut tagged = false;
            for place in places {
                let (_, text) = SOURCES.iter().find(|(file, _)| *file == place.file).unwrap();
                let line = text.lines().nth(place.line - 1).unwrap();
                assert!(named(line).contains(&number) && text.contains(&place.item), "({number}): {place:?}");
                // Lines that compute come before items with a tag.
                let tag = line.contains("#[doc(alias");
                assert!(tag || !tagged, "({number}): {place:?}");
                tagged = tag;
                found += 1;
            }
        }
        let lines = SOURCES.iter().flat_map(|(_, text)| text.lines());
        assert_eq!(found, lines.map(|line| named(line).len()).sum::<usize>());
    }

    #[test]
    fn lists_and_ranges_are_read() {
        assert_eq!(named("// Eq. (4)-(7), (9), with (10)"), [4, 5, 6, 7, 9]);
        assert_eq!(named("// Eq. (37), from (36): and Eq. (38) and (39)"), [37, 36, 38, 39]);
        assert_eq!(named("// Eq. (2), (5) from (7)"), [2, 5, 7]);
        assert!(named("// (3), Eq. 3, Eq. (x), Eq. ()").is_empty());
    }
}
