//! The pair with its dofs moved, and its closest point solved for again.

use super::noise::of_position;
use super::norm;
use super::tangent::{self, tangent};
use crate::check::evaluation_point::EvaluationPoint;
use crate::linearization::ad::PositionAt;
use crate::linearization::{COMPONENTS, Quantities};
use crate::number::{DoubleDouble, Real};
use nalgebra::Vector3;

/// The first step for the measurement of the radius; a hundredth of it if the iterations do not converge.
const FIRST_STEP: f64 = 1.0 / 1_048_576.0;
/// The step in the parameters for the differences of the matrix.
const MATRIX: f64 = 1.0 / 1_048_576.0;
/// The maximum number of chord iterations.
const ITERATIONS: usize = 40;

type Vector = Vector3<DoubleDouble>;

/// The closest point without a move, to 30 digits, and the matrix for all chord iterations.
pub(super) struct Base<'a> {
    pub(super) evaluation: &'a EvaluationPoint<'a>,
    pub(super) place: Place,
    /// The inverse Jacobian of the orthogonality conditions. Held parameters do not move.
    pub(super) inverse: [[f64; 2]; 2],
    /// ‖x,xixi‖ and ‖x_bar,xixi‖.
    pub(super) bends: [f64; 2],
    /// The rounding of both positions.
    pub(super) rounded: [f64; 2],
    /// The change of the parameters by this rounding.
    settled: [f64; 2],
}

/// Points and tangents of both beams at two parameters.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) at: [DoubleDouble; 2],
    pub(super) x: [Vector; 2],
    pub(super) t: [Vector; 2],
}

/// The closest point of moved beams.
pub(super) struct Moved<'a> {
    base: &'a Base<'a>,
    place: Place,
    /// The ratio of the second step of the chord iterations to the first.
    rate: f64,
}

type Beams<'a> = [Box<dyn PositionAt<DoubleDouble> + 'a>; 2];

impl Place {
    fn new(beams: &Beams, at: [DoubleDouble; 2]) -> Self {
        let on = |i: usize| beams[i].position_at(at[i]);
        let along = |i: usize| tangent(&*beams[i], at[i], tangent::STEP);
        Self { at, x: [on(0), on(1)], t: [along(0), along(1)] }
    }

    pub(super) fn d(&self) -> Vector {
        self.x[0] - self.x[1]
    }

    /// d.t and d.t_bar.
    fn conditions(&self) -> [DoubleDouble; 2] {
        let d = self.d();
        self.t.map(|t| d.dot(&t))
    }

    /// The definitions (4)-(15) of the paper, from positions alone.
    fn quantities(&self, evaluation: &EvaluationPoint) -> [DoubleDouble; COMPONENTS] {
        let length = |v: &Vector| v.dot(v).sqrt();
        let Self { at: [xi, xi_bar], x: [x, x_bar], t: [t_vector, t_bar_vector] } = *self;
        let (d_vector, contact) = (self.d(), evaluation.contact);
        let [d, t, t_bar] = [&d_vector, &t_vector, &t_bar_vector].map(length);
        let radii = DoubleDouble::from(contact.radius) + DoubleDouble::from(contact.radius_bar);
        let slip = |xi: DoubleDouble, start: f64| xi - DoubleDouble::from(start);
        Quantities {
            x,
            x_bar,
            d_vector,
            t_vector,
            t_bar_vector,
            d,
            t,
            t_bar,
            xi,
            xi_bar,
            g_n: d - radii,
            g_t: t * slip(xi, contact.xi_0),
            g_t_bar: t_bar * slip(xi_bar, contact.xi_bar_0),
        }
        .components()
    }
}

impl<'a> Base<'a> {
    /// Differences the matrix and refines the closest point.
    pub(super) fn new(evaluation: &'a EvaluationPoint<'a>) -> Option<Self> {
        let beams = beams(evaluation, [0.0; 2]);
        let at = [evaluation.at.0.value, evaluation.at.1.value].map(DoubleDouble::from);
        let place = Place::new(&beams, at);
        let mut jacobian = [[0.0; 2]; 2];
        let mut bends = [0.0; 2];
        for i in 0..2 {
            let shifted = |by: f64| {
                let mut at = at;
                at[i] += DoubleDouble::from(by);
                Place::new(&beams, at)
            };
            let (up, down) = (shifted(MATRIX), shifted(-MATRIX));
            for (row, (up, down)) in
                jacobian.iter_mut().zip(up.conditions().into_iter().zip(down.conditions()))
            {
                row[i] = (up - down).value() / (2.0 * MATRIX);
            }
            bends[i] = norm(&(up.t[i] - down.t[i])) / (2.0 * MATRIX);
        }
        let rounded = [0, 1].map(|i| of_position(evaluation.beams[i], at[i].value()));
        let inverse = inverse(jacobian, [evaluation.held.xi, evaluation.held.xi_bar]);
        let mut base = Self { evaluation, place, inverse, bends, rounded, settled: [0.0; 2] };
        base.settled = base.noise_of_parameters();
        base.place = base.solve(&beams)?.0;
        Some(base)
    }

    /// Chord iterations from the closest point without a move. Returns the place and the rate of the first two steps.
    fn solve(&self, beams: &Beams) -> Option<(Place, f64)> {
        let noise = self.settled;
        let mut at = self.place.at;
        let mut sizes = Vec::with_capacity(ITERATIONS);
        while sizes.len() < ITERATIONS {
            let place = Place::new(beams, at);
            let [f, f_bar] = place.conditions();
            let step = self.inverse.map(|[p, q]| DoubleDouble::from(p) * f + DoubleDouble::from(q) * f_bar);
            let size = step[0].value().abs().max(step[1].value().abs());
            if !size.is_finite() {
                return None;
            }
            let stagnates = sizes.last().is_some_and(|&previous| size >= 0.5 * previous);
            let below = |part: f64| (0..2).all(|i| step[i].value().abs() <= part * noise[i]);
            if below(0.25) || (stagnates && below(1.0)) {
                let rate = if let [first, second, ..] = sizes[..] { second / first } else { 0.0 };
                return Some((place, rate));
            }
            if stagnates {
                return None;
            }
            at = [at[0] - step[0], at[1] - step[1]];
            sizes.push(size);
        }
        None
    }

    /// The pair moved along both directions.
    pub(super) fn moved(&'a self, along: [f64; 2]) -> Option<Moved<'a>> {
        let (place, rate) = self.solve(&beams(self.evaluation, along))?;
        Some(Moved { base: self, place, rate })
    }

    /// The distance in one direction over which the problem remains similar.
    pub(super) fn radius(&'a self, direction: [f64; 2]) -> Option<f64> {
        let mut step = FIRST_STEP;
        for _ in 0..5 {
            match self.moved(direction.map(|component| step * component)) {
                Some(moved) if moved.rate < 0.1 => return Some((step / moved.change()).min(1.0)),
                _ => step *= 1e-2,
            }
        }
        None
    }

    /// The quantities without a move.
    pub(super) fn quantities(&self) -> [DoubleDouble; COMPONENTS] {
        self.place.quantities(self.evaluation)
    }
}

impl Moved<'_> {
    /// The quantities of the moved pair.
    pub(super) fn quantities(&self) -> [DoubleDouble; COMPONENTS] {
        self.place.quantities(self.base.evaluation)
    }

    /// The largest relative change of the numbers that the problem depends on.
    fn change(&self) -> f64 {
        let (place, base) = (&self.place, &self.base.place);
        let relative = |moved: &Vector, v: &Vector| norm(&(moved - v)) / norm(v);
        let xi = |i: usize| (place.at[i] - base.at[i]).abs().value();
        [
            self.rate,
            xi(0),
            xi(1),
            relative(&place.d(), &base.d()),
            relative(&place.t[0], &base.t[0]),
            relative(&place.t[1], &base.t[1]),
        ]
        .into_iter()
        .fold(0.0, f64::max)
    }
}

fn beams<'a>(evaluation: &EvaluationPoint<'a>, along: [f64; 2]) -> Beams<'a> {
    evaluation.beams.map(|beam| beam.moved(along.map(DoubleDouble::from)))
}

/// The inverse of a matrix, without the rows and columns that are held.
fn inverse([[a, b], [c, d]]: [[f64; 2]; 2], held: [bool; 2]) -> [[f64; 2]; 2] {
    match held {
        [false, false] => {
            let det = a * d - b * c;
            [[d / det, -b / det], [-c / det, a / det]]
        }
        [true, false] => [[0.0, 0.0], [0.0, 1.0 / d]],
        [false, true] => [[1.0 / a, 0.0], [0.0, 0.0]],
        [true, true] => [[0.0; 2]; 2],
    }
}
