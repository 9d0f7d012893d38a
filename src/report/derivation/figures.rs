//! The figures of the page: SVG in the colours of the page, made from the standard case and from records.

mod beams;
mod matrix;
mod plot;
mod system;

pub(super) use beams::{before_and_after, varied_pair};
pub(super) use matrix::blocks;
pub(super) use plot::{Axis, Plot, Series};
pub(super) use system::two_lines;

use std::fmt::Write;

/// The frame of a figure.
pub(super) fn svg(width: f64, height: f64, title: &str, body: &str) -> String {
    format!("<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{title}\">\n{body}</svg>\n")
}

/// A text in a figure.
fn text(at: [f64; 2], class: &str, words: &str) -> String {
    format!("<text class=\"{class}\" x=\"{:.1}\" y=\"{:.1}\">{words}</text>\n", at[0], at[1])
}

/// A line through points.
fn path(class: &str, points: impl IntoIterator<Item = [f64; 2]>) -> String {
    let mut data = String::new();
    for (i, [x, y]) in points.into_iter().enumerate() {
        let _ = write!(data, "{}{x:.1} {y:.1}", if i == 0 { "M" } else { "L" });
    }
    format!("<path class=\"{class}\" d=\"{data}\"/>\n")
}

/// An arrow with a head at its end.
fn arrow(class: &str, from: [f64; 2], to: [f64; 2]) -> String {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy).max(1e-9);
    let (ux, uy) = (dx / length, dy / length);
    let back = [to[0] - 11.0 * ux, to[1] - 11.0 * uy];
    let side = |sign: f64| [back[0] - sign * 4.5 * uy, back[1] + sign * 4.5 * ux];
    let [left, right] = [side(1.0), side(-1.0)];
    path(&format!("arrow {class}"), [from, back])
        + &format!(
            "<path class=\"head {class}\" d=\"M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}z\"/>\n",
            to[0], to[1], left[0], left[1], right[0], right[1]
        )
}

/// A point.
fn dot(class: &str, [x, y]: [f64; 2]) -> String {
    format!("<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\"/>\n")
}
