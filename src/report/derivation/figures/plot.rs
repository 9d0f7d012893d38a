//! Curves over logarithmic axes.

use super::{path, svg, text};
use std::fmt::Write;

/// The scale of an axis.
#[derive(Clone, Copy)]
pub(in super::super) enum Axis {
    /// Numbers from 0 to this number, with a mark every this many.
    Count(f64, usize),
    /// Powers of ten, from the smaller to the larger, with a mark every this many.
    Powers(i32, i32, usize),
}

/// One curve.
pub(in super::super) struct Series {
    /// Its name.
    pub(in super::super) name: String,
    /// Its classes: colour and dashes.
    pub(in super::super) class: &'static str,
    /// Its points.
    pub(in super::super) points: Vec<(f64, f64)>,
}

/// A figure of curves.
pub(in super::super) struct Plot<'a> {
    pub(in super::super) title: &'a str,
    pub(in super::super) x: (Axis, &'a str),
    pub(in super::super) y: (Axis, &'a str),
    pub(in super::super) series: Vec<Series>,
}

const LEFT: f64 = 74.0;
const TOP: f64 = 16.0;
const WIDTH: f64 = 540.0;
const HEIGHT: f64 = 270.0;

impl Axis {
    /// The position of a number between 0 and 1. Numbers beyond the axis are at its end.
    fn place(self, x: f64) -> f64 {
        let place = match self {
            Self::Count(end, _) => x / end,
            Self::Powers(low, high, _) => (x.log10() - f64::from(low)) / f64::from(high - low),
        };
        if place.is_nan() { 0.0 } else { place.clamp(0.0, 1.0) }
    }

    /// The marks, with their labels.
    fn marks(self) -> Vec<(f64, String)> {
        match self {
            Self::Count(end, step) => {
                let counts = (0..).step_by(step).map(|i: u32| f64::from(i)).take_while(|&x| x <= end);
                counts.map(|x| (x, format!("{x}"))).collect()
            }
            Self::Powers(low, high, step) => (low..=high)
                .rev()
                .step_by(step)
                .map(|power| {
                    let words = format!(
                        "10<tspan dy=\"-5\" font-size=\"11\">{}</tspan>",
                        power.to_string().replace('-', "−")
                    );
                    (10.0_f64.powi(power), if power == 0 { "1".to_owned() } else { words })
                })
                .collect(),
        }
    }
}

impl Plot<'_> {
    /// The figure, with a legend below.
    pub(in super::super) fn draw(&self) -> String {
        let (x, y) = (self.x.0, self.y.0);
        let at = |u: f64, v: f64| [LEFT + WIDTH * x.place(u), TOP + HEIGHT * (1.0 - y.place(v))];
        let mut body = String::new();
        for (u, words) in x.marks() {
            let across = LEFT + WIDTH * x.place(u);
            body += &path("grid", [[across, TOP], [across, TOP + HEIGHT]]);
            body += &text([across, TOP + HEIGHT + 19.0], "small middle", &words);
        }
        for (v, words) in y.marks() {
            let up = TOP + HEIGHT * (1.0 - y.place(v));
            body += &path("grid", [[LEFT, up], [LEFT + WIDTH, up]]);
            body += &text([LEFT - 8.0, up + 5.0], "small end", &words);
        }
        body += &text([LEFT + WIDTH / 2.0, TOP + HEIGHT + 42.0], "small middle", self.x.1);
        let _ = writeln!(
            body,
            "<text class=\"small middle\" transform=\"translate(16 {:.1}) rotate(-90)\">{}</text>",
            TOP + HEIGHT / 2.0,
            self.y.1
        );
        let mut legend = TOP + HEIGHT + 66.0;
        for series in &self.series {
            let points: Vec<[f64; 2]> = series.points.iter().map(|&(u, v)| at(u, v)).collect();
            body += &path(&format!("curve {}", series.class), points.clone());
            if points.len() <= 60 && points.len() > 2 {
                for [u, v] in points {
                    let _ = write!(
                        body,
                        "<circle class=\"{}\" cx=\"{u:.1}\" cy=\"{v:.1}\" r=\"2.6\"/>",
                        series.class
                    );
                }
                body.push('\n');
            }
            body += &path(
                &format!("curve {}", series.class),
                [[LEFT, legend - 5.0], [LEFT + 44.0, legend - 5.0]],
            );
            body += &text([LEFT + 54.0, legend], "small", &series.name);
            legend += 22.0;
        }
        svg(LEFT + WIDTH + 20.0, legend - 6.0, self.title, &body)
    }
}
