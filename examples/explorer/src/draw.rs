//! SVG elements: lines, arrows, points, letters, with the classes of the page.

use std::fmt::Write;

/// A line through points.
pub(crate) fn path(class: &str, points: impl IntoIterator<Item = [f64; 2]>) -> String {
    let mut data = String::new();
    for (i, [x, y]) in points.into_iter().enumerate() {
        let _ = write!(data, "{}{x:.1} {y:.1}", if i == 0 { "M" } else { "L" });
    }
    format!("<path class=\"{class}\" d=\"{data}\"/>\n")
}

/// An arrow with a head at its end. A line in the colour of the page behind it separates it from the beams.
pub(crate) fn arrow(class: &str, from: [f64; 2], to: [f64; 2]) -> String {
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy);
    if length < 2.0 {
        return String::new();
    }
    let size = length.min(11.0);
    let (ux, uy) = (dx / length, dy / length);
    let back = [to[0] - size * ux, to[1] - size * uy];
    let side = |sign: f64| [back[0] - sign * 0.41 * size * uy, back[1] + sign * 0.41 * size * ux];
    let ([x, y], [u, v]) = (side(1.0), side(-1.0));
    path("under", [from, back])
        + &path(&format!("arrow {class}"), [from, back])
        + &format!(
            "<path class=\"head {class}\" d=\"M{:.1} {:.1}L{x:.1} {y:.1}L{u:.1} {v:.1}z\"/>\n",
            to[0], to[1]
        )
}

/// A point.
pub(crate) fn dot(class: &str, [x, y]: [f64; 2]) -> String {
    format!("<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\"/>\n")
}

/// A text in the picture.
pub(crate) fn text(class: &str, [x, y]: [f64; 2], words: &str) -> String {
    format!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{words}</text>\n")
}
