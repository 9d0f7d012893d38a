//! The pictures of the beam problems: convergence of Newton's method, and deformed beams.

use super::beam_problems::{BeamProblem, BeamProblems, NOTHING, Shape};
use super::chart::{Anchor, Axis, Chart, INK, Mark, Place, WIDTH, apart, errors};

const LEFT: f64 = 60.0;
const TOP: f64 = 56.0;
/// The right end of the curves; their names follow.
const RIGHT: f64 = 190.0;
const BOTTOM: f64 = 330.0;
/// The iterations that are drawn.
const ITERATIONS: usize = 20;

impl BeamProblems {
    /// The pictures, by file name.
    pub fn pictures(&self) -> Vec<(String, String)> {
        let compared = self.problems.iter().filter(|problem| !problem.convergence.is_empty());
        compared
            .flat_map(|problem| {
                let file = |what: &str| format!("beam-problems-{}-{what}.svg", file_name(&problem.name));
                [(file("newton"), problem.newton_to_svg()), (file("beams"), problem.beams_to_svg())]
            })
            .collect()
    }
}

/// The first word of a name, in small letters.
pub(super) fn file_name(name: &str) -> String {
    name.split(' ').next().unwrap_or(name).to_lowercase()
}

impl BeamProblem {
    /// The length of the residual over the iterations of one step, with each tangent.
    pub fn newton_to_svg(&self) -> String {
        let step = self.convergence.first().map_or(0, |of| of.step);
        let mut chart = Chart::new(&format!("Step {step}: left out of the tangent"), BOTTOM + 46.0);
        let norms = self.convergence.iter().flat_map(|of| of.residuals.iter().copied().take(ITERATIONS));
        let y = errors(Axis::decades(norms), [BOTTOM, TOP], "length of the residual, a force", 12);
        let most = self.convergence.iter().map(|of| of.residuals.len().min(ITERATIONS)).max().unwrap_or(1);
        let across =
            |i: usize| LEFT + (RIGHT - LEFT) * super::number::number(i) / super::number::number(most);
        for (value, label) in y.ticks() {
            let at = y.at(value);
            chart.line([LEFT, at], [RIGHT, at], "grid");
            chart.text([LEFT - 6.0, at + 4.0], Anchor::End, INK, &label);
        }
        for i in (0..=most).step_by(5) {
            chart.text([across(i), BOTTOM + 16.0], Anchor::Middle, INK, &i.to_string());
        }
        chart.line([LEFT, BOTTOM], [RIGHT, BOTTOM], "");
        chart.line([LEFT, TOP], [LEFT, BOTTOM], "");
        chart.text([RIGHT, BOTTOM + 34.0], Anchor::End, INK, "iteration");
        chart.text([8.0, TOP - 10.0], Anchor::Start, INK, y.name);
        let curves: Vec<Vec<Place>> = self
            .convergence
            .iter()
            .map(|of| {
                let drawn = of.residuals.iter().take(ITERATIONS).enumerate();
                drawn.map(|(i, &norm)| [across(i + 1), y.at(norm)]).collect()
            })
            .collect();
        let ends: Vec<f64> = curves.iter().map(|curve| curve.last().map_or(BOTTOM, |end| end[1])).collect();
        let heights = apart(&ends, 17.0, [TOP, BOTTOM]);
        for (i, ((of, curve), height)) in self.convergence.iter().zip(&curves).zip(heights).enumerate() {
            let colour = i % INK;
            let line = if of.left_out == NOTHING {
                "thick"
            } else if i > INK {
                "dashed"
            } else {
                ""
            };
            chart.curve(curve, &format!("s{colour} {line}"));
            if let Some(&end) = curve.last() {
                chart.mark(end, Mark::Dot, colour);
                chart.line(end, [RIGHT + 10.0, height], "grid");
            }
            chart.text([RIGHT + 14.0, height + 4.0], Anchor::Start, colour, &of.left_out);
        }
        chart.svg()
    }

    /// Both beams in the drawn states: the last one with thick lines.
    pub fn beams_to_svg(&self) -> String {
        let all = || self.shapes.iter().flat_map(|shape| shape.beams.iter().flatten()).map(seen);
        let range = |i: usize| {
            all().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x[i]), high.max(x[i])])
        };
        let [[left, right], [low, high]] = [range(0), range(1)];
        let scale = (WIDTH - 40.0) / (right - left);
        let height = TOP + scale * (high - low);
        let place = |x: &[f64; 3]| -> Place {
            let [u, v] = seen(x);
            [20.0 + scale * (u - left), height - scale * (v - low)]
        };
        let steps: Vec<String> = self.shapes.iter().map(|shape| shape.step.to_string()).collect();
        let title = format!("{}, after steps {}", self.name, steps.join(", "));
        let mut chart = Chart::new(&title, height + 24.0);
        for (i, Shape { beams, .. }) in self.shapes.iter().enumerate() {
            let line = if i + 1 == self.shapes.len() { "thick" } else { "dashed" };
            let order = if self.beam_is_above { [1, 0] } else { [0, 1] };
            for k in order {
                let places: Vec<Place> = beams[k].iter().map(place).collect();
                chart.curve(&places, &format!("s{k} {line}"));
            }
        }
        if let Some([Some(start), Some(end)]) =
            self.shapes.last().map(|Shape { beams: [beam, bar], .. }| [beam.first(), bar.last()])
        {
            let ([x, y], [u, v]) = (place(start), place(end));
            chart.text([x, y + 16.0], Anchor::Start, 0, "beam");
            chart.text([u, v - 8.0], Anchor::End, 1, "bar beam");
        }
        chart.svg()
    }
}

/// A point seen from the side and from above.
fn seen(&[x, y, z]: &[f64; 3]) -> [f64; 2] {
    [x + 0.35 * y, z + 0.25 * y]
}
