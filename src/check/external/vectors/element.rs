//! The contact element of a case from JSON.

use super::entries::{Entries, Read, find, finite, known, missing};
use super::steps::StepDofs;
use crate::check::ElementData;
use crate::check::external::json::{JsonError, Node, Value};
use crate::closest_point::Held;
use crate::contact::{History, Law, Parameters, Slips, Work};
use nalgebra::Vector3;

/// The number with this name, which must be there.
fn number(node: &Node, entries: Entries, name: &str) -> Read<f64> {
    let found = find(entries, name).ok_or_else(|| JsonError::at(node.column, missing(name)))?;
    finite(found, name)
}

/// The value with this name among the known ones; the first one if there is none.
fn choice<T: Copy>(entries: Entries, name: &str, known: &[(&str, T)]) -> Read<T> {
    let Some(node) = find(entries, name) else { return Ok(known[0].1) };
    let found = node.text(name)?;
    known.iter().find(|(word, _)| *word == found).map(|(_, value)| *value).ok_or_else(|| {
        let words: Vec<_> = known.iter().map(|(word, _)| *word).collect();
        JsonError::at(node.column, format!("{name}: one of {} expected, found {found:?}", words.join(", ")))
    })
}

/// Parameters and history, with all numbers in their ranges, and earlier steps of beams with so many dofs.
pub(super) fn element(node: &Node, dofs: [usize; 2]) -> Read<(ElementData, Vec<StepDofs>)> {
    let entries = node.object("element")?;
    known(entries, &["comment", "law", "eps_N", "g_0", "lambda", "eps_T", "mu", "work", "history", "steps"])?;
    let get = |name: &str| number(node, entries, name);
    let eps = get("eps_N")?;
    let law = match choice(entries, "law", &[("linear", 0), ("lpqp", 1), ("augmented", 2)])? {
        0 => Law::Linear { eps },
        1 => Law::Lpqp { eps, g_0: get("g_0")? },
        _ => Law::Augmented { eps, lambda: get("lambda")? },
    };
    let mut parameters = Parameters::with_friction(law, get("eps_T")?, get("mu")?);
    parameters.work = choice(entries, "work", &[("rate", Work::Rate), ("paper", Work::Paper)])?;
    let history = find(entries, "history").map_or(Ok(History::default()), history)?;
    let element = ElementData { parameters, history };
    element.check().map_err(|wrong| JsonError::at(node.column, format!("element: {wrong}")))?;
    let steps = find(entries, "steps").map_or(Ok(Vec::new()), |node| steps(node, dofs))?;
    Ok((element, steps))
}

fn steps(node: &Node, dofs: [usize; 2]) -> Read<Vec<StepDofs>> {
    let all = match &node.value {
        Value::List(all) => &all[..],
        Value::Numbers(none) if none.is_empty() => &[],
        _ => return Err(JsonError::at(node.column, "element.steps: a list of steps expected")),
    };
    let step = |node: &Node| {
        let entries = node.object("element.steps")?;
        known(entries, &["beam", "bar"])?;
        let of = |name: &str, count: usize| {
            let found = find(entries, name).ok_or_else(|| JsonError::at(node.column, missing(name)))?;
            found.numbers(name, Some(count))
        };
        Ok([of("beam", dofs[0])?, of("bar", dofs[1])?])
    };
    all.iter().map(step).collect()
}

fn history(node: &Node) -> Read<History> {
    let entries = node.object("history")?;
    known(entries, &["normal", "slips"])?;
    let given = |name: &str| find(entries, name).filter(|node| node.value != Value::Null);
    let normal = given("normal").map(|node| node.numbers("history.normal", Some(3))).transpose()?;
    Ok(History {
        normal: normal.map(|n| Vector3::from_column_slice(&n)),
        slips: given("slips").map(slips).transpose()?,
    })
}

fn slips(node: &Node) -> Read<Slips> {
    let entries = node.object("slips")?;
    known(entries, &["xi", "xi_bar", "e", "e_bar", "cosine", "held"])?;
    let get = |name: &str| number(node, entries, name);
    let held = |xi, xi_bar| Held { xi, xi_bar };
    let words = [
        ("none", held(false, false)),
        ("xi", held(true, false)),
        ("xi_bar", held(false, true)),
        ("both", held(true, true)),
    ];
    Ok(Slips {
        xi: get("xi")?,
        xi_bar: get("xi_bar")?,
        e: get("e")?,
        e_bar: get("e_bar")?,
        cosine: get("cosine")?,
        held: choice(entries, "held", &words)?,
        is_slipping: false,
    })
}
