//! Values of JSON with their columns, and the error of a line.

use std::borrow::Cow;

/// A value and its first column.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::check::external) struct Node<'a> {
    pub(in crate::check::external) value: Value<'a>,
    /// The column from 1, in bytes.
    pub(in crate::check::external) column: usize,
}

#[derive(Clone, Debug, PartialEq)]
pub(in crate::check::external) enum Value<'a> {
    Null,
    Bool(bool),
    /// A number, and the word from which it was read.
    Number(f64, &'a str),
    /// A list of numbers alone. null stands for a value that is not a number. Numbers may be written as strings.
    Numbers(Vec<f64>),
    Text(Cow<'a, str>),
    List(Vec<Node<'a>>),
    Object(Vec<(Cow<'a, str>, Node<'a>)>),
}

/// What was expected, and the column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::check::external) struct JsonError {
    pub(in crate::check::external) column: usize,
    pub(in crate::check::external) expected: String,
}

impl JsonError {
    pub(in crate::check::external) fn at(column: usize, expected: impl Into<String>) -> Self {
        Self { column, expected: expected.into() }
    }
}

pub(super) type Read<T> = Result<T, JsonError>;
