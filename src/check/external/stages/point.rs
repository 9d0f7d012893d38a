//! The values of terms at a sample.

use super::sample::Sample;
use super::terms::{Beam, Earlier, Factor, Number, Part, Reading, Side, Term, Vector, place};
use crate::linearization::Quantity;
use crate::number::{Real, RunningError};
use nalgebra::Vector3;

const fn exact(value: f64) -> RunningError {
    RunningError { value, bound: 0.0 }
}

/// The number of vectors in the table of a point, without those with moved components.
const VECTORS: usize = 29;

/// A sample with its vectors and their scalar products.
#[derive(Clone, Debug)]
pub(super) struct Point<'a> {
    pub(super) sample: &'a Sample,
    vectors: Vec<Vector3<RunningError>>,
    dots: Vec<RunningError>,
}

impl<'a> Point<'a> {
    pub(super) fn new(sample: &'a Sample) -> Self {
        Self::with(sample, &sample.geometry, &sample.moved)
    }

    /// The sample with other vectors.
    pub(super) fn with(
        sample: &'a Sample,
        geometry: &[[Vector3<RunningError>; 4]; 2],
        moved: &[[[Vector3<RunningError>; 3]; 2]; 2],
    ) -> Self {
        let mut vectors = vec![geometry[0][0] - geometry[1][0], geometry[0][0], geometry[1][0]];
        vectors.extend(geometry.iter().flat_map(|of| of[1..].to_vec()));
        vectors.extend(moved.iter().flatten().flatten());
        vectors.extend(sample.mixed.iter().flatten());
        vectors.extend((0..3).map(|axis| Vector3::from_fn(|c, _| exact(if c == axis { 1.0 } else { 0.0 }))));
        let cross = vectors[3].cross(&vectors[6]);
        let side = if cross.dot(&vectors[0]).value < 0.0 { -1.0 } else { 1.0 };
        vectors.push(cross * exact(side));
        let mut dots = vec![exact(0.0); VECTORS * VECTORS];
        for i in 0..VECTORS {
            for j in 0..=i {
                let dot = vectors[i].dot(&vectors[j]);
                (dots[i * VECTORS + j], dots[j * VECTORS + i]) = (dot, dot);
            }
        }
        Self { sample, vectors, dots }
    }

    pub(super) fn vector(&self, of: Vector) -> Vector3<RunningError> {
        match of {
            Vector::Permuted(of, order) => {
                let v = self.vectors[of];
                Vector3::from_fn(|c, _| v[order[c]])
            }
            _ => self.vectors[place(of).unwrap_or(0)],
        }
    }

    fn dot(&self, v: Vector, w: Vector) -> RunningError {
        match (place(v), place(w)) {
            (Some(i), Some(j)) => self.dots[i * VECTORS + j],
            _ => self.vector(v).dot(&self.vector(w)),
        }
    }

    /// A number; nothing if it is a result that the program does not answer.
    fn number(&self, of: Number, reading: &Reading) -> Option<RunningError> {
        let sample = self.sample;
        let beam_of = |beam: Beam| [Quantity::Xi, Quantity::XiBar][beam];
        let reference = |beam: Beam| exact([sample.contact.xi_0, sample.contact.xi_bar_0][beam]);
        Some(match of {
            Number::Of(quantity, part) => {
                let at = quantity.component();
                let own = sample.own[at][part];
                match own {
                    _ if reading.results.contains(&(quantity, part)) => own?,
                    Some(own) if reading.earlier == Earlier::Own => own,
                    None if reading.earlier == Earlier::Own => {
                        self.following(quantity, part, reading).unwrap_or(sample.exact[at][part])
                    }
                    _ => sample.exact[at][part],
                }
            }
            Number::Component(quantity, axis, part) => sample.own[quantity.component() + axis][part]?,
            Number::Length(of) => self.dot(of, of).sqrt(),
            Number::End(beam) => sample.exact[beam_of(beam).component()][0],
            Number::Radius(beam) => exact([sample.contact.radius, sample.contact.radius_bar][beam]),
            Number::Moved(beam, of) => self.number(Number::Of(beam_of(beam), 0), reading)? - reference(of),
            Number::Stiffness => exact(sample.element.as_ref()?.stiffness?),
            Number::Element(k) => sample.element.as_ref()?.numbers[k]?,
        })
    }

    /// A length that is not answered, as it follows from the numbers of the program before it: it may have another point, or
    /// other vectors.
    fn following(&self, quantity: Quantity, part: Part, reading: &Reading) -> Option<RunningError> {
        let (beam, xi) = match quantity {
            Quantity::D if part == 0 => return Some(self.dot(Vector::D, Vector::D).sqrt()),
            Quantity::T => (0, Quantity::Xi),
            Quantity::TBar => (1, Quantity::XiBar),
            _ => return None,
        };
        let along = |part: Part| self.number(Number::Of(xi, part), reading);
        let [t, bend, third] = [0, 1, 2].map(|k| self.vector(Vector::T(beam, k)));
        let length = t.dot(&t).sqrt();
        let turned = |side: Side| {
            let by = along(1 + side)?;
            Some(self.vector(Vector::U(side, beam, 1)) + bend * by)
        };
        Some(match part {
            0 => length,
            1 | 2 => t.dot(&turned(part - 1)?) / length,
            _ => {
                let [dt, linear_dt] = [turned(0)?, turned(1)?];
                let [by, linear_by] = [along(1)?, along(2)?];
                let [u, linear_u] = [0, 1].map(|side| self.vector(Vector::U(side, beam, 2)));
                let second = self.vector(Vector::Mixed(beam, 1))
                    + linear_u * by
                    + u * linear_by
                    + third * (by * linear_by)
                    + bend * along(3)?;
                let lengths = t.dot(&dt) / length * (t.dot(&linear_dt) / length);
                (dt.dot(&linear_dt) - lengths + t.dot(&second)) / length
            }
        })
    }

    fn factor(&self, of: Factor, reading: &Reading) -> Option<RunningError> {
        let size = |of: RunningError| RunningError { value: of.value.abs(), ..of };
        Some(match of {
            Factor::Dot(v, w) => self.dot(v, w),
            Factor::Size(v, w) => size(self.dot(v, w)),
            Factor::Entry(v, i, w, j) => self.vector(v)[i] * self.vector(w)[j],
            Factor::Number(number) => self.number(number, reading)?,
            Factor::SizeOf(number) => size(self.number(number, reading)?),
            Factor::Power(of, n) => {
                let length = self.number(Number::Of(of, 0), reading)?;
                let power = (1..n.abs()).fold(length, |power, _| power * length);
                if n > 0 { power } else { exact(1.0) / power }
            }
        })
    }

    /// The sum of the absolute values of terms.
    pub(super) fn size(&self, terms: &[Term], reading: &Reading) -> f64 {
        let size = |term| self.value(std::slice::from_ref(term), reading).map_or(0.0, |of| of.value.abs());
        terms.iter().map(size).sum()
    }

    /// The value of a sum of terms; nothing if a result is not answered.
    pub(super) fn value(&self, terms: &[Term], reading: &Reading) -> Option<RunningError> {
        let mut sum = exact(0.0);
        for term in terms {
            let mut product = exact(term.coefficient);
            for factor in &term.factors {
                product *= self.factor(*factor, reading)?;
            }
            sum += product;
        }
        Some(sum)
    }
}
