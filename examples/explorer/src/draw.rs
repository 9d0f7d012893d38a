//! SVG elements: lines and texts, with the classes of the page.

use std::fmt::Write;

/// A line through points.
pub(crate) fn path(class: &str, points: impl IntoIterator<Item = [f64; 2]>) -> String {
    let mut data = String::new();
    for (i, [x, y]) in points.into_iter().enumerate() {
        let _ = write!(data, "{}{x:.1} {y:.1}", if i == 0 { "M" } else { "L" });
    }
    format!("<path class=\"{class}\" d=\"{data}\"/>\n")
}

/// A text in the picture.
pub(crate) fn text(class: &str, [x, y]: [f64; 2], words: &str) -> String {
    format!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{words}</text>\n")
}
