//! The operations of formulas, and lists of them. A list is evaluated faster than a tree.

use super::axes::AXES;
use super::tree::{Name, Op, Tree};
use super::values::{Number, Value, Values};
use std::ops::Range;

/// The place of a value.
pub(super) type Place = u16;

/// What yields a value from others.
#[derive(Clone, Copy, Debug)]
pub(super) enum Operation {
    Same,
    Negative,
    Plus,
    Minus,
    Times,
    Over,
    Dot,
    Cross,
    /// The place in [`AXES`].
    Axes(usize),
    Root,
    Single,
    Less,
    If,
}

impl Operation {
    /// That of a node whose number of branches is fixed.
    fn of_node(op: &Op) -> Self {
        match op {
            Op::Number(_) | Op::Name(_) | Op::Sum(_) | Op::Product(_) => Self::Same,
            Op::Dot => Self::Dot,
            Op::Cross => Self::Cross,
            Op::Root => Self::Root,
            Op::Single => Self::Single,
            Op::Axes(axes) => Self::Axes(*axes),
            Op::Less => Self::Less,
            Op::If => Self::If,
        }
    }

    /// The value that it yields from those `at` 0, 1 and 2. A comparison within rounding is not a number.
    #[inline]
    fn of<S: Number>(self, at: impl Fn(usize) -> Value<S>) -> Value<S> {
        match self {
            Self::Same => at(0),
            Self::Negative => at(0).negative(),
            Self::Plus => at(0).plus(at(1)),
            Self::Minus => at(0).plus(at(1).negative()),
            Self::Times => at(0).times(at(1)),
            Self::Over => at(0).over(at(1)),
            Self::Dot => at(0).dot(at(1)),
            Self::Cross => at(0).cross(at(1)),
            Self::Axes(axes) => at(0).with_axes(&AXES[axes].0),
            Self::Root => Value::Number(at(0).number().sqrt()),
            Self::Single => at(0).in_single_precision(),
            Self::Less => at(0).number().is_less(at(1).number()).map_or(Value::NOT_A_NUMBER, Value::from),
            Self::If => match at(0).number().value() {
                condition if condition.is_nan() => Value::NOT_A_NUMBER,
                0.0 => at(2),
                _ => at(1),
            },
        }
    }
}

/// An operation with the places of its values.
#[derive(Clone, Copy, Debug)]
struct Step {
    operation: Operation,
    of: [Place; 3],
    to: Place,
}

/// Where a value is: known before the evaluation, or in a place.
#[derive(Clone, Copy, Debug)]
pub(super) enum At {
    Known(Value<f64>),
    Place(Place),
}

/// Operations on values by their places.
#[derive(Debug, Default)]
pub(super) struct Operations {
    steps: Vec<Step>,
    /// The values that are known before.
    constants: Vec<(Place, Value<f64>)>,
    /// The number of places.
    places: Place,
    /// Whether operations on known values alone are done at once. Their rounding is lost.
    is_folded: bool,
}

impl Operations {
    /// Those of many formulas that may share places: the first ones are those of names, by number.
    pub(super) fn of_formulas<'a>(
        names: usize,
        formulas: impl Iterator<Item = (Name, &'a Tree)> + Clone,
    ) -> (Self, Vec<Range<usize>>) {
        let mut all = Self { places: place(names), ..Self::default() };
        formulas.clone().for_each(|(_, tree)| all.add_constants(tree));
        let (first, mut most) = (all.places, all.places);
        let mut ranges = Vec::new();
        for (name, tree) in formulas {
            all.places = first;
            ranges.push(all.add(tree, place(name), &|name| At::Place(place(name))));
            most = most.max(all.places);
        }
        all.places = most;
        (all, ranges)
    }

    /// None yet. Operations on known values are done at once.
    pub(super) fn folded() -> Self {
        Self { is_folded: true, ..Self::default() }
    }

    /// The number of steps.
    pub(super) fn len(&self) -> usize {
        self.steps.len()
    }

    fn add_constants(&mut self, tree: &Tree) {
        if let Op::Number(number) = tree.op {
            self.place(At::Known(Value::from(number)));
        }
        tree.of.iter().for_each(|of| self.add_constants(of));
    }

    /// A new place.
    pub(super) fn new_place(&mut self) -> Place {
        self.places += 1;
        self.places - 1
    }

    fn place(&mut self, at: At) -> Place {
        let value = match at {
            At::Place(place) => return place,
            At::Known(value) => value,
        };
        let known = self.constants.iter().find(|(_, known)| *known == value).map(|(place, _)| *place);
        known.unwrap_or_else(|| {
            let place = self.new_place();
            self.constants.push((place, value));
            place
        })
    }

    /// Adds the evaluation of a formula to a place: which steps it has.
    fn add(&mut self, tree: &Tree, to: Place, of_name: &dyn Fn(Name) -> At) -> Range<usize> {
        let first = self.steps.len();
        let at = self.steps_of(tree, of_name);
        let own = self.steps.len();
        match self.steps.last_mut() {
            Some(last) if own > first && matches!(at, At::Place(place) if place == last.to) => last.to = to,
            _ => {
                let of = [self.place(at); 3];
                self.steps.push(Step { operation: Operation::Same, of, to });
            }
        }
        first..self.steps.len()
    }

    /// Adds the steps of a formula: where its value is.
    pub(super) fn steps_of(&mut self, tree: &Tree, of_name: &dyn Fn(Name) -> At) -> At {
        let number = |number: f64| At::Known(Value::from(number));
        let at = |all: &mut Self, i: usize| all.steps_of(&tree.of[i], of_name);
        match &tree.op {
            Op::Number(value) => number(*value),
            Op::Name(name) => of_name(*name),
            Op::Sum(minus) => {
                let first = at(self, 0);
                let first = if minus.has(0) { self.step(Operation::Negative, &[first]) } else { first };
                (1..minus.len()).fold(first, |sum, i| {
                    let term = at(self, i);
                    self.step(if minus.has(i) { Operation::Minus } else { Operation::Plus }, &[sum, term])
                })
            }
            Op::Product(divides) => {
                let from = usize::from(!divides.has(0));
                let first = if divides.has(0) { number(1.0) } else { at(self, 0) };
                (from..divides.len()).fold(first, |product, i| {
                    let factor = at(self, i);
                    self.step(
                        if divides.has(i) { Operation::Over } else { Operation::Times },
                        &[product, factor],
                    )
                })
            }
            op => {
                let first = at(self, 0);
                if let (Op::If, At::Known(condition), true) = (op, first, self.is_folded) {
                    return match condition.number() {
                        condition if condition.is_nan() => At::Known(Value::NOT_A_NUMBER),
                        condition => at(self, if condition == 0.0 { 2 } else { 1 }),
                    };
                }
                let others = (1..tree.of.len()).map(|i| at(self, i));
                let of: Vec<At> = std::iter::once(first).chain(others).collect();
                self.step(Operation::of_node(op), &of)
            }
        }
    }

    /// Adds an operation.
    fn step(&mut self, operation: Operation, of: &[At]) -> At {
        let known = |i: usize| match of.get(i).or(of.last()) {
            Some(At::Known(value)) => Some(*value),
            _ => None,
        };
        if self.is_folded
            && let [Some(first), Some(second), Some(third)] = [0, 1, 2].map(known)
        {
            return At::Known(operation.of(|i| [first, second, third][i]));
        }
        let mut places = [0; 3];
        for (i, place) in places.iter_mut().enumerate() {
            *place = self.place(of[i.min(of.len() - 1)]);
        }
        let to = self.new_place();
        self.steps.push(Step { operation, of: places, to });
        At::Place(to)
    }

    /// The values in all places: the first ones, then constants, and zero elsewhere.
    pub(super) fn start<S: Number>(&self, first: &[Value<S>], values: &mut Vec<Value<S>>) {
        values.clear();
        values.reserve(usize::from(self.places));
        values.extend_from_slice(first);
        values.resize(usize::from(self.places), Value::from(0.0));
        for (place, value) in &self.constants {
            values[usize::from(*place)] = value.exact();
        }
    }

    /// The same without first ones. The constants are not kept, so it is asked for once.
    pub(super) fn take_start<S: Number>(&mut self) -> Vec<Value<S>> {
        let mut values = Vec::new();
        self.start(&[], &mut values);
        self.constants = Vec::new();
        self.steps.shrink_to_fit();
        values
    }

    /// Does some of the steps.
    pub(super) fn run<S: Number>(&self, steps: &Range<usize>, values: &mut [Value<S>]) {
        for Step { operation, of, to } in &self.steps[steps.clone()] {
            values[usize::from(*to)] = operation.of(|i| values[usize::from(of[i])]);
        }
    }
}

/// The value of a formula.
pub(super) fn value<S: Number>(tree: &Tree, values: &(impl Values<S> + ?Sized)) -> Value<S> {
    let at = |i: usize| value(&tree.of[i], values);
    match &tree.op {
        Op::Number(number) => Value::from(*number),
        Op::Name(name) => values.at(*name),
        Op::Sum(minus) => {
            let signed = |i: usize| if minus.has(i) { at(i).negative() } else { at(i) };
            (1..minus.len()).fold(signed(0), |sum, i| sum.plus(signed(i)))
        }
        Op::Product(divides) => {
            let first = usize::from(!divides.has(0));
            let start = if divides.has(0) { Value::from(1.0) } else { at(0) };
            (first..divides.len()).fold(start, |product, i| {
                if divides.has(i) { product.over(at(i)) } else { product.times(at(i)) }
            })
        }
        op => Operation::of_node(op).of(at),
    }
}

#[expect(clippy::cast_possible_truncation, reason = "there are few names")]
fn place(name: Name) -> Place {
    name as Place
}
