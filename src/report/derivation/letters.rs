//! The letters of the page, each explained once.

use super::inline::inline;
use super::math::{mathml, parsed, with_macros};
use pulldown_latex::Storage;
use pulldown_latex::event::{Content, Event, Font, ScriptPosition, ScriptType, StateChange, Visual};

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

/// The letters of a formula in their order, each with its index and without bars, with a space around each:
/// `\bar g_N=\frac d2\vt_{,\xi}` has ` g_N = d 2 \mathbf{t}_,ξ ξ `.
///
/// Superscripts, and indices that are not derivatives, contain no letters.
fn letters(latex: &str) -> Result<String, String> {
    let (source, storage) = (with_macros(latex), Storage::new());
    let events = parsed(&source, &storage)?.into_iter();
    let mut reader = Reader { events, found: Vec::new(), font: None };
    reader.group();
    Ok(format!(" {} ", reader.found.join(" ")))
}

/// Reads the letters of what is parsed.
struct Reader<'a> {
    events: std::vec::IntoIter<Event<'a>>,
    found: Vec<String>,
    font: Option<Font>,
}

impl Reader<'_> {
    /// Reads to the end of the group.
    fn group(&mut self) {
        let font = self.font;
        while let Some(event) = self.events.next().filter(|event| *event != Event::End) {
            self.element(&event);
        }
        self.font = font;
    }

    fn element(&mut self, event: &Event) {
        match event {
            Event::Begin(_) => self.group(),
            Event::StateChange(StateChange::Font(font)) => self.font = *font,
            Event::Content(content) => self.found.extend(self.letter(*content)),
            Event::Script { position: ScriptPosition::AboveBelow, .. } => {
                let (base, accent) = (self.apart(), self.apart());
                let is_hat = accent == ["^"];
                self.found
                    .extend(base.into_iter().map(|letter| if is_hat { "\\hat".to_owned() } else { letter }));
            }
            Event::Script { ty, .. } => {
                self.next();
                if *ty != ScriptType::Superscript {
                    self.index();
                }
                if *ty != ScriptType::Subscript {
                    self.apart();
                }
            }
            Event::Visual(visual) => {
                self.next();
                if matches!(visual, Visual::Fraction(_) | Visual::Root) {
                    self.next();
                }
            }
            _ => {}
        }
    }

    fn next(&mut self) {
        if let Some(event) = self.events.next() {
            self.element(&event);
        }
    }

    /// The letters of the next element alone.
    fn apart(&mut self) -> Vec<String> {
        let before = std::mem::take(&mut self.found);
        self.next();
        std::mem::replace(&mut self.found, before)
    }

    /// Adds the next element to the last letter. In a derivative, it is a letter too.
    fn index(&mut self) {
        let index = self.apart();
        match self.found.last_mut() {
            // The limit of an integral is not an index.
            Some(last) if last != "∫" => {
                last.push('_');
                last.push_str(&index.concat());
            }
            _ => return self.found.extend(index),
        }
        if index.iter().any(|letter| letter == ",") {
            self.found.extend(index.into_iter().find(|letter| letter == "ξ"));
        }
    }

    fn letter(&self, content: Content) -> Option<String> {
        let of = |letter: char| Some(letter.to_string());
        match content {
            Content::Ordinary { content, .. } => match self.font {
                None => of(content),
                Some(Font::Bold) => Some(format!("\\mathbf{{{content}}}")),
                // A word is a letter that is no symbol of the page.
                Some(_) => Some("word".to_owned()),
            },
            Content::Text("&nbsp;") => None,
            Content::Text(_) | Content::Function(_) => Some("word".to_owned()),
            Content::Number(digits) => Some(digits.to_owned()),
            Content::Relation { content, .. } => {
                Some(String::from_utf8_lossy(content.encode_utf8_to_buf(&mut [0; 8])).into_owned())
            }
            Content::LargeOp { content, .. }
            | Content::BinaryOp { content, .. }
            | Content::Delimiter { content, .. }
            | Content::Punctuation(content) => of(content),
        }
    }
}

/// Whether the page does not explain the letter.
fn is_other(letter: &str, symbols: &[Symbol]) -> bool {
    let alone = letter.chars().count() == 1 && letter.chars().all(|c| c.is_alphabetic() || "∇∂".contains(c));
    let is_letter = alone || letter == "word" || letter.starts_with("\\mathbf");
    let has_index = letter.contains('_') && !letter.starts_with('\\');
    (is_letter || has_index) && !symbols.iter().any(|symbol| symbol.is_in(&format!(" {letter} ")))
}

/// Links to the letters that an equation uses.
pub(super) fn used(latex: &str) -> Result<String, String> {
    let letters = letters(latex)?;
    let link = |Symbol { id, latex, name, words, .. }: &Symbol| {
        let meaning = inline(words)?;
        let letter = mathml(latex, false)?;
        Ok(format!("<a href=\"#sym-{id}\">{letter} {name}<span class=\"tip\">{meaning}</span></a>"))
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
    let letters = letters(latex)?;
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
        let letters = |latex| letters(latex).unwrap();
        assert_eq!(letters(r"\bar g_N=\frac d2\vt_{,\xi}"), r" g_N = d 2 \mathbf{t}_,ξ ξ ");
        assert_eq!(letters(r"\begin{aligned}\xb_{\bar C_0}\\[2pt]&\uh^2\end{aligned}"), r" ξ_C_0 \hat_C ");
        assert_eq!(
            letters(r"\mathbf X+\operatorname{Hess}\,\bar{\mathbf{x}}_{\bar C}"),
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
        assert_eq!(ids(r"\vn=\vd/d^\frac{t}{2}"), ["d", "n"]);
        assert_eq!(ids(r"\vt=\vx_{C,\xi}"), ["x", "xi", "t"]);
    }
}
