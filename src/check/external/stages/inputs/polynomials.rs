//! Errors of one derivative of a shape function: a term of it, or another shape function in its place.

use super::shapes::{TERMS, WRONG_FACTORS, derivative, error_words, factor_words, fitted, polynomial};
use super::{BEAMS, Input, ORDERS, Of, Vectors, add};
use crate::check::external::stages::sample::Sample;
use crate::check::external::stages::terms::Beam;

/// How near values are to a known error, over the largest.
const SAME: f64 = 1e-6;

/// A shape function: the beams that have the error, their name, the place of the function, the order of the derivative, and its
/// coefficients.
#[derive(Clone, Copy)]
pub(in crate::check::external::stages) struct Derivative {
    pub(in crate::check::external::stages) beams: (&'static [Beam], &'static str),
    node: usize,
    order: usize,
    coefficients: [f64; 4],
}

impl Derivative {
    fn words(&self) -> String {
        format!("{}shape function {} of {}", ORDERS[self.order], self.node + 1, self.beams.1)
    }

    /// The vectors of a sample with numbers added to the derivative of each beam.
    pub(in crate::check::external::stages) fn vectors(&self, sample: &Sample, by: [f64; 2]) -> Vectors {
        let mut vectors = (sample.geometry, sample.moved);
        for &beam in self.beams.0 {
            if let Some(of) = sample.nodes[beam].get(self.node) {
                add(&mut vectors, (beam, self.order), by[beam], of.vectors, Of::Both);
            }
        }
        vectors
    }

    /// The error that has these values at these parameters, if there is one: a known one, or a polynomial. `all` are the
    /// derivatives that it may be confused with.
    pub(in crate::check::external::stages) fn with_errors(
        &self,
        values: &[(f64, f64)],
        all: &[Self],
    ) -> Option<Input> {
        let size = values.iter().fold(0.0_f64, |size, (_, value)| size.max(value.abs()));
        let is_same = |known: &[f64; 4]| {
            values.iter().all(|(xi, value)| (polynomial(known, 0, *xi) - value).abs() <= SAME * size)
        };
        let known = self.errors(all).into_iter().find(|(_, known)| is_same(known));
        let (words, error) = known.or_else(|| {
            let error = fitted(values)?;
            Some((error_words(&self.coefficients, &error), error))
        })?;
        Some(self.plus(&words, error))
    }

    /// The derivative with a polynomial added.
    fn plus(&self, words: &str, error: [f64; 4]) -> Input {
        let &Self { beams: (beams, _), node, order, .. } = self;
        Input::new(format!("{}: {words}", self.words()), move |sample, vectors| {
            for &beam in beams {
                if let Some(of) = sample.nodes[beam].get(node) {
                    let error = polynomial(&error, 0, sample.xi[beam].value);
                    add(vectors, (beam, order), error, of.vectors, Of::Both);
                }
            }
        })
    }

    /// Its errors, in words: a term with another factor or another power, all of it with another factor, another shape function in
    /// its place.
    fn errors(&self, all: &[Self]) -> Vec<(String, [f64; 4])> {
        let own = self.coefficients;
        let mut errors = Vec::new();
        for (power, coefficient) in own.into_iter().enumerate().filter(|(_, of)| *of != 0.0) {
            let alone = |power: usize, by: f64| -> [f64; 4] {
                std::array::from_fn(|i| if i == power { by * coefficient } else { 0.0 })
            };
            for by in WRONG_FACTORS.map(|factor| factor - 1.0) {
                errors.push((format!("its {} {}", TERMS[power], factor_words(by)), alone(power, by)));
            }
            for other in (0..4).filter(|other| *other != power) {
                let [old, new] = [alone(power, -1.0), alone(other, 1.0)];
                let words = format!("its {} is a {}", TERMS[power], TERMS[other]);
                errors.push((words, std::array::from_fn(|i| old[i] + new[i])));
            }
        }
        let count = |of: &[f64; 4]| of.iter().filter(|of| **of != 0.0).count();
        if count(&own) > 1 {
            let whole = |by: f64| (format!("it {}", factor_words(by)), own.map(|of| by * of));
            errors.extend(WRONG_FACTORS.map(|factor| whole(factor - 1.0)));
        }
        for other in all.iter().filter(|other| self.is_like(other)) {
            let error: [f64; 4] = std::array::from_fn(|i| other.coefficients[i] - own[i]);
            // One term that differs is told as such.
            if count(&error) > 1 {
                errors.push((format!("shape function {} stands in its place", other.node + 1), error));
            }
        }
        errors
    }

    /// Whether the other is the same derivative of another shape function.
    fn is_like(&self, other: &Self) -> bool {
        other.node != self.node && other.order == self.order && other.beams.0 == self.beams.0
    }
}

/// All derivatives of the shape functions, of both beams, of the beam, and of the bar beam.
pub(in crate::check::external::stages) fn derivatives(samples: &[Sample]) -> Vec<Derivative> {
    let of_beams = |beams: (&'static [Beam], &'static str)| {
        let nodes = samples.iter().map(|sample| &sample.nodes[beams.0[0]]).max_by_key(|nodes| nodes.len());
        let cubics: Vec<[f64; 4]> =
            nodes.into_iter().flatten().filter_map(|node| node.coefficients).collect();
        (0..4).flat_map(move |order| {
            let of = move |(node, cubic): (usize, [f64; 4])| Derivative {
                beams,
                node,
                order,
                coefficients: derivative(&cubic, order),
            };
            cubics.clone().into_iter().enumerate().map(of)
        })
    };
    BEAMS.into_iter().flat_map(of_beams).collect()
}

/// Errors of single derivatives, and of pairs that are exchanged.
pub(super) fn inputs(samples: &[Sample]) -> Vec<Input> {
    let all = derivatives(samples);
    let of_one = |of: &Derivative| -> Vec<Input> {
        let errors = of.errors(&all).into_iter().map(|(words, error)| of.plus(&words, error));
        let later = all.iter().filter(|other| of.is_like(other) && other.node > of.node);
        errors.chain(later.map(|other| exchanged(of, other))).collect()
    };
    all.iter().flat_map(of_one).collect()
}

/// Both stand in the place of each other.
fn exchanged(one: &Derivative, other: &Derivative) -> Input {
    let difference: [f64; 4] = std::array::from_fn(|i| other.coefficients[i] - one.coefficients[i]);
    let [first, second] = [one.plus("", difference), other.plus("", difference.map(|of| -of))];
    let words = format!("{} and {} are exchanged", one.words(), other.node + 1);
    Input::new(words, move |sample, vectors| {
        (first.change)(sample, vectors);
        (second.change)(sample, vectors);
    })
}
