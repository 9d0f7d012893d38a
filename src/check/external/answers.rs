//! Answers of another program, of the schema `beamgap-answers/1`: JSON Lines or CSV.
//!
//! Both begin with a head that names the schema and the [`Conventions`]. In JSON a line answers a case:
//! `{"id":"7","d":{"value":0.1,"gradient":[..],"hessian":[..]},"x":{"delta":[0.1,0.2,0.3]}}`. In CSV a row answers one
//! number, `7,d:gradient:3,0.1`, and the rows of a case are consecutive. Quantities may be omitted.

mod csv;
mod jsonl;

use super::conventions::Conventions;
use super::error::{ExternalError, Place};
use super::lines::Lines;
use super::only::{ONLY, Only};
use crate::check::Answer;
use crate::check::element::index;
use crate::contact::State;
use crate::linearization::Quantity;
use serde::{Deserialize, Serialize};
use std::io::BufRead;

/// The schema.
pub const ANSWERS: &str = "beamgap-answers/1";

/// The answers to a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Answers {
    /// The name of the case.
    pub id: String,
    /// The place in the text.
    pub place: Place,
    /// Whether the program declares that there is no answer: a degenerate point, or no closest point.
    pub declined: bool,
    /// Its answers for the quantities.
    pub answers: Vec<Answer>,
    /// The residual of a contact element.
    pub residual: Option<Vec<f64>>,
    /// The tangent of a contact element.
    pub tangent: Option<Vec<f64>>,
    /// The state of a contact element, as its index in [`State::ALL`](crate::contact::State::ALL), and its forces: F_N, F and
    /// F_bar.
    pub state_and_forces: [Option<f64>; 4],
}

impl Answers {
    fn new(id: String, place: Place) -> Self {
        Self {
            id,
            place,
            declined: false,
            answers: Vec::new(),
            residual: None,
            tangent: None,
            state_and_forces: [None; 4],
        }
    }

    /// The answer for a component, empty if there was none yet.
    fn of(&mut self, quantity: Quantity, axis: Option<char>) -> &mut Answer {
        let is_of = |answer: &Answer| answer.quantity == quantity && answer.axis == axis;
        let known = self.answers.iter().position(is_of);
        let at = known.unwrap_or_else(|| {
            self.answers.push(Answer { axis, ..Answer::of(quantity) });
            self.answers.len() - 1
        });
        &mut self.answers[at]
    }

    /// Whether no quantity is answered.
    pub fn is_empty(&self) -> bool {
        self.answers.is_empty() && !self.has_element()
    }

    /// Whether numbers of a contact element are answered.
    pub(super) fn has_element(&self) -> bool {
        self.residual.is_some() || self.tangent.is_some() || self.state_and_forces != [None; 4]
    }
}

/// Reads answers, case by case.
#[derive(Debug)]
pub struct AnswerReader<R> {
    lines: Lines<R>,
    head: Head,
    rows: Option<csv::Rows>,
}

/// The head of answers.
#[derive(Clone, Debug, Default, PartialEq)]
struct Head {
    conventions: Conventions,
    program: Program,
    only: Only,
}

impl Head {
    /// Sets an entry.
    ///
    /// # Errors
    /// What was expected, if the key or the value is unknown.
    fn set(&mut self, key: &str, value: &str) -> Result<(), String> {
        match key {
            "program" => value.clone_into(&mut self.program.name),
            "version" => value.clone_into(&mut self.program.version),
            "comment" => {}
            _ if ONLY.contains(&key) => return self.only.set(key, value),
            _ => return self.conventions.set(key, value),
        }
        Ok(())
    }
}

/// The program, as the head describes it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Program {
    /// Its name.
    pub name: String,
    /// Its version.
    pub version: String,
}

impl<R: BufRead> AnswerReader<R> {
    /// Reads the head; `name` is that of the file, for messages. JSON begins with a brace; all else is CSV.
    ///
    /// # Errors
    /// If there is no head of the schema [`ANSWERS`], or the head has an unknown entry.
    pub fn new(from: R, name: &str) -> Result<Self, ExternalError> {
        let mut lines = Lines::new(from, name);
        let first = lines.next_line()?.unwrap_or_default().to_owned();
        let mut head = Head::default();
        let rows = if first.trim_start().starts_with('{') || first.is_empty() {
            jsonl::head(&first, &mut head).map_err(|wrong| {
                let place = lines.place();
                Place { column: wrong.column, line: place.line.max(1), ..place }.error(wrong.expected)
            })?;
            None
        } else {
            csv::head(first, &mut lines, &mut head)?;
            Some(csv::Rows::default())
        };
        Ok(Self { lines, head, rows })
    }

    /// The conventions that the head states.
    pub fn conventions(&self) -> &Conventions {
        &self.head.conventions
    }

    /// The program, as the head describes it.
    pub fn program(&self) -> &Program {
        &self.head.program
    }

    /// What the program answers, if not everything.
    pub fn only(&self) -> &Only {
        &self.head.only
    }

    /// The answers to the next case; nothing at the end of the text.
    ///
    /// # Errors
    /// If a line is not a valid answer.
    pub fn next_answers(&mut self) -> Result<Option<Answers>, ExternalError> {
        if let Some(rows) = &mut self.rows {
            return rows.next_answers(&mut self.lines, &self.head.conventions);
        }
        let Some(line) = self.lines.next_line()? else { return Ok(None) };
        match jsonl::answers(line) {
            Ok(mut answers) => {
                let Conventions { triangle, column_major, .. } = self.head.conventions;
                triangle.complete(column_major, &mut answers);
                Ok(Some(Answers { place: self.lines.place(), ..answers }))
            }
            Err(wrong) => Err(Place { column: wrong.column, ..self.lines.place() }.error(wrong.expected)),
        }
    }
}

/// The quantity with a name such as `d` or `d_vector.x`; what was expected, if there is none.
fn quantity(name: &str) -> Result<(Quantity, Option<char>), String> {
    let (of, axis) = name.split_once('.').map_or((name, None), |(of, axis)| (of, Some(axis)));
    let unknown = || {
        let names = Quantity::ALL.map(Quantity::name).join(", ");
        format!("one of {names}, residual, tangent expected, found {name:?}")
    };
    let quantity = Quantity::ALL.into_iter().find(|known| known.name() == of).ok_or_else(unknown)?;
    let axis = match axis {
        None => None,
        Some("x") => Some('x'),
        Some("y") => Some('y'),
        Some("z") => Some('z'),
        Some(_) => return Err(unknown()),
    };
    if is_vector(quantity) || axis.is_none() { Ok((quantity, axis)) } else { Err(unknown()) }
}

/// The index of the state with this name.
fn state(name: &str) -> Result<f64, String> {
    let names = || State::ALL.map(State::name).join(", ");
    let known = State::ALL.into_iter().find(|state| state.name() == name);
    known.map(index).ok_or_else(|| format!("state: one of {} expected, found {name:?}", names()))
}

pub(super) fn is_vector(quantity: Quantity) -> bool {
    let vectors = [Quantity::X, Quantity::XBar, Quantity::DVector, Quantity::TVector, Quantity::TBarVector];
    vectors.contains(&quantity)
}
