//! The grammar of JSON, with numbers in any notation.

use super::value::{JsonError, Node, Read, Value};
use crate::check::external::no_dof::NULL;
use crate::check::external::number;
use std::borrow::Cow;

/// The maximum depth of nested values.
const DEEPEST: usize = 32;

/// A line, and the position of the reader in it.
pub(super) struct Reader<'a> {
    pub(super) text: &'a str,
    pub(super) at: usize,
}

impl<'a> Reader<'a> {
    fn column(&self) -> usize {
        self.at + 1
    }

    pub(super) fn expected(&self, what: &str) -> JsonError {
        let found = match self.text[self.at..].chars().next() {
            Some(c) => format!("{c:?}"),
            None => "the end of the line".into(),
        };
        JsonError::at(self.column(), format!("{what} expected, found {found}"))
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    pub(super) fn blanks(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\r' | b'\n')) {
            self.at += 1;
        }
    }

    fn take(&mut self, byte: u8) -> bool {
        self.blanks();
        let is_there = self.peek() == Some(byte);
        self.at += usize::from(is_there);
        is_there
    }

    pub(super) fn value(&mut self, depth: usize) -> Read<Node<'a>> {
        self.blanks();
        let column = self.column();
        if depth > DEEPEST {
            return Err(JsonError::at(column, format!("at most {DEEPEST} levels expected")));
        }
        let value = match self.peek() {
            Some(b'{') => self.object(depth)?,
            Some(b'[') => self.list(depth)?,
            Some(b'"') => Value::Text(self.string()?),
            Some(_) => self.word()?,
            None => return Err(self.expected("a value")),
        };
        Ok(Node { value, column })
    }

    fn object(&mut self, depth: usize) -> Read<Value<'a>> {
        self.at += 1;
        let mut entries: Vec<(Cow<'a, str>, Node<'a>)> = Vec::new();
        if self.take(b'}') {
            return Ok(Value::Object(entries));
        }
        loop {
            self.blanks();
            let column = self.column();
            if self.peek() != Some(b'"') {
                return Err(self.expected("a name in quotes"));
            }
            let name = self.string()?;
            if entries.iter().any(|(known, _)| *known == name) {
                return Err(JsonError::at(column, format!("{name:?} expected once, found twice")));
            }
            if !self.take(b':') {
                return Err(self.expected("a colon"));
            }
            entries.push((name, self.value(depth + 1)?));
            if self.take(b'}') {
                return Ok(Value::Object(entries));
            }
            if !self.take(b',') {
                return Err(self.expected("a comma or a closing brace"));
            }
        }
    }

    fn list(&mut self, depth: usize) -> Read<Value<'a>> {
        self.at += 1;
        if self.take(b']') {
            return Ok(Value::Numbers(Vec::new()));
        }
        // Numbers are collected as long as there are no other values.
        let (mut numbers, mut nodes) = (Vec::new(), Vec::new());
        loop {
            let node = self.value(depth + 1)?;
            let number = match &node.value {
                Value::Number(number, _) => Some(*number),
                Value::Null => Some(NULL),
                Value::Text(text) => number::parse(text).ok(),
                _ => None,
            };
            match number {
                Some(number) if nodes.is_empty() => numbers.push(number),
                None if numbers.is_empty() => nodes.push(node),
                _ => {
                    let what = if numbers.is_empty() { "lists" } else { "numbers" };
                    return Err(JsonError::at(node.column, format!("a list of {what} alone expected")));
                }
            }
            if self.take(b']') {
                let is_numbers = nodes.is_empty();
                return Ok(if is_numbers { Value::Numbers(numbers) } else { Value::List(nodes) });
            }
            if !self.take(b',') {
                return Err(self.expected("a comma or a closing bracket"));
            }
        }
    }

    /// A number, or one of the words of JSON.
    fn word(&mut self) -> Read<Value<'a>> {
        let rest = &self.text[self.at..];
        let ends =
            |byte: &u8| matches!(byte, b',' | b']' | b'}' | b':' | b'"' | b' ' | b'\t' | b'\r' | b'\n');
        let length = rest.as_bytes().iter().position(ends).unwrap_or(rest.len());
        let word = &rest[..length];
        let value = match word {
            "null" => Value::Null,
            "true" => Value::Bool(true),
            "false" => Value::Bool(false),
            "" => return Err(self.expected("a value")),
            _ => {
                let number = number::parse(word).map_err(|wrong| {
                    let shown: String = word.chars().take(32).collect();
                    JsonError::at(self.column(), format!("{}, found {shown:?}", wrong.words()))
                })?;
                Value::Number(number, word)
            }
        };
        self.at += length;
        Ok(value)
    }

    fn string(&mut self) -> Read<Cow<'a, str>> {
        let column = self.column();
        self.at += 1;
        let start = self.at;
        let mut escaped: Option<String> = None;
        loop {
            let rest = &self.text[self.at..];
            let Some(length) = rest.find(['"', '\\']) else {
                return Err(JsonError::at(column, "a closing quote expected, found none"));
            };
            let is_end = rest.as_bytes()[length] == b'"';
            if let Some(text) = &mut escaped {
                text.push_str(&rest[..length]);
            } else if !is_end {
                escaped = Some(self.text[start..self.at + length].to_owned());
            }
            self.at += length;
            if is_end {
                let whole = &self.text[start..self.at];
                self.at += 1;
                return Ok(escaped.map_or(Cow::Borrowed(whole), Cow::Owned));
            }
            let character = self.escape()?;
            escaped.get_or_insert_default().push(character);
        }
    }

    /// The character that a backslash and the characters after it denote.
    fn escape(&mut self) -> Read<char> {
        let column = self.column();
        let wrong = || JsonError::at(column, "a character that may be escaped expected");
        let byte = self.text.as_bytes().get(self.at + 1).copied().ok_or_else(wrong)?;
        self.at += 2;
        Ok(match byte {
            b'"' | b'\\' | b'/' => char::from(byte),
            b'b' => '\u{8}',
            b'f' => '\u{c}',
            b'n' => '\n',
            b'r' => '\r',
            b't' => '\t',
            b'u' => {
                let mut unit = || {
                    let digits = self.text.get(self.at..self.at + 4)?;
                    self.at += 4;
                    digits.bytes().all(|byte| byte.is_ascii_hexdigit()).then_some(())?;
                    u32::from_str_radix(digits, 16).ok()
                };
                let first = unit().ok_or_else(wrong)?;
                if (0xd800..0xdc00).contains(&first) {
                    let is_pair = self.text[self.at..].starts_with("\\u");
                    self.at += if is_pair { 2 } else { 0 };
                    let digits = self.text.get(self.at..self.at + 4).filter(|_| is_pair).ok_or_else(wrong)?;
                    self.at += 4;
                    let second =
                        u32::from_str_radix(digits, 16).ok().filter(|s| (0xdc00..0xe000).contains(s));
                    let second = second.ok_or_else(wrong)?;
                    char::from_u32(0x10000 + ((first - 0xd800) << 10) + (second - 0xdc00))
                        .ok_or_else(wrong)?
                } else {
                    char::from_u32(first).ok_or_else(wrong)?
                }
            }
            _ => return Err(wrong()),
        })
    }
}
