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
    "contact/geometry.rs",
    "contact/closed_form/assemble.rs",
    "contact/ad.rs",
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
                let item = item(&lines, i).and_then(|at| name(lines[at])).unwrap_or_default().to_owned();
                let kinds = found.entry(number).or_default();
                kinds[usize::from(is_tag(line))].push(Place { file: (*file).to_owned(), item, line: i + 1 });
            }
        }
    }
    found.into_iter().map(|(number, [lines, tags])| (number, [lines, tags].concat())).collect()
}

/// The function that computes the result of an equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Definition {
    /// The file, below `src`.
    pub file: &'static str,
    /// The name of the function, or of a type if only that has the tag of the equation.
    pub item: &'static str,
    /// The first line of its documentation.
    pub from: usize,
    /// The line with its name.
    pub line: usize,
    /// Its last line.
    pub to: usize,
}

/// The first function with the tag of the equation, otherwise the first one with a line that computes it.
pub fn definition(number: u8) -> Option<Definition> {
    let found = places().remove(&number)?.into_iter().filter_map(|place| {
        let (file, text) = SOURCES.iter().find(|(file, _)| *file == place.file)?;
        let lines: Vec<&str> = text.lines().collect();
        let at = item(&lines, place.line - 1)?;
        let (from, to) = span(&lines, at);
        let is_function = lines[at].split_whitespace().any(|word| word == "fn");
        let definition = Definition { file, item: name(lines[at])?, from, line: at + 1, to };
        Some(((!is_function, !is_tag(lines[place.line - 1])), definition))
    });
    found.min_by_key(|(order, _)| *order).map(|(_, definition)| definition)
}

/// The first and the last line of an item with its documentation and attributes.
fn span(lines: &[&str], at: usize) -> (usize, usize) {
    let is_about = |line: &&&str| ["///", "#["].iter().any(|mark| line.trim_start().starts_with(mark));
    let about = lines[..at].iter().rev().take_while(is_about).count();
    let is_end = |line: &&str| indent(line) == indent(lines[at]) && line.ends_with(['}', ';']);
    let below = lines[at..].iter().position(is_end).unwrap_or_default();
    (at - about + 1, at + below + 1)
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
    let mut line = line.trim_start();
    if let Some(public) = line.strip_prefix("pub") {
        // The path of `pub(in path)` is no name.
        line =
            public.strip_prefix('(').and_then(|path| path.split_once(')')).map_or(public, |(_, item)| item);
    }
    let mut words = line.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
    let word = words.by_ref().find(|&word| word != "const")?;
    ["fn", "struct", "enum", "trait", "type"].contains(&word).then(|| words.next())?
}

fn is_tag(line: &str) -> bool {
    line.trim_start().starts_with("#[doc(alias")
}

fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

/// The line of the item that a tag or a comment belongs to.
fn item(lines: &[&str], at: usize) -> Option<usize> {
    let around = if is_tag(lines[at]) { None } else { above(lines, at) };
    around.or_else(|| below(lines, at))
}

/// The function that contains a comment: the nearest above it with less indentation.
fn above(lines: &[&str], at: usize) -> Option<usize> {
    (0..at).rev().find(|&i| indent(lines[i]) < indent(lines[at]) && name(lines[i]).is_some())
}

/// The item that follows a tag.
fn below(lines: &[&str], at: usize) -> Option<usize> {
    (at + 1..lines.len()).find(|&i| name(lines[i]).is_some())
}

#[cfg(test)]
mod tests {
    use super::{SOURCES, above, below, definition, name, named, places};

    #[test]
    fn the_first_word_after_what_begins_an_item_is_its_name() {
        assert_eq!(name("    pub(crate) const fn delta<T>(x: T) -> T {"), Some("delta"));
        assert_eq!(name("pub struct Closed_Form;"), Some("Closed_Form"));
        assert_eq!(name("pub(super) trait Terms: Copy {"), Some("Terms"));
        assert_eq!(name("pub(in crate::contact) fn assemble("), Some("assemble"));
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
        assert_eq!((above(&lines, 4), below(&lines, 4)), (Some(2), Some(7)));
        assert_eq!((above(&lines, 0), below(&lines, 7)), (None, None));
        assert_eq!(below(&lines, 1), Some(2));
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
    fn the_definition_of_an_equation_names_it_and_its_function() {
        for number in 1..=59 {
            let definition = definition(number).unwrap();
            let (_, text) = SOURCES.iter().find(|(file, _)| *file == definition.file).unwrap();
            let lines: Vec<&str> = text.lines().collect();
            let shown = &lines[definition.from - 1..definition.to];
            assert!(shown.iter().any(|line| named(line).contains(&number)), "({number}): {definition:?}");
            assert_eq!(name(lines[definition.line - 1]), Some(definition.item), "({number})");
            // It begins with the documentation, and the braces are balanced.
            assert!(shown[0].trim_start().starts_with("//"), "({number}): {definition:?}");
            let count = |brace| shown.concat().matches(brace).count();
            assert_eq!(count('{'), count('}'), "({number}): {definition:?}");
        }
        let item = |number| definition(number).unwrap().item;
        assert_eq!([20, 40, 52, 59].map(item), ["delta_slip", "second_distance", "delta_xi", "second_xi"]);
    }

    #[test]
    fn lists_and_ranges_are_read() {
        assert_eq!(named("// Eq. (4)-(7), (9), with (10)"), [4, 5, 6, 7, 9]);
        assert_eq!(named("// Eq. (37), from (36): and Eq. (38) and (39)"), [37, 36, 38, 39]);
        assert_eq!(named("// Eq. (2), (5) from (7)"), [2, 5, 7]);
        assert!(named("// (3), Eq. 3, Eq. (x), Eq. ()").is_empty());
    }
}
