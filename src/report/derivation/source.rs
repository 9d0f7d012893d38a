//! Lines of the source, cut where comments name an equation or a mark.

use crate::equations::{Place, SOURCES, named, places};

/// The most lines that are shown.
const LINES: usize = 20;

/// Lines that compute an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Snippet {
    /// The file, below `src`.
    pub(super) file: &'static str,
    /// The function around the lines, or the item that is tagged.
    pub(super) item: String,
    /// The equation that the comment names first.
    pub(super) owner: u8,
    /// The lines; none if the item is only tagged.
    pub(super) code: String,
}

/// Where an equation is computed: the first of its [`places`].
///
/// # Errors
/// If the source does not name it.
pub(super) fn of_equation(number: u8) -> Result<Snippet, String> {
    // The checks use the equations; they do not derive them.
    let is_derived = |place: &Place| !place.file.starts_with("check");
    let place = places().remove(&number).and_then(|places| places.into_iter().find(is_derived));
    let place = place.ok_or_else(|| format!("no line of the source names ({number})"))?;
    let (file, text) = SOURCES
        .iter()
        .find(|(file, _)| *file == place.file)
        .ok_or_else(|| format!("{} is not among the sources", place.file))?;
    let lines: Vec<&str> = text.lines().collect();
    let first = lines[place.line - 1];
    let is_tag = first.trim_start().starts_with("#[doc(alias");
    let owner = named(first).first().copied().unwrap_or(number);
    let code = if is_tag { String::new() } else { below(&lines[place.line - 1..]) };
    Ok(Snippet { file, item: place.item, owner, code })
}

/// A comment and the code below it: to the next comment, the next blank line, or the end of the block.
fn below(lines: &[&str]) -> String {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let own = indent(lines[0]);
    let is_comment = |line: &str| line.trim_start().starts_with("//");
    let comments = lines.iter().take_while(|line| is_comment(line)).count();
    let more = lines[comments..]
        .iter()
        .take_while(|line| !line.trim().is_empty() && !is_comment(line) && indent(line) >= own)
        .count();
    let shown = &lines[..(comments + more).min(LINES)];
    let cut = |line: &&str| line[own.min(indent(line))..].trim_end().to_owned();
    shown.iter().map(cut).collect::<Vec<_>>().join("\n")
}

/// The lines between `// mark: name` and `// end: name`.
///
/// # Errors
/// If one of the two is missing.
pub(super) fn marked(text: &str, name: &str) -> Result<String, String> {
    let lines: Vec<&str> = text.lines().collect();
    let find = |what: &str| {
        let mark = format!("// {what}: {name}");
        lines.iter().position(|line| line.trim() == mark).ok_or_else(|| format!("`{mark}` is missing"))
    };
    let (from, to) = (find("mark")? + 1, find("end")?);
    let cut = lines.get(from..to).filter(|cut| !cut.is_empty());
    let cut = cut.ok_or_else(|| format!("nothing stands between the marks of {name}"))?;
    let indent = cut[0].len() - cut[0].trim_start().len();
    let cut = cut.iter().map(|line| line.get(indent..).unwrap_or_default());
    Ok(cut.collect::<Vec<_>>().join("\n"))
}

#[cfg(test)]
mod tests {
    use super::{below, marked, of_equation};

    #[test]
    fn every_equation_has_a_place_and_those_that_are_computed_have_lines() {
        let with_code: Vec<u8> =
            (1..=59).filter(|&number| !of_equation(number).unwrap().code.is_empty()).collect();
        assert!(with_code.len() >= 45, "{with_code:?}");
        for number in [20, 21, 32, 37, 40, 42, 50, 52, 54, 55] {
            let snippet = of_equation(number).unwrap();
            let code = snippet.code.lines().filter(|line| !line.trim_start().starts_with("//"));
            assert!(code.count() > 0, "({number}): {snippet:?}");
        }
    }

    #[test]
    fn a_comment_is_cut_with_the_code_below_it() {
        let lines =
            ["    // Eq. (1): a", "    // more", "    let a =", "        1;", "    let b = 2;", "", "    c"];
        assert_eq!(below(&lines), "// Eq. (1): a\n// more\nlet a =\n    1;\nlet b = 2;");
        assert_eq!(below(&["  // Eq.", "  a;", "}"]), "// Eq.\na;");
    }

    #[test]
    fn marks_that_are_missing_are_errors() {
        assert_eq!(marked("x\n  // mark: a\n  b\n    c\n  // end: a", "a").unwrap(), "b\n  c");
        assert!(marked("// mark: a\nb", "a").is_err() && marked("// mark: a\n// end: a", "a").is_err());
    }
}
