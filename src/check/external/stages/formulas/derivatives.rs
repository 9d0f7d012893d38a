//! The derivatives of a result by all names.

use super::degrees::Through;
use super::list::FORMULAS;
use super::operations::value;
use super::outputs::Output;
use super::tree::{Name, Op, Tree};
use super::values::{Number, Value};

/// The derivatives of a result by all names, through some of those that follow: those of each step follow from those of the
/// steps that use it.
pub(super) fn derivatives<S: Number>(
    through: Through,
    right: &[Value<S>],
    given: &[(Name, Value)],
    (output, way): (Output, usize),
) -> Vec<Value<S>> {
    let mut derivatives = vec![Value::from(0.0); right.len()];
    // What is changed in derivatives alone is answered right.
    if through != Through::Derivatives || through.has(output.name) {
        derivatives[output.name] = Value::of_axis(output.axis);
    }
    for step in FORMULAS.ways[way].iter().rev().filter(|step| step.name <= output.name) {
        let by = derivatives[step.name];
        // What is given stays as it is.
        if given.iter().any(|(name, _)| *name == step.name) {
            derivatives[step.name] = Value::from(0.0);
        } else if through.has(step.name) && !by.is_zero() {
            add_derivatives(&step.tree, by, right, &mut derivatives);
        }
    }
    derivatives
}

/// Adds the derivatives by the names of a formula, if that by the formula is known.
fn add_derivatives<S: Number>(tree: &Tree, by: Value<S>, right: &[Value<S>], to: &mut [Value<S>]) {
    let at = |i: usize| value(&tree.of[i], right);
    let mut add = |i: usize, by: Value<S>| add_derivatives(&tree.of[i], by, right, to);
    match &tree.op {
        Op::Number(_) | Op::Less => {}
        Op::Name(name) => to[*name] = to[*name].plus(by),
        Op::Sum(minus) => {
            for (i, minus) in minus.iter().enumerate() {
                add(i, if minus { by.negative() } else { by });
            }
        }
        Op::Product(divides) => {
            for (i, is_divisor) in divides.iter().enumerate() {
                let others = (0..divides.len()).filter(|k| *k != i).fold(Value::from(1.0), |product, k| {
                    if divides.has(k) { product.over(at(k)) } else { product.times(at(k)) }
                });
                let by = if others.is_vector() { by.along(others) } else { by.times(others) };
                let square = || at(i).times(at(i));
                add(i, if is_divisor { by.over(square()).negative() } else { by });
            }
        }
        Op::Dot => {
            add(0, by.times(at(1)));
            add(1, by.times(at(0)));
        }
        Op::Cross => {
            add(0, at(1).cross(by));
            add(1, by.cross(at(0)));
        }
        // No right formula has them.
        Op::Axes(_) | Op::Single => add(0, Value::NOT_A_NUMBER),
        Op::Root => add(0, by.over(value(tree, right).times(Value::from(2.0)))),
        Op::If => match at(0).number().value() {
            condition if condition.is_nan() => add(1, Value::NOT_A_NUMBER),
            0.0 => add(2, by),
            _ => add(1, by),
        },
    }
}
