//! The letters of the page, each explained once.

use super::math::{expand, mathml};

/// A letter.
pub(super) struct Symbol {
    pub(super) id: &'static str,
    pub(super) latex: &'static str,
    /// What it is, in prose.
    pub(super) words: &'static str,
    /// Its name in words.
    pub(super) name: &'static str,
    /// What in the LaTeX of an equation shows that it is used.
    keys: Vec<&'static str>,
}

/// The letters of the text file: lines of id, LaTeX, keys, words and name, with bars between.
pub(super) fn all() -> Result<Vec<Symbol>, String> {
    include_str!("symbols.txt")
        .lines()
        .filter(|line| !line.is_empty())
        .map(|line| {
            let parts: Vec<&'static str> = line.split(" | ").collect();
            let [id, latex, keys, words, name] = parts[..] else {
                return Err(format!("{line:?} has not five parts"));
            };
            let keys: Vec<&'static str> = keys.split(' ').filter(|key| *key != "-").collect();
            Ok(Symbol { id, latex, words, name, keys })
        })
        .collect()
}

/// The letters that a formula uses.
fn of_formula(latex: &str) -> Result<Vec<Symbol>, String> {
    let plain = expand(latex).replace('\n', " ");
    let is_used = |symbol: &Symbol| symbol.keys.iter().any(|key| plain.contains(&key.replace('~', " ")));
    Ok(all()?.into_iter().filter(is_used).collect())
}

/// Links to the letters that an equation uses.
pub(super) fn used(latex: &str) -> Result<String, String> {
    let link = |Symbol { id, latex, name, .. }: &Symbol| {
        Ok(format!("<a href=\"#sym-{id}\">{} {name}</a>", mathml(latex, false)?))
    };
    let links: Vec<String> = of_formula(latex)?.iter().map(link).collect::<Result<_, String>>()?;
    Ok(links.join(" "))
}

/// The letter that a formula is, or the only one that it uses.
pub(super) fn of_letter(latex: &str) -> Result<Option<Symbol>, String> {
    let is_letter = |symbol: &Symbol| symbol.latex.split(r",\;").any(|letter| letter == latex.trim());
    if let Some(letter) = all()?.into_iter().find(is_letter) {
        return Ok(Some(letter));
    }
    let mut used = of_formula(latex)?;
    Ok(if used.len() == 1 { used.pop() } else { None })
}

#[cfg(test)]
mod tests {
    use super::{of_letter, used};

    #[test]
    fn letters_are_found_alone_and_in_formulas() {
        assert_eq!(of_letter(r"\vtb").unwrap().map(|symbol| symbol.id), Some("t"));
        assert!(of_letter(r"\vd\cdot\vt").unwrap().is_none());
        assert_eq!(of_letter(r"\vt/2").unwrap().map(|symbol| symbol.id), Some("t"));
        let links = used(r"\vd\cdot\vt=0").unwrap();
        assert!(links.contains("#sym-d") && links.contains("#sym-t") && !links.contains("#sym-u"), "{links}");
    }
}
