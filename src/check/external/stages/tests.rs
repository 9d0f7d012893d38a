use super::equations::{At, equations};
use super::point::Point;
use super::rows::{What, rows};
use super::sample::{Along, Sample, samples};
use super::search::System;
use super::terms::Earlier;
use super::{Traced, traced};
use crate::check::Regime;
use crate::check::external::answers::Answers;
use crate::check::external::vectors::Vector;
use crate::check::external::{AnswerReader, Demands, Drawing, Evaluator};
use crate::linearization::Quantity;
use crate::test_beam::Family;
use crate::variant::scalar_of;

/// Right answers of all families in all regimes, with so many digits.
pub(super) fn right_answers(digits: Option<u8>) -> (Vec<(Vector, Answers)>, Demands) {
    right_answers_of(Family::ALL.to_vec(), digits)
}

fn right_answers_of(families: Vec<Family>, digits: Option<u8>) -> (Vec<(Vector, Answers)>, Demands) {
    let drawing = Drawing {
        seed: 11,
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

/// The numbers of a program with another point are compared at this point.
#[test]
fn a_gap_at_another_point_is_right() {
    let (mut cases, demands) = right_answers(None);
    let mut moved = 0;
    for (vector, answers) in &mut cases {
        let value = |of: Quantity| answers.answers.iter().find(|answer| answer.quantity == of)?.value;
        let at = value(Quantity::Xi).zip(value(Quantity::XiBar));
        answers
            .answers
            .retain(|answer| matches!(answer.quantity, Quantity::Xi | Quantity::XiBar | Quantity::GN));
        let Some((xi, xi_bar)) = at.filter(|(xi, xi_bar)| xi.abs() < 0.99 && xi_bar.abs() < 0.99) else {
            answers.answers.clear();
            continue;
        };
        let [beam, bar] = vector.case.beams().unwrap();
        let contact = vector.case.contact;
        let d = beam.geometry(xi + 1e-3).x - bar.geometry(xi_bar).x;
        for answer in &mut answers.answers {
            (answer.gradient, answer.hessian, answer.variations) = (None, None, [None; 3]);
            match answer.quantity {
                Quantity::Xi => answer.value = Some(xi + 1e-3),
                Quantity::GN => answer.value = Some(d.norm() - contact.radius - contact.radius_bar),
                _ => {}
            }
        }
        moved += 1;
    }
    assert!(moved > 40, "{moved}");
    let found = traced(&cases.iter().collect::<Vec<_>>(), &demands).unwrap();
    assert_eq!(found.place, "all equations but those of the closest point are satisfied");
}

/// The causes for answers of Hermite curves after `change`, which has g_T's gradient and Hessian, the gradients of |t|, xi and
/// the value of |t|.
fn causes_with(change: impl Fn(&mut [f64], &mut [f64], [&[f64]; 2], f64)) -> Vec<String> {
    traced_with(change).causes.into_iter().map(|of| of.words).collect()
}

/// What is told of them.
fn traced_with(change: impl Fn(&mut [f64], &mut [f64], [&[f64]; 2], f64)) -> Traced {
    let (mut cases, demands) = right_answers_of(vec![Family::Hermite], None);
    for (_, answers) in &mut cases {
        let of = |of: Quantity| answers.answers.iter().find(|answer| answer.quantity == of);
        let gradient = |quantity| of(quantity).and_then(|answer| answer.gradient.clone());
        let length = of(Quantity::T).and_then(|answer| answer.value);
        let Some((by_length, by_xi)) = gradient(Quantity::T).zip(gradient(Quantity::Xi)) else { continue };
        let slip = answers.answers.iter_mut().find(|answer| answer.quantity == Quantity::GT);
        let arrays = slip.and_then(|slip| slip.gradient.as_mut().zip(slip.hessian.as_mut()));
        let Some(((gradient, hessian), length)) = arrays.zip(length) else { continue };
        change(gradient, hessian, [&by_length, &by_xi], length);
    }
    traced(&cases.iter().collect::<Vec<_>>(), &demands).unwrap()
}

/// What is added to an entry, by row and column, with the gradients of |t| and xi.
type Added<'a> = &'a dyn Fn(usize, usize, [&[f64]; 2]) -> f64;

/// Where no error is known, the difference may still be a product with something that is known.
#[test]
fn what_a_difference_is_a_product_with_is_told() {
    let place = |change: Added| {
        let found = traced_with(|_, hessian, both, _| {
            for (k, entry) in hessian.iter_mut().enumerate() {
                *entry += change(k / (2 * DOFS), k % (2 * DOFS), both);
            }
        });
        assert_eq!(found.causes, []);
        found.place.split_once(" cases").unwrap().1.to_owned()
    };
    let unknown = |k: usize| f64::from(u8::try_from(k).unwrap()).sin();
    assert_eq!(
        place(&|i, j, [_, by_xi]| by_xi[i] * unknown(j)),
        ", in all of which xi is free, and Ddg_T differs by a product of dxi with something"
    );
    assert_eq!(
        place(&|i, j, [_, by_xi]| by_xi[i] * unknown(j) + 2.0 * unknown(i + 1) * by_xi[j]),
        ", where xi is free, and Ddg_T differs by products with dxi in rows or columns"
    );
    assert_eq!(place(&|i, j, _| unknown(i) * unknown(j)), "");
}

/// The number of dofs of a Hermite curve.
const DOFS: usize = 12;

/// A program may write each block of a Hessian by itself. Here one lacks a term.
#[test]
fn an_error_in_one_block_is_told() {
    let words = causes_with(|_, hessian, [by_length, by_xi], _| {
        for (i, row) in hessian.chunks_mut(2 * DOFS).enumerate().take(DOFS) {
            row.iter_mut().zip(by_xi).skip(DOFS).for_each(|(entry, xi)| *entry -= by_length[i] * xi);
        }
    });
    let block = "in the block of the beam's rows and the bar beam's columns";
    assert_eq!(words, [format!("in Ddg_T, eq. (21), the term d|t| Dxi is missing, {block}")]);
}

/// The same of a gradient.
#[test]
fn an_error_in_the_entries_of_one_beam_is_told() {
    let words = causes_with(|gradient, _, [_, by_xi], length| {
        gradient.iter_mut().zip(by_xi).skip(DOFS).for_each(|(entry, xi)| *entry -= length * xi);
    });
    let wanted = "in dg_T, eq. (20), the term |t| dxi is missing, in the entries of the dofs of the bar beam";
    assert!(words.iter().any(|words| words == wanted), "{words:?}");
    // If both beams are wrong, and each in its own way, it is not the error of one.
    let words = causes_with(|gradient, _, [by_length, by_xi], length| {
        let (beam, bar) = gradient.split_at_mut(DOFS);
        beam.iter_mut().zip(by_length).for_each(|(entry, by)| *entry += 0.3 * by);
        bar.iter_mut().zip(&by_xi[DOFS..]).for_each(|(entry, xi)| *entry -= length * xi);
    });
    assert!(!words.iter().any(|words| words.contains("in the entries of the dofs of")), "{words:?}");
}

/// Where one parameter is held, its variations are zero, and nothing is said to be one of them by mistake.
#[test]
fn no_variation_of_a_held_parameter_is_taken_for_another() {
    let count = |at: At| {
        let all = equations(true);
        let of_at = all.iter().filter(|equation| equation.at == at && equation.number == "(55)");
        let rows = of_at.flat_map(|equation| rows(&equation.forms[0][0], equation));
        let is_taken = |what: &What| matches!(what, What::Replaced { words, .. } if words == "dxi_bar stands in the place of dxi");
        rows.filter(|row| is_taken(&row.what)).count()
    };
    assert!(count(At::Free) > 0);
    assert_eq!(count(At::Alone(0)), 0);
}

/// Each form by itself, in both directions, also of single entries. A form other than the first may be valid only where
/// both parameters are free.
#[test]
fn right_answers_satisfy_each_form_of_all_equations() {
    let (cases, demands) = right_answers(None);
    for along in [Along::Stated, Along::Random, Along::Lower, Along::Upper, Along::Block([0, 1])] {
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
                            Along::Lower | Along::Upper | Along::Block(_) | Along::Grid => false,
                        };
                        assert!(!is_answered || !system.points.is_empty(), "{results:?}, {at:?}, form {k}");
                    }
                }
            }
        }
    }
}
