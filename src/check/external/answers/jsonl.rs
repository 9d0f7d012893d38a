//! Answers as JSON Lines.

use super::{ANSWERS, Answers, Head, Place, is_vector, quantity, state};
use crate::check::external::conventions::STATE_AND_FORCES;
use crate::check::external::json::{JsonError, Node, Value};
use crate::check::external::vectors::{find, id, schema};

type Read<T> = Result<T, JsonError>;

/// Reads the head.
pub(super) fn head(line: &str, to: &mut Head) -> Read<()> {
    let head = schema(line, ANSWERS)?;
    for (name, node) in head.object("head")? {
        let value = match &node.value {
            Value::Number(_, word) => (*word).to_owned(),
            Value::Text(text) => text.clone().into_owned(),
            Value::Numbers(numbers) => format!("{numbers:?}").replace(".0", ""),
            Value::List(words) => {
                let words = words.iter().map(|word| word.text(name)).collect::<Read<Vec<_>>>()?;
                words.join(",")
            }
            _ => return Err(JsonError::at(node.column, format!("{name}: a string or a number expected"))),
        };
        match name.as_ref() {
            "schema" => {}
            _ => to.set(name, &value).map_err(|wrong| JsonError::at(node.column, wrong))?,
        }
    }
    Ok(())
}

/// Reads the answers to a case. Their place in the text is not known here.
pub(super) fn answers(line: &str) -> Read<Answers> {
    let node = Node::read(line)?;
    let entries = node.object("answers")?;
    let name = find(entries, "id").ok_or_else(|| JsonError::at(node.column, "id expected, found none"))?;
    let mut answers = Answers::new(id(name)?, Place { file: String::new(), line: 0, column: 0 });
    for (name, node) in entries {
        match name.as_ref() {
            "id" | "comment" => {}
            _ if node.value == Value::Null => {}
            "result" => answers.declined = declined(node)?,
            "residual" => answers.residual = Some(node.numbers(name, None)?),
            "tangent" => answers.tangent = Some(node.numbers(name, None)?),
            "state" => {
                answers.state_and_forces[0] =
                    Some(state(node.text(name)?).map_err(|wrong| JsonError::at(node.column, wrong))?);
            }
            _ => match STATE_AND_FORCES.iter().position(|force| force == name) {
                Some(k) => answers.state_and_forces[k] = Some(node.number(name)?),
                None => of_quantity(&mut answers, name, node)?,
            },
        }
    }
    Ok(answers)
}

fn declined(node: &Node) -> Read<bool> {
    match node.text("result")? {
        "valid" => Ok(false),
        "degenerate" | "no-projection" => Ok(true),
        other => {
            let expected = "one of valid, degenerate, no-projection expected";
            Err(JsonError::at(node.column, format!("result: {expected}, found {other:?}")))
        }
    }
}

fn of_quantity(answers: &mut Answers, name: &str, node: &Node) -> Read<()> {
    let (quantity, axis) = quantity(name).map_err(|wrong| JsonError::at(node.column, wrong))?;
    let is_whole_vector = is_vector(quantity) && axis.is_none();
    if matches!(node.value, Value::Number(..) | Value::Numbers(_) | Value::Text(_)) {
        return scalar(answers, (quantity, is_whole_vector, axis), 0, name, node);
    }
    for (part, node) in node.object(name)? {
        let what = format!("{name}.{part}");
        match part.as_ref() {
            "gradient" | "hessian" if node.value == Value::Null => {}
            "value" => scalar(answers, (quantity, is_whole_vector, axis), 0, &what, node)?,
            "delta" => scalar(answers, (quantity, is_whole_vector, axis), 1, &what, node)?,
            "Delta" => scalar(answers, (quantity, is_whole_vector, axis), 2, &what, node)?,
            "Delta-delta" => scalar(answers, (quantity, is_whole_vector, axis), 3, &what, node)?,
            "gradient" | "hessian" if is_whole_vector => {
                let expected = format!("{what}: of a component expected, such as {name}.x");
                return Err(JsonError::at(node.column, expected));
            }
            "gradient" => answers.of(quantity, axis).gradient = Some(node.numbers(&what, None)?),
            "hessian" => answers.of(quantity, axis).hessian = Some(node.numbers(&what, None)?),
            // `export` writes these entries beside the numbers.
            "tolerance" | "gradient_tolerance" | "hessian_tolerance" => {}
            _ => {
                let expected = "one of value, gradient, hessian, delta, Delta, Delta-delta expected";
                return Err(JsonError::at(node.column, format!("{name}: {expected}, found {part:?}")));
            }
        }
    }
    Ok(())
}

/// Part k of a scalar, or of the three components of a vector.
fn scalar(
    answers: &mut Answers,
    (quantity, is_whole_vector, axis): (crate::linearization::Quantity, bool, Option<char>),
    k: usize,
    what: &str,
    node: &Node,
) -> Read<()> {
    let numbers = match node.value {
        // Some writers of JSON have no other word for NaN.
        Value::Null => vec![f64::NAN; if is_whole_vector { 3 } else { 1 }],
        _ if is_whole_vector => node.numbers(what, Some(3))?,
        _ => vec![node.number(what)?],
    };
    let axes = if is_whole_vector { vec![Some('x'), Some('y'), Some('z')] } else { vec![axis] };
    for (axis, number) in axes.into_iter().zip(numbers) {
        let answer = answers.of(quantity, axis);
        match k {
            0 => answer.value = Some(number),
            k => answer.variations[k - 1] = Some(number),
        }
    }
    Ok(())
}
