//! The page of the scenes: its prose, with formulas as MathML, and the frames in which it opens.
//!
//! In the files of `page/learn`, `$..$` is LaTeX, `[[name|..]]` is a term with the value of this name, and
//! `{{scene name=value,.. key}}` is a value of a scene after its controls are set. A number of the prose is never written.

use crate::assets::{script, style};
use crate::math::mathml;
use crate::{compose, escaped};
use beamgap_explorer::{Frame, SCENES, asymmetry, hidden, learn, opening, spectral_radius};
use serde_json::{Value, json};
use std::error::Error;
use std::fmt::Write;

const TEMPLATE: &str = include_str!("../page/learn/page.html");
/// The parts of the script and the style that this page alone has.
const SCRIPT: [&str; 1] = [include_str!("../page/learn/walk.js")];
const STYLE: &str = include_str!("../page/learn/learn.css");
/// The files of the scenes, in the order of [`SCENES`].
const PROSE: [&str; 8] = [
    include_str!("../page/learn/valley.html"),
    include_str!("../page/learn/normal.html"),
    include_str!("../page/learn/slide.html"),
    include_str!("../page/learn/lines.html"),
    include_str!("../page/learn/envelope.html"),
    include_str!("../page/learn/race.html"),
    include_str!("../page/learn/detective.html"),
    include_str!("../page/learn/friction.html"),
];

/// The page that contains the module.
///
/// # Errors
/// A formula, a name or a placeholder that is not known.
pub(crate) fn page(module: &str) -> Result<String, Box<dyn Error>> {
    let mut scenes = String::new();
    let mut contents = String::new();
    for (count, (name, prose)) in (1..).zip(SCENES.into_iter().zip(PROSE)) {
        let frame = opening(name)?;
        let html = filled(&typeset(&with_values(prose)?)?, &frame)?;
        let title = between(&html, "-title\">", "</h2>").ok_or("a scene has no title")?.to_owned();
        let html = html.replacen("-title\">", &format!("-title\"><span class=\"count\">{count}</span> "), 1);
        writeln!(contents, "<li><a href=\"#{name}\">{title}</a></li>")?;
        let rests = if name == "detective" { " data-rest" } else { "" };
        writeln!(
            scenes,
            "<section class=\"scene\" id=\"{name}\" data-scene=\"{name}\"{rests} aria-labelledby=\"{name}-title\">\n{html}</section>"
        )?;
    }
    let pieces = [
        ("style", style(STYLE)),
        ("contents", contents),
        ("scenes", scenes),
        ("module", module.to_owned()),
        ("script", script(&SCRIPT)),
    ];
    compose(&typeset(TEMPLATE)?, &pieces)
}

fn between<'a>(text: &'a str, from: &str, to: &str) -> Option<&'a str> {
    Some(text.split_once(from)?.1.split_once(to)?.0)
}

/// The prose with the values that it states, and the explanations of the hidden errors.
fn with_values(prose: &str) -> Result<String, Box<dyn Error>> {
    let mut out = String::new();
    let mut rest = prose;
    while let Some((before, from)) = rest.split_once("{{") {
        let (command, after) = from.split_once("}}").ok_or("a placeholder does not end")?;
        out += before;
        if command == "explanations" {
            for (i, error) in hidden().into_iter().enumerate() {
                let words = escaped(&error.explanation);
                write!(
                    out,
                    "<span data-shown=\"explain{i}\" hidden> The program <code>beamgap check</code> names as the likely cause: {words}.</span>"
                )?;
            }
        } else {
            out += &value(command)?;
        }
        rest = after;
    }
    Ok(out + rest)
}

/// A value of a scene after its controls are set, or a number that no scene shows: `radius TANGENT PUSH` or `asymmetry X Y`.
fn value(command: &str) -> Result<String, Box<dyn Error>> {
    match command.split(' ').collect::<Vec<_>>()[..] {
        ["radius", tangent, push] => {
            let radius = spectral_radius(tangent, push.parse()?);
            return Ok(format!("{:.2}", radius.ok_or_else(|| format!("{command:?} has no value"))?));
        }
        ["asymmetry", x, y] => return Ok(format!("{:.3}", asymmetry([x.parse()?, y.parse()?])?)),
        _ => {}
    }
    let mut words = command.split(' ');
    let (Some(scene), Some(settings), Some(key)) = (words.next(), words.next(), words.next()) else {
        return Err(format!("{command:?} is no scene with controls and a value").into());
    };
    let mut state = Value::Null;
    let mut found = Value::Null;
    for setting in settings.split(',') {
        let (name, value) = setting.split_once('=').ok_or("a control has no value")?;
        let request = json!({ "scene": scene, "state": state, "action": { "choose": { "name": name, "value": value } } });
        let frame: Value = serde_json::from_str(&learn(&request.to_string()))?;
        state = frame["state"].clone();
        found = frame["values"][key].clone();
    }
    Ok(found.as_str().ok_or_else(|| format!("{command:?} has no value"))?.to_owned())
}

/// LaTeX becomes MathML, and terms become buttons with their values.
pub(crate) fn typeset(html: &str) -> Result<String, Box<dyn Error>> {
    let mut out = String::new();
    let mut rest = html;
    while let Some(at) = rest.find(['$', '[']) {
        let (before, from) = rest.split_at(at);
        out += before;
        if let Some(from) = from.strip_prefix("[[") {
            let (name, from) = from.split_once('|').ok_or("a term has no formula")?;
            let (latex, after) = from.split_once("]]").ok_or("a term does not end")?;
            write!(
                out,
                "<button type=\"button\" class=\"term\" data-term=\"{name}\">{}<span class=\"now\" data-value=\"{name}\"></span></button>",
                mathml(latex, false)?
            )?;
            rest = after;
        } else if let Some(from) = from.strip_prefix('$') {
            let (latex, after) = from.split_once('$').ok_or("a formula does not end")?;
            // A mark after a formula stays on its line.
            let marks = after.len() - after.trim_start_matches(['.', ',', ';', ':', ')']).len();
            let (marks, after) = after.split_at(marks);
            let math = mathml(latex, false)?;
            if marks.is_empty() {
                out += &math;
            } else {
                write!(out, "<span class=\"joined\">{math}{marks}</span>")?;
            }
            rest = after;
        } else {
            out.push('[');
            rest = &from[1..];
        }
    }
    Ok(out + rest)
}

/// The elements of a scene, with their content as the page opens.
pub(crate) fn filled(html: &str, frame: &Frame) -> Result<String, Box<dyn Error>> {
    let mut out = String::new();
    let mut rest = html;
    while let Some((before, from)) = rest.split_once("data-") {
        out += before;
        out += "data-";
        rest = from;
        let Some((kind, name, after)) = attribute(from) else { continue };
        let missing = || format!("no {kind} of the scene is called {name:?}");
        let added = match kind {
            "path" => format!(" d=\"{}\"", frame.paths.get(name).ok_or_else(missing)?),
            "place" => match frame.places.get(name).ok_or_else(missing)? {
                Some([x, y]) => format!(" transform=\"translate({x} {y})\""),
                None => " style=\"display:none\"".to_owned(),
            },
            "value" => {
                let (tag, after) = after.split_once('>').ok_or("an element does not end")?;
                let text = escaped(frame.values.get(name).ok_or_else(missing)?);
                write!(out, "{kind}=\"{name}\"{tag}>{text}")?;
                rest = after;
                continue;
            }
            _ => continue,
        };
        write!(out, "{kind}=\"{name}\"{added}")?;
        rest = after;
    }
    Ok(out + rest)
}

/// The kind and the name of an attribute after its `data-`, and the text after it.
fn attribute(text: &str) -> Option<(&str, &str, &str)> {
    let (kind, from) = text.split_once("=\"")?;
    let (name, after) = from.split_once('"')?;
    kind.chars().all(|c| c.is_ascii_lowercase()).then_some((kind, name, after))
}
