//! The text of a formula as a tree.
//!
//! `a b` is a product, `a.b` a scalar product, `a ? b : c` is b where a is not zero, else c. From weak to strong: choice,
//! comparison, sum, product and quotient, scalar product.

use super::tree::{Names, Op, Tree};

/// A text that is read from left to right.
pub(super) struct Parser<'a> {
    rest: &'a str,
    names: &'a mut Names,
}

impl<'a> Parser<'a> {
    /// The formula, and the names that it has.
    ///
    /// # Errors
    /// The text that cannot be read.
    pub(super) fn tree(text: &'a str, names: &'a mut Names) -> Result<Tree, String> {
        let mut parser = Self { rest: text.trim(), names };
        let tree = parser.choice()?;
        if parser.rest.is_empty() { Ok(tree) } else { Err(parser.rest.to_owned()) }
    }

    fn takes(&mut self, sign: &str) -> bool {
        let Some(rest) = self.rest.strip_prefix(sign) else { return false };
        self.rest = rest.trim_start();
        true
    }

    fn choice(&mut self) -> Result<Tree, String> {
        let first = self.comparison()?;
        if !self.takes("?") {
            return Ok(first);
        }
        let yes = self.choice()?;
        if !self.takes(":") {
            return Err(self.rest.to_owned());
        }
        Ok(Tree::new(Op::If, vec![first, yes, self.choice()?]))
    }

    fn comparison(&mut self) -> Result<Tree, String> {
        let first = self.sum()?;
        if !self.takes("<") {
            return Ok(first);
        }
        Ok(Tree::new(Op::Less, vec![first, self.sum()?]))
    }

    fn sum(&mut self) -> Result<Tree, String> {
        let mut terms = vec![(self.takes("-"), self.product()?)];
        loop {
            let is_minus = self.rest.starts_with('-');
            if !self.takes("-") && !self.takes("+") {
                break;
            }
            terms.push((is_minus, self.product()?));
        }
        Ok(if let [(false, _)] = terms[..] { terms.remove(0).1 } else { Tree::sum(terms) })
    }

    fn product(&mut self) -> Result<Tree, String> {
        let mut factors = vec![(false, self.scalar_product()?)];
        loop {
            let divides = self.takes("/");
            let continues = |c: char| c.is_alphanumeric() || c == '(' || c == '|';
            if !divides && !self.rest.starts_with(continues) {
                break;
            }
            factors.push((divides, self.scalar_product()?));
        }
        Ok(if factors.len() == 1 { factors.remove(0).1 } else { Tree::product(factors) })
    }

    fn scalar_product(&mut self) -> Result<Tree, String> {
        let sign = self.takes("-");
        let first = self.atom()?;
        let dot = if self.takes(".") { Tree::new(Op::Dot, vec![first, self.atom()?]) } else { first };
        Ok(if sign { Tree::sum(vec![(true, dot)]) } else { dot })
    }

    fn atom(&mut self) -> Result<Tree, String> {
        for (name, op) in [("cross(", Op::Cross), ("sqrt(", Op::Root), ("(", Op::If)] {
            if self.takes(name) {
                let mut of = vec![self.choice()?];
                while self.takes(",") {
                    of.push(self.choice()?);
                }
                if !self.takes(")") {
                    return Err(self.rest.to_owned());
                }
                return Ok(if name == "(" { of.remove(0) } else { Tree::new(op, of) });
            }
        }
        let length = self.length_of_name();
        let (word, rest) = self.rest.split_at(length);
        if word.is_empty() {
            return Err(self.rest.to_owned());
        }
        self.rest = rest.trim_start();
        Ok(match word.parse() {
            Ok(value) => Tree::number(value),
            Err(_) => Tree::name(self.names.add(word)),
        })
    }

    /// Letters, digits, a derivative as in `t,xi`, a length as in `|t|`.
    fn length_of_name(&self) -> usize {
        let text = self.rest.as_bytes();
        let (mut at, mut bars) = (0, 0);
        while let Some(&byte) = text.get(at) {
            let is_derivative = byte == b',' && text.get(at + 1).is_some_and(u8::is_ascii_alphabetic);
            let is_bar = byte == b'|' && bars < 2;
            if !(byte.is_ascii_alphanumeric() || byte == b'_' || is_derivative || is_bar) {
                break;
            }
            bars += usize::from(is_bar);
            at += 1;
            if is_bar && bars == 2 {
                break;
            }
        }
        at
    }
}
