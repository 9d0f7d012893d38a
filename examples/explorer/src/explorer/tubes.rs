//! The beams as shaded tubes. Where a beam passes in front of another, or of itself, it is drawn in a later layer.

use super::BEAMS;
use crate::frame::{Frame, push_line};
use crate::view::View;
use beamgap::closest_point::Centroid;
use beamgap::nalgebra::Vector3;

/// The pieces of a drawn beam.
const PIECES: usize = 32;
/// The number of layers on the page.
const LAYERS: usize = 3;
/// The part of the next piece that a piece in front covers, so that no seam is visible.
const OVERLAP: f64 = 0.3;
/// The width of the gap around a beam in front.
const HALO: f64 = 6.0;
/// The points of a drawn end.
const ROUND: u8 = 20;

/// A piece between two drawn points.
struct Piece {
    beam: usize,
    number: usize,
    middle: Vector3<f64>,
    at: [f64; 2],
    half_length: f64,
    depth: f64,
    layer: usize,
}

/// Draws both beams, layer by layer.
pub(super) fn draw(frame: &mut Frame, view: &View, centroids: [&dyn Centroid; 2], radii: [f64; 2]) {
    let points = centroids.map(|centroid| {
        let parameter = |i: usize| 2.0 * of(i) / of(PIECES) - 1.0;
        (0..=PIECES).map(|i| centroid.geometry(parameter(i)).x).collect::<Vec<_>>()
    });
    // A beam without thickness is drawn as a line.
    let widths = radii.map(|radius| (2.0 * radius.abs() * view.scale).clamp(2.0, 400.0));
    let layers = layers(view, &points, radii, widths);
    for (beam, name) in BEAMS.into_iter().enumerate() {
        frame.widths.insert(name.into(), (widths[beam] * 10.0).round() / 10.0);
        let drawn: Vec<[f64; 2]> = points[beam].iter().map(|x| view.at(x)).collect();
        for layer in 0..LAYERS {
            let mut data = String::new();
            for run in runs(&layers[beam], layer) {
                push_line(&mut data, extended(&drawn, run));
            }
            frame.paths.insert(format!("tube{layer}{name}").into(), data);
            frame.no_path(format!("cap{layer}{name}"));
        }
        for (end, piece) in [(-1.0, 0), (1.0, PIECES - 1)] {
            let layer = layers[beam][piece];
            if let Some(round) = cap(view, centroids[beam], end, radii[beam]) {
                let both = frame.paths.entry(format!("cap{layer}{name}").into()).or_default();
                push_line(both, round);
            }
        }
    }
}

fn of(i: usize) -> f64 {
    f64::from(u16::try_from(i).unwrap_or(u16::MAX))
}

/// The layer of each piece of both beams: one more than that of all pieces which it covers.
fn layers(
    view: &View,
    points: &[Vec<Vector3<f64>>; 2],
    radii: [f64; 2],
    widths: [f64; 2],
) -> [Vec<usize>; 2] {
    let mut pieces: Vec<Piece> = Vec::with_capacity(2 * PIECES);
    for (beam, points) in points.iter().enumerate() {
        for (number, ends) in points.windows(2).enumerate() {
            let middle = (ends[0] + ends[1]) * 0.5;
            let [from, to] = [ends[0], ends[1]].map(|x| view.at(&x));
            let half_length = 0.5 * length([to[0] - from[0], to[1] - from[1]]);
            let depth = view.depth(&middle);
            pieces.push(Piece { beam, number, middle, at: view.at(&middle), half_length, depth, layer: 0 });
        }
    }
    pieces.sort_by(|one, other| other.depth.total_cmp(&one.depth));
    for i in 1..pieces.len() {
        let (behind, rest) = pieces.split_at_mut(i);
        let piece = &mut rest[0];
        for other in behind {
            let reach = 0.5 * (widths[piece.beam] + widths[other.beam])
                + HALO
                + piece.half_length
                + other.half_length;
            let away = length([piece.at[0] - other.at[0], piece.at[1] - other.at[1]]);
            // A beam covers itself where pieces that are apart in space are close in the picture.
            let in_space = (piece.middle - other.middle).norm();
            let is_apart = piece.beam != other.beam
                || in_space > 2.0 * radii[piece.beam].abs() && away < 0.5 * in_space * view.scale;
            if is_apart && away < reach {
                piece.layer = piece.layer.max(other.layer + 1).min(LAYERS - 1);
            }
        }
    }
    let mut layers = [vec![0; PIECES], vec![0; PIECES]];
    for piece in pieces {
        layers[piece.beam][piece.number] = piece.layer;
    }
    layers
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// The runs of pieces that are in one layer: the first piece, and the first that is not in it any more.
fn runs(layers: &[usize], layer: usize) -> Vec<[usize; 2]> {
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for i in (0..layers.len()).filter(|&i| layers[i] == layer) {
        match runs.last_mut() {
            Some(last) if last[1] == i => last[1] = i + 1,
            _ => runs.push([i, i + 1]),
        }
    }
    runs
}

/// The points of a run, with a part of the pieces before and after it.
fn extended(points: &[[f64; 2]], [from, to]: [usize; 2]) -> Vec<[f64; 2]> {
    let towards = |at: [f64; 2], next: [f64; 2]| [0, 1].map(|c| at[c] + OVERLAP * (next[c] - at[c]));
    let mut all = Vec::with_capacity(to - from + 3);
    if from > 0 {
        all.push(towards(points[from], points[from - 1]));
    }
    all.extend(&points[from..=to]);
    if let Some(next) = points.get(to + 1) {
        all.push(towards(points[to], *next));
    }
    all
}

/// The end of a tube, if it faces the eye.
fn cap(view: &View, centroid: &dyn Centroid, end: f64, radius: f64) -> Option<Vec<[f64; 2]>> {
    let at = centroid.geometry(end);
    let outwards = (at.t * end).try_normalize(1e-12)?;
    if outwards.dot(&view.away) > -1e-3 {
        return None;
    }
    let across = outwards.cross(&view.away).try_normalize(1e-6).unwrap_or(view.right);
    let along = across.cross(&outwards);
    let point = |i: u8| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(ROUND)).sin_cos();
        view.at(&(at.x + (across * cos + along * sin) * radius.abs()))
    };
    Some((0..=ROUND).map(point).collect())
}
