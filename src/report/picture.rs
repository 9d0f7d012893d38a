//! The picture of the front page: two beams, their closest points and what is measured there.

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
/// How many points a curve is drawn with.
const POINTS: u32 = 48;
/// The radius of both beams.
const RADIUS: f64 = 0.12;
/// The look in light and dark.
const STYLE: &str = "<style>text{font:italic 19px serif;fill:#111}path,line{fill:none;stroke-linecap:round}\
    .beam{stroke:#8ab4d8;stroke-opacity:.55}.bar{stroke:#e0a458;stroke-opacity:.55}.axis{stroke:#333;stroke-width:1.5}\
    .vector{stroke:#b3261e;stroke-width:2.5;marker-end:url(#arrow)}marker path{fill:#b3261e;stroke:none}.gap{stroke:#1b7837;stroke-width:4}circle{fill:#111}\
    @media(prefers-color-scheme:dark){text,circle{fill:#eee}.axis{stroke:#ddd}.vector{stroke:#ff8a80}marker path{fill:#ff8a80}\
    .gap{stroke:#7ee787}}</style>";

/// The head of a vector.
const ARROW: &str = "<marker id=\"arrow\" viewBox=\"0 0 8 8\" refX=\"7\" refY=\"4\" markerWidth=\"5\" \
    markerHeight=\"5\" orient=\"auto\"><path d=\"M0 0L8 4L0 8z\"/></marker>";

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
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\">\n\
         <title>Two beams with the distance d, the tangents t and t_bar and the gap g_N at their closest points</title>\n\
         {STYLE}{ARROW}\n",
        2.0 * HALF[0],
        2.0 * HALF[1]
    );
    for (q, class) in [(&bar, "bar"), (&beam, "beam")] {
        let steps = (0..=POINTS).map(|i| seen(&at(q, -1.0 + 2.0 * f64::from(i) / f64::from(POINTS)).x));
        let path = steps.map(|[x, y]| format!("{x:.1} {y:.1}")).collect::<Vec<_>>().join("L");
        let width = 2.0 * RADIUS * SCALE;
        let _ = writeln!(
            svg,
            "<path class=\"{class}\" stroke-width=\"{width:.1}\" d=\"M{path}\"/><path class=\"axis\" d=\"M{path}\"/>"
        );
    }
    let mut line = |class: &str, from: Vector3<f64>, to: Vector3<f64>| {
        let ([x, y], [u, v]) = (seen(&from), seen(&to));
        let _ = writeln!(
            svg,
            "<line class=\"{class}\" x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{u:.1}\" y2=\"{v:.1}\"/>"
        );
    };
    let tangents = [x, x_bar].map(|x| x.x + x.t * (0.45 / x.t.norm()));
    line("vector", x.x, tangents[0]);
    line("vector", x_bar.x, tangents[1]);
    line("vector", x_bar.x, x.x);
    line("gap", x_bar.x + n * RADIUS, x.x - n * RADIUS);
    let label = |at: Vector3<f64>, [right, down]: [f64; 2], text: &str| {
        let [x, y] = seen(&at);
        format!("<text x=\"{:.1}\" y=\"{:.1}\">{text}</text>\n", x + right, y + down)
    };
    let middle = (x.x + x_bar.x) * 0.5;
    let labels = [
        label(tangents[0], [6.0, -4.0], "t"),
        label(tangents[1], [8.0, 4.0], "t̄"),
        label(middle, [-24.0, 6.0], "d"),
        label(middle, [10.0, 6.0], "g<tspan dy=\"5\" font-size=\"13\">N</tspan>"),
        label(x.x, [-22.0, -8.0], "x"),
        label(x_bar.x, [-24.0, 20.0], "x̄"),
    ];
    let dots = [x.x, x_bar.x].map(|at| {
        let [x, y] = seen(&at);
        format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>\n")
    });
    Ok(svg + &dots.concat() + &labels.concat() + "</svg>\n")
}

/// Where a point is seen from above and from the side.
fn seen(x: &Vector3<f64>) -> [f64; 2] {
    [HALF[0] + SCALE * (x.x + 0.25 * x.y), HALF[1] - SCALE * (x.z + 0.3 * x.y)]
}
