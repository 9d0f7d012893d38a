//! What the script and the style of both pages have in common.

pub(crate) const FONT: &str = include_str!("../../../src/report/derivation/math.woff2.base64");
const SCRIPT: [&str; 3] =
    [include_str!("../page/module.js"), include_str!("../page/scene.js"), include_str!("../page/hands.js")];
const STYLE: [&str; 2] =
    [include_str!("../../../src/report/derivation/style.css"), include_str!("../page/scene.css")];

/// The script of a page with these parts of its own. All share one scope.
pub(crate) fn script(own: &[&str]) -> String {
    format!("\"use strict\";\n(() => {{\n{}}})();\n", [&SCRIPT, own].concat().join("\n"))
}

/// The style of a page with this part of its own.
pub(crate) fn style(own: &str) -> String {
    (STYLE.concat() + own).replace("FONT", &FONT.replace('\n', ""))
}
