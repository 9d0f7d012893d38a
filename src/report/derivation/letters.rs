//! The letters of the page, each explained once.

use super::math::{expand, mathml};

/// A letter.
pub(super) struct Symbol {
    pub(super) id: &'static str,
    pub(super) latex: &'static str,
    /// Its meaning, in prose.
    pub(super) words: &'static str,
    /// Its name in words.
    pub(super) name: &'static str,
    /// The keys of the letter: if [`letters`] writes one of them for an equation, the equation uses the letter.
    keys: Vec<&'static str>,
}

impl Symbol {
    fn is_in(&self, letters: &str) -> bool {
        self.keys.iter().any(|key| letters.contains(&key.replace('~', " ")))
    }
}

/// The letters of the text file: lines of id, LaTeX, keys, words and name, separated by bars. In a key `~` is a space.
pub(super) fn all() -> Result<Vec<Symbol>, String> {
    include_str!("symbols.txt")
        .lines()
        .filter(|line| !line.is_empty())
        .map(|line| {
            let parts: Vec<&'static str> = line.split(" | ").collect();
            let [id, latex, keys, words, name] = parts[..] else {
                return Err(format!("{line:?} has not five parts"));
            };
            Ok(Symbol { id, latex, words, name, keys: keys.split(' ').collect() })
        })
        .collect()
}

/// The letters of a formula in their order, each with its subscript and without bars, with a space around each:
/// `\bar g_N=\frac d2\vt_{,\xi}` has ` g_N = \frac d 2 \mathbf{t}_,\xi \xi `.
///
/// The arguments of commands for words, superscripts, and subscripts that are not derivatives contain no letters.
fn letters(latex: &str) -> String {
    let text: Vec<char> = expand(latex).chars().collect();
    let mut found = vec![String::new()];
    read(&text, &mut found);
    found.push(String::new());
    found.join(" ")
}

/// The argument of a command, a `_` or a `^`: a group without its braces, a command with its argument, or one character.
fn argument(text: &[char], mut at: usize) -> (&[char], usize) {
    while text.get(at).is_some_and(|c| c.is_whitespace()) {
        at += 1;
    }
    match text.get(at) {
        Some('{') => {
            let mut depth = 0;
            let end = text[at..].iter().position(|c| {
                depth += i32::from(*c == '{') - i32::from(*c == '}');
                depth == 0
            });
            let end = end.map_or(text.len(), |end| at + end);
            (&text[(at + 1).min(end)..end], (end + 1).min(text.len()))
        }
        Some('\\') => {
            let end = after_name(text, at + 1);
            let is_accent = ["bar", "hat", "mathbf", "mathsf", "mathrm"].map(|name| format!("\\{name}"));
            let name: String = text[at..end].iter().collect();
            let end = if is_accent.contains(&name) { argument(text, end).1 } else { end };
            (&text[at..end], end)
        }
        Some(_) => (&text[at..=at], at + 1),
        None => (&[], at),
    }
}

/// The end of the name of a command: one character that is not a letter, or all letters.
fn after_name(text: &[char], at: usize) -> usize {
    let letters = text[at..].iter().take_while(|c| c.is_ascii_alphabetic()).count();
    (at + letters.max(1)).min(text.len())
}

fn read(text: &[char], found: &mut Vec<String>) {
    let mut at = 0;
    while let Some(&c) = text.get(at) {
        match c {
            '{' => {
                let (group, end) = argument(text, at);
                read(group, found);
                at = end;
            }
            '^' => at = argument(text, at + 1).1,
            '_' => {
                let (group, end) = argument(text, at + 1);
                at = end;
                // The limit of an integral is not an index.
                if found.last().is_some_and(|last| last == "\\int") {
                    read(group, found);
                    continue;
                }
                let plain: String = group.iter().collect();
                let plain = plain.replace("\\bar", "").replace(['{', '}', ' '], "");
                if let Some(last) = found.last_mut() {
                    *last += "_";
                    *last += &plain;
                }
                if plain.contains(',') {
                    found.extend(plain.contains("\\xi").then(|| "\\xi".to_owned()));
                }
            }
            '\\' => {
                let end = after_name(text, at + 1);
                let name: String = text[at + 1..end].iter().collect();
                at = command(&name, text, end, found);
            }
            _ if c.is_whitespace() || c == '&' => at += 1,
            _ => {
                found.push(c.to_string());
                at += 1;
            }
        }
    }
}

/// Reads a command whose name ends at `end`. Returns the position after it.
fn command(name: &str, text: &[char], end: usize, found: &mut Vec<String>) -> usize {
    match name {
        "bar" => {
            let (group, end) = argument(text, end);
            read(group, found);
            end
        }
        "mathbf" | "hat" => {
            let (group, end) = argument(text, end);
            let mut inner = Vec::new();
            read(group, &mut inner);
            let inner = inner.into_iter().map(|letter| {
                if name == "hat" { "\\hat".to_owned() } else { format!("\\mathbf{{{letter}}}") }
            });
            found.extend(inner);
            end
        }
        // A word is a letter that is no symbol of the page.
        "mathrm" | "mathsf" | "text" | "operatorname" => {
            found.push("word".to_owned());
            argument(text, end).1
        }
        "begin" | "end" => argument(text, end).1,
        "\\" => {
            let skip = text.get(end) == Some(&'[');
            let close = text[end..].iter().position(|c| *c == ']').filter(|_| skip);
            close.map_or(end, |close| end + close + 1)
        }
        _ if !name.starts_with(|c: char| c.is_ascii_alphabetic()) => end,
        _ => {
            found.push(format!("\\{name}"));
            end
        }
    }
}

/// Commands that are letters or change the meaning of a letter, and are not symbols of the page.
const OTHERS: [&str; 5] = ["\\nabla", "\\partial", "\\varepsilon", "\\epsilon", "\\theta"];

/// Whether the page does not explain the letter.
fn is_other(letter: &str, symbols: &[Symbol]) -> bool {
    let alone = letter.chars().count() == 1 && letter.chars().all(char::is_alphabetic);
    let base = letter.split('_').next().unwrap_or(letter);
    let is_letter = alone || letter == "word" || letter.starts_with("\\mathbf") || OTHERS.contains(&base);
    let has_index = letter.contains('_') && !letter.starts_with('\\');
    (is_letter || has_index) && !symbols.iter().any(|symbol| symbol.is_in(&format!(" {letter} ")))
}

/// Links to the letters that an equation uses.
pub(super) fn used(latex: &str) -> Result<String, String> {
    let letters = letters(latex);
    let link = |Symbol { id, latex, name, .. }: &Symbol| {
        Ok(format!("<a href=\"#sym-{id}\">{} {name}</a>", mathml(latex, false)?))
    };
    let links = all()?.into_iter().filter(|symbol| symbol.is_in(&letters));
    Ok(links.map(|symbol| link(&symbol)).collect::<Result<Vec<_>, String>>()?.join(" "))
}

/// The letter that is the formula, or the only letter in the formula.
pub(super) fn of_letter(latex: &str) -> Result<Option<Symbol>, String> {
    let mut symbols = all()?;
    let is_letter = |symbol: &Symbol| symbol.latex.split(r",\;").any(|letter| letter == latex.trim());
    if let Some(at) = symbols.iter().position(is_letter) {
        return Ok(Some(symbols.swap_remove(at)));
    }
    let letters = letters(latex);
    if letters.split(' ').any(|letter| is_other(letter, &symbols)) {
        return Ok(None);
    }
    symbols.retain(|symbol| symbol.is_in(&letters));
    Ok(if symbols.len() == 1 { symbols.pop() } else { None })
}

#[cfg(test)]
mod tests {
    use super::{letters, of_letter, used};

    /// The ids of the letters that a formula is said to use.
    fn ids(latex: &str) -> Vec<String> {
        let links = used(latex).unwrap();
        links.split("#sym-").skip(1).map(|rest| rest.split('"').next().unwrap().to_owned()).collect()
    }

    #[test]
    fn letters_are_read_with_their_subscripts_and_without_bars() {
        assert_eq!(letters(r"\bar g_N=\frac d2\vt_{,\xi}"), r" g_N = \frac d 2 \mathbf{t}_,\xi \xi ");
        assert_eq!(letters(r"\begin{aligned}\xb_{\bar C_0}\\[2pt]&\uh^2\end{aligned}"), r" \xi_C_0 \hat_C ");
        assert_eq!(
            letters(r"\mathbf X+\mathrm{Hess}\,\bar{\mathbf{x}}_{\bar C}"),
            r" \mathbf{X} + word \mathbf{x}_C "
        );
    }

    #[test]
    fn letters_are_found_alone_and_in_formulas() {
        let id = |latex| of_letter(latex).unwrap().map(|symbol| symbol.id);
        assert_eq!((id(r"\vtb"), id(r"\vt/2"), id("g_N=0.25")), (Some("t"), Some("t"), Some("gN")));
        // Two letters, a letter that the page does not explain, an index.
        assert_eq!(
            (id(r"\vd\cdot\vt"), id("f(Q)"), id(r"b=\vt\cdot\vtb"), id(r"f_{,p}")),
            (None, None, None, None)
        );
        assert_eq!(ids(r"\vd\cdot\vt=0"), ["d", "t"]);
    }

    #[test]
    fn commands_and_indices_are_no_letters() {
        assert_eq!(ids(r"\int_{\xi_{C_0}}^{\xi_C}\lVert\vx_{,\xi}\rVert\,\mathrm{d}\xi"), ["x", "xi", "xi0"]);
        assert_eq!(ids(r"\begin{aligned}\delta g_N,\qquad\bar g_T\end{aligned}"), ["gN", "gT", "delta"]);
        assert_eq!(ids(r"J_d=G+\vt g^{\mathsf T}"), ["t", "A", "g", "J"]);
        assert_eq!(ids(r"\Delta_u\delta_u\uh"), ["delta", "Delta", "uhat", "K"]);
        assert_eq!(ids(r"\vn=\vd/d"), ["d", "n"]);
        assert_eq!(ids(r"\vt=\vx_{C,\xi}"), ["x", "xi", "t"]);
    }
}
