//! Shape functions at a wrong parameter.

use super::shapes::polynomial;
use super::{BEAMS, Input, OF, ORDERS, add};
use crate::check::external::stages::sample::Sample;

const ARGUMENTS: [&str; 2] = ["the absolute value of its parameter", "the parameter of the other beam"];

pub(super) fn inputs(samples: &[Sample]) -> Vec<Input> {
    let mut all = Vec::new();
    let nodes = |beam: usize| samples.iter().map(|sample| sample.nodes[beam].len()).max().unwrap_or(0);
    for (beams, of_beams) in BEAMS {
        let every = std::iter::once(None).chain((0..nodes(beams[0])).map(Some));
        for (only, (first, last)) in every.flat_map(|only| RANGES.map(|range| (only, range))) {
            let which = only
                .map_or_else(|| "the shape functions".to_owned(), |k| format!("shape function {}", k + 1));
            let range = if first == last {
                format!("{}{which}", ORDERS[first])
            } else if first == 0 {
                format!("{which} with all derivatives")
            } else {
                format!("{which} from the derivative {first} on")
            };
            for (of, scope) in OF {
                for (kind, argument) in ARGUMENTS.iter().enumerate() {
                    let words = format!("{range} of {of_beams}: at {argument}{scope}");
                    all.push(Input::new(words, move |sample, vectors| {
                        for &b in beams {
                            let xi = sample.xi[b].value;
                            let other = [xi.abs(), sample.xi[1 - b].value][kind];
                            let is_meant = |k: usize| only.is_none_or(|only| only == k);
                            for (_, node) in sample.nodes[b].iter().enumerate().filter(|(k, _)| is_meant(*k))
                            {
                                let Some(coefficients) = &node.coefficients else { continue };
                                for order in first..=last {
                                    let at = |xi: f64| polynomial(coefficients, order, xi);
                                    add(vectors, (b, order), at(other) - at(xi), node.vectors, of);
                                }
                            }
                        }
                    }));
                }
            }
        }
    }
    all
}

/// The derivatives that are wrong, from the first to the last.
const RANGES: [(usize, usize); 7] = [(0, 0), (1, 1), (2, 2), (3, 3), (0, 3), (1, 3), (2, 3)];
