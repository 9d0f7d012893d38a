//! Cases from lines of JSON.

use super::element::element;
pub(in crate::check::external) use super::entries::find;
use super::entries::{Read, finite, known, missing};
use super::{VECTORS, Vector};
use crate::check::CaseData;
use crate::check::external::error::ExternalError;
use crate::check::external::json::{JsonError, Node, Value};
use crate::check::external::lines::Lines;
use crate::check::external::recent::Recent;
use crate::pair::Contact;
use crate::test_beam::{Family, TestBeam};
use std::io::BufRead;

/// Reads a file of cases, line by line.
#[derive(Debug)]
pub struct VectorReader<R> {
    lines: Lines<R>,
    text: String,
    known: Recent,
}

impl<R: BufRead> VectorReader<R> {
    /// Reads the head; `name` is that of the file, for messages.
    ///
    /// # Errors
    /// If there is no head of the schema [`VECTORS`].
    pub fn new(from: R, name: &str) -> Result<Self, ExternalError> {
        let mut lines = Lines::new(from, name);
        let text = lines.next_line()?.unwrap_or_default().to_owned();
        let place = lines.place();
        schema(&text, VECTORS).map_err(|JsonError { column, expected }| {
            super::Place { column, line: place.line.max(1), ..place }.error(expected)
        })?;
        Ok(Self { lines, text, known: Recent::default() })
    }

    /// The next case; nothing at the end.
    ///
    /// # Errors
    /// If a line is not a valid case, or has the name of one of the last cases.
    pub fn next_vector(&mut self) -> Result<Option<Vector>, ExternalError> {
        self.text.clear();
        match self.lines.next_line()? {
            None => return Ok(None),
            Some(line) => self.text.push_str(line),
        }
        let place = self.lines.place();
        match vector(&self.text) {
            Ok(vector) => match self.known.insert(&vector.id, place.line) {
                None => Ok(Some(Vector { place: Some(place), ..vector })),
                Some(line) => {
                    let expected =
                        format!("id: a name of its own expected, found {:?} as in line {line}", vector.id);
                    Err(place.error(expected))
                }
            },
            Err(JsonError { column, expected }) => Err(super::Place { column, ..place }.error(expected)),
        }
    }

    /// The text of the line read last: the head, or a case.
    pub fn line(&self) -> &str {
        &self.text
    }
}

/// Whether a line is a head of this schema.
pub(in crate::check::external) fn schema<'a>(line: &'a str, expected: &str) -> Read<Node<'a>> {
    let missing = |found: &str| {
        JsonError::at(1, format!("a head {{\"schema\":\"{expected}\", ..}} expected, found {found}"))
    };
    if line.is_empty() {
        return Err(missing("the end of the text"));
    }
    let head = Node::read(line)?;
    let entries = head.object("head")?;
    match entries.iter().find(|(name, _)| name == "schema").map(|(_, node)| node) {
        Some(Node { value: Value::Text(schema), .. }) if schema == expected => Ok(head),
        Some(node) => {
            let found = node.text("schema")?;
            Err(JsonError::at(node.column, format!("schema: {expected:?} expected, found {found:?}")))
        }
        None => Err(missing("no schema")),
    }
}

/// A case from its line.
pub(in crate::check::external) fn vector(line: &str) -> Read<Vector> {
    let node = Node::read(line)?;
    let entries = node.object("case")?;
    known(
        entries,
        &[
            "id", "comment", "regime", "beam", "bar", "contact", "element", "point", "result", "reason",
            "held", "jets", "expected",
        ],
    )?;
    let get = |name: &str| find(entries, name).ok_or_else(|| JsonError::at(node.column, missing(name)));
    let text = |name: &str| find(entries, name).map_or(Ok(""), |node| node.text(name));
    let [beam, bar] = ["beam", "bar"].map(|name| beam(get(name)?, name));
    let contact = find(entries, "contact").map_or(Ok(Contact::default()), contact)?;
    let (beam, bar) = (beam?, bar?);
    let dofs = [beam.q.len(), bar.q.len()];
    let element = find(entries, "element").map(|node| element(node, dofs)).transpose()?;
    let (element, steps) = element.map_or((None, Vec::new()), |(element, steps)| (Some(element), steps));
    let point = find(entries, "point").map(point).transpose()?;
    Ok(Vector {
        id: id(get("id")?)?,
        regime: text("regime")?.to_owned(),
        case: CaseData { test_beams: [beam, bar], contact },
        element,
        steps,
        point,
        place: None,
    })
}

/// A name: a string, or a number as it is written.
pub(in crate::check::external) fn id(node: &Node) -> Read<String> {
    match &node.value {
        Value::Number(_, word) => Ok((*word).to_owned()),
        _ => node.text("id").map(ToOwned::to_owned),
    }
}

fn beam(node: &Node, name: &str) -> Read<TestBeam> {
    let entries = node.object(name)?;
    known(entries, &["family", "curve", "q", "dq", "linear_dq"])?;
    let get = |entry: &str| {
        let path = format!("{name}.{entry}");
        find(entries, entry).ok_or_else(|| JsonError::at(node.column, missing(&path)))
    };
    let word = get("family")?;
    let told = word.text("family")?;
    let family = Family::from_name(told).ok_or_else(|| {
        let names = Family::ALL.map(Family::name).join(", ");
        JsonError::at(word.column, format!("{name}.family: one of {names} expected, found {told:?}"))
    })?;
    let dofs = family.units().len();
    let numbers = |entry: &str| get(entry)?.numbers(&format!("{name}.{entry}"), Some(dofs));
    let mut parameters = Vec::new();
    let curve = find(entries, "curve").map_or(Ok(&[][..]), |node| node.object("curve"))?;
    let names: Vec<_> = family.parameters().iter().map(|(name, _)| *name).collect();
    known(curve, &names)?;
    for &(parameter, count) in family.parameters() {
        let path = format!("{name}.curve.{parameter}");
        let found = find(curve, parameter).ok_or_else(|| JsonError::at(node.column, missing(&path)))?;
        match count {
            1 => parameters.push(found.number(&path)?),
            _ => parameters.extend(found.numbers(&path, Some(count))?),
        }
    }
    let (q, dq, linear_dq) = (numbers("q")?, numbers("dq")?, numbers("linear_dq")?);
    let beam = TestBeam { family, parameters, q, dq, linear_dq };
    beam.validate().map_err(|wrong| JsonError::at(node.column, format!("{name}: {}", chain(&wrong))))?;
    Ok(beam)
}

/// An error with its causes.
fn chain(error: &dyn std::error::Error) -> String {
    error.source().map_or_else(|| error.to_string(), |source| format!("{error}: {}", chain(source)))
}

fn contact(node: &Node) -> Read<Contact> {
    let entries = node.object("contact")?;
    known(entries, &["radius", "radius_bar", "xi_0", "xi_bar_0"])?;
    let get = |name: &str| find(entries, name).map_or(Ok(0.0), |node| finite(node, name));
    let radius = |name: &str| {
        let radius = get(name)?;
        let column = find(entries, name).map_or(node.column, |node| node.column);
        let wrong = || JsonError::at(column, format!("{name}: a number from 0 on expected, found {radius}"));
        if radius >= 0.0 { Ok(radius) } else { Err(wrong()) }
    };
    Ok(Contact {
        radius: radius("radius")?,
        radius_bar: radius("radius_bar")?,
        xi_0: get("xi_0")?,
        xi_bar_0: get("xi_bar_0")?,
    })
}

fn point(node: &Node) -> Read<(f64, f64)> {
    let entries = node.object("point")?;
    known(entries, &["xi", "xi_bar"])?;
    let get = |name: &str| {
        let found = find(entries, name).ok_or_else(|| JsonError::at(node.column, missing(name)))?;
        finite(found, name)
    };
    Ok((get("xi")?, get("xi_bar")?))
}
