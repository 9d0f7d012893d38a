//! JSON as programs print it: numbers of any language, lists of numbers without a box for each, columns for messages.

use super::number;
use std::borrow::Cow;

/// How deep values may be nested.
const DEEPEST: usize = 32;

/// A value and where it starts.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node<'a> {
    pub(super) value: Value<'a>,
    /// From 1, in bytes.
    pub(super) column: usize,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value<'a> {
    Null,
    Bool(bool),
    /// A number, and the word that it was read from.
    Number(f64, &'a str),
    /// A list of numbers alone; null is what is not a number. Numbers may be written as strings.
    Numbers(Vec<f64>),
    Text(Cow<'a, str>),
    List(Vec<Node<'a>>),
    Object(Vec<(Cow<'a, str>, Node<'a>)>),
}

/// What was expected, and the column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct JsonError {
    pub(super) column: usize,
    pub(super) expected: String,
}

impl JsonError {
    pub(super) fn at(column: usize, expected: impl Into<String>) -> Self {
        Self { column, expected: expected.into() }
    }
}

type Read<T> = Result<T, JsonError>;

impl<'a> Node<'a> {
    /// Reads a line that holds one value.
    pub(super) fn read(line: &'a str) -> Read<Self> {
        let mut reader = Reader { text: line, at: 0 };
        let node = reader.value(0)?;
        reader.blanks();
        if reader.at < line.len() {
            return Err(reader.expected("the end of the line"));
        }
        Ok(node)
    }

    /// The entries of an object, none of which is named twice.
    pub(super) fn object(&self, what: &str) -> Read<&[(Cow<'a, str>, Self)]> {
        match &self.value {
            Value::Object(entries) => Ok(entries),
            other => Err(self.found(&format!("{what}: an object expected"), other)),
        }
    }

    pub(super) fn text(&self, what: &str) -> Read<&str> {
        match &self.value {
            Value::Text(text) => Ok(text),
            other => Err(self.found(&format!("{what}: a string expected"), other)),
        }
    }

    /// A number, infinite or none included.
    pub(super) fn number(&self, what: &str) -> Read<f64> {
        match &self.value {
            Value::Number(number, _) => Ok(*number),
            Value::Text(text) => {
                let wrong =
                    |_| JsonError::at(self.column, format!("{what}: a number expected, found {text:?}"));
                number::parse(text).map_err(wrong)
            }
            other => Err(self.found(&format!("{what}: a number expected"), other)),
        }
    }

    /// Numbers in a row; `expected` if it is said how many.
    pub(super) fn numbers(&self, what: &str, expected: Option<usize>) -> Read<Vec<f64>> {
        let mut all = Vec::new();
        self.flatten(what, &mut all)?;
        match expected {
            Some(expected) if expected != all.len() => Err(JsonError::at(
                self.column,
                format!("{what}: {expected} numbers expected, found {}", all.len()),
            )),
            _ => Ok(all),
        }
    }

    fn flatten(&self, what: &str, to: &mut Vec<f64>) -> Read<()> {
        match &self.value {
            Value::Numbers(numbers) => {
                to.extend(numbers);
                Ok(())
            }
            Value::List(rows) => rows.iter().try_for_each(|row| row.flatten(what, to)),
            other => Err(self.found(&format!("{what}: a list of numbers expected"), other)),
        }
    }

    fn found(&self, expected: &str, found: &Value) -> JsonError {
        let found = match found {
            Value::Null => "null".into(),
            Value::Bool(value) => value.to_string(),
            Value::Number(_, word) => (*word).to_owned(),
            Value::Text(text) => format!("{text:?}"),
            Value::Numbers(_) | Value::List(_) => "a list".into(),
            Value::Object(_) => "an object".into(),
        };
        JsonError::at(self.column, format!("{expected}, found {found}"))
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Reader<'a> {
    fn column(&self) -> usize {
        self.at + 1
    }

    fn expected(&self, what: &str) -> JsonError {
        let found = match self.text[self.at..].chars().next() {
            Some(c) => format!("{c:?}"),
            None => "the end of the line".into(),
        };
        JsonError::at(self.column(), format!("{what} expected, found {found}"))
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn blanks(&mut self) {
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

    fn value(&mut self, depth: usize) -> Read<Node<'a>> {
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
        // Numbers as long as there is nothing else.
        let (mut numbers, mut nodes) = (Vec::new(), Vec::new());
        loop {
            let node = self.value(depth + 1)?;
            let number = match &node.value {
                Value::Number(number, _) => Some(*number),
                Value::Null => Some(f64::NAN),
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

    /// What a backslash and the characters after it stand for.
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

#[cfg(test)]
mod tests {
    use super::{Node, Value};
    use proptest::prelude::*;

    fn told(line: &str) -> String {
        let error = Node::read(line).unwrap_err();
        format!("{}: {}", error.column, error.expected)
    }

    #[test]
    fn lists_of_numbers_are_read_in_every_notation() {
        let node = Node::read(r#" {"a": [[1, 2.5D0], ["0x1p-1", 1.0-101]], "b": [null, NaN]} "#).unwrap();
        let entries = node.object("line").unwrap();
        assert_eq!(entries[0].1.numbers("a", Some(4)).unwrap(), [1.0, 2.5, 0.5, 1e-101]);
        assert!(entries[1].1.numbers("b", None).unwrap().iter().all(|number| number.is_nan()));
        assert_eq!((entries[1].0.as_ref(), entries[1].1.column), ("b", 48));
    }

    #[test]
    fn strings_may_be_escaped() {
        let node = Node::read(r#"["a\"\\\/\n\u00e9\ud83d\ude00b"]"#).unwrap();
        let Value::List(nodes) = node.value else { panic!("{node:?}") };
        assert_eq!(nodes[0].text("a").unwrap(), "a\"\\/\n\u{e9}\u{1f600}b");
    }

    #[test]
    fn each_error_says_where_and_what_was_expected() {
        for (line, expected) in [
            ("{\"a\": 1, }", "10: a name in quotes expected, found '}'"),
            ("{\"a\" 1}", "6: a colon expected, found '1'"),
            ("[1, 2", "6: a comma or a closing bracket expected, found the end of the line"),
            ("[1, x2]", "5: a number expected, found \"x2\""),
            ("[1, [2]]", "5: a list of numbers alone expected"),
            ("{\"a\":1,\"a\":2}", "8: \"a\" expected once, found twice"),
            ("1 2", "3: the end of the line expected, found '2'"),
            ("\"a", "1: a closing quote expected, found none"),
            ("", "1: a value expected, found the end of the line"),
            (
                "[**]",
                "2: a number expected, found asterisks: the field of the Fortran format is too narrow, found \"**\"",
            ),
        ] {
            assert_eq!(told(line), expected, "{line}");
        }
        assert!(told(&"[".repeat(100)).starts_with("34: at most 32 levels"));
    }

    proptest! {
        #[test]
        fn no_text_makes_it_panic(text in "\\PC{0,64}") {
            let _ = Node::read(&text);
        }

        #[test]
        fn no_text_like_json_makes_it_panic(text in r#"[\[\]{}",:\\u0-9eEdD.+\-a-f ]{0,64}"#) {
            let _ = Node::read(&text);
        }
    }
}
