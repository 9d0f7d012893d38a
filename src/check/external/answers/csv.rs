//! Answers as CSV: `case,quantity,value`, one number a row.

use super::{ANSWERS, Answers, Head, quantity, state};
use crate::check::external::conventions::{Conventions, STATE_AND_FORCES, Triangle};
use crate::check::external::error::{ExternalError, Place};
use crate::check::external::lines::Lines;
use crate::check::external::number;
use std::collections::{BTreeMap, HashSet};
use std::io::BufRead;

const TITLES: &str = "case,quantity,value";

/// Reads the head: comments `# key = value`, of which one names the schema, and the titles.
pub(super) fn head<R: BufRead>(
    first: String,
    lines: &mut Lines<R>,
    head: &mut Head,
) -> Result<(), ExternalError> {
    let (mut line, mut is_named) = (first, false);
    while let Some(comment) = line.trim_start().strip_prefix('#') {
        let error = |expected: String| Place { column: 1, ..lines.place() }.error(expected);
        let (key, value) = comment
            .split_once('=')
            .map(|(key, value)| (key.trim(), value.trim()))
            .ok_or_else(|| error(format!("a comment `# key = value` expected, found {line:?}")))?;
        match key {
            "schema" if value == ANSWERS => is_named = true,
            "schema" => return Err(error(format!("schema: {ANSWERS} expected, found {value}"))),
            _ => head.set(key, value).map_err(error)?,
        }
        lines.next_line()?.unwrap_or_default().clone_into(&mut line);
    }
    let place = Place { column: 1, ..lines.place() };
    let shown: String = line.chars().take(60).collect();
    if line.replace([' ', '"'], "") != TITLES {
        let expected = format!("the titles `{TITLES}`, or a head of JSON, expected, found {shown:?}");
        return Err(place.error(expected));
    }
    if is_named {
        Ok(())
    } else {
        Err(place.error(format!("a comment `# schema = {ANSWERS}` expected before the titles")))
    }
}

/// The rows of the current case, and the names of the earlier cases.
#[derive(Debug, Default)]
pub(super) struct Rows {
    /// The first row of the next case.
    next: Option<(Row, Place)>,
    ended: HashSet<String>,
}

#[derive(Debug)]
struct Row {
    id: String,
    item: String,
    part: String,
    indices: Vec<usize>,
    word: String,
    columns: [usize; 2],
}

/// A gradient, a Hessian, a residual or a tangent, entry by entry.
type Arrays = BTreeMap<(String, String), BTreeMap<Vec<usize>, f64>>;

impl Rows {
    pub(super) fn next_answers<R: BufRead>(
        &mut self,
        lines: &mut Lines<R>,
        conventions: &Conventions,
    ) -> Result<Option<Answers>, ExternalError> {
        let mut arrays = Arrays::new();
        let mut answers: Option<Answers> = None;
        loop {
            let (row, place) = if let Some(next) = self.next.take() {
                next
            } else {
                let Some(line) = lines.next_line()?.map(ToOwned::to_owned) else { break };
                (Row::read(&line, conventions.first_index, &lines.place())?, lines.place())
            };
            if answers.as_ref().is_some_and(|answers| answers.id != row.id) {
                self.next = Some((row, place));
                break;
            }
            if self.ended.contains(&row.id) {
                let expected = format!("the rows of case {:?} expected one after another", row.id);
                return Err(Place { column: 1, ..place }.error(expected));
            }
            let answers = answers.get_or_insert_with(|| Answers::new(row.id.clone(), place.clone()));
            row.add(answers, &mut arrays, &place)?;
        }
        let Some(mut answers) = answers else { return Ok(None) };
        self.ended.insert(answers.id.clone());
        for ((item, part), mut entries) in arrays {
            if conventions.triangle != Triangle::Both {
                mirror(&mut entries, conventions.triangle);
            }
            add_array(&mut answers, &item, &part, &entries)?;
        }
        Ok(Some(answers))
    }
}

impl Row {
    fn read(line: &str, first_index: usize, place: &Place) -> Result<Self, ExternalError> {
        let error = |column: usize, expected: String| Place { column, ..place.clone() }.error(expected);
        let mut cells = line.splitn(3, ',');
        let [id, item, word] = [cells.next(), cells.next(), cells.next()].map(Option::unwrap_or_default);
        let columns = [id.len() + 2, id.len() + item.len() + 3];
        if line.matches(',').count() != 2 {
            return Err(error(1, format!("three cells, {TITLES}, expected")));
        }
        let bare = |cell: &str| cell.trim().trim_matches('"').to_owned();
        let (id, item) = (bare(id), bare(item));
        let mut words = item.split(':');
        let name = words.next().unwrap_or_default().to_owned();
        let part = match name.as_str() {
            "residual" | "tangent" | "result" => name.clone(),
            _ => words.next().unwrap_or("value").to_owned(),
        };
        let index = |word: &str| {
            let expected =
                || error(columns[0], format!("an index from {first_index} on expected, found {word:?}"));
            let index = word.parse::<usize>().ok().filter(|&index| index < 1 << 20);
            index.and_then(|index| index.checked_sub(first_index)).ok_or_else(expected)
        };
        let indices = words.map(index).collect::<Result<Vec<_>, _>>()?;
        let expected = match part.as_str() {
            "gradient" | "residual" => 1,
            "hessian" | "tangent" => 2,
            "value" | "delta" | "Delta" | "Delta-delta" | "result" => 0,
            _ => {
                let parts = "value, gradient, hessian, delta, Delta, Delta-delta";
                return Err(error(columns[0], format!("{name}: one of {parts} expected, found {part:?}")));
            }
        };
        if indices.len() != expected {
            let found = indices.len();
            return Err(error(
                columns[0],
                format!("{name}:{part}: {expected} indices expected, found {found}"),
            ));
        }
        Ok(Self { id, item: name, part, indices, word: bare(word), columns })
    }

    fn add(self, answers: &mut Answers, arrays: &mut Arrays, place: &Place) -> Result<(), ExternalError> {
        let error = |column: usize, expected: String| Place { column, ..place.clone() }.error(expected);
        if self.part == "result" {
            answers.declined = match self.word.as_str() {
                "valid" => false,
                "degenerate" | "no-projection" => true,
                other => {
                    let expected = "one of valid, degenerate, no-projection expected";
                    return Err(error(self.columns[1], format!("result: {expected}, found {other:?}")));
                }
            };
            return Ok(());
        }
        if let Some(k) = STATE_AND_FORCES.iter().position(|name| *name == self.item) {
            return self.add_of_element(answers, k, &error);
        }
        let number = number::parse(&self.word)
            .map_err(|wrong| error(self.columns[1], format!("{}, found {:?}", wrong.words(), self.word)))?;
        let twice =
            || error(self.columns[0], format!("{}:{} expected once, found twice", self.item, self.part));
        if self.part != "residual" && self.part != "tangent" {
            let (of, axis) = quantity(&self.item).map_err(|wrong| error(self.columns[0], wrong))?;
            if axis.is_none() && super::is_vector(of) {
                let expected = format!("a component expected, such as {}.x", self.item);
                return Err(error(self.columns[0], expected));
            }
            let answer = answers.of(of, axis);
            let place = match self.part.as_str() {
                "value" => Some(&mut answer.value),
                "delta" => Some(&mut answer.variations[0]),
                "Delta" => Some(&mut answer.variations[1]),
                "Delta-delta" => Some(&mut answer.variations[2]),
                _ => None,
            };
            if let Some(place) = place {
                return if place.replace(number).is_none() { Ok(()) } else { Err(twice()) };
            }
        }
        let entries = arrays.entry((self.item.clone(), self.part.clone())).or_default();
        if entries.insert(self.indices.clone(), number).is_none() { Ok(()) } else { Err(twice()) }
    }
}

impl Row {
    /// Adds state or force k of a contact element.
    fn add_of_element(
        &self,
        answers: &mut Answers,
        k: usize,
        error: &impl Fn(usize, String) -> ExternalError,
    ) -> Result<(), ExternalError> {
        let number = if k == 0 {
            state(&self.word)
        } else {
            number::parse(&self.word).map_err(|wrong| format!("{}, found {:?}", wrong.words(), self.word))
        };
        let number = number.map_err(|wrong| error(self.columns[1], wrong))?;
        let known = answers.state_and_forces[k].replace(number);
        known.map_or(Ok(()), |_| {
            Err(error(self.columns[0], format!("{} expected once, found twice", self.item)))
        })
    }
}

/// Completes a matrix of which one triangle is answered. Rows and columns have their indices here, in any order of storage.
fn mirror(entries: &mut BTreeMap<Vec<usize>, f64>, triangle: Triangle) {
    let of_other = |(at, number): (&Vec<usize>, &f64)| match at[..] {
        [i, j] if triangle.has(i, j) => Some((vec![j, i], *number)),
        _ => None,
    };
    let others: Vec<_> = entries.iter().filter_map(of_other).collect();
    entries.extend(others);
}

/// Assembles the entries of an array. None may be missing.
fn add_array(
    answers: &mut Answers,
    item: &str,
    part: &str,
    entries: &BTreeMap<Vec<usize>, f64>,
) -> Result<(), ExternalError> {
    let size = entries.keys().flatten().max().map_or(0, |index| index + 1);
    let dimensions = entries.keys().next().map_or(0, Vec::len);
    let count = if dimensions == 2 { size.saturating_mul(size) } else { size };
    if count != entries.len() {
        let expected = format!(
            "case {}: {item}:{part}: {count} entries expected for {size} dofs, found {}",
            answers.id,
            entries.len()
        );
        return Err(answers.place.clone().error(expected));
    }
    // In the order of their indices, row by row.
    let numbers = Some(entries.values().copied().collect());
    match part {
        "residual" => answers.residual = numbers,
        "tangent" => answers.tangent = numbers,
        _ => {
            let (of, axis) = quantity(item).map_err(|wrong| answers.place.clone().error(wrong))?;
            let answer = answers.of(of, axis);
            if part == "gradient" {
                answer.gradient = numbers;
            } else {
                answer.hessian = numbers;
            }
        }
    }
    Ok(())
}
