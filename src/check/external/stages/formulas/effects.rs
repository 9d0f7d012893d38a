//! The effect of a change on an answer that is of first degree in what is changed.
//!
//! To evaluate all formulas again is slow. The derivatives of the answer by all names are evaluated once. The effect of a
//! change is the product of its own values with them. It is exact where the answer is of first degree in the names that are
//! changed, as it is in most, because derivatives are of first degree in each other.

use super::change::Change;
use super::list::FORMULAS;
use super::names::{Set, WAYS};
use super::outputs::Output;
use super::point::{Answer, Point};
use super::tree::{Name, Op, Tree};
use super::values::{Value, value};
use super::ways::Ways;
use crate::check::external::stages::sample::Sample;
use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, OnceLock, RwLock};

/// What a change does to some answers.
pub(super) struct Effects<'a> {
    /// The results, which may be written in some ways where these parameters are held, with the answers to them.
    results: Vec<(Output, [bool; WAYS], Vec<Answered<'a>>)>,
    /// By the names of changes.
    of_names: RwLock<HashMap<Set, Arc<OfNames>>>,
}

/// What depends on the names of a change.
struct OfNames {
    /// The ways of writing in which each result is of first degree in them.
    of_first_degree: Vec<[bool; WAYS]>,
    /// They and all that follows from them in each way.
    affected: [Set; WAYS],
}

/// The answer of a sample, with its derivatives by all names in each way of writing.
struct Answered<'a> {
    point: &'a Point<'a>,
    answer: &'a Answer,
    derivatives: [OnceLock<Vec<Value>>; WAYS],
}

impl<'a> Effects<'a> {
    /// The effects on wrong answers at these samples, and on right ones that follow from nothing else.
    pub(super) fn new(probes: &[&'a Point<'a>], wrong: &Ways, right: &Ways) -> Self {
        let mut all: BTreeMap<_, Vec<Answered>> = BTreeMap::new();
        for of in probes.iter().flat_map(|point| Answered::all(point)) {
            all.entry((of.answer.output, of.point.sample.held)).or_default().push(of);
        }
        let results = all.into_iter().filter_map(|((output, held), answers)| {
            let ways = wrong.of_answer((output, held)).or_else(|| right.of_answer((output, held)))?;
            Some((output, ways, answers))
        });
        Self { results: results.collect(), of_names: RwLock::default() }
    }

    /// Whether a change may yield these answers.
    pub(super) fn may_yield(&self, change: &Change) -> bool {
        if change.is_stored || change.is_of_derivatives || change.entries.is_some() {
            return true;
        }
        let names = change.names();
        let uses = change.uses(names);
        let used = names.or(uses);
        let OfNames { of_first_degree, affected } = &*self.of_names(names);
        let mut known = Vec::new();
        self.results.iter().zip(of_first_degree).all(|((_, ways, answers), of_first_degree)| {
            (0..WAYS).filter(|way| ways[*way]).any(|way| {
                !of_first_degree[way]
                    // What stands in the place of a formula must have its right value.
                    || !uses.and(affected[way]).is_empty()
                    || answers.iter().filter(|of| of.answer.ways[way]).all(|of| {
                        let effect = of.effect(way, (change, used), &mut known);
                        of.point.is_near(of.answer, way, effect)
                    })
            })
        })
    }

    fn of_names(&self, names: Set) -> Arc<OfNames> {
        let known = self.of_names.read().ok().and_then(|known| known.get(&names).cloned());
        known.unwrap_or_else(|| {
            let mut of_first_degree = vec![[false; WAYS]; self.results.len()];
            for way in 0..WAYS {
                let degrees = degrees(way, names);
                for (of, (output, ..)) in of_first_degree.iter_mut().zip(&self.results) {
                    of[way] = degrees.is_some_and(|degrees| degrees[output.name] <= 1);
                }
            }
            let of = Arc::new(OfNames {
                of_first_degree,
                affected: std::array::from_fn(|way| affected(way, names)),
            });
            if let Ok(mut known) = self.of_names.write() {
                known.insert(names, Arc::clone(&of));
            }
            of
        })
    }
}

/// These names and all that follows from them.
fn affected(way: usize, names: Set) -> Set {
    names.names().fold(names, |all, name| all.or(FORMULAS.relations[way].follows[name]))
}

/// The sample, the way of writing, and how the values of what is changed differ there.
type Differences<'a> = (&'a Sample, usize, Vec<Value>);

impl<'a> Answered<'a> {
    fn all(point: &'a Point<'a>) -> Vec<Self> {
        let of = |answer| Self { point, answer, derivatives: Default::default() };
        point.answers.iter().map(of).collect()
    }

    /// What the change adds to the answer. `used` are the names in it.
    fn effect(&self, way: usize, (change, used): (&Change, Set), known: &mut Vec<Differences<'a>>) -> f64 {
        let Point { values, given, .. } = self.point;
        let derivatives =
            self.derivatives[way].get_or_init(|| derivatives(&values[way], given, self.answer.output, way));
        let is_affected = |(name, _): &(Name, Tree)| !derivatives[*name].is_zero();
        if !change.new.iter().any(is_affected) {
            return 0.0;
        }
        // Most values are the same in all ways.
        let is_same = |(sample, other, _): &Differences| {
            std::ptr::eq(*sample, self.point.sample) && used.and(self.point.unlike(way, *other)).is_empty()
        };
        let place = known.iter().position(is_same).unwrap_or_else(|| {
            let right = &self.point.values[way][..];
            let of = |(name, tree): &(Name, Tree)| value(tree, right).plus(right[*name].negative());
            known.push((self.point.sample, way, change.new.iter().map(of).collect()));
            known.len() - 1
        });
        let of = change.new.iter().zip(&known[place].2);
        let of = of.filter(|((name, _), _)| !derivatives[*name].is_zero());
        of.map(|((name, _), difference)| derivatives[*name].along(*difference).number().value).sum()
    }
}

/// The degree of each result in these names, unless one of them follows from another.
fn degrees(way: usize, names: Set) -> Option<[u8; Set::NAMES]> {
    let follows = &FORMULAS.relations[way].follows;
    let after = |name: Name| follows[name].without(Set::from_iter([name]));
    let after = names.names().fold(Set::default(), |all, name| all.or(after(name)));
    if !after.and(names).is_empty() {
        return None;
    }
    let mut degrees = [0; Set::NAMES];
    names.names().for_each(|name| degrees[name] = 1);
    for name in after.names() {
        degrees[name] = degree(&FORMULAS.step(way, name).tree, &degrees);
    }
    Some(degrees)
}

/// The degree of a formula in some names, of which these are the degrees: 0, 1, or 2 for all others.
fn degree(tree: &Tree, degrees: &[u8; Set::NAMES]) -> u8 {
    let of = |i: usize| degree(&tree.of[i], degrees);
    let all = 0..tree.of.len();
    let only_constant = |degree: u8| if degree > 0 { 2 } else { 0 };
    let found = match &tree.op {
        Op::Number(_) => 0,
        Op::Name(name) => degrees[*name],
        Op::Product(divides) => all.map(|i| if divides[i] { only_constant(of(i)) } else { of(i) }).sum(),
        Op::Dot | Op::Cross => all.map(of).sum(),
        Op::Sum(_) | Op::Axes(_) => all.map(of).max().unwrap_or(0),
        Op::Root => only_constant(of(0)),
        Op::Less => only_constant(of(0).max(of(1))),
        Op::If => only_constant(of(0)).max(of(1)).max(of(2)),
    };
    found.min(2)
}

/// The derivatives of a result by all names: those of each step follow from those of the steps that use it.
pub(super) fn derivatives(
    right: &[Value],
    given: &[(Name, Value)],
    output: Output,
    way: usize,
) -> Vec<Value> {
    let mut derivatives = vec![Value::from(0.0); right.len()];
    derivatives[output.name] = Value::of_axis(output.axis);
    for step in FORMULAS.ways[way].iter().rev().filter(|step| step.name <= output.name) {
        let by = derivatives[step.name];
        // What is given stays as it is.
        if given.iter().any(|(name, _)| *name == step.name) {
            derivatives[step.name] = Value::from(0.0);
        } else if !by.is_zero() {
            add_derivatives(&step.tree, by, right, &mut derivatives);
        }
    }
    derivatives
}

/// Adds the derivatives by the names of a formula, if that by the formula is known.
fn add_derivatives(tree: &Tree, by: Value, right: &[Value], to: &mut [Value]) {
    let at = |i: usize| value(&tree.of[i], right);
    let mut add = |i: usize, by: Value| add_derivatives(&tree.of[i], by, right, to);
    match &tree.op {
        Op::Number(_) | Op::Less => {}
        Op::Name(name) => to[*name] = to[*name].plus(by),
        Op::Sum(minus) => {
            for (i, &minus) in minus.iter().enumerate() {
                add(i, if minus { by.negative() } else { by });
            }
        }
        Op::Product(divides) => {
            for (i, &is_divisor) in divides.iter().enumerate() {
                let others = (0..divides.len()).filter(|k| *k != i).fold(Value::from(1.0), |product, k| {
                    if divides[k] { product.over(at(k)) } else { product.times(at(k)) }
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
        Op::Axes(_) => add(0, Value::NOT_A_NUMBER),
        Op::Root => add(0, by.over(value(tree, right).times(Value::from(2.0)))),
        Op::If => match at(0).number().value {
            condition if condition.is_nan() => add(1, Value::NOT_A_NUMBER),
            0.0 => add(2, by),
            _ => add(1, by),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::super::point::points;
    use super::super::tests::{all_changes, right_answers};
    use super::{Answered, Change, FORMULAS, Name, Set, Tree, WAYS, degrees, value};
    use crate::check::candidate::CAREFUL;
    use crate::test_beam::Family;
    use std::collections::HashSet;

    /// Where an answer is of first degree in what is changed, its derivatives tell the effect of any change.
    #[test]
    fn effects_are_those_of_the_changed_formulas() {
        let samples = right_answers(&[Family::Hermite]);
        let points: Vec<_> = points(&samples, Set::default()).into_iter().step_by(20).collect();
        let needed = (0..FORMULAS.names.0.len()).collect();
        let answered: Vec<Vec<Answered>> = points.iter().map(Answered::all).collect();
        let (mut equal, mut affected) = (0, 0);
        // One change of each set of names.
        let mut sets = HashSet::new();
        let is_tried = |change: &&&Change| {
            let is_plain = !change.is_stored && !change.is_of_derivatives && change.entries.is_none();
            is_plain && sets.insert(change.names())
        };
        for change in all_changes().iter().filter(is_tried) {
            let used = change.names().or(change.uses(change.names()));
            for (way, (point, answers)) in
                (0..WAYS).flat_map(|way| points.iter().zip(&answered).map(move |of| (way, of)))
            {
                let Some(degrees) = degrees(way, change.names()) else { continue };
                if !change.uses(change.names()).and(super::affected(way, change.names())).is_empty() {
                    continue;
                }
                let right = &point.values[way][..];
                let is_known = |(_, tree): &(Name, Tree)| !value(tree, right).is_nan();
                if !change.new.iter().all(is_known) {
                    continue;
                }
                let changed = point.changed(way, change, needed);
                for of in answers.iter().filter(|of| degrees[of.answer.output.name] <= 1) {
                    let [before, after] = [of.answer.output.of(right), of.answer.output.of(&changed)];
                    let effect = of.effect(way, (change, used), &mut Vec::new());
                    let (found, allowed) =
                        (after.value - before.value, CAREFUL * (before.bound + after.bound));
                    let is_equal = (effect - found).abs() <= allowed || !found.is_finite();
                    assert!(is_equal, "{}, way {way}: {effect:e}, {found:e}", change.words());
                    equal += 1;
                    affected += u32::from(found.abs() > 1e3 * allowed);
                }
            }
        }
        assert!(equal > 10_000 && affected > 500, "{equal}, {affected}");
    }
}
