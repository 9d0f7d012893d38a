//! The errors of both predictions against the step, with logarithmic axes.

use crate::draw::{path, text};
use crate::prediction::Prediction;
use std::fmt::Write;

const LEFT: f64 = 66.0;
const TOP: f64 = 12.0;
const WIDTH: f64 = 470.0;
const HEIGHT: f64 = 270.0;
/// The powers of ten of the step and of the error.
const STEPS: [i32; 2] = [-5, 0];
const ERRORS: [i32; 2] = [-17, 1];

/// The position of a number between two powers of ten, from 0 to 1.
fn place(x: f64, [low, high]: [i32; 2]) -> f64 {
    let place = (x.log10() - f64::from(low)) / f64::from(high - low);
    if place.is_nan() { 0.0 } else { place.clamp(0.0, 1.0) }
}

fn power(power: i32) -> String {
    match power {
        0 => "1".to_owned(),
        _ => format!("10<tspan dy=\"-5\" font-size=\"11\">{}</tspan>", power.to_string().replace('-', "−")),
    }
}

/// The figure.
pub(crate) fn plot(prediction: &Prediction, direction: &str) -> String {
    let at = |step: f64, error: f64| {
        [LEFT + WIDTH * place(step, STEPS), TOP + HEIGHT * (1.0 - place(error, ERRORS))]
    };
    let mut body = String::new();
    for i in STEPS[0]..=STEPS[1] {
        let x = LEFT + WIDTH * place(10.0_f64.powi(i), STEPS);
        body += &path("grid", [[x, TOP], [x, TOP + HEIGHT]]);
        body += &text("small middle", [x, TOP + HEIGHT + 19.0], &power(i));
    }
    for i in (ERRORS[0]..=ERRORS[1]).rev().step_by(3) {
        let y = TOP + HEIGHT * (1.0 - place(10.0_f64.powi(i), ERRORS));
        body += &path("grid", [[LEFT, y], [LEFT + WIDTH, y]]);
        body += &text("small end", [LEFT - 8.0, y + 5.0], &power(i));
    }
    body +=
        &text("small middle", [LEFT + WIDTH / 2.0, TOP + HEIGHT + 42.0], &format!("step along {direction}"));
    let _ = writeln!(
        body,
        "<text class=\"small middle\" transform=\"translate(16 {:.1}) rotate(-90)\">error of the predicted gap</text>",
        TOP + HEIGHT / 2.0
    );
    let mut legend = TOP + HEIGHT + 66.0;
    for (order, name, class) in [(0, "first order", "d dots"), (1, "second order", "black solid")] {
        let points: Vec<_> =
            prediction.samples.iter().map(|sample| at(sample.step, sample.errors()[order])).collect();
        body += &path(&format!("curve {class}"), points.iter().copied());
        for [x, y] in points {
            let _ = write!(body, "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.6\"/>");
        }
        if let Some(sample) = &prediction.here {
            let [x, y] = at(sample.step, sample.errors()[order]);
            let _ = write!(body, "<circle class=\"{class} hollow\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"6\"/>");
        }
        let rate = prediction.rate(order);
        let rate = rate.map_or_else(|| "rounding only".to_owned(), |rate| format!("slope {rate:.2}"));
        body += &path(&format!("curve {class}"), [[LEFT, legend - 5.0], [LEFT + 44.0, legend - 5.0]]);
        body += &text("small", [LEFT + 54.0, legend], &format!("{name}: {rate}; should be {}", order + 2));
        legend += 22.0;
    }
    format!(
        "<svg viewBox=\"0 0 {} {}\" style=\"max-width:{}px\" role=\"img\" aria-label=\"Errors of the first-order and the \
         second-order prediction of the gap over the step\">\n{body}</svg>\n",
        LEFT + WIDTH + 20.0,
        legend - 6.0,
        LEFT + WIDTH + 20.0
    )
}
