//! Lines of the source, selected by comments that name an equation or a mark.

use crate::equations::{Place, SOURCES, named, places};

/// The maximum number of lines shown.
const LINES: usize = 20;

/// Lines that compute an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Snippet {
    /// The file, below `src`.
    pub(super) file: &'static str,
    /// The function that contains the lines, or the item that has the tag.
    pub(super) item: String,
    /// The first equation that the comment names.
    pub(super) owner: u8,
    /// The lines; empty if the item only has a tag.
    pub(super) code: String,
}

/// The place where an equation is computed: the first of its [`places`].
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
    let code = if is_tag { String::new() } else { below(&lines[place.line - 1..], number) };
    Ok(Snippet { file, item: place.item, owner, code })
}

/// A comment and the code below it, up to a comment that does not name the equation, a blank line, or the end of the block.
fn below(lines: &[&str], number: u8) -> String {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let own = indent(lines[0]);
    let is_comment = |line: &str| line.trim_start().starts_with("//");
    let mut end = 0;
    loop {
        end += lines[end..].iter().take_while(|line| is_comment(line)).count();
        let is_code = |line: &&&str| !line.trim().is_empty() && !is_comment(line) && indent(line) >= own;
        end += lines[end..].iter().take_while(is_code).count();
        let goes_on = lines.get(end).is_some_and(|line| indent(line) == own && named(line).contains(&number));
        if !goes_on {
            break;
        }
    }
    let cut = |line: &&str| line[own.min(indent(line))..].trim_end().to_owned();
    let mut shown: Vec<String> = lines[..end.min(LINES)].iter().map(cut).collect();
    if end > LINES {
        shown.push("// ..".to_owned());
    }
    shown.join("\n")
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
        // Concatenated here, so that this file is not counted as one that computes equations.
        let names = |numbers: &str| format!("// {}. {numbers}", "Eq");
        let first = format!("    {}", names("(1): a"));
        let lines = [&first, "    // more", "    let a =", "        1;", "    let b = 2;", "", "    c"]
            .map(str::to_owned);
        let cut = |lines: &[String]| below(&lines.iter().map(String::as_str).collect::<Vec<_>>(), 1);
        assert_eq!(cut(&lines), names("(1): a\n// more\nlet a =\n    1;\nlet b = 2;"));
        let [one, two, three] = ["(1)", "(2), (1)", "(3)"].map(names);
        let (a, b, c) = ("a;".to_owned(), "b;".to_owned(), "}".to_owned());
        let lines = [one.clone(), a, two.clone(), b, three, c];
        assert_eq!(cut(&lines), format!("{one}\na;\n{two}\nb;"));
    }

    #[test]
    fn marks_that_are_missing_are_errors() {
        assert_eq!(marked("x\n  // mark: a\n  b\n    c\n  // end: a", "a").unwrap(), "b\n  c");
        assert!(marked("// mark: a\nb", "a").is_err() && marked("// mark: a\n// end: a", "a").is_err());
    }
}
