//! Shape functions with other control vectors than their own.

use super::{BEAMS, Input, OF, add};
use crate::check::external::stages::sample::{Node, Sample};
use nalgebra::Vector3;

/// Which control vector stands in the place of one.
#[derive(Clone, Copy)]
enum Other {
    Before,
    After,
    OfOtherBeam,
    InPairs,
    OfOtherEnd,
    SlopesOfOtherEnd,
    Reversed,
}

const OTHERS: [(Other, &str); 7] = [
    (Other::Before, "the control vectors one place before"),
    (Other::After, "the control vectors one place after"),
    (Other::OfOtherBeam, "the control vectors of the other beam"),
    (Other::InPairs, "control vectors exchanged in pairs"),
    (Other::OfOtherEnd, "the control vectors of the other end"),
    (Other::SlopesOfOtherEnd, "the slopes of the other end"),
    (Other::Reversed, "control vectors in reversed order"),
];

impl Other {
    /// The index of the other one among the control vectors of both beams, if there is one.
    fn of(self, beam: usize, k: usize, [n, m]: [usize; 2]) -> Option<usize> {
        let (start, count, start_of_other) = if beam == 0 { (0, n, n) } else { (n, m, 0) };
        match self {
            Self::Before => (start + k).checked_sub(1),
            Self::After => Some(start + k + 1),
            Self::OfOtherBeam => Some(start_of_other + k),
            Self::InPairs => Some(start + (k ^ 1)),
            Self::OfOtherEnd => Some(start + (k ^ 2)),
            Self::SlopesOfOtherEnd => Some(start + if k % 2 == 1 { k ^ 2 } else { k }),
            Self::Reversed => Some(start + count - 1 - k),
        }
    }
}

pub(super) fn inputs(samples: &[Sample]) -> Vec<Input> {
    let mut all = Vec::new();
    if samples.iter().all(|sample| sample.nodes.iter().all(Vec::is_empty)) {
        return all;
    }
    for (beams, of_beam) in BEAMS {
        for (other, from) in OTHERS {
            for (first, last) in [(0, 0), (1, 1), (2, 2), (3, 3), (0, 3), (1, 3), (2, 3)] {
                let range = if first == last {
                    format!("the derivative {first}")
                } else {
                    format!("the derivatives from {first} on")
                };
                for (of, scope) in OF {
                    let words = format!("{range} of {of_beam}: with {from}{scope}");
                    all.push(Input::new(words, move |sample, vectors| {
                        let list: Vec<&Node> = sample.nodes.iter().flatten().collect();
                        let counts = sample.nodes.each_ref().map(Vec::len);
                        let nodes = beams.iter().flat_map(|beam| {
                            sample.nodes[*beam].iter().enumerate().map(|(k, node)| (*beam, k, node))
                        });
                        for (beam, k, node) in nodes {
                            let at = other.of(beam, k, counts).and_then(|at| list.get(at));
                            let with = at.map_or([Vector3::zeros(); 3], |node| node.vectors);
                            let difference = std::array::from_fn(|i| with[i] - node.vectors[i]);
                            for order in first..=last {
                                add(vectors, (beam, order), node.shape[order], difference, of);
                            }
                        }
                    }));
                }
            }
        }
    }
    all
}
