mod products;
mod stages;
mod ways;

use super::change::Change;
use super::changes::CHANGES;
use super::kinds::Class;
use super::list::{FORMULAS, STRAIGHT};
use super::names::{Set, WAYS};
use super::outputs::{RESULTS, names};
use super::point::{Point, points};
use super::values::Values;
use super::{found, of_all};
use crate::check::Regime;
use crate::check::candidate::CAREFUL;
use crate::check::external::stages::sample::{Along, Sample, samples};
use crate::check::external::{AnswerReader, Demands, Drawing, Evaluator};
use crate::linearization::Quantity;
use crate::number::RunningError;
use crate::test_beam::Family;
use std::sync::LazyLock;

pub(super) fn all_changes() -> &'static [&'static Change] {
    static ALL: LazyLock<Vec<&Change>> = LazyLock::new(|| changes_of((0..FORMULAS.names.0.len()).collect()));
    &ALL
}

fn changes_of(needed: Set) -> Vec<&'static Change> {
    Class::KEPT.into_iter().flat_map(|class| CHANGES.of(needed, class, |_| true)).collect()
}

/// Right answers to elements of these families in all regimes.
pub(super) fn right_answers(families: &[Family]) -> Vec<Sample> {
    right_answers_along(Along::Random, families)
}

fn right_answers_along(along: Along, families: &[Family]) -> Vec<Sample> {
    let drawing = Drawing {
        seed: 11,
        regimes: Regime::ALL.to_vec(),
        families: families.to_vec(),
        cases: 6,
        penetrating: false,
        elements: true,
        steps: false,
        work: None,
    };
    let vectors: Vec<_> = (0..drawing.count()).map(|number| drawing.vector(number)).collect();
    let program = Evaluator::default();
    let lines: Vec<_> = vectors.iter().map(|vector| program.line(vector)).collect();
    let text = format!("{}\n{}\n", program.head(), lines.join("\n"));
    let mut reader = AnswerReader::new(text.as_bytes(), "answers").unwrap();
    let answers: Vec<_> = std::iter::from_fn(|| reader.next_answers().unwrap()).collect();
    let of = |i: usize| samples(i, &vectors[i], &answers[i], &Demands::default(), along);
    (0..vectors.len()).flat_map(of).collect()
}

#[test]
fn the_formulas_yield_right_answers_in_each_way_of_writing() {
    let samples = right_answers(&Family::ALL);
    assert!(samples.len() > 100, "{}", samples.len());
    assert_eq!(found(&samples, &|_| Vec::new(), &Vec::new), None);
    // One way is right for straight beams alone.
    let of_segments = right_answers(&[Family::Segment]);
    for way in 0..WAYS {
        let samples = if way == STRAIGHT { &of_segments } else { &samples };
        let is_right = |point: &&Point| point.answers.iter().all(|answer| answer.ways[way]);
        let right = points(samples).iter().filter(is_right).count();
        assert!(right > samples.len() / 2, "way {way}: {right} of {}", samples.len());
    }
}

/// The changes of a formula are left out only where none of them can have an effect.
#[test]
fn a_formula_says_which_names_its_changes_may_give_another_formula() {
    let count = all_changes().len();
    for (names, changes) in CHANGES.of_each_formula() {
        for change in changes {
            assert!(change.names().without(names).is_empty(), "{}", change.words());
        }
    }
    let of_gap = changes_of(FORMULAS.needed([FORMULAS.name("g_N")].into_iter().collect())).len();
    assert!(4 * of_gap < count, "{of_gap} of {count}");
}

/// Where a change is said to have the same values in two ways of writing, it has: also a change of an entry of the inverse
/// matrix, which some ways do not use.
#[test]
fn a_change_is_the_same_in_ways_that_are_said_to_be_the_same() {
    let samples = right_answers(&[Family::Hermite, Family::Arc]);
    let points: Vec<Point> = points(&samples).into_iter().step_by(7).collect();
    let needed =
        FORMULAS.needed(["dxi", "dxi_bar", "Ddxi_bar", "K"].iter().map(|name| FORMULAS.name(name)).collect());
    let inverse: Set = ["i12", "i22"].iter().map(|name| FORMULAS.name(name)).collect();
    let of_inverse =
        all_changes().iter().filter(|change| !change.names().and(inverse).is_empty()).step_by(20);
    let (mut same, mut others) = (0, 0);
    for change in all_changes().iter().step_by(4000).chain(of_inverse) {
        for point in &points {
            let in_first = point.changed(0, change, needed);
            for way in 1..WAYS {
                if !in_first.is_same(point, way, (change, needed)) {
                    others += 1;
                    continue;
                }
                same += 1;
                let in_other = point.changed(way, change, needed);
                // Values that the change does not affect may have other formulas.
                let affected = change
                    .names()
                    .names()
                    .filter(|name| needed.has(*name))
                    .chain(needed.names().filter(|name| in_other.at(*name) != point.values[way][*name]));
                for name in affected {
                    let [one, other] = [in_first.at(name).number(), in_other.at(name).number()];
                    let allowed = CAREFUL * (one.bound + other.bound);
                    let is_same = one.value.to_bits() == other.value.to_bits()
                        || (one.value - other.value).abs() <= allowed;
                    let is_near = is_same || one.value.is_nan() || allowed.is_nan();
                    assert!(
                        is_near,
                        "{}: {}, way {way}: {one:?}, {other:?}",
                        change.words(),
                        FORMULAS.names.0[name]
                    );
                }
            }
        }
    }
    assert!(same > 100 && others > 100, "{same}, {others}");
}

/// The sample with the answers of the changed formulas.
fn answered(sample: &Sample, change: &Change) -> Sample {
    answered_in(0, sample, change)
}

/// The same in a way of writing.
fn answered_in(way: usize, sample: &Sample, change: &Change) -> Sample {
    let mut sample = sample.clone();
    let own = sample.clone();
    let of = points(std::slice::from_ref(&own));
    let (Some(element), [point]) = (&mut sample.element, &of[..]) else { return sample };
    let values = point.changed(way, change, (0..FORMULAS.names.0.len()).collect());
    let number = |name: &str| {
        let RunningError { value, .. } = values.at(FORMULAS.name(name)).number();
        RunningError { value, bound: f64::EPSILON * value.abs() }
    };
    element.numbers = [Some(number("R")), None, Some(number("K"))];
    for (name, force) in &mut sample.inputs.forces {
        *force = number(&FORMULAS.names.0[*name]);
    }
    sample
}

/// The sample with the geometry of the changed formulas, and without its element.
fn with_geometry(way: usize, sample: &Sample, change: &Change) -> Sample {
    let mut own = Sample { element: None, ..sample.clone() };
    own.inputs.forces.clear();
    let [point] = &points(std::slice::from_ref(&own))[..] else { unreachable!() };
    let values = point.changed(way, change, (0..FORMULAS.names.0.len()).collect());
    let mut sample = own.clone();
    let mut outputs = point.answers.iter().map(|answer| answer.output);
    for (component, numbers) in sample.own.iter_mut().enumerate() {
        let is_result = names(Quantity::of_component(component)).map(|name| name.is_some());
        for number in numbers.iter_mut().zip(is_result).filter(|(_, is)| *is).flat_map(|(of, _)| of) {
            let RunningError { value, .. } = outputs.next().unwrap().of(&values);
            *number = RunningError { value, bound: f64::EPSILON * value.abs() };
        }
    }
    sample
}

/// The same for the geometry, with changes of each kind.
#[test]
fn a_wrong_geometry_is_explained() {
    let samples: Vec<Sample> = right_answers(&[Family::Hermite]).into_iter().step_by(2).collect();
    let (mut seen, mut known, mut hidden) = (0, 0, 0);
    let of_geometry = FORMULAS.needed(RESULTS.iter().copied().collect()).or((0..FORMULAS.inputs).collect());
    let is_of_geometry =
        |change: &Change| change.uses(change.names()).or(change.names()).without(of_geometry).is_empty();
    // An error of the tangent alone is looked for where a tangent is answered.
    let of_tangent = |change: &Change| change.words().ends_with("in the tangent alone");
    let is_tried = |change: &&&Change| change.ways[0] && is_of_geometry(change);
    let tried = || all_changes().iter().filter(is_tried);
    let of_entries = tried().filter(|change| change.entries.is_some()).step_by(80);
    let stored = tried().filter(|change| change.is_stored && change.entries.is_none()).step_by(900);
    let all = tried().step_by(4000).filter(|change| !of_tangent(change));
    for change in all.chain(of_entries).chain(stored) {
        let answered: Vec<Sample> = samples.iter().map(|sample| with_geometry(0, sample, change)).collect();
        let wrong = points(&answered)
            .iter()
            .filter(|point| point.is_wrong(RESULTS.iter().copied().collect()))
            .count();
        let mut numbers = answered.iter().flat_map(|sample| &sample.own).flatten().flatten();
        if wrong < 8 || !numbers.all(|number| number.value.is_finite()) {
            continue;
        }
        seen += 1;
        let causes = of_all(&answered);
        if causes.is_empty() {
            // A change is not told if rounding explains much more with it than before at some sample.
            let among: Set = RESULTS.iter().copied().collect();
            let is_hidden = points(&answered).iter().any(|point| {
                let changed = point.changed(0, change, FORMULAS.needed(among));
                point.among(among).any(|answer| !point.is_explained(answer, 0, &changed))
            });
            assert!(is_hidden, "not explained: {}", change.words());
            hidden += 1;
        }
        known += usize::from(causes.iter().any(|cause| cause.words == change.words()));
    }
    assert!(seen >= 20 && 2 * known >= seen, "{known} of {seen} are told with the same words");
    assert!(hidden <= 1, "{hidden} of {seen} are hidden by rounding");
}

/// Some changes of all kinds: the answers with them are explained by them, or by others that yield the same numbers.
#[test]
fn answers_with_a_change_are_explained() {
    let samples: Vec<Sample> = right_answers(&Family::ALL).into_iter().step_by(4).collect();
    let names: Set = ["F_N", "F", "F_bar", "R", "K"].iter().map(|name| FORMULAS.name(name)).collect();
    let (mut seen, mut known) = (0, 0);
    for change in all_changes().iter().filter(|change| change.ways[0]).step_by(3000) {
        let answered: Vec<Sample> = samples.iter().map(|sample| answered(sample, change)).collect();
        let wrong = points(&answered).iter().filter(|point| point.is_wrong(names)).count();
        let is_finite = |sample: &Sample| {
            let numbers = sample.element.iter().flat_map(|element| element.numbers).flatten();
            numbers.clone().all(|number| number.value.is_finite())
        };
        if wrong < 8 || !answered.iter().all(is_finite) {
            continue;
        }
        seen += 1;
        let causes =
            found(&answered, &|_| Vec::new(), &Vec::new).map_or_else(Vec::new, |traced| traced.causes);
        assert!(!causes.is_empty(), "not explained: {}", change.words());
        known += usize::from(causes.iter().any(|cause| cause.words == change.words()));
    }
    assert!(seen >= 8 && 2 * known >= seen, "{known} of {seen} are told with the same words");
}

/// A term of the tangent with any factor is told, and friction with a cone for each beam.
#[test]
fn a_term_with_a_factor_and_uncoupled_friction_are_told() {
    let samples: Vec<Sample> = right_answers(&[Family::Hermite]);
    let told = |answered: &[Sample]| -> Vec<String> {
        let causes =
            found(answered, &|_| Vec::new(), &Vec::new).map_or_else(Vec::new, |traced| traced.causes);
        causes.into_iter().map(|cause| cause.words).collect()
    };
    let change = |words: &str| all_changes().iter().find(|change| change.words() == words).unwrap();
    for term in ["the term k dgap Dgap", "the part of friction"] {
        let missing = change(&format!("in the tangent {term} is missing"));
        let with_factor = |sample: &Sample| {
            let mut with = sample.clone();
            let [right, without] = [sample, &answered(sample, missing)]
                .map(|of| of.element.as_ref().and_then(|element| element.numbers[2]).unwrap());
            let half = RunningError::from(0.5) * (right - without);
            with.element.as_mut().unwrap().numbers[2] = Some(right + half);
            with
        };
        let answered: Vec<Sample> = samples.iter().map(with_factor).collect();
        assert_eq!(told(&answered), [format!("in the tangent {term} is multiplied by 1.5")]);
    }
    let words = "friction is uncoupled: eps_T e and eps_T e_bar have a cone each";
    let answered: Vec<Sample> = samples.iter().map(|sample| answered(sample, change(words))).collect();
    assert_eq!(told(&answered), [words]);
}

/// A change must yield all answers, and not those alone that are wrong: here those with xi_bar held.
#[test]
fn a_change_that_spoils_right_answers_is_not_told() {
    let samples: Vec<Sample> = right_answers(&Family::ALL).into_iter().step_by(2).collect();
    let words = "in dxi, eq. (52), the term dp/a has the wrong sign";
    let change = all_changes().iter().find(|change| change.words() == words).unwrap();
    let answered: Vec<Sample> = samples.iter().map(|sample| answered(sample, change)).collect();
    let causes = found(&answered, &|_| Vec::new(), &Vec::new).map_or_else(Vec::new, |traced| traced.causes);
    let told: Vec<&str> = causes.iter().map(|cause| &*cause.words).collect();
    assert_eq!(told, [words]);
}
