//! The entries of an object in a line of cases.

use crate::check::external::json::{JsonError, Node};
use std::borrow::Cow;

pub(super) type Read<T> = Result<T, JsonError>;

pub(in crate::check::external) type Entries<'a, 'b> = &'b [(Cow<'a, str>, Node<'a>)];

pub(in crate::check::external) fn find<'a, 'b>(entries: Entries<'a, 'b>, name: &str) -> Option<&'b Node<'a>> {
    entries.iter().find(|(known, _)| known == name).map(|(_, node)| node)
}

pub(super) fn missing(name: &str) -> String {
    format!("{name} expected, found none")
}

pub(super) fn known(entries: Entries, names: &[&str]) -> Read<()> {
    let unknown = entries.iter().find(|(name, _)| !names.contains(&name.as_ref()));
    unknown.map_or(Ok(()), |(name, node)| {
        let expected = names.join(", ");
        Err(JsonError::at(node.column, format!("{name}: no such entry, expected {expected}")))
    })
}

pub(super) fn finite(node: &Node, what: &str) -> Read<f64> {
    let number = node.number(what)?;
    let wrong = || JsonError::at(node.column, format!("{what}: a finite number expected, found {number}"));
    number.is_finite().then_some(number).ok_or_else(wrong)
}
