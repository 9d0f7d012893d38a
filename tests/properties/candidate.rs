//! The check of a linearization of the user.

use beamgap::check::{self, Answer, Family, Found, Order, Situation};
use beamgap::curve::Segment;
use beamgap::linearization::closed_form::{Formulation, Matrices};
use beamgap::linearization::{Derivatives, Quantity};
use beamgap::pair::DofVector;
use nalgebra::SVector;

type Numbers = Derivatives<f64, 6, 6>;

/// The paper's matrices of two segments, changed by `change`.
fn of_segments(at: &Situation<'_>, change: impl Fn(Quantity, &mut Numbers)) -> Vec<Answer> {
    use beamgap::curve::Curve;
    let [q, q_bar] = [at.q, at.q_bar].map(SVector::<f64, 6>::from_column_slice);
    let (jet, jet_bar) = (Segment::new().jet(&q, at.at.0), Segment::new().jet(&q_bar, at.at.1));
    let all = Matrices::in_formulation(&jet, &jet_bar, Formulation::paper(at.held)).all(at.at, &at.contact);
    let quantities = [
        (Quantity::Xi, all.xi),
        (Quantity::XiBar, all.xi_bar),
        (Quantity::D, all.d),
        (Quantity::T, all.t),
        (Quantity::TBar, all.t_bar),
        (Quantity::GN, all.g_n()),
        (Quantity::GT, all.g_t),
        (Quantity::GTBar, all.g_t_bar),
    ];
    let answer = |(quantity, mut numbers): (Quantity, Numbers)| {
        change(quantity, &mut numbers);
        let (mut gradient, mut hessian) = (vec![0.0; 12], vec![0.0; 144]);
        numbers.gradient.write_to(&mut gradient).unwrap();
        numbers.hessian.write_dense(&mut hessian).unwrap();
        let along = |dq: &[f64]| DofVector::<f64, 6, 6>::from_slice(dq).unwrap();
        let (dq, linear_dq) = (along(at.dq), along(at.linear_dq));
        let variations = [
            numbers.gradient.along(&dq),
            numbers.gradient.along(&linear_dq),
            numbers.hessian.along(&dq, &linear_dq),
        ];
        Answer {
            quantity,
            axis: None,
            value: Some(numbers.value),
            gradient: Some(gradient),
            hessian: Some(hessian),
            variations: variations.map(Some),
        }
    };
    quantities.into_iter().map(answer).collect()
}

fn found(change: impl Fn(Quantity, &mut Numbers) + Sync) -> Found {
    check::linearization(&|at: &Situation<'_>| of_segments(at, &change), [Family::Segment; 2], 12)
}

#[test]
fn the_textbook_formulas_agree_in_every_regime() {
    let found = found(|_, _| ());
    assert!(found.agrees(), "{found}");
    // Eight quantities in three orders. Both the check and the candidate contract, which doubles the variations.
    assert_eq!(found.digits.len(), 8 * 3);
    assert!(
        found.compared > 100 && (found.mismatches, found.unanswered, found.doubted) == (0, 0, 0),
        "{found}"
    );
    let count = |order| found.digits[&(Quantity::Xi, order)].entries;
    assert!(count(Order::Value) > 100 && count(Order::First) <= 4 * found.compared);
}

#[test]
fn the_first_wrong_number_is_named_with_its_equations() {
    let halved = |wrong: Quantity, order: Order| {
        found(move |quantity, numbers| {
            if quantity == wrong {
                match order {
                    Order::Value => numbers.value *= 0.5,
                    Order::First => numbers.gradient = numbers.gradient.times(0.5),
                    _ => numbers.hessian.beam *= 1.0 + 1e-6,
                }
            }
        })
    };
    for (quantity, order, words) in [
        (Quantity::Xi, Order::First, "look at the 2 x 2 system, eq. (50)-(52)"),
        (Quantity::D, Order::Second, "look at eq. (40) and (57)"),
        (Quantity::GTBar, Order::Value, "look at its definition"),
    ] {
        let found = halved(quantity, order);
        assert!(!found.agrees() && found.mismatches > 50 && found.doubted == 0, "{found}");
        assert!(found.first.keys().all(|&first| first == (order, quantity)), "{:?}", found.first);
        // The shrunk case keeps only the numbers that the fault needs.
        let example = found.example.as_ref().unwrap();
        let numbers = example.case.test_beams.iter().flat_map(|s| [&s.q, &s.dq, &s.linear_dq]).flatten();
        let not_zero = numbers.filter(|&&number| number != 0.0).count();
        assert!((1..20).contains(&not_zero) && example.entry.is_wrong(), "{found}");
        assert_eq!((example.entry.quantity, example.entry.order), (quantity, order));
        let text = found.to_string();
        assert!(text.contains(words) && text.contains("WRONG") && text.contains("DISAGREE"), "{text}");
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    }
}

#[test]
fn answers_of_another_shape_are_refused_in_words() {
    let short = |_: &Situation<'_>| vec![Answer { gradient: Some(vec![0.0; 11]), ..Answer::of(Quantity::D) }];
    let found = check::linearization(&short, [Family::Segment; 2], 1);
    assert!(!found.agrees());
    assert_eq!(found.to_string(), "DISAGREE: gradient of d: 12 numbers expected, found 11");
    let vector = |_: &Situation<'_>| vec![Answer::of(Quantity::DVector)];
    let found = check::linearization(&vector, [Family::Segment; 2], 1);
    assert_eq!(
        found.to_string(),
        "DISAGREE: d_vector: a component x, y or z expected for a vector and none for a scalar, found none"
    );
}

#[test]
fn who_answers_nothing_is_not_right() {
    let none = |_: &Situation<'_>| Vec::new();
    let found = check::linearization(&none, [Family::Segment; 2], 1);
    assert!(!found.agrees() && found.unanswered > 0 && found.to_string().starts_with("quantity"), "{found}");
    let infinite = |_: &Situation<'_>| vec![Answer { value: Some(f64::NAN), ..Answer::of(Quantity::D) }];
    assert!(check::linearization(&infinite, [Family::Segment; 2], 1).mismatches > 0);
}
