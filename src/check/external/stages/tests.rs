use super::equations::{At, equations};
use super::point::Point;
use super::sample::{Along, Sample, samples};
use super::search::System;
use super::terms::Earlier;
use super::traced;
use crate::check::Regime;
use crate::check::external::answers::Answers;
use crate::check::external::vectors::Vector;
use crate::check::external::{AnswerReader, Demands, Drawing, Evaluator};
use crate::linearization::Quantity;
use crate::test_beam::Family;
use crate::variant::scalar_of;

/// Right answers of all families in all regimes, with so many digits.
fn right_answers(digits: Option<u8>) -> (Vec<(Vector, Answers)>, Demands) {
    let (seed, families) = (11, Family::ALL.to_vec());
    let drawing = Drawing {
        seed,
        regimes: Regime::ALL.to_vec(),
        families,
        cases: 6,
        penetrating: false,
        elements: false,
        steps: false,
        work: None,
    };
    let vectors: Vec<_> = (0..drawing.count()).map(|number| drawing.vector(number)).collect();
    let program = Evaluator { digits: digits.map(usize::from), ..Evaluator::default() };
    let lines: Vec<_> = vectors.iter().map(|vector| program.line(vector)).collect();
    let text = format!("{}\n{}\n", program.head(), lines.join("\n"));
    let mut reader = AnswerReader::new(text.as_bytes(), "answers").unwrap();
    let answers = std::iter::from_fn(|| reader.next_answers().unwrap());
    let cases: Vec<_> = vectors.iter().cloned().zip(answers).collect();
    assert_eq!(cases.len(), vectors.len());
    (cases, Demands { digits, ..Demands::default() })
}

#[test]
fn right_answers_satisfy_all_equations() {
    for digits in [None, Some(8)] {
        let (cases, demands) = right_answers(digits);
        assert_eq!(traced(&cases.iter().collect::<Vec<_>>(), &demands), None, "{digits:?} digits");
    }
}

/// Lengths that are not answered follow from the numbers before them.
#[test]
fn right_answers_without_lengths_satisfy_all_equations() {
    let (mut cases, demands) = right_answers(None);
    let is_length = |of: Quantity| matches!(of, Quantity::D | Quantity::T | Quantity::TBar);
    for (_, answers) in &mut cases {
        let count = answers.answers.len();
        answers.answers.retain(|answer| !is_length(answer.quantity));
        assert!(answers.answers.is_empty() || answers.answers.len() + 3 == count);
    }
    assert_eq!(traced(&cases.iter().collect::<Vec<_>>(), &demands), None);
}

/// Each form by itself, in both directions, also of single entries. A form other than the first may be valid only where
/// both parameters are free.
#[test]
fn right_answers_satisfy_each_form_of_all_equations() {
    let (cases, demands) = right_answers(None);
    for along in [Along::Stated, Along::Random, Along::Lower, Along::Upper] {
        let of = |(i, (vector, answers)): (usize, &(Vector, Answers))| {
            samples(i, vector, answers, &demands, along)
        };
        let all: Vec<Sample> = cases.iter().enumerate().flat_map(of).collect();
        let points: Vec<Point> = all.iter().map(Point::new).collect();
        let is_free = |case: usize| all.iter().any(|sample| sample.case == case && sample.held == [false; 2]);
        for equation in equations(false) {
            for (k, form) in equation.forms.iter().enumerate() {
                for zero in form.iter().filter(|zero| zero.is_wrong_form.is_none()) {
                    for earlier in [Earlier::Own, Earlier::Exact] {
                        let mut system = System::new(&equation, zero, &points, earlier);
                        system.retain(|case| k == 0 || equation.at == At::SomeHeld || is_free(case));
                        let (results, at) = (&equation.results, equation.at);
                        let wrong = system.wrong_cases();
                        assert!(wrong.is_empty(), "{results:?}, {at:?}, form {k}, {along:?}: {wrong:?}");
                        // A contact element is not answered, and vectors have no gradients.
                        let has_arrays = results.iter().all(|(of, _)| scalar_of(of.component()).is_some());
                        let is_answered = match along {
                            Along::Stated => !equation.number.is_empty(),
                            Along::Random => !equation.number.is_empty() && has_arrays,
                            Along::Lower | Along::Upper => false,
                        };
                        assert!(!is_answered || !system.points.is_empty(), "{results:?}, {at:?}, form {k}");
                    }
                }
            }
        }
    }
}
