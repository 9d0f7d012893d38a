//! Pictures of pairs of beams.

use super::{arrow, dot, path, svg, text};
use crate::closest_point::{Held, ProjectionError};
use crate::curve::{Curve, Geometry, Hermite};
use crate::equations::StandardCase;
use crate::pair::DofVector;
use crate::teaching::{Problem, Tangent};
use nalgebra::{SVector, Vector3};

type Dofs = DofVector<f64, 12, 12>;

/// The number of segments of a drawn curve.
const PIECES: u32 = 40;

/// The projections of a point from above and from the side.
#[derive(Clone, Copy)]
struct View {
    centre: [f64; 2],
    scale: f64,
}

impl View {
    fn at(self, x: &Vector3<f64>) -> [f64; 2] {
        let Self { centre: [u, v], scale } = self;
        [u + scale * (x.x + 0.25 * x.y), v - scale * (x.z + 0.3 * x.y)]
    }

    fn curve(self, q: &SVector<f64, 12>) -> Vec<[f64; 2]> {
        (0..=PIECES).map(|i| self.at(&geometry(q, -1.0 + 2.0 * f64::from(i) / f64::from(PIECES)).x)).collect()
    }
}

fn geometry(q: &SVector<f64, 12>, xi: f64) -> Geometry<f64> {
    Hermite::new().jet(q, xi).geometry
}

/// The standard case with d, both tangents and the gap, and the same pair after a step along delta, dashed.
pub(in super::super) fn varied_pair(step: f64) -> Result<String, ProjectionError> {
    let case = StandardCase::default();
    let point = case.closest_point()?;
    let view = View { centre: [310.0, 190.0], scale: 185.0 };
    let moved = case.moved(step, 0.0);
    let other = case.pair.refine(&moved, (point.xi, point.xi_bar), Held::default())?;
    let (x, y) = (geometry(&case.q.beam, point.xi), geometry(&case.q.bar, point.xi_bar));
    let (x2, y2) = (geometry(&moved.beam, other.xi), geometry(&moved.bar, other.xi_bar));
    let radius = case.pair.contact.radius;
    let n = (x.x - y.x).normalize();
    let (t, t_bar) = (x.x + x.t * (0.45 / x.t.norm()), y.x + y.t * (0.45 / y.t.norm()));
    let wide = |class: &str, q: &SVector<f64, 12>| {
        format!(
            "<g style=\"stroke-width:{:.1}\">{}</g>",
            2.0 * radius * view.scale,
            path(class, view.curve(q))
        )
    };
    let mut body = wide("tube r", &case.q.bar) + &path("axis r", view.curve(&case.q.bar));
    body += &path("dashed r", view.curve(&moved.bar));
    body += &(wide("tube b", &case.q.beam) + &path("axis b", view.curve(&case.q.beam)));
    body += &path("dashed b", view.curve(&moved.beam));
    body += &path("dashed d", [view.at(&x2.x), view.at(&y2.x)]);
    body +=
        &path("gap", [y.x + n * radius, x.x - n * radius].map(|x| view.at(&x)).map(|[u, v]| [u + 14.0, v]));
    body += &arrow("b", view.at(&x.x), view.at(&t));
    body += &arrow("r", view.at(&y.x), view.at(&t_bar));
    body += &arrow("d", view.at(&y.x), view.at(&x.x));
    body += &(dot("b", view.at(&x.x)) + &dot("r", view.at(&y.x)));
    body += &(dot("b hollow", view.at(&x2.x)) + &dot("r hollow", view.at(&y2.x)));
    let label = |at: &Vector3<f64>, [right, down]: [f64; 2], class: &str, words: &str| {
        let [u, v] = view.at(at);
        text([u + right, v + down], &format!("letter {class}"), words)
    };
    body += &label(&t, [-14.0, 24.0], "b", "t");
    body += &label(&t_bar, [-18.0, -14.0], "r", "t̄");
    body += &label(&((x.x + y.x) * 0.5), [-38.0, 14.0], "d", "d");
    body += &label(&((x.x + y.x) * 0.5), [24.0, 14.0], "g", "g<tspan dy=\"5\" font-size=\"13\">N</tspan>");
    body += &label(&x.x, [6.0, -26.0], "b", "x<tspan dy=\"5\" font-size=\"13\">C</tspan>");
    body += &label(&y.x, [2.0, 40.0], "r", "x̄<tspan dy=\"5\" font-size=\"13\">C̄</tspan>");
    let title = "Two beams with the distance vector d, the tangents t and t bar and the gap at their closest points, \
                 and the same beams varied, dashed";
    Ok(svg(640.0, 380.0, title, &body))
}

/// The two elastic beams of the example, straight and in equilibrium.
pub(in super::super) fn before_and_after() -> String {
    let problem = Problem::default();
    let equilibrium = problem.solve(Tangent::Exact).q;
    let panel = |q: &Dofs, left: f64, title: &str| {
        let view = View { centre: [left + 160.0, 190.0], scale: 105.0 };
        let wide = |class: &str, q: &SVector<f64, 12>, radius: f64| {
            let tube = path(class, view.curve(q));
            format!("<g style=\"stroke-width:{:.1}\">{tube}</g>", 2.0 * radius * view.scale)
        };
        let [radius, radius_bar] = problem.beams.each_ref().map(|beam| beam.material.radius);
        let clamp = |q: &SVector<f64, 12>| {
            let [u, v] = view.at(&geometry(q, -1.0).x);
            format!(
                "<rect class=\"clamp\" x=\"{:.1}\" y=\"{:.1}\" width=\"9\" height=\"18\"/>\n",
                u - 4.5,
                v - 9.0
            )
        };
        // The bar beam lies above the beam.
        wide("tube b", &q.beam, radius)
            + &path("axis b", view.curve(&q.beam))
            + &clamp(&q.beam)
            + &wide("tube r", &q.bar, radius_bar)
            + &path("axis r", view.curve(&q.bar))
            + &clamp(&q.bar)
            + &text([left + 20.0, 24.0], "small", title)
    };
    let body = panel(&problem.start(), 0.0, "straight, just in touch")
        + &panel(&equilibrium, 330.0, "in equilibrium");
    svg(660.0, 330.0, "The two beams of the example, straight and in equilibrium", &body)
}
