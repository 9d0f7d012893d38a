//! The edits, largest first.

use super::super::CaseData;
use super::{frame, simpler};
use crate::test_beam::{Family, TestBeam, Unit};

/// A change of a case that may make it smaller.
#[derive(Clone, Copy, Debug)]
pub(super) enum Edit {
    /// Another family for one beam, with the same point and tangent.
    Family(usize, Family),
    /// No radii and no reference parameters; or one of the four.
    Contact(Option<usize>),
    /// One dof varies, by one, and no other; of both beams.
    Only(List, usize, usize),
    /// No dof of this beam varies.
    Still(List, usize),
    /// The closest point and t on the first axis, t_bar in the first plane; and all dofs rounded to this many binary
    /// digits.
    Frame(i32),
    /// All dofs of one beam rounded to this many binary digits.
    Round(usize, i32),
    /// Knots at equal distances, weights of one, the length of a reference beam 2, and no rotation.
    Plain(usize),
    /// A node, or a weight, like its neighbours.
    Straight(usize, usize),
    /// One number set to zero or one, or rounded to this many binary digits.
    Number(usize, List, usize, To),
}

/// The lists of numbers of a beam.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum List {
    Parameters,
    Q,
    Dq,
    LinearDq,
}

/// The new value of a number.
#[derive(Clone, Copy, Debug)]
pub(super) enum To {
    Zero,
    One,
    Digits(i32),
}

/// All edits of a case.
pub(super) fn edits(case: &CaseData) -> Vec<Edit> {
    let mut edits = Vec::new();
    let dofs = |beam: usize| case.test_beams[beam].q.len();
    let all_dofs = || [0, 1].into_iter().flat_map(move |beam| (0..dofs(beam)).map(move |i| (beam, i)));
    for beam in [0, 1] {
        edits.extend(simpler::FAMILIES.map(|family| Edit::Family(beam, family)));
    }
    edits.push(Edit::Contact(None));
    edits.extend((0..4).map(|which| Edit::Contact(Some(which))));
    for list in [List::Dq, List::LinearDq] {
        edits.extend([0, 1].map(|beam| Edit::Still(list, beam)));
        edits.extend(all_dofs().map(|(beam, i)| Edit::Only(list, beam, i)));
    }
    edits.extend([0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32].map(Edit::Frame));
    edits.extend([0, 1].map(Edit::Plain));
    for digits in [0, 1, 2, 3, 4, 6, 8, 12, 16] {
        edits.extend([0, 1].map(|beam| Edit::Round(beam, digits)));
    }
    edits.extend(all_dofs().map(|(beam, i)| Edit::Straight(beam, i)));
    for list in [List::Dq, List::LinearDq, List::Q, List::Parameters] {
        for beam in [0, 1] {
            for i in 0..numbers(&case.test_beams[beam], list).len() {
                edits.extend([To::Zero, To::One].map(|to| Edit::Number(beam, list, i, to)));
                edits.extend((0..6).map(|digits| Edit::Number(beam, list, i, To::Digits(digits))));
            }
        }
    }
    edits
}

impl Edit {
    /// The changed case; nothing if the edit does not change it.
    pub(super) fn apply(self, case: &CaseData) -> Option<CaseData> {
        let mut edited = case.clone();
        match self {
            Self::Family(beam, family) => edited.test_beams[beam] = simpler::simpler(case, beam, family)?,
            Self::Contact(which) => {
                let contact = &mut edited.contact;
                let all =
                    [&mut contact.radius, &mut contact.radius_bar, &mut contact.xi_0, &mut contact.xi_bar_0];
                for (i, number) in all.into_iter().enumerate() {
                    if which.is_none_or(|which| which == i) {
                        *number = 0.0;
                    }
                }
            }
            Self::Only(list, beam, i) => {
                edited.test_beams.iter_mut().for_each(|test_beam| numbers_mut(test_beam, list).fill(0.0));
                *numbers_mut(&mut edited.test_beams[beam], list).get_mut(i)? = 1.0;
            }
            Self::Still(list, beam) => numbers_mut(&mut edited.test_beams[beam], list).fill(0.0),
            Self::Frame(digits) => {
                edited = frame::framed(case)?;
                edited.test_beams.iter_mut().for_each(|test_beam| round(test_beam, digits));
            }
            Self::Round(beam, digits) => round(&mut edited.test_beams[beam], digits),
            Self::Plain(beam) => plain(&mut edited.test_beams[beam]),
            Self::Straight(beam, i) => straighten(&mut edited.test_beams[beam], i)?,
            Self::Number(beam, list, i, to) => {
                let number = numbers_mut(&mut edited.test_beams[beam], list).get_mut(i)?;
                *number = match to {
                    To::Zero => 0.0,
                    To::One => 1.0,
                    To::Digits(digits) => rounded(*number, digits),
                };
            }
        }
        (edited != *case).then_some(edited)
    }
}

fn numbers(test_beam: &TestBeam, list: List) -> &Vec<f64> {
    match list {
        List::Parameters => &test_beam.parameters,
        List::Q => &test_beam.q,
        List::Dq => &test_beam.dq,
        List::LinearDq => &test_beam.linear_dq,
    }
}

fn numbers_mut(test_beam: &mut TestBeam, list: List) -> &mut Vec<f64> {
    match list {
        List::Parameters => &mut test_beam.parameters,
        List::Q => &mut test_beam.q,
        List::Dq => &mut test_beam.dq,
        List::LinearDq => &mut test_beam.linear_dq,
    }
}

/// The nearest multiple of 2^-digits.
fn rounded(number: f64, digits: i32) -> f64 {
    let unit = 2.0_f64.powi(-digits);
    // Avoids a minus sign in front of zero.
    (number / unit).round() * unit + 0.0
}

fn round(test_beam: &mut TestBeam, digits: i32) {
    for list in [List::Q, List::Dq, List::LinearDq] {
        for number in numbers_mut(test_beam, list) {
            *number = rounded(*number, digits);
        }
    }
}

fn plain(test_beam: &mut TestBeam) {
    let mut places = test_beam.parameters.iter_mut();
    for &(name, count) in test_beam.family.parameters() {
        let equidistant = (0..).map(f64::from);
        for (parameter, knot) in places.by_ref().take(count).zip(equidistant) {
            *parameter = match name {
                "knots" => knot,
                "weights" | "half_angle" => 1.0,
                "length" => 2.0,
                _ => *parameter,
            };
        }
    }
    if let Some(start) = test_beam.family.quaternion() {
        test_beam.q[start..start + 4].copy_from_slice(&[1.0, 0.0, 0.0, 0.0]);
    }
    if test_beam.family == Family::NurbsWeighted {
        test_beam.q.iter_mut().skip(3).step_by(4).for_each(|weight| *weight = 1.0);
    }
}

/// A coordinate of a node is set to the mean of those of its neighbours.
fn straighten(test_beam: &mut TestBeam, i: usize) -> Option<()> {
    let units = test_beam.family.units();
    let node = if test_beam.family == Family::NurbsWeighted { 4 } else { 3 };
    let (before, after) = (i.checked_sub(node)?, i + node);
    let is_point = |i: usize| units.get(i) == Some(&Unit::Point);
    if !(is_point(before) && is_point(i) && is_point(after)) {
        return None;
    }
    test_beam.q[i] = 0.5 * (test_beam.q[before] + test_beam.q[after]);
    Some(())
}
