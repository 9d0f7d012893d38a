//! The page of the explorer: its pictures, its formulas with a button for each term, and the standard case as it opens.

use crate::assets::{script, style};
use crate::equations_table::rows;
use crate::learn_page::{filled, typeset};
use crate::math::mathml;
use crate::{compose, escaped};
use beamgap::linearization::Quantity;
use beamgap::test_beam::Family;
use beamgap::variant::{Fault, Kind, catalogue};
use beamgap_explorer::{Answer, Formula, Frame, Piece, State, Term, formulas, opening};
use serde_json::Value;
use std::error::Error;
use std::fmt::Write;

const TEMPLATE: &str = include_str!("../page/explorer/page.html");
/// The parts of the script and the style that this page alone has.
const SCRIPT: [&str; 5] = [
    include_str!("../page/explorer/picture.js"),
    include_str!("../page/explorer/fault.js"),
    include_str!("../page/explorer/tables.js"),
    include_str!("../page/explorer/dofs.js"),
    include_str!("../page/explorer/link.js"),
];
const STYLE: &str = include_str!("../page/explorer/explorer.css");

/// Instructive faults: their names, and the labels of their buttons.
const LESSONS: [(&str, &str); 6] = [
    ("", "no fault"),
    ("a: d.t,xi = dropped", "a without d·t,ξ"),
    ("R: du,xi.d = dropped", "R without δu,ξ·d"),
    ("d|d|: n.du_hat = sign", "δd with the wrong sign"),
    ("Dd x: rest = dropped", "Δδx without its known terms"),
    ("Ddg_T: dt Dxi = dropped", "Δδg of the slip without a mixed term"),
];
const SITUATIONS: [&str; 7] =
    ["standard", "parallel", "nearly parallel", "crossing", "overlap", "at an end", "two minima"];
/// What the picture has room for: layers of tubes, handles of a beam, other points, marks on the map.
const LAYERS: usize = 3;
const HANDLES: usize = 6;
const OTHERS: usize = 4;
const BEAMS: [&str; 2] = ["b", "r"];

/// The page that contains the module.
///
/// # Errors
/// A formula or a name that is not known, or a record of the equations that does not fit.
pub(crate) fn page(module: &str, equations: &Value) -> Result<String, Box<dyn Error>> {
    let standard = State::default();
    let mut frame = opening("explorer")?;
    let answer = Answer::of(&standard)?;
    let faults = catalogue();
    let is_known = |name: &str| name.is_empty() || faults.iter().any(|fault| fault.to_string() == name);
    if let Some((unknown, _)) = LESSONS.iter().find(|(name, _)| !is_known(name)) {
        return Err(format!("no fault is called {unknown:?}").into());
    }
    let formulas = formulas_html(&frame, &faults)?;
    // Formulas of other quantities have no values yet.
    for name in formulas.split("data-value=\"").skip(1).filter_map(|text| text.split('"').next()) {
        frame.values.entry(name.to_owned().into()).or_default();
    }
    let keep = |name: &'static str| (name, format!("{{{{{name}}}}}"));
    let pieces = [
        ("tubes", tubes(&frame)),
        ("others", others()),
        ("handles", handles(&frame)),
        ("marks", marks()),
        ("formulas", formulas),
        ("kinds", kinds()),
        ("lessons", buttons("lesson", LESSONS)),
        ("situations", buttons("situation", SITUATIONS.map(|name| (name, name)))),
        ("families", families()),
        ("radius", standard.contact.radius.to_string()),
        keep("style"),
        keep("script"),
        keep("module"),
        keep("equations"),
        keep("lesson"),
        keep("words"),
        keep("points"),
        keep("checks"),
        keep("prediction"),
        keep("plot"),
        keep("numbers"),
        keep("case"),
        keep("test"),
        keep("command"),
    ];
    let html = filled(&compose(&typeset(TEMPLATE)?, &pieces)?, &frame)?;
    let cells = answer.equations.clone().unwrap_or_default();
    let pieces = [
        ("style", style(STYLE)),
        ("lesson", answer.lesson),
        ("words", answer.words),
        ("points", answer.points),
        ("checks", answer.checks),
        ("prediction", answer.prediction),
        ("plot", answer.plot),
        ("numbers", answer.numbers),
        ("equations", rows(equations, &cells)?),
        ("case", escaped(&answer.case)),
        ("test", escaped(&answer.test)),
        ("command", escaped(&answer.command)),
        ("script", script(&SCRIPT)),
        ("module", module.to_owned()),
    ];
    compose(&html, &pieces)
}

/// The layers of both tubes: a gap around each, strokes from dark to light, the axis, and the ends that face the eye.
fn tubes(frame: &Frame) -> String {
    let mut out = String::new();
    for layer in 0..LAYERS {
        for beam in BEAMS {
            let width = frame.widths.get(beam).copied().unwrap_or_default();
            let name = format!("tube{layer}{beam}");
            let _ = write!(out, "<g class=\"tubes {beam}\" data-width=\"{beam}\" style=\"--w:{width}px\">");
            // The first layer covers nothing, and needs no gap.
            for class in ["halo", "edge", "middle", "light", "axis"].into_iter().skip(usize::from(layer == 0))
            {
                let _ = write!(out, "<g class=\"{class}\"><path data-path=\"{name}\"/></g>");
            }
            let _ = writeln!(out, "<path class=\"cap\" data-path=\"cap{layer}{beam}\"/></g>");
        }
    }
    out
}

fn others() -> String {
    let of = |i| {
        format!(
            "<path class=\"dashed d faint\" data-path=\"other{i}\"/><circle class=\"b hollow faint\" r=\"4.5\" data-place=\"other{i}b\"/>\
             <circle class=\"r hollow faint\" r=\"4.5\" data-place=\"other{i}r\"/>\n"
        )
    };
    (0..OTHERS).map(of).collect()
}

fn handles(frame: &Frame) -> String {
    let mut out = String::new();
    for beam in BEAMS {
        for i in 0..HANDLES {
            let name = format!("{beam}{i}");
            let label = frame.labels.get(name.as_str()).map_or("a point", String::as_str);
            let _ = writeln!(
                out,
                "<g class=\"handle {beam}\" data-handle=\"{name}\" data-place=\"{name}\" data-label=\"{name}\" tabindex=\"0\" \
                 role=\"button\" aria-label=\"{label}\"><circle class=\"grip\" r=\"20\"/><circle class=\"knob\" r=\"6.5\"/></g>"
            );
        }
    }
    out
}

fn marks() -> String {
    let cross = "<path class=\"cross\" d=\"M-6 -6L6 6M-6 6L6 -6\"/>";
    let saddle = |i| format!("<g data-place=\"saddle{i}\">{cross}</g>");
    let minimum = |i| {
        format!(
            "<g class=\"minimum\" data-place=\"minimum{i}\" data-minimum=\"{i}\" tabindex=\"0\" role=\"button\" aria-label=\"minimum {}\">\
             <circle class=\"grip\" r=\"22\"/><circle class=\"g ringed\" r=\"7\"/></g>\n",
            i + 1
        )
    };
    (0..OTHERS).map(saddle).chain((0..OTHERS).map(minimum)).collect()
}

fn buttons<'a>(what: &str, names: impl IntoIterator<Item = (&'a str, &'a str)>) -> String {
    let button = |(value, words): (&str, &str)| {
        let (value, words) = (escaped(value), escaped(words));
        format!("<button type=\"button\" data-choose=\"{what}\" data-to=\"{value}\">{words}</button>\n")
    };
    names.into_iter().map(button).collect()
}

fn families() -> String {
    let option = |family: Family| {
        let selected = if family == Family::Hermite { " selected" } else { "" };
        format!("<option{selected}>{}</option>", family.name())
    };
    Family::ALL.map(option).concat()
}

fn kinds() -> String {
    let kind = |(i, kind): (usize, &Kind)| {
        format!("<button type=\"button\" data-kind=\"{i}\">{}</button>\n", kind.name())
    };
    Kind::ALL.iter().enumerate().map(kind).collect()
}

/// All formulas; those of the standard case are visible.
fn formulas_html(frame: &Frame, faults: &[Fault]) -> Result<String, Box<dyn Error>> {
    let mut out = String::new();
    for (i, formula) in formulas().iter().enumerate() {
        let name = formula.visible;
        let hidden = if frame.shown.get(name) == Some(&true) { "" } else { " hidden" };
        write!(out, "<div class=\"formula\" data-shown=\"{name}\"{hidden}>")?;
        for piece in &formula.pieces {
            match piece {
                Piece::Latex(latex) => write!(out, "{} ", short(latex)?)?,
                Piece::Term(term) => out += &term_html(term, faults)?,
            }
        }
        if let Some(result) = formula.result {
            let is_vector = Quantity::axis_of_component(result.0.component()).is_some();
            let class = if is_vector { "is vector" } else { "is" };
            write!(
                out,
                "<span class=\"result\">= <span class=\"{class}\" data-value=\"result{i}\"></span></span> "
            )?;
        }
        writeln!(out, "{}</div>", tag(formula))?;
    }
    Ok(out)
}

fn tag(formula: &Formula) -> String {
    let number = formula.equation;
    format!("<a class=\"tag\" href=\"derivation.html#eq-{number}\">({number})</a>")
}

/// A term as a button, with its value. The script adds a place for the right one.
fn term_html(term: &Term, faults: &[Fault]) -> Result<String, Box<dyn Error>> {
    let of_term = |fault: &&Fault| fault.label.to_string() == term.name;
    let place = |fault: &Fault| Kind::ALL.iter().position(|kind| *kind == fault.kind);
    let kinds: String =
        faults.iter().filter(of_term).filter_map(place).map(|place| place.to_string()).collect();
    if kinds.is_empty() {
        return Err(format!("no term is called {:?}", term.name).into());
    }
    let name = escaped(term.name);
    let number = term.number;
    let values = match term.value {
        None => String::new(),
        Some((is_vector, _)) => {
            let class = if is_vector { "now vector" } else { "now" };
            format!("<span class=\"{class}\" data-value=\"term{number}\"></span>")
        }
    };
    Ok(format!(
        "<button class=\"term\" data-name=\"{name}\" data-kinds=\"{kinds}\" data-light=\"{}\">{}{values}</button> ",
        lights(term.latex),
        short(term.latex)?
    ))
}

/// A formula as MathML, without rows that contain one letter alone.
fn short(latex: &str) -> Result<String, Box<dyn Error>> {
    let mut math = mathml(latex, false)?.replace(" display=\"inline\"", "");
    loop {
        let single = math.match_indices("<mrow>").find_map(|(start, row)| {
            let inner = start + row.len();
            let end = inner + math[inner..].find("</mrow>")?;
            let element = &math[inner..end];
            let tag = element.strip_prefix('<')?.split(['>', ' ']).next()?;
            let is_single = element.matches('<').count() == 2 && element.ends_with(&format!("</{tag}>"));
            is_single.then(|| (start..end + "</mrow>".len(), element.to_owned()))
        });
        let Some((range, element)) = single else { return Ok(math) };
        math.replace_range(range, &element);
    }
}

/// The parts of the picture that the letters of a term stand for.
fn lights(latex: &str) -> String {
    let mut rest = latex.to_owned();
    let mut parts = Vec::new();
    for (letters, part) in [
        (&[r"\vtb", r"\tbx", r"\bar t"][..], "t_bar"),
        (&[r"\vt", r"\tx", "t\\,"], "t"),
        (&[r"\vxb"], "x_bar"),
        (&[r"\vx"], "x"),
        (&[r"\delta\xb", r"\Delta\xb", r"\bar\xi"], "xi_bar predicted"),
        (&[r"\delta\xi", r"\Delta\xi"], "xi predicted"),
        (&[r"\vd", r"\vn"], "d"),
        (&[r"\bar r", "r"], "gap"),
    ] {
        let is_radius = part == "gap";
        for letter in letters {
            if if is_radius { rest == *letter } else { rest.contains(letter) } {
                parts.push(part);
                rest = rest.replace(letter, " ");
            }
        }
    }
    parts.dedup();
    parts.join(" ")
}
