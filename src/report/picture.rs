//! The picture of the front page: two beams, their closest points and the quantities that are measured there.

use crate::closest_point::ProjectionError;
use crate::curve::{Curve, Hermite};
use crate::equations::StandardCase;
use crate::pair::DofVector;
use nalgebra::{SVector, Vector3};
use std::fmt::Write;

/// Half of the width and of the height.
const HALF: [f64; 2] = [310.0, 185.0];
/// The length of a unit.
const SCALE: f64 = 190.0;
/// The number of points of a drawn curve.
const POINTS: u32 = 48;
/// The radius of both beams.
const RADIUS: f64 = 0.12;
/// The look in light and dark: the colours of the derivation.
const STYLE: &str = "<style>.pair{--text:#1b1b1b;--b:#00619c;--r:#8f5c00;--d:#b84300;--g:#1b7837}\
    @media(prefers-color-scheme:dark){.pair{--text:#e6e6e6;--b:#6cbcf2;--r:#f0b445;--d:#ff9161;--g:#7ee787;background:#161616}}\
    .pair text{font:italic 19px serif;fill:var(--c,var(--text))}.pair path,.pair line{fill:none;stroke:var(--c);stroke-linecap:round}\
    .pair .b{--c:var(--b)}.pair .r{--c:var(--r)}.pair .d{--c:var(--d)}.pair .g{--c:var(--g)}\
    .pair .tube{stroke-opacity:.28;stroke-linecap:butt}.pair .axis{stroke-width:1.5}.pair .vector{stroke-width:2.5}\
    .pair .gap{stroke-width:4}.pair marker path{fill:var(--c);stroke:none}.pair circle{fill:var(--c)}</style>";

/// The head of a vector of this colour.
fn arrow(colour: &str) -> String {
    format!(
        "<marker id=\"arrow-{colour}\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"5\" markerHeight=\"5\" \
         orient=\"auto\"><path class=\"{colour}\" d=\"M0 0L8 4L0 8z\"/></marker>"
    )
}

/// Two Hermite beams with d, t, t_bar and g_N at their closest points, as SVG.
///
/// # Errors
/// None, as long as the beams of the picture have one closest point inside both.
pub fn picture() -> Result<String, ProjectionError> {
    let case = StandardCase::default();
    let DofVector { beam, bar } = case.q;
    let point = case.closest_point()?;
    let at = |q: &SVector<f64, 12>, xi: f64| Hermite::new().jet(q, xi).geometry;
    let (x, x_bar) = (at(&beam, point.xi), at(&bar, point.xi_bar));
    let n = (x.x - x_bar.x).normalize();

    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" class=\"pair\">\n\
         <title>Two beams with the distance d, the tangents t and t_bar and the gap g_N at their closest points</title>\n\
         {STYLE}{}\n",
        2.0 * HALF[0],
        2.0 * HALF[1],
        ["b", "r", "d"].map(arrow).concat()
    );
    for (q, class) in [(&bar, "r"), (&beam, "b")] {
        let steps = (0..=POINTS).map(|i| seen(&at(q, -1.0 + 2.0 * f64::from(i) / f64::from(POINTS)).x));
        let path = steps.map(|[x, y]| format!("{x:.1} {y:.1}")).collect::<Vec<_>>().join("L");
        let width = 2.0 * RADIUS * SCALE;
        let _ = writeln!(
            svg,
            "<path class=\"tube {class}\" stroke-width=\"{width:.1}\" d=\"M{path}\"/><path class=\"axis {class}\" d=\"M{path}\"/>"
        );
    }
    let mut line = |class: &str, end: &str, from: Vector3<f64>, to: Vector3<f64>| {
        let ([x, y], [u, v]) = (seen(&from), seen(&to));
        let _ = writeln!(
            svg,
            "<line class=\"{class}\"{end} x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{u:.1}\" y2=\"{v:.1}\"/>"
        );
    };
    let tangents = [x, x_bar].map(|x| x.x + x.t * (0.45 / x.t.norm()));
    for (colour, from, to) in [("b", x.x, tangents[0]), ("r", x_bar.x, tangents[1]), ("d", x_bar.x, x.x)] {
        line(&format!("vector {colour}"), &format!(" marker-end=\"url(#arrow-{colour})\""), from, to);
    }
    // Beside d, so that both are visible.
    let aside = Vector3::new(14.0 / SCALE, 0.0, 0.0);
    line("gap g", "", x_bar.x + n * RADIUS + aside, x.x - n * RADIUS + aside);
    let label = |at: Vector3<f64>, [right, down]: [f64; 2], class: &str, text: &str| {
        let [x, y] = seen(&at);
        format!("<text class=\"{class}\" x=\"{:.1}\" y=\"{:.1}\">{text}</text>\n", x + right, y + down)
    };
    let middle = (x.x + x_bar.x) * 0.5;
    let labels = [
        label(tangents[0], [6.0, -4.0], "b", "t"),
        label(tangents[1], [-8.0, -14.0], "r", "t̄"),
        label(middle, [-24.0, 6.0], "d", "d"),
        label(middle, [22.0, 6.0], "g", "g<tspan dy=\"5\" font-size=\"13\">N</tspan>"),
        label(x.x, [-22.0, -8.0], "b", "x"),
        label(x_bar.x, [-24.0, 20.0], "r", "x̄"),
    ];
    let dots = [(x.x, "b"), (x_bar.x, "r")].map(|(at, class)| {
        let [x, y] = seen(&at);
        format!("<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>\n")
    });
    Ok(svg + &dots.concat() + &labels.concat() + "</svg>\n")
}

/// The projections of a point from above and from the side.
fn seen(x: &Vector3<f64>) -> [f64; 2] {
    [HALF[0] + SCALE * (x.x + 0.25 * x.y), HALF[1] - SCALE * (x.z + 0.3 * x.y)]
}
