use super::changes::{Change, changes};
use super::found;
use super::list::{FORMULAS, WAYS};
use super::point::points;
use super::tree::Name;
use crate::check::Regime;
use crate::check::external::stages::sample::{Along, Sample, samples};
use crate::check::external::{AnswerReader, Demands, Drawing, Evaluator};
use crate::number::RunningError;
use crate::test_beam::Family;

/// Right answers to elements of all families in all regimes.
fn right_answers() -> Vec<Sample> {
    let drawing = Drawing {
        seed: 11,
        regimes: Regime::ALL.to_vec(),
        families: Family::ALL.to_vec(),
        cases: 6,
        penetrating: false,
        elements: true,
        steps: false,
    };
    let vectors: Vec<_> = (0..drawing.count()).map(|number| drawing.vector(number)).collect();
    let program = Evaluator::default();
    let lines: Vec<_> = vectors.iter().map(|vector| program.line(vector)).collect();
    let text = format!("{}\n{}\n", program.head(), lines.join("\n"));
    let mut reader = AnswerReader::new(text.as_bytes(), "answers").unwrap();
    let answers: Vec<_> = std::iter::from_fn(|| reader.next_answers().unwrap()).collect();
    let of = |i: usize| samples(i, &vectors[i], &answers[i], &Demands::default(), Along::Random);
    (0..vectors.len()).flat_map(of).collect()
}

/// The way of writing for straight beams.
const STRAIGHT: usize = 3;

#[test]
fn the_formulas_yield_right_answers_in_each_way_of_writing() {
    let samples = right_answers();
    assert!(samples.len() > 100, "{}", samples.len());
    assert_eq!(found(&samples, &|_| Vec::new()), None);
    for way in 0..WAYS {
        let points = points(&samples, way, &[]);
        // One way is valid for straight beams alone.
        let least = if way == STRAIGHT { samples.len() / 10 } else { samples.len() / 2 };
        assert!(points.len() > least, "way {way}: {} of {}", points.len(), samples.len());
    }
}

/// The sample with the answers of the changed formulas.
fn answered(sample: &Sample, change: &Change) -> Sample {
    let mut sample = sample.clone();
    let own = sample.clone();
    let of = points(std::slice::from_ref(&own), 0, &[]);
    let (Some(element), [point]) = (&mut sample.element, &of[..]) else { return sample };
    let values = point.changed(0, change);
    let number = |name: &str| {
        let RunningError { value, .. } = values[FORMULAS.name(name)].number();
        RunningError { value, bound: f64::EPSILON * value.abs() }
    };
    element.numbers = [Some(number("R")), None, Some(number("K"))];
    if let Some(inputs) = &mut element.inputs {
        for (name, force) in &mut inputs.forces {
            *force = number(&FORMULAS.names.0[*name]);
        }
    }
    sample
}

/// Some changes of all kinds: the answers with them are explained by them, or by others that yield the same numbers.
#[test]
fn answers_with_a_change_are_explained() {
    let samples: Vec<Sample> = right_answers().into_iter().step_by(4).collect();
    let names: Vec<Name> = ["F_N", "F", "F_bar", "R", "K"].map(|name| FORMULAS.name(name)).to_vec();
    let (mut seen, mut known) = (0, 0);
    for change in changes(0).iter().step_by(1500) {
        let answered: Vec<Sample> = samples.iter().map(|sample| answered(sample, change)).collect();
        let wrong = points(&answered, 0, &[]).iter().filter(|point| point.is_wrong(&names)).count();
        let is_finite = |sample: &Sample| {
            let numbers = sample.element.iter().flat_map(|element| element.numbers).flatten();
            numbers.clone().all(|number| number.value.is_finite())
        };
        if wrong < 8 || !answered.iter().all(is_finite) {
            continue;
        }
        seen += 1;
        let causes = found(&answered, &|_| Vec::new()).map_or_else(Vec::new, |traced| traced.causes);
        assert!(!causes.is_empty(), "not explained: {}", change.words);
        known += usize::from(causes.iter().any(|cause| cause.words == change.words));
    }
    assert!(seen >= 8 && 2 * known >= seen, "{known} of {seen} are told with the same words");
}

/// A change must yield all answers, and not those alone that are wrong: here those with xi_bar held.
#[test]
fn a_change_that_spoils_right_answers_is_not_told() {
    let samples: Vec<Sample> = right_answers().into_iter().step_by(2).collect();
    let words = "in dxi the term dp/a has the wrong sign";
    let changes = changes(0);
    let change = changes.iter().find(|change| change.words == words).unwrap();
    let answered: Vec<Sample> = samples.iter().map(|sample| answered(sample, change)).collect();
    let causes = found(&answered, &|_| Vec::new()).map_or_else(Vec::new, |traced| traced.causes);
    let told: Vec<&str> = causes.iter().map(|cause| &*cause.words).collect();
    assert_eq!(told, [words]);
}
