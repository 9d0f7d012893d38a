//! Exported cases and answers are valid by the JSON Schemas.

use crate::program::{run, stdout};
use serde_json::Value;

/// Whether a value is valid by a schema; an unknown keyword is an error of the schema.
pub(crate) fn is_valid(value: &Value, schema: &Value, root: &Value) -> Result<(), String> {
    let wrong = |what: &str| Err(format!("{what}: {value} is not {schema}"));
    let Some(schema) = schema.as_object() else { return wrong("schema") };
    for (keyword, of) in schema {
        let list = || of.as_array().unwrap();
        let holds = match keyword.as_str() {
            "$schema" | "$id" | "$defs" | "definitions" | "title" | "description" | "default" | "format" => {
                true
            }
            "$ref" => {
                let path = of.as_str().unwrap().strip_prefix('#').unwrap();
                is_valid(value, root.pointer(path).unwrap(), root)?;
                true
            }
            "type" => {
                let is = |name: &Value| match name.as_str().unwrap() {
                    "object" => value.is_object(),
                    "array" => value.is_array(),
                    "string" => value.is_string(),
                    "number" => value.is_number(),
                    "integer" => value.is_u64() || value.is_i64(),
                    "null" => value.is_null(),
                    "boolean" => value.is_boolean(),
                    other => panic!("{other}"),
                };
                if of.is_array() { list().iter().any(is) } else { is(of) }
            }
            "const" => value == of,
            "enum" => list().contains(value),
            "oneOf" => list().iter().filter(|one| is_valid(value, one, root).is_ok()).count() == 1,
            "anyOf" => list().iter().any(|one| is_valid(value, one, root).is_ok()),
            "required" => list().iter().all(|name| value.get(name.as_str().unwrap()).is_some()),
            "properties" => {
                for (name, of) in of.as_object().unwrap() {
                    value.get(name).map_or(Ok(()), |value| is_valid(value, of, root))?;
                }
                true
            }
            "additionalProperties" => {
                let known = schema.get("properties");
                let is_more = |name: &str| known.is_none_or(|known| known.get(name).is_none());
                let mut more = value.as_object().into_iter().flatten().filter(|(name, _)| is_more(name));
                match of {
                    Value::Bool(allowed) => *allowed || more.next().is_none(),
                    of => more.all(|(_, value)| is_valid(value, of, root).is_ok()),
                }
            }
            "items" => {
                for item in value.as_array().into_iter().flatten() {
                    is_valid(item, of, root)?;
                }
                true
            }
            "uniqueItems" => {
                let items = value.as_array().map_or(&[][..], Vec::as_slice);
                (0..items.len()).all(|i| !items[..i].contains(&items[i]))
            }
            "minItems" => value.as_array().is_none_or(|items| items.len() as u64 >= of.as_u64().unwrap()),
            "maxItems" => value.as_array().is_none_or(|items| items.len() as u64 <= of.as_u64().unwrap()),
            "maximum" => value.as_f64().is_none_or(|number| number <= of.as_f64().unwrap()),
            "minimum" => value.as_f64().is_none_or(|number| number >= of.as_f64().unwrap()),
            "exclusiveMinimum" => value.as_f64().is_none_or(|number| number > of.as_f64().unwrap()),
            "pattern" => value.as_str().is_none_or(|text| beamgap::check::external::parse(text).is_ok()),
            other => panic!("unknown keyword {other}"),
        };
        if !holds {
            return wrong(keyword);
        }
    }
    Ok(())
}

fn schema(of: &str) -> Value {
    serde_json::from_str(&stdout(&run(&["schema", of]))).unwrap()
}

fn lines(text: &str) -> Vec<Value> {
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn cases_and_answers_are_what_their_schemas_say() {
    let (of_vectors, of_answers) = (schema("vectors"), schema("answers"));
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("schemas.jsonl");
    for more in [&["--expected", "all"][..], &["--hex"], &["--expected", "none", "--penetrating"]] {
        let text = stdout(&run(&[&["export", "--cases", "2"], more].concat()));
        for line in lines(&text) {
            is_valid(&line, &of_vectors, &of_vectors).unwrap();
            is_valid(&line, &of_answers, &of_answers).unwrap_err();
        }
        std::fs::write(&path, &text).unwrap();
        let answers = stdout(&run(&["evaluate", path.to_str().unwrap(), "--penalty", "10"]));
        for line in lines(&answers) {
            is_valid(&line, &of_answers, &of_answers).unwrap();
        }
    }
}

#[test]
fn what_is_misspelt_is_against_the_schema() {
    let (of_vectors, of_answers) = (schema("vectors"), schema("answers"));
    let text = stdout(&run(&["export", "--cases", "1", "--family", "arc"]));
    let case = lines(&text).remove(1);
    for (name, wrong) in [("beams", Value::Null), ("result", "invalid".into()), ("id", Value::Null)] {
        let mut case = case.clone();
        case[name] = wrong;
        is_valid(&case, &of_vectors, &of_vectors).unwrap_err();
    }
    for wrong in
        [r#"{"schema":"beamgap-answers/1","dofs":"node"}"#, r#"{"id":"1","d":{"values":1}}"#, r#"{"d":1}"#]
    {
        is_valid(&serde_json::from_str(wrong).unwrap(), &of_answers, &of_answers).unwrap_err();
    }
}
