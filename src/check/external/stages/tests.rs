use super::equations::{At, equations};
use super::point::Point;
use super::sample::{Along, Sample, samples};
use super::search::System;
use super::terms::Earlier;
use super::{Traced, traced};
use crate::check::Regime;
use crate::check::external::answers::Answers;
use crate::check::external::vectors::Vector;
use crate::check::external::{AnswerReader, Demands, Drawing, Evaluator, Formulas};
use crate::linearization::Quantity;
use crate::test_beam::Family;
use crate::variant::{scalar_of, with_faults};

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
    };
    let program = Evaluator { digits: digits.map(usize::from), ..Evaluator::default() };
    (answered(&program, &drawing), Demands { digits, ..Demands::default() })
}

/// Cases with the answers of a program.
fn answered(program: &Evaluator, drawing: &Drawing) -> Vec<(Vector, Answers)> {
    let vectors: Vec<_> = (0..drawing.count()).map(|number| drawing.vector(number)).collect();
    let lines: Vec<_> = vectors.iter().map(|vector| program.line(vector)).collect();
    let text = format!("{}\n{}\n", program.head(), lines.join("\n"));
    let mut reader = AnswerReader::new(text.as_bytes(), "answers").unwrap();
    let answers = std::iter::from_fn(|| reader.next_answers().unwrap());
    let cases: Vec<_> = vectors.iter().cloned().zip(answers).collect();
    assert_eq!(cases.len(), vectors.len());
    cases
}

/// What is found of answers to Hermite beams, after a change of them.
fn found(program: &Evaluator, change: impl Fn(&mut Answers)) -> Traced {
    let (regimes, families) = (vec![Regime::Generic], vec![Family::Hermite]);
    let drawing = Drawing { seed: 5, regimes, families, cases: 12, penetrating: false, elements: false };
    let mut cases = answered(program, &drawing);
    for (_, answers) in &mut cases {
        for answer in &mut answers.answers {
            answer.variations = [None; 3];
        }
        change(answers);
    }
    traced(&cases.iter().collect::<Vec<_>>(), &Demands::default()).unwrap()
}

fn words(found: &Traced) -> Vec<&str> {
    found.causes.iter().map(|cause| cause.words.as_str()).collect()
}

/// Changes the entries of a Hessian of Hermite beams, or of a gradient, with a column of 0.
fn change_entries(of: &mut [f64], change: impl Fn(usize, usize, f64) -> f64) {
    let size = if of.len() > 24 { 24 } else { 1 };
    for (k, entry) in of.iter_mut().enumerate() {
        *entry = change(k / size, k % size, *entry);
    }
}

#[test]
fn wrong_entries_are_stated() {
    let program = Evaluator::default();
    let change = |answers: &mut Answers, quantity: Quantity, change: fn(usize, usize, f64) -> f64| {
        for answer in answers.answers.iter_mut().filter(|answer| answer.quantity == quantity) {
            let of = if quantity == Quantity::D { &mut answer.hessian } else { &mut answer.gradient };
            change_entries(of.as_mut().unwrap(), change);
        }
    };
    let zero = |i: usize, j: usize, entry: f64| if (i < 12) == (j < 12) { entry } else { 0.0 };
    assert_eq!(
        words(&found(&program, |answers| change(answers, Quantity::D, zero))),
        [
            "in the second order of d: the Hessian of d is zero, in the entries where the dofs are of both beams"
        ]
    );
    let sign = |i: usize, _: usize, entry: f64| if i % 3 == 2 { -entry } else { entry };
    assert_eq!(
        words(&found(&program, |answers| change(answers, Quantity::XiBar, sign))),
        [
            "in the first order of xi and xi_bar: the gradient of xi_bar has the wrong sign, in the entries where the \
          dof is along z"
        ]
    );
    // Nothing explains these numbers. Their place is stated.
    let other = |i: usize, j: usize, entry: f64| {
        let odd = f64::from(u8::try_from(i % 5).unwrap());
        if i / 3 == 1 && j >= 12 { entry + odd.sin() + 0.1 } else { entry }
    };
    let traced = found(&program, |answers| change(answers, Quantity::D, other));
    assert_eq!(words(&traced), [""; 0]);
    assert!(
        traced.place.ends_with(
            ", in the entries where the dofs are of both beams and they are above the diagonal and the row is of control \
             vector 2"
        ),
        "{}",
        traced.place
    );
}

/// An error in the first order of xi is named, although the Hessian of d alone is answered.
#[test]
fn errors_of_numbers_that_are_not_answered_are_named() {
    let variant = with_faults(&["grad R: A1'd = sign".to_owned()]).unwrap();
    let program = Evaluator { variant, formulas: Formulas::Paper, ..Evaluator::default() };
    let traced = found(&program, |answers| {
        answers.answers.retain(|answer| answer.quantity == Quantity::D);
        for answer in &mut answers.answers {
            answer.gradient = None;
        }
    });
    assert_eq!(
        words(&traced),
        [
            "in the first order of xi and xi_bar the term d.du,xi, eq. (50), has the wrong sign, as the second order of d \
          shows"
        ]
    );
}

#[test]
fn right_answers_satisfy_all_equations() {
    for digits in [None, Some(8)] {
        let (cases, demands) = right_answers(digits);
        assert_eq!(traced(&cases.iter().collect::<Vec<_>>(), &demands), None, "{digits:?} digits");
    }
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
                            Along::Lower | Along::Upper | Along::EachDof | Along::EachEntry => false,
                        };
                        assert!(!is_answered || !system.points.is_empty(), "{results:?}, {at:?}, form {k}");
                    }
                }
            }
        }
    }
}
