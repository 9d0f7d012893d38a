//! JSON as programs print it: numbers of any language, lists of numbers without boxes, columns for messages.
//!
//! serde_json rejects number formats that JSON does not have (`NaN`, `-Infinity`, `0.1D+00`, `1.0-101`) before a
//! visitor sees them, keeps the last of two entries of one name, and gives a place in the text for syntax errors only.
//! Therefore this reader exists. It reads plain JSON as serde_json does, which a test asserts.

mod reader;
mod value;

use super::number;
use reader::Reader;
use std::borrow::Cow;
use value::Read;
pub(super) use value::{JsonError, Node, Value};

impl<'a> Node<'a> {
    /// Reads a line that contains one value.
    pub(super) fn read(line: &'a str) -> Read<Self> {
        let mut reader = Reader { text: line, at: 0 };
        let node = reader.value(0)?;
        reader.blanks();
        if reader.at < line.len() {
            return Err(reader.expected("the end of the line"));
        }
        Ok(node)
    }

    /// The entries of an object. No name occurs twice.
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

    /// A number, which may be infinite or not a number.
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

    /// A list of numbers; `expected` is their count, if it is known.
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
        fn plain_json_is_read_as_serde_json_reads_it(
            numbers in prop::collection::vec(any::<f64>().prop_filter("JSON has it", |x| x.is_finite()), 1..8),
            text in "\\PC{0,16}",
        ) {
            let line = serde_json::json!({ "numbers": numbers, "text": text }).to_string();
            let node = Node::read(&line).unwrap();
            let entries = node.object("line").unwrap();
            let of = |name: &str| &entries.iter().find(|(known, _)| known == name).unwrap().1;
            prop_assert_eq!(of("numbers").numbers("numbers", None).unwrap(), numbers);
            prop_assert_eq!(of("text").text("text").unwrap(), text);
        }

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
