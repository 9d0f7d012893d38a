//! Errors of one derivative of a shape function: a term of it, or another shape function in its place.

use super::shapes::{TERMS, WRONG_FACTORS, derivative, error_words, factor_words, fitted, polynomial};
use super::{BEAMS, Input, ORDERS, Of, Vectors, add};
use crate::check::external::stages::sample::Sample;
use crate::check::external::stages::terms::Beam;

/// Factors that shape functions have, by their root and the number before xi: 3 xi + 1 has the root -1/3.
const FACTORS: [(f64, f64); 8] = [
    (1.0, 1.0),
    (-1.0, 1.0),
    (2.0, 1.0),
    (-2.0, 1.0),
    (0.5, 2.0),
    (-0.5, 2.0),
    (1.0 / 3.0, 3.0),
    (-1.0 / 3.0, 3.0),
];

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
        if own[2] != 0.0 || own[3] != 0.0 {
            errors.extend(FACTORS.iter().flat_map(|factor| of_factor(&own, *factor)));
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

/// Errors of a polynomial that is written with a factor: a wrong sign in it, or the factor left out.
fn of_factor(own: &[f64; 4], (root, scale): (f64, f64)) -> Vec<(String, [f64; 4])> {
    let mut rest = [0.0; 4];
    for i in (0..3).rev() {
        rest[i] = own[i + 1] + root * rest[i + 1];
    }
    if (own[0] + root * rest[0]).abs() > 1e-12 {
        return Vec::new();
    }
    let sign = if root > 0.0 { "-" } else { "+" };
    let before = if scale > 1.0 { format!("{scale} ") } else { String::new() };
    let factor = format!("its factor {before}xi {sign} {}", (scale * root).abs());
    // With the other sign of its constant; it may also have been written with both signs exchanged.
    let other: [f64; 4] = std::array::from_fn(|i| root * rest[i] + if i > 0 { rest[i - 1] } else { 0.0 });
    [1.0, -1.0]
        .into_iter()
        .flat_map(|by| {
            let less = |new: [f64; 4]| -> [f64; 4] { std::array::from_fn(|i| by * new[i] - own[i]) };
            [
                (format!("in {factor} a sign is wrong"), less(other)),
                (format!("{factor} is missing"), less(rest.map(|of| of / scale))),
            ]
        })
        .collect()
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

#[cfg(test)]
mod tests {
    use super::of_factor;

    #[test]
    fn a_factor_has_a_wrong_sign_or_is_missing() {
        // (xi + 1) (3 xi - 1)/4, the first derivative of a shape function of Hermite.
        let own = [-0.25, 0.5, 0.75, 0.0];
        let errors = of_factor(&own, (1.0 / 3.0, 3.0));
        let wrong = |words: &str| -> Vec<[f64; 4]> {
            let of = errors.iter().filter(|(known, _)| known == words);
            of.map(|(_, error)| std::array::from_fn(|i| own[i] + error[i])).collect()
        };
        let has = |all: &[[f64; 4]], one: [f64; 4]| {
            all.iter().any(|other| other.iter().zip(one).all(|(x, y)| (x - y).abs() < 1e-15))
        };
        assert!(has(&wrong("in its factor 3 xi - 1 a sign is wrong"), [0.25, 1.0, 0.75, 0.0]), "{errors:?}");
        assert!(has(&wrong("its factor 3 xi - 1 is missing"), [0.25, 0.25, 0.0, 0.0]), "{errors:?}");
        assert_eq!(of_factor(&own, (1.0, 1.0)), []);
    }
}
