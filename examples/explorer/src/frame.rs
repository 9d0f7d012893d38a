//! What a picture and its formulas show: texts, paths and places by name.

use beamgap::nalgebra::Vector3;
use serde::Serialize;
use serde_json::Value;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The name of an element.
type Name = Cow<'static, str>;

/// The parts of a picture and of its formula, by the names of their elements.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Frame {
    /// The error in the request; all other fields are then empty.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<String>,
    /// The state that this is the frame of.
    pub state: Value,
    /// Texts.
    pub values: BTreeMap<Name, String>,
    /// Lines and arrows, as the data of SVG paths. An empty one is not visible.
    pub paths: BTreeMap<Name, String>,
    /// Handles, points and letters; those without a place are not visible.
    pub places: BTreeMap<Name, Option<[f64; 2]>>,
    /// Maps in shades: a letter for each point, `a` the lightest.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub shades: BTreeMap<Name, String>,
    /// Which parts of the text are visible.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub shown: BTreeMap<Name, bool>,
    /// The values of controls and of handles that are sliders.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub controls: BTreeMap<Name, String>,
    /// The names of handles, for those who do not see them.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub labels: BTreeMap<Name, String>,
    /// Widths in units of the picture.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub widths: BTreeMap<Name, f64>,
}

impl Frame {
    pub(crate) fn text(&mut self, name: impl Into<Name>, words: impl Into<String>) {
        self.values.insert(name.into(), words.into());
    }

    /// A number with three decimals.
    pub(crate) fn number(&mut self, name: impl Into<Name>, x: f64) {
        self.text(name, number(x));
    }

    /// A place. If a wrong formula has led to a number that is not finite, nothing is shown.
    pub(crate) fn place(&mut self, name: impl Into<Name>, at: [f64; 2]) {
        self.place_if(name, Some(at));
    }

    /// A place, if there is one.
    pub(crate) fn place_if(&mut self, name: impl Into<Name>, at: Option<[f64; 2]>) {
        let at = at.filter(|at| at.iter().all(|x| x.is_finite()));
        self.places.insert(name.into(), at.map(|at| at.map(tenth)));
    }

    pub(crate) fn hide(&mut self, name: impl Into<Name>) {
        self.places.insert(name.into(), None);
    }

    /// A line through points.
    pub(crate) fn line(&mut self, name: impl Into<Name>, points: impl IntoIterator<Item = [f64; 2]>) {
        self.paths.insert(name.into(), line(points));
    }

    /// Several lines as one path.
    pub(crate) fn lines<const K: usize>(&mut self, name: impl Into<Name>, lines: &[[[f64; 2]; K]]) {
        let mut data = String::new();
        for line in lines {
            push_line(&mut data, *line);
        }
        self.paths.insert(name.into(), data);
    }

    pub(crate) fn no_path(&mut self, name: impl Into<Name>) {
        self.paths.insert(name.into(), String::new());
    }

    /// An arrow as an outline that can be filled. A very short one is not drawn.
    pub(crate) fn solid_arrow(&mut self, name: impl Into<Name>, from: [f64; 2], to: [f64; 2]) {
        self.paths.insert(name.into(), solid_arrow(from, to));
    }

    /// An arrow with a head. A very short one is not drawn.
    pub(crate) fn arrow(&mut self, name: impl Into<Name>, from: [f64; 2], to: [f64; 2]) {
        self.paths.insert(name.into(), arrow(from, to));
    }
}

fn tenth(x: f64) -> f64 {
    (x * 10.0).round() / 10.0
}

/// The data of a line through points.
pub(crate) fn line(points: impl IntoIterator<Item = [f64; 2]>) -> String {
    let mut data = String::new();
    push_line(&mut data, points);
    data
}

/// Adds a line through points.
pub(crate) fn push_line(data: &mut String, points: impl IntoIterator<Item = [f64; 2]>) {
    for (i, [x, y]) in points.into_iter().enumerate() {
        data.push(if i == 0 { 'M' } else { 'L' });
        push_tenths(data, x);
        data.push(' ');
        push_tenths(data, y);
    }
}

/// Adds a number with at most one decimal. A map has a thousand of them, and the formatting of floats takes too long.
fn push_tenths(data: &mut String, x: f64) {
    #[expect(clippy::cast_possible_truncation, reason = "clamped; a number that is not finite becomes 0")]
    let tenths = (x * 10.0).round().clamp(-1e6, 1e6) as i32;
    if tenths < 0 {
        data.push('-');
    }
    let mut rest = tenths.unsigned_abs();
    let mut digits = [b'0'; 8];
    let mut count = 0;
    while rest > 0 || count < 2 {
        digits[count] = b'0' + u8::try_from(rest % 10).unwrap_or(0);
        rest /= 10;
        count += 1;
    }
    data.extend(digits[1..count].iter().rev().map(|&digit| char::from(digit)));
    if digits[0] != b'0' {
        data.push('.');
        data.push(char::from(digits[0]));
    }
}

fn arrow(from: [f64; 2], to: [f64; 2]) -> String {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = (dx * dx + dy * dy).sqrt();
    if length < 2.5 || !length.is_finite() {
        return String::new();
    }
    let size = length.min(11.0);
    let (ux, uy) = (dx / length, dy / length);
    let back = [to[0] - size * ux, to[1] - size * uy];
    let side = |sign: f64| [back[0] - sign * 0.42 * size * uy, back[1] + sign * 0.42 * size * ux];
    line([from, back]) + &line([to, side(1.0), side(-1.0)]) + "z"
}

fn solid_arrow(from: [f64; 2], to: [f64; 2]) -> String {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = (dx * dx + dy * dy).sqrt();
    if length < 2.5 || !length.is_finite() {
        return String::new();
    }
    let (ux, uy) = (dx / length, dy / length);
    let head = length.min(13.0);
    // Along the arrow and across it.
    let at =
        |along: f64, across: f64| [from[0] + along * ux - across * uy, from[1] + along * uy + across * ux];
    let neck = length - head;
    let half = [at(0.0, 1.4), at(neck, 1.4), at(neck, 0.45 * head), to];
    let other = [at(neck, -0.45 * head), at(neck, -1.4), at(0.0, -1.4)];
    line(half.into_iter().chain(other)) + "z"
}

/// A number with three decimals, or with an exponent if it is very large or very small.
pub(crate) fn number(x: f64) -> String {
    let text = match x.abs() {
        size if !size.is_finite() => return "not finite".to_owned(),
        size if size < 5e-13 => "0.000".to_owned(),
        size if (5e-4..1e4).contains(&size) => format!("{x:.3}"),
        _ => format!("{x:.1e}"),
    };
    text.replace('-', "−")
}

/// A vector with two decimals, or with exponents where an entry is very large.
pub(crate) fn vector(v: &Vector3<f64>) -> String {
    let entry = |x: f64| {
        let text = match x.abs() {
            size if size < 0.005 => "0.00".to_owned(),
            size if size < 1e3 => format!("{x:.2}"),
            _ => format!("{x:.1e}"),
        };
        text.replace('-', "−")
    };
    format!("({}, {}, {})", entry(v.x), entry(v.y), entry(v.z))
}
