//! Places for the letters of the picture, at which they cover neither each other nor the lines.

use crate::view::{HEIGHT, WIDTH};

/// Half the width of a letter with its margin.
const SIZE: f64 = 15.0;
/// The distances of a letter from what it belongs to.
const AWAY: [f64; 3] = [20.0, 36.0, 52.0];
/// The tried directions.
const DIRECTIONS: u8 = 16;

/// A letter: what it belongs to, and the direction in which it stands if nothing is there.
#[derive(Clone, Copy, Debug)]
pub struct Label {
    /// The letter.
    pub name: &'static str,
    /// The place of what it belongs to, in pixels.
    pub at: [f64; 2],
    /// The direction.
    pub towards: [f64; 2],
}

/// The places of all letters, one after the other. Lines have a weight.
pub fn placed(labels: &[Label], lines: &[([[f64; 2]; 2], f64)]) -> Vec<[f64; 2]> {
    let mut places: Vec<[f64; 2]> = Vec::new();
    for label in labels {
        // Only lines near the label can be covered by it.
        let reach = AWAY[AWAY.len() - 1] + SIZE;
        let lines: Vec<_> = lines.iter().filter(|(line, _)| distance(label.at, *line) < reach).collect();
        let norm = (label.towards[0].powi(2) + label.towards[1].powi(2)).sqrt().max(1e-9);
        let cost = |place: &[f64; 2], away: f64, turn: f64| {
            let from_lines: f64 =
                lines.iter().map(|(line, weight)| weight * near(distance(*place, *line), SIZE)).sum();
            let from_letters: f64 =
                places.iter().map(|other| 4.0 * near(distance(*place, [*other, *other]), 2.0 * SIZE)).sum();
            let outside = [place[0], WIDTH - place[0], place[1], HEIGHT - place[1]].map(|x| near(x, SIZE));
            from_lines + from_letters + 4.0 * outside.iter().sum::<f64>() + 0.01 * away + 0.3 * (1.0 - turn)
        };
        let mut best = (f64::INFINITY, label.at);
        for away in AWAY {
            for i in 0..DIRECTIONS {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(DIRECTIONS)).sin_cos();
                let place = [label.at[0] + away * cos, label.at[1] + away * sin];
                let turn = (cos * label.towards[0] + sin * label.towards[1]) / norm;
                let cost = cost(&place, away, turn);
                if cost < best.0 {
                    best = (cost, place);
                }
            }
        }
        places.push(best.1);
    }
    places
}

/// How much nearer than `size` something is, from 0 to 1 and more.
fn near(distance: f64, size: f64) -> f64 {
    ((size - distance) / size).max(0.0)
}

fn distance([x, y]: [f64; 2], [[x0, y0], [x1, y1]]: [[f64; 2]; 2]) -> f64 {
    let (dx, dy) = (x1 - x0, y1 - y0);
    let square = dx * dx + dy * dy;
    let along = if square > 0.0 { (((x - x0) * dx + (y - y0) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    let (u, v) = (x - x0 - along * dx, y - y0 - along * dy);
    (u * u + v * v).sqrt()
}
