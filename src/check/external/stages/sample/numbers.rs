//! The numbers of a program along directions, in the conventions of this library.

use crate::check::Answer;
use crate::check::external::answers::Answers;
use crate::check::external::compare::{Demands, half_unit};
use crate::check::external::conventions::{Conventions, Length, Penalty, Range};
use crate::linearization::{COMPONENTS, Quantity};
use crate::number::{Real, RunningError};

/// The numbers of a component: value, delta, Delta and Delta-delta, where they are answered.
type Numbers = [Option<RunningError>; 4];

/// The numbers of a program along two directions; nothing if an array has another number of entries. Either variations or
/// gradients and Hessians are used. The bounds are what rounding explains: as much as of the exact numbers.
pub(super) fn own_numbers(
    answers: &Answers,
    dq: [&[f64]; 2],
    demands: &Demands,
    exact: &[[RunningError; 4]; COMPONENTS],
    of_variations: bool,
) -> Option<[Numbers; COMPONENTS]> {
    let mut own = [[None; 4]; COMPONENTS];
    for answer in &answers.answers {
        let axis = answer.axis.map_or(0, |axis| axis as usize - 'x' as usize);
        let component = answer.quantity.component() + axis;
        own[component] =
            stated(component, contracted(answer, dq, demands, of_variations)?, &demands.conventions);
    }
    for (numbers, exact) in own.iter_mut().zip(exact) {
        for (number, exact) in numbers.iter_mut().zip(exact) {
            if let Some(number) = number {
                let growth = (number.value / exact.value).abs();
                number.bound += exact.bound * if growth.is_finite() { growth.clamp(1.0, 1e6) } else { 1.0 };
            }
        }
    }
    Some(own)
}

/// The answers of a contact element.
#[derive(Clone, Debug)]
pub(in crate::check::external::stages) struct Element {
    /// The residual along both directions, and the tangent, where they are answered.
    pub(in crate::check::external::stages) numbers: [Option<RunningError>; 3],
    /// The penalty stiffness of an element without friction, or zero at an open gap.
    pub(in crate::check::external::stages) stiffness: Option<f64>,
}

/// The answers of a contact element along two directions. `has_data`: it has a law and a history of its own.
pub(super) fn element(
    answers: &Answers,
    dq: [&[f64]; 2],
    demands: &Demands,
    is_closed: bool,
    has_data: bool,
) -> Option<Element> {
    let conventions = &demands.conventions;
    let stiffness = |penalty: Penalty| if penalty.always || is_closed { penalty.stiffness } else { 0.0 };
    let stiffness = conventions.penalty.filter(|_| !has_data).map(stiffness);
    if stiffness.is_none() && !has_data {
        return None;
    }
    let (gradient, hessian) = (answers.residual.clone(), answers.tangent.clone());
    let of = Answer { gradient, hessian, ..Answer::of(Quantity::GN) };
    let [_, delta, linear, second] = contracted(&of, dq, demands, false)?;
    let signed =
        |number: Option<RunningError>, is_negative: bool| number.map(|of| if is_negative { -of } else { of });
    let numbers = [
        signed(delta, conventions.residual_is_negative),
        signed(linear, conventions.residual_is_negative),
        signed(second, conventions.tangent_is_negative),
    ];
    Some(Element { numbers, stiffness })
}

/// An answer along the directions. Nothing if an array has another number of entries.
fn contracted(
    answer: &Answer,
    [dq, linear_dq]: [&[f64]; 2],
    demands: &Demands,
    of_variations: bool,
) -> Option<Numbers> {
    let half = demands.digits.map_or(0.0, half_unit);
    let size = dq.len();
    let sum = |entries: &mut dyn Iterator<Item = f64>| {
        let (value, absolute, squares) = entries.fold((0.0, 0.0, 0.0), |(sum, absolute, squares), of| {
            (sum + of, absolute + of.abs(), squares + of * of)
        });
        #[expect(clippy::cast_precision_loss, reason = "a count of dofs")]
        let rounding = f64::EPSILON * (size as f64) * absolute;
        RunningError { value, bound: rounding + 4.0 * half * f64::sqrt(squares) }
    };
    let single = |number: Option<f64>| number.map(|value| RunningError { value, bound: half * value.abs() });
    let mut numbers = [single(answer.value), None, None, None];
    if of_variations {
        for (number, variation) in numbers[1..].iter_mut().zip(answer.variations) {
            *number = single(variation);
        }
        return Some(numbers);
    }
    if let Some(gradient) = &answer.gradient {
        if gradient.len() != size {
            return None;
        }
        let along = |dq: &[f64]| sum(&mut gradient.iter().zip(dq).map(|(entry, dq)| entry * dq));
        (numbers[1], numbers[2]) = (Some(along(dq)), Some(along(linear_dq)));
    }
    if let Some(hessian) = &answer.hessian {
        if hessian.len() != size * size {
            return None;
        }
        let [rows, columns] =
            if demands.conventions.column_major { [linear_dq, dq] } else { [dq, linear_dq] };
        let entry = |i: usize| hessian[i] * rows[i / size] * columns[i % size];
        numbers[3] = Some(sum(&mut (0..size * size).map(entry)));
    }
    Some(numbers)
}

/// The numbers of a component in the conventions of this library.
fn stated(component: usize, numbers: Numbers, conventions: &Conventions) -> Numbers {
    let times = |factor: f64| {
        numbers.map(|number| {
            number.map(|of| RunningError { value: factor * of.value, bound: factor.abs() * of.bound })
        })
    };
    match Quantity::of_component(component) {
        Quantity::DVector if conventions.d_is_negative => times(-1.0),
        Quantity::GN if conventions.gap_is_negative => times(-1.0),
        Quantity::TVector | Quantity::TBarVector | Quantity::T | Quantity::TBar
            if conventions.parameter == Range::Unit =>
        {
            times(0.5)
        }
        Quantity::Xi | Quantity::XiBar if conventions.parameter == Range::Unit => {
            let [value, rest @ ..] = times(2.0);
            let [delta, linear, second] = rest;
            [value.map(|of| of - RunningError::from(1.0)), delta, linear, second]
        }
        Quantity::D if conventions.length != Length::Distance => {
            // s = f d²: δs = 2 f d δd, Δδs = 2 f (δd Δd + d Δδd).
            let two_f = RunningError::from(if conventions.length == Length::Square { 2.0 } else { 1.0 });
            let [value, delta, linear, second] = numbers;
            let Some(d) = value.map(|s| (s * RunningError::from(2.0) / two_f).sqrt()) else {
                return [None; 4];
            };
            let [delta, linear] = [delta, linear].map(|of| of.map(|of| of / (two_f * d)));
            let second = second.map(|of| {
                let product = delta.zip(linear).map_or(RunningError::from(0.0), |(one, other)| one * other);
                (of / two_f - product) / d
            });
            [Some(d), delta, linear, second]
        }
        _ => numbers,
    }
}
