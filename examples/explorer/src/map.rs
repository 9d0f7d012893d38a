//! The square of both parameters as a map: xi to the right, xi_bar upwards.

use crate::frame::push_line;
use beamgap::closest_point::{Centroid, SquaredDistance};

const LEFT: f64 = 40.0;
const TOP: f64 = 12.0;
const SIDE: f64 = 300.0;
/// Cells of the grid in each direction.
const CELLS: usize = 20;
/// The number of shades.
const SHADES: f64 = 15.0;

/// Where a pair of parameters is drawn.
pub(crate) fn at([xi, xi_bar]: [f64; 2]) -> [f64; 2] {
    [LEFT + 0.5 * SIDE * (xi + 1.0), TOP + 0.5 * SIDE * (1.0 - xi_bar)]
}

/// The pair of parameters nearest to a place.
pub(crate) fn from([x, y]: [f64; 2]) -> [f64; 2] {
    [2.0 * (x - LEFT) / SIDE - 1.0, 1.0 - 2.0 * (y - TOP) / SIDE].map(|xi| xi.clamp(-1.0, 1.0))
}

fn parameter(i: usize) -> f64 {
    let [i, cells] = [i, CELLS].map(|n| f64::from(u16::try_from(n).unwrap_or(u16::MAX)));
    2.0 * i / cells - 1.0
}

/// A function of both parameters on a grid.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    /// Rows of equal xi_bar, from below.
    values: Vec<f64>,
}

impl Grid {
    /// Several functions of the two points on the same grid.
    pub(crate) fn of<const K: usize>(
        [beam, bar]: [&dyn Centroid; 2],
        functions: [fn(&SquaredDistance) -> f64; K],
    ) -> [Self; K] {
        let rows: Vec<_> = (0..=CELLS).map(|j| bar.geometry(parameter(j))).collect();
        let columns: Vec<_> = (0..=CELLS).map(|i| beam.geometry(parameter(i))).collect();
        let mut grids = functions.map(|_| Self { values: Vec::with_capacity((CELLS + 1).pow(2)) });
        for y in &rows {
            for x in &columns {
                let at = SquaredDistance::new(x, y);
                for (grid, function) in grids.iter_mut().zip(functions) {
                    grid.values.push(function(&at));
                }
            }
        }
        grids
    }

    /// The smallest and the largest value.
    pub(crate) fn range(&self) -> [f64; 2] {
        let fold = |pick: fn(f64, f64) -> f64, from| self.values.iter().copied().fold(from, pick);
        [fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY)]
    }

    /// The lines where the function has these values, which ascend.
    pub(crate) fn contours(&self, levels: &[f64]) -> String {
        let mut data = String::new();
        let width = CELLS + 1;
        // The number of levels up to each value. A line crosses few cells, and these numbers are compared fast.
        let up_to = |value: &f64| levels.iter().take_while(|&level| level <= value).count();
        let counts: Vec<usize> = self.values.iter().map(up_to).collect();
        for j in 0..CELLS {
            for i in 0..CELLS {
                let places = [j * width + i, j * width + i + 1, (j + 1) * width + i + 1, (j + 1) * width + i];
                let [p, q, r, s] = places.map(|place| counts[place]);
                let (low, high) = (p.min(q).min(r.min(s)), p.max(q).max(r.max(s)));
                if low == high {
                    continue;
                }
                let corner =
                    |place: usize, i: usize, j: usize| (self.values[place], [parameter(i), parameter(j)]);
                let corners = [
                    corner(places[0], i, j),
                    corner(places[1], i + 1, j),
                    corner(places[2], i + 1, j + 1),
                    corner(places[3], i, j + 1),
                ];
                for &level in &levels[low..high] {
                    segments(&corners, level, &mut data);
                }
            }
        }
        data
    }

    /// A letter for each point, row by row from above: `a` for the largest value, `p` for the smallest.
    pub(crate) fn shades(&self) -> String {
        let [low, high] = self.range();
        let scale = SHADES / (high - low).max(1e-12);
        let letter = |&value: &f64| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 15")]
            let shade = ((high - value) * scale).clamp(0.0, SHADES).round() as u8;
            char::from(b'a' + shade)
        };
        self.values.chunks(CELLS + 1).rev().flatten().map(letter).collect()
    }
}

/// The pieces of a line of equal value in one cell: between crossed edges, two at a time.
fn segments(corners: &[(f64, [f64; 2]); 4], level: f64, data: &mut String) {
    let mut crossings = [[0.0; 2]; 4];
    let mut count = 0;
    for edge in 0..4 {
        let ((u, p), (v, q)) = (corners[edge], corners[(edge + 1) % 4]);
        if (u < level) != (v < level) {
            let s = (level - u) / (v - u);
            crossings[count] = at([p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])]);
            count += 1;
        }
    }
    for pair in crossings[..count].chunks_exact(2) {
        push_line(data, [pair[0], pair[1]]);
    }
}
