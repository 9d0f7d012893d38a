//! The loss of accuracy of each formulation: median errors over the distance and over the angle.

use crate::check::{Errors, Level};
use crate::report::Accuracy;
use crate::report::chart::{Anchor, Axis, Chart, Place, WIDTH, errors};

const LEFT: f64 = 52.0;
const RIGHT: f64 = WIDTH - 14.0;
const TOP: f64 = 56.0;
const BOTTOM: f64 = 340.0;
/// The paper's formulation, the robust one, and the one that the library chooses, with their lines.
const LINES: [(usize, &str); 3] = [(1, "thick s1"), (0, "thick s0"), (2, "thick dashed s2")];

impl Accuracy {
    /// The errors of Delta-delta d over the distance. The same record always gives the same picture.
    pub fn gap_to_svg(&self) -> String {
        let names = ["paper: divides by d", "robust: along the normal", "chosen by the library"];
        picture(
            "Second variation of d over the distance",
            "d/L: distance / length of a beam",
            names,
            &self.found.gaps,
            |row| row.d,
        )
    }

    /// The errors of Delta-delta xi over the angle. The same record always gives the same picture.
    pub fn angle_to_svg(&self) -> String {
        let names = ["paper: determinants", "robust: cross products", "chosen by the library"];
        let title = "Second variation of xi over the angle, straight beams";
        picture(title, "angle between the beams in rad", names, &self.found.angles, |row| row.xi)
    }
}

fn picture(title: &str, across: &str, names: [&str; 3], rows: &[Level], of: fn(&Level) -> Errors) -> String {
    let parts = |row: &Level| {
        let Errors { paper, robust, chosen } = of(row);
        [paper, robust, chosen]
    };
    let x = errors(Axis::decades(rows.iter().map(|row| row.at)), [LEFT, RIGHT], across, 7);
    let range = Axis::decades(rows.iter().flat_map(parts).flatten());
    let y = errors(range, [BOTTOM, TOP], "median relative error", 9);
    let mut chart = Chart::new(title, BOTTOM + 46.0);
    chart.frame(&x, &y);
    let mut curves: Vec<Vec<Place>> = Vec::new();
    for (k, (_, class)) in LINES.iter().enumerate() {
        let place =
            |row: &Level| parts(row)[k].filter(|error| *error > 0.0).map(|error| [x.at(row.at), y.at(error)]);
        let mut places: Vec<Place> = rows.iter().filter_map(place).collect();
        places.sort_by(|a, b| a[0].total_cmp(&b[0]));
        if !places.is_empty() {
            chart.curve(&places, class);
        }
        curves.push(places);
    }
    // Each label is above its curve, on the left, where the curves are far apart. The choice follows one of the others.
    for ((places, above), (name, (colour, _))) in
        curves.iter().zip([8.0, 25.0, 8.0]).zip(names.iter().zip(LINES))
    {
        let Some([left, height]) = places.get(places.len() / 8) else { continue };
        chart.text([left + 6.0, height - above], Anchor::Start, colour, name);
    }
    chart.svg()
}
