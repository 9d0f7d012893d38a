//! The markup of a line of prose: formulas, strong words, code, numbers of equations, links.

use super::math::mathml;
use std::fmt::Write;

/// The id and the name of the letter that a formula is.
type Letter<'a> = dyn Fn(&str) -> Result<Option<[&'static str; 2]>, String> + 'a;

/// A line of text with `$formulas$`, `**strong**`, `` `code` `` and numbers of equations. The numbers become links.
pub(super) fn inline(text: &str) -> Result<String, String> {
    line(text, &|_| Ok(None))
}

/// The same. `letter` returns the id and the name of a formula that is a letter with an explanation.
pub(super) fn line(text: &str, letter: &Letter) -> Result<String, String> {
    let mut out = String::new();
    for (i, part) in text.split('$').enumerate() {
        if i % 2 == 1 {
            let math = mathml(part, false)?;
            match letter(part)? {
                // Screen readers do not read the formula of a link.
                Some([id, name]) => {
                    let _ = write!(out, "<a class=\"letter\" title=\"{name}\" href=\"#sym-{id}\">{math}</a>");
                }
                None => out += &math,
            }
            continue;
        }
        for (i, part) in part.split('`').enumerate() {
            if i % 2 == 1 {
                let _ = write!(out, "<code>{}</code>", escaped(part));
                continue;
            }
            for (i, part) in part.split("**").enumerate() {
                let linked = links(&escaped(part));
                let mark = if i % 2 == 1 { ["<strong>", "</strong>"] } else { ["", ""] };
                out.extend([mark[0], &linked, mark[1]]);
            }
        }
    }
    if text.matches('$').count() % 2 == 1 {
        return Err(format!("a $ is missing in {text:?}"));
    }
    Ok(out)
}

/// `(40)` as a link to the equation, `[words](#id)` as a link.
fn links(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(['(', '[']) {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        let number = rest.strip_prefix('(').and_then(|rest| rest.split_once(')'));
        let number = number.filter(|(n, _)| n.parse::<u8>().is_ok_and(|n| (1..=59).contains(&n)));
        let words = rest.strip_prefix('[').and_then(|rest| rest.split_once("]("));
        if let Some((number, after)) = number {
            let _ = write!(out, "<a href=\"#eq-{number}\">({number})</a>");
            rest = after;
        } else if let Some((words, (target, after))) =
            words.and_then(|(words, rest)| Some((words, rest.split_once(')')?)))
        {
            let _ = write!(out, "<a href=\"{target}\">{words}</a>");
            rest = after;
        } else {
            out.push_str(&rest[..1]);
            rest = &rest[1..];
        }
    }
    out + rest
}

pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
