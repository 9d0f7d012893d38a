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
/// The number of frames of the motion, and its time in seconds.
const FRAMES: u32 = 16;
const PERIOD: u32 = 9;
/// The motion of the bar beam: of its points and tangents.
const MOTION: [f64; 12] = [0.45, 0.0, 0.0, 0.0, 0.0, 0.0, -0.15, 0.0, 0.05, 0.0, 0.0, 0.15];
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

/// Two Hermite beams with d, t, t_bar and g_N at their closest points, as SVG. The bar beam moves to and fro, unless the reader
/// prefers reduced motion.
///
/// # Errors
/// None, as long as the beams of the picture have one closest point inside both.
pub fn picture() -> Result<String, ProjectionError> {
    let phase = |k: u32| (std::f64::consts::TAU * f64::from(k) / f64::from(FRAMES)).sin();
    let frames = (0..=FRAMES).map(|k| frame(phase(k))).collect::<Result<Vec<_>, _>>()?;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" class=\"pair\">\n\
         <title>Two beams with the distance d, the tangents t and t_bar and the gap g_N at their closest points</title>\n\
         {STYLE}<style>@media(prefers-reduced-motion:no-preference){{{}}}</style>{}\n",
        2.0 * HALF[0],
        2.0 * HALF[1],
        animations(&frames),
        ["b", "r", "d"].map(arrow).concat()
    );
    for (i, Part { class, shape, .. }) in frames[0].iter().enumerate() {
        let class = format!("{class} m{i}");
        let _ = match shape {
            Shape::Path(d, more) => writeln!(svg, "<path class=\"{class}\"{more} d=\"{d}\"/>"),
            Shape::Dot([x, y]) => {
                writeln!(svg, "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>")
            }
            Shape::Label([x, y], text) => {
                writeln!(svg, "<text class=\"{class}\" transform=\"translate({x:.1} {y:.1})\">{text}</text>")
            }
        };
    }
    Ok(svg + "</svg>\n")
}

/// The rules that move the parts that are not the same in all frames.
fn animations(frames: &[Vec<Part>]) -> String {
    let mut rules = String::new();
    for (i, first) in frames[0].iter().enumerate() {
        if frames.iter().all(|frame| frame[i].shape == first.shape) {
            continue;
        }
        let _ = write!(rules, ".m{i}{{animation:m{i} {PERIOD}s linear infinite}}@keyframes m{i}{{");
        for (frame, k) in frames.iter().zip(0_u32..) {
            let percent = 100.0 * f64::from(k) / f64::from(FRAMES);
            let _ = write!(rules, "{percent:.2}%{{{}}}", frame[i].shape.declaration());
        }
        rules.push('}');
    }
    rules
}

/// A part of the picture.
struct Part {
    class: String,
    shape: Shape,
}

#[derive(PartialEq)]
enum Shape {
    /// A path, with more attributes.
    Path(String, String),
    Dot([f64; 2]),
    Label([f64; 2], &'static str),
}

impl Shape {
    /// Its place as a declaration of CSS.
    fn declaration(&self) -> String {
        match self {
            Self::Path(d, _) => format!("d:path(\"{d}\")"),
            Self::Dot([x, y]) => format!("cx:{x:.1}px;cy:{y:.1}px"),
            Self::Label([x, y], _) => format!("transform:translate({x:.1}px,{y:.1}px)"),
        }
    }
}

/// All parts of the picture, with the bar beam moved by a share of its motion.
fn frame(share: f64) -> Result<Vec<Part>, ProjectionError> {
    let case = StandardCase::default();
    let mut q = case.q;
    q.bar += SVector::from(MOTION) * share;
    let moved = StandardCase { q, ..case };
    let point = moved.closest_point()?;
    let DofVector { beam, bar } = q;
    let at = |q: &SVector<f64, 12>, xi: f64| Hermite::new().jet(q, xi).geometry;
    let (x, x_bar) = (at(&beam, point.xi), at(&bar, point.xi_bar));
    let n = (x.x - x_bar.x).normalize();
    let mut parts = Vec::new();
    let mut add = |class: &str, shape: Shape| parts.push(Part { class: class.to_owned(), shape });
    for (q, class) in [(&bar, "r"), (&beam, "b")] {
        let width = format!(" stroke-width=\"{:.1}\"", 2.0 * RADIUS * SCALE);
        add(&format!("tube {class}"), Shape::Path(curve(q), width));
        add(&format!("axis {class}"), Shape::Path(curve(q), String::new()));
    }
    let line = |from: Vector3<f64>, to: Vector3<f64>| {
        let ([x, y], [u, v]) = (seen(&from), seen(&to));
        format!("M{x:.1} {y:.1}L{u:.1} {v:.1}")
    };
    let tangents = [x, x_bar].map(|x| x.x + x.t * (0.45 / x.t.norm()));
    for (colour, from, to) in [("b", x.x, tangents[0]), ("r", x_bar.x, tangents[1]), ("d", x_bar.x, x.x)] {
        let head = format!(" marker-end=\"url(#arrow-{colour})\"");
        add(&format!("vector {colour}"), Shape::Path(line(from, to), head));
    }
    // Beside d, so that both are visible.
    let aside = Vector3::new(14.0 / SCALE, 0.0, 0.0);
    let gap = line(x_bar.x + n * RADIUS + aside, x.x - n * RADIUS + aside);
    add("gap g", Shape::Path(gap, String::new()));
    add("b", Shape::Dot(seen(&x.x)));
    add("r", Shape::Dot(seen(&x_bar.x)));
    let middle = (x.x + x_bar.x) * 0.5;
    for (at, [right, down], class, text) in [
        (tangents[0], [6.0, -4.0], "b", "t"),
        (tangents[1], [-8.0, -14.0], "r", "t̄"),
        (middle, [-24.0, 6.0], "d", "d"),
        (middle, [22.0, 6.0], "g", "g<tspan dy=\"5\" font-size=\"13\">N</tspan>"),
        (x.x, [-22.0, -8.0], "b", "x"),
        (x_bar.x, [-24.0, 20.0], "r", "x̄"),
    ] {
        let [x, y] = seen(&at);
        add(class, Shape::Label([x + right, y + down], text));
    }
    Ok(parts)
}

/// A Hermite beam as a cubic Bezier curve.
fn curve(q: &SVector<f64, 12>) -> String {
    let node = |i: usize| q.fixed_rows::<3>(3 * i).into_owned();
    let (first, last) = (node(0), node(2));
    // xi runs over an interval of length 2.
    let inner = [first + node(1) * (2.0 / 3.0), last - node(3) * (2.0 / 3.0)];
    let [[a, b], [c, d], [e, f], [g, h]] = [first, inner[0], inner[1], last].map(|x| seen(&x));
    format!("M{a:.1} {b:.1}C{c:.1} {d:.1} {e:.1} {f:.1} {g:.1} {h:.1}")
}

/// The projections of a point from above and from the side.
fn seen(x: &Vector3<f64>) -> [f64; 2] {
    [HALF[0] + SCALE * (x.x + 0.25 * x.y), HALF[1] - SCALE * (x.z + 0.3 * x.y)]
}

#[cfg(test)]
mod tests {
    use super::{FRAMES, Shape, animations, frame, picture};

    #[test]
    fn the_picture_moves_and_begins_with_the_standard_case() {
        let frames: Vec<_> = (0..=FRAMES).map(|k| frame(f64::from(k) / f64::from(FRAMES)).unwrap()).collect();
        let rules = animations(&frames);
        // The beam alone rests: its tube and its axis.
        let rest = frames[0].iter().zip(&frames[8]).filter(|(one, other)| one.shape == other.shape);
        assert!(rest.map(|(one, _)| &*one.class).eq(["tube b", "axis b"]));
        let moving = frames[0].len() - 2;
        assert_eq!(rules.matches("@keyframes").count(), moving);
        assert_eq!(rules.matches("%{").count(), moving * (usize::try_from(FRAMES).unwrap() + 1));
        let svg = picture().unwrap();
        assert!(svg.contains("prefers-reduced-motion:no-preference"));
        for part in frame(0.0).unwrap() {
            if let Shape::Path(d, _) = part.shape {
                assert!(svg.contains(&format!(" d=\"{d}\"")), "{d}");
            }
        }
    }
}
