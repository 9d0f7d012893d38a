//! Wrong vectors: a factor, a component that is missing, another derivative.

use super::{BEAMS, FACTORS, Input};
use crate::number::RunningError;

const CURVES: [[&str; 4]; 2] = [["x", "t", "t,xi", "t,xixi"], ["x_bar", "t_bar", "t_bar,xi", "t_bar,xixi"]];
const MOVED: [[&str; 3]; 2] = [["du", "du,xi", "du,xixi"], ["du_bar", "du_bar,xi", "du_bar,xixi"]];
const AXES: [&str; 3] = ["x", "y", "z"];

pub(super) fn inputs() -> Vec<Input> {
    let mut all = Vec::new();
    for (beams, of) in BEAMS {
        let (curve, moved) = (CURVES[beams[0]], MOVED[beams[0]]);
        let range = |names: &[&str], first: usize, last: usize| {
            if first == last {
                names[first].to_owned()
            } else {
                format!("{} to {}", names[first], names[last])
            }
        };
        for (first, last) in [(1, 1), (2, 2), (3, 3), (1, 2), (2, 3), (1, 3)] {
            let name = range(&curve, first, last);
            for (by, words) in FACTORS {
                all.push(Input::new(format!("{name} of {of} {words}"), move |_, (curves, _)| {
                    for &b in beams {
                        for v in &mut curves[b][first..=last] {
                            *v = v.map(|c| c * RunningError::from(1.0 + by));
                        }
                    }
                }));
            }
            for (axis, letter) in AXES.iter().enumerate() {
                let words = format!("the component {letter} of {name} of {of} is missing");
                all.push(Input::new(words, move |_, (curves, _)| {
                    for &b in beams {
                        curves[b][first..=last].iter_mut().for_each(|v| v[axis] = RunningError::from(0.0));
                    }
                }));
            }
        }
        for (first, last) in [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)] {
            let name = range(&moved, first, last);
            for (by, words) in FACTORS {
                all.push(Input::new(format!("{name} of {of} {words}"), move |_, (_, moved)| {
                    for side in moved {
                        for &b in beams {
                            for v in &mut side[b][first..=last] {
                                *v = v.map(|c| c * RunningError::from(1.0 + by));
                            }
                        }
                    }
                }));
            }
            for (axis, letter) in AXES.iter().enumerate() {
                let words = format!("the component {letter} of {name} of {of} is missing");
                all.push(Input::new(words, move |_, (_, moved)| {
                    for side in moved {
                        for &b in beams {
                            side[b][first..=last].iter_mut().for_each(|v| v[axis] = RunningError::from(0.0));
                        }
                    }
                }));
            }
        }
        for (order, other) in [(0, 1), (1, 0), (1, 2), (2, 1), (0, 2), (2, 0)] {
            let words = format!("{} of {of} stands in the place of {}", moved[other], moved[order]);
            all.push(Input::new(words, move |_, (_, moved)| {
                for side in moved {
                    for &b in beams {
                        side[b][order] = side[b][other];
                    }
                }
            }));
        }
        for (order, other) in [(1, 2), (2, 1), (2, 3), (3, 2)] {
            let words = format!("{} of {of} stands in the place of {}", curve[other], curve[order]);
            all.push(Input::new(words, move |_, (curves, _)| {
                for &b in beams {
                    curves[b][order] = curves[b][other];
                }
            }));
            let words = format!("{} is added to {} of {of}", curve[other], curve[order]);
            all.push(Input::new(words, move |_, (curves, _)| {
                for &b in beams {
                    let other = curves[b][other];
                    curves[b][order] += other;
                }
            }));
        }
    }
    all
}
