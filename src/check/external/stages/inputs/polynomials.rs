//! Errors of one derivative of a shape function: a term of it, or another shape function in its place.

use super::shapes::{TERMS, WRONG_FACTORS, derivative, error_words, factor_words, polynomial};
use super::{BEAMS, Input, ORDERS, Of, Vectors, add};
use crate::check::external::stages::sample::Sample;
use crate::check::external::stages::terms::Beam;

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

    /// The derivative with this polynomial added.
    pub(in crate::check::external::stages) fn with_error(&self, error: [f64; 4]) -> Input {
        self.plus(&error_words(&self.coefficients, &error), error)
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

    /// All of it with another factor, if it has several terms.
    fn as_whole(&self) -> impl Iterator<Item = Input> {
        let terms = self.coefficients.iter().filter(|of| **of != 0.0).count();
        let factors = WRONG_FACTORS.into_iter().filter(move |_| terms > 1).map(|factor| factor - 1.0);
        factors.map(|by| self.plus(&format!("it {}", factor_words(by)), self.coefficients.map(|of| by * of)))
    }

    /// A term with another factor, or another power.
    fn terms(&self) -> impl Iterator<Item = Input> {
        let terms = self.coefficients.into_iter().enumerate().filter(|(_, coefficient)| *coefficient != 0.0);
        terms.flat_map(move |(power, coefficient)| {
            let alone = move |power: usize, by: f64| -> [f64; 4] {
                std::array::from_fn(|i| if i == power { by * coefficient } else { 0.0 })
            };
            let factors = WRONG_FACTORS.map(|factor| {
                let words = format!("its {} {}", TERMS[power], factor_words(factor - 1.0));
                self.plus(&words, alone(power, factor - 1.0))
            });
            let powers = (0..4).filter(move |other| *other != power).map(move |other| {
                let words = format!("its {} is a {}", TERMS[power], TERMS[other]);
                let [old, new] = [alone(power, -1.0), alone(other, 1.0)];
                self.plus(&words, std::array::from_fn(|i| old[i] + new[i]))
            });
            factors.into_iter().chain(powers)
        })
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

/// Errors of single terms, and of shape functions that are exchanged.
pub(super) fn inputs(samples: &[Sample]) -> Vec<Input> {
    let mut all = Vec::new();
    let derivatives = derivatives(samples);
    for of in &derivatives {
        all.extend(of.terms());
        all.extend(of.as_whole());
        let is_like = |other: &&Derivative| {
            other.node != of.node && other.order == of.order && other.beams.0 == of.beams.0
        };
        for other in derivatives.iter().filter(is_like) {
            let error: [f64; 4] = std::array::from_fn(|i| other.coefficients[i] - of.coefficients[i]);
            // One term that differs is told as such.
            if error.iter().filter(|of| **of != 0.0).count() > 1 {
                let words = format!("shape function {} stands in its place", other.node + 1);
                all.push(of.plus(&words, error));
            }
            if other.node > of.node {
                all.push(exchanged(of, other));
            }
        }
    }
    all
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
