//! Cases as JSON, of the schema `beamgap-case/1`: written, and read back to the last bit.
//!
//! A case consists of `beam`, `bar` and `contact`. A document with a result has more keys, which are ignored.
//! Any other key is an error, so that a misspelt name is reported.

use super::arguments::program;
use anyhow::{Context, anyhow, bail, ensure};
use beamgap::check::{CaseData, Family, TestBeam};
use beamgap::pair::Contact;
use serde_json::{Map, Value, json};
use std::io::Read;
use std::path::Path;

/// The schema.
pub(super) const SCHEMA: &str = "beamgap-case/1";

/// The other keys of a document.
const SHOWN: [&str; 9] =
    ["schema", "version", "seed", "case", "regime", "verdict", "closest_points", "open_regions", "search"];

/// The case as JSON; `null` for a number that JSON cannot represent.
pub(super) fn object(case: &CaseData) -> Map<String, Value> {
    let [beam, bar] = case.test_beams.each_ref().map(test_beam);
    let Contact { radius, radius_bar, xi_0, xi_bar_0 } = case.contact;
    let contact = json!({ "radius": radius, "radius_bar": radius_bar, "xi_0": xi_0, "xi_bar_0": xi_bar_0 });
    let entries = [("schema", json!(SCHEMA)), ("beam", beam), ("bar", bar), ("contact", contact)];
    entries.map(|(name, value)| (name.to_owned(), value)).into_iter().collect()
}

/// The command that repeats the case.
pub(super) fn command(case: &CaseData) -> String {
    let mut object = object(case);
    if case.contact == Contact::default() {
        object.remove("contact");
    }
    format!("echo '{}' | {} check --case-file -", short(Value::Object(object)), program())
}

/// Converts a number that is whole to an integer, which is written without a decimal point.
fn short(value: Value) -> Value {
    match value {
        Value::Array(values) => values.into_iter().map(short).collect(),
        Value::Object(entries) => entries.into_iter().map(|(name, value)| (name, short(value))).collect(),
        // Negative zero cannot be written as an integer.
        Value::Number(number) if number.as_f64().is_some_and(|number| number.to_bits() != 1 << 63) => {
            let whole = format!("{number}").strip_suffix(".0").and_then(|whole| whole.parse::<i64>().ok());
            whole.map_or(Value::Number(number), Value::from)
        }
        other => other,
    }
}

fn test_beam(test_beam: &TestBeam) -> Value {
    let TestBeam { family, q, dq, linear_dq, .. } = test_beam;
    let parameters = family.parameters().iter().map(|&(name, count)| {
        let numbers = test_beam.parameter(name);
        (name.to_owned(), if count == 1 { json!(numbers.first()) } else { json!(numbers) })
    });
    let curve: Map<_, _> = parameters.collect();
    let mut object = json!({ "family": family.name(), "q": q, "dq": dq, "linear_dq": linear_dq });
    if !curve.is_empty() {
        object["curve"] = Value::Object(curve);
    }
    object
}

/// Reads a case from a file, or from standard input if the path is `-`.
pub(super) fn read(path: &Path) -> anyhow::Result<CaseData> {
    let from_stdin = path == Path::new("-");
    let name = if from_stdin { "standard input".into() } else { path.display().to_string() };
    let text = if from_stdin {
        let mut text = String::new();
        std::io::stdin().read_to_string(&mut text).map(|_| text)
    } else {
        std::fs::read_to_string(path)
    };
    parse(&text.with_context(|| format!("cannot read {name}"))?, &name)
}

/// Reads a case from a text; `name` is the name of the file, for messages.
pub(super) fn parse(text: &str, name: &str) -> anyhow::Result<CaseData> {
    let document: Value = serde_json::from_str(text).with_context(|| format!("{name} is not JSON"))?;
    case(&document).with_context(|| format!("{name} is not a case"))
}

fn case(document: &Value) -> anyhow::Result<CaseData> {
    let object = as_object(document, "the document")?;
    match object.get("schema") {
        Some(Value::String(schema)) if schema == SCHEMA => {}
        Some(other) => bail!("schema: {SCHEMA:?} expected, found {other}"),
        None => bail!("schema: missing, {SCHEMA:?} expected"),
    }
    known(object, "", &[&["beam", "bar", "contact"][..], &SHOWN].concat())?;
    let [beam, bar] = ["beam", "bar"].map(|name| beam(object, name));
    let contact = object.get("contact").map_or(Ok(Contact::default()), contact)?;
    Ok(CaseData { test_beams: [beam?, bar?], contact })
}

fn beam(object: &Map<String, Value>, name: &str) -> anyhow::Result<TestBeam> {
    let value = object.get(name).ok_or_else(|| anyhow!("{name}: missing"))?;
    let object = as_object(value, name)?;
    known(object, name, &["family", "curve", "q", "dq", "linear_dq"])?;
    let families = || Family::ALL.map(Family::name).join(", ");
    let family = match object.get("family") {
        Some(Value::String(family)) => {
            let found = || anyhow!("{name}.family: one of {} expected, found {family:?}", families());
            Family::from_name(family).ok_or_else(found)?
        }
        Some(other) => bail!("{name}.family: one of {} expected, found {other}", families()),
        None => bail!("{name}.family: missing, one of {} expected", families()),
    };
    let numbers = |list: &str, count: usize| -> anyhow::Result<Vec<f64>> {
        let path = format!("{name}.{list}");
        let found = object.get(list).ok_or_else(|| anyhow!("{path}: missing, {count} numbers expected"))?;
        several(found, &path, count)
    };
    let dofs = family.units().len();
    let test_beam = TestBeam {
        family,
        parameters: parameters(object, name, family)?,
        q: numbers("q", dofs)?,
        dq: numbers("dq", dofs)?,
        linear_dq: numbers("linear_dq", dofs)?,
    };
    test_beam.validate().with_context(|| name.to_owned())?;
    Ok(test_beam)
}

/// The fixed parameters of a curve: all those of the family and no others.
fn parameters(object: &Map<String, Value>, name: &str, family: Family) -> anyhow::Result<Vec<f64>> {
    let path = format!("{name}.curve");
    let none = Map::new();
    let curve = object.get("curve").map_or(Ok(&none), |curve| as_object(curve, &path))?;
    known(curve, &path, &family.parameters().iter().map(|&(name, _)| name).collect::<Vec<_>>())?;
    let mut parameters = Vec::new();
    for &(parameter, count) in family.parameters() {
        let path = format!("{path}.{parameter}");
        match (curve.get(parameter), count) {
            (Some(found), 1) => parameters.push(number(found, &path)?),
            (Some(found), _) => parameters.extend(several(found, &path, count)?),
            (None, 1) => bail!("{path}: missing, a number expected"),
            (None, _) => bail!("{path}: missing, {count} numbers expected"),
        }
    }
    Ok(parameters)
}

/// Radii and reference parameters; the default is zero.
fn contact(value: &Value) -> anyhow::Result<Contact> {
    let object = as_object(value, "contact")?;
    known(object, "contact", &["radius", "radius_bar", "xi_0", "xi_bar_0"])?;
    let get =
        |name: &str| object.get(name).map_or(Ok(0.0), |value| number(value, &format!("contact.{name}")));
    let radius = |name: &str| {
        let radius = get(name)?;
        ensure!(radius >= 0.0, "contact.{name}: a number from 0 on expected, found {radius}");
        anyhow::Ok(radius)
    };
    Ok(Contact {
        radius: radius("radius")?,
        radius_bar: radius("radius_bar")?,
        xi_0: get("xi_0")?,
        xi_bar_0: get("xi_bar_0")?,
    })
}

fn known(object: &Map<String, Value>, path: &str, names: &[&str]) -> anyhow::Result<()> {
    let Some(unknown) = object.keys().find(|name| !names.contains(&name.as_str())) else { return Ok(()) };
    let dot = if path.is_empty() { "" } else { "." };
    let expected = if names.is_empty() { "nothing".into() } else { names.join(", ") };
    bail!("{path}{dot}{unknown}: no such entry, expected {expected}")
}

fn as_object<'a>(value: &'a Value, path: &str) -> anyhow::Result<&'a Map<String, Value>> {
    value.as_object().ok_or_else(|| anyhow!("{path}: an object expected, found {}", shown(value)))
}

fn several(value: &Value, path: &str, count: usize) -> anyhow::Result<Vec<f64>> {
    let found = || anyhow!("{path}: {count} numbers expected, found {}", shown(value));
    let list = value.as_array().ok_or_else(found)?;
    ensure!(list.len() == count, "{path}: {count} numbers expected, found {}", list.len());
    list.iter().enumerate().map(|(i, value)| number(value, &format!("{path}[{i}]"))).collect()
}

fn number(value: &Value, path: &str) -> anyhow::Result<f64> {
    let number = value.as_f64().filter(|number| number.is_finite());
    number.ok_or_else(|| anyhow!("{path}: a number expected, found {}", shown(value)))
}

/// A short description of a value.
fn shown(value: &Value) -> String {
    match value {
        Value::Array(_) => "a list".into(),
        Value::Object(_) => "an object".into(),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::{case, command, program};
    use beamgap::check::{Case, CaseData};

    /// The case in the printed command.
    fn given(printed: &str) -> CaseData {
        let end = format!("' | {} check --case-file -", program());
        let json = printed.strip_prefix("echo '").unwrap().strip_suffix(end.as_str()).unwrap();
        // The shell must not interpret any character.
        assert!(!json.contains(['\'', '\n']), "{json}");
        case(&serde_json::from_str(json).unwrap()).unwrap()
    }

    #[test]
    fn a_command_gives_the_case_to_the_last_bit() {
        for number in 0..1089 {
            let mut drawn = Case::draw(5, number).data();
            let [beam, bar] = &mut drawn.test_beams;
            (beam.q[0], beam.dq[0], bar.q[1], bar.dq[2]) = (-0.0, 1e300, -7.0, 0.0);
            drawn.contact.xi_0 = -1.0 / 3.0;
            let read = given(&command(&drawn));
            assert_eq!(read, drawn);
            assert!(read.test_beams[0].q[0].is_sign_negative());
        }
    }

    #[test]
    fn whole_numbers_and_no_contact_are_written_short() {
        let mut drawn = Case::draw(5, 0).data();
        drawn.contact = beamgap::pair::Contact::default();
        drawn.test_beams[0].q = vec![1.0, 0.0, -2.0, 0.5, 1e15, 3.0];
        let printed = command(&drawn);
        assert!(
            printed.contains("\"q\":[1,0,-2,0.5,1000000000000000,3]") && !printed.contains("contact"),
            "{printed}"
        );
    }
}
