//! A curve over intervals of its parameter: Taylor polynomials with bounds, from its position alone.

use crate::linearization::ad::PositionAt;
use crate::number::TaylorSeries;
use nalgebra::Vector3;

/// The curve over an interval: x + t u + w u² + r u³ at the distance u from the centre, with ‖r‖ <= `rest`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) centre: f64,
    pub(super) half: f64,
    pub(super) x: Vector3<f64>,
    pub(super) t: Vector3<f64>,
    pub(super) w: Vector3<f64>,
    /// Bounds on the rounding of x, t and w.
    pub(super) error: [f64; 3],
    /// ‖t‖ and ‖w‖.
    pub(super) size: [f64; 2],
    pub(super) rest: f64,
    /// The index of the first of the two halves; 0 if there are none.
    halves: u32,
}

/// The whole curve, its lower end and its upper end.
pub(super) const WHOLE: u32 = 0;
pub(super) const LOWER: u32 = 1;
pub(super) const UPPER: u32 = 2;

/// A curve with its pieces, in units in which its numbers are near one.
pub(super) struct Pieces<'a> {
    position: &'a dyn PositionAt<TaylorSeries>,
    /// A power of two.
    factor: f64,
    all: Vec<Piece>,
}

impl Piece {
    fn new(position: &dyn PositionAt<TaylorSeries>, factor: f64, [centre, half]: [f64; 2]) -> Self {
        let series = position.position_at(TaylorSeries::about(centre, half));
        let value = |k: usize| series.map(|of| of.coefficient(k).value) * factor;
        let error = |k: usize| series.map(|of| of.coefficient(k).bound[0]).norm() * factor;
        let rest =
            series.map(|of| of.coefficient(3).value.abs() + of.coefficient(3).bound[1]).norm() * factor;
        let [x, t, w] = [0, 1, 2].map(value);
        let size = [t.norm(), w.norm()];
        Self { centre, half, x, t, w, error: [0, 1, 2].map(error), size, rest, halves: 0 }
    }

    /// Whether the interval contains the end -1 or 1.
    pub(super) fn touches(&self, end: f64) -> bool {
        (self.centre - end).abs() <= self.half
    }

    /// The smallest and the largest parameter.
    pub(super) fn extent(&self) -> [f64; 2] {
        [self.centre - self.half, self.centre + self.half]
    }
}

impl<'a> Pieces<'a> {
    /// The curve, with its lengths multiplied by a power of two.
    pub(super) fn new(position: &'a dyn PositionAt<TaylorSeries>, factor: f64) -> Self {
        let all = [[0.0, 1.0], [-1.0, 0.0], [1.0, 0.0]].map(|at| Piece::new(position, factor, at));
        Self { position, factor, all: all.into() }
    }

    /// The largest of its lengths: the position and the tangent in the middle and at the ends.
    pub(super) fn length(&self) -> f64 {
        let lengths = self.all.iter().map(|Piece { x, size: [t, _], .. }| x.norm() + t);
        lengths
            .fold(0.0, |longest, length| if length > longest || length.is_nan() { length } else { longest })
    }

    /// Whether x is linear in the parameter, without rounding.
    pub(super) fn is_straight(position: &dyn PositionAt<TaylorSeries>) -> bool {
        position.position_at(TaylorSeries::about(0.0, 1.0)).iter().all(TaylorSeries::is_linear)
    }

    pub(super) fn piece(&self, index: u32) -> &Piece {
        &self.all[index as usize]
    }

    /// The curve at one parameter.
    pub(super) fn at(&self, xi: f64) -> Piece {
        Piece::new(self.position, self.factor, [xi, 0.0])
    }

    /// The two halves of a piece.
    pub(super) fn halves(&mut self, index: u32) -> [u32; 2] {
        let Piece { centre, half, halves, .. } = self.all[index as usize];
        if halves > 0 {
            return [halves, halves + 1];
        }
        let first = u32::try_from(self.all.len()).unwrap_or(u32::MAX - 1);
        for side in [-0.5, 0.5] {
            self.all.push(Piece::new(self.position, self.factor, [centre + side * half, 0.5 * half]));
        }
        self.all[index as usize].halves = first;
        [first, first + 1]
    }
}

#[cfg(test)]
mod tests {
    use super::{LOWER, Pieces, UPPER, WHOLE};
    use crate::check::Case;
    use crate::number::DoubleDouble;

    #[test]
    fn a_piece_contains_the_curve_over_its_interval() {
        // Every pair of families, so every family.
        for number in 0..10 * 121 {
            let case = Case::draw(7, number);
            let beam = case.beams()[1];
            let mut pieces = Pieces::new(beam, 1.0);
            let lower = pieces.halves(WHOLE)[0];
            let parts = pieces.halves(lower);
            for index in [WHOLE, LOWER, UPPER, lower, parts[0], parts[1]] {
                let piece = pieces.piece(index);
                for i in -4..=4 {
                    let u = f64::from(i) / 4.0 * piece.half;
                    let exact = beam.geometry_precise((piece.centre + u).into()).x.map(DoubleDouble::value);
                    let polynomial = piece.x + piece.t * u + piece.w * (u * u);
                    let off = (exact - polynomial).norm();
                    let [x, t, w] = piece.error;
                    let rounding = x + (t + w * u.abs()) * u.abs() + 4.0 * f64::EPSILON * pieces.length();
                    // The rest may be infinite, but not at the centre.
                    let rest = if u == 0.0 { 0.0 } else { piece.rest * u.abs().powi(3) };
                    assert!(off <= rest + rounding, "{case:?} {piece:?} {u} {off}");
                }
            }
        }
    }
}
