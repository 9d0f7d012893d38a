//! The answers of the explorer, tested natively.

use beamgap::test_beam::Family;
use beamgap_explorer::{Answer, State, preset};

fn standard() -> State {
    State::default()
}

fn segments(q: [f64; 6], q_bar: [f64; 6]) -> State {
    let (mut beam, mut bar) = (preset(Family::Segment, false), preset(Family::Segment, true));
    (beam.q, bar.q) = (q.into(), q_bar.into());
    State { beam, bar, ..State::default() }
}

#[test]
fn every_pair_of_families_has_an_answer() {
    for family in Family::ALL {
        for other in Family::ALL {
            let state = State { beam: preset(family, false), bar: preset(other, true), ..standard() };
            let answer = Answer::of(&state).unwrap();
            assert!(
                answer.numbers.contains("agrees") && !answer.numbers.contains("WRONG"),
                "{family:?} {other:?}: {answer:?}"
            );
            assert!(!answer.checks.contains("WRONG"), "{family:?} {other:?}: {}", answer.checks);
        }
    }
}

#[test]
fn a_fault_turns_ad_red_and_leaves_symmetry_green_or_not() {
    let row = |fault: &str, check: &str| {
        let answer = Answer::of(&State { fault: Some(fault.to_owned()), ..standard() }).unwrap();
        let row = answer.checks.lines().find(|line| line.contains(&format!(">{check}<"))).unwrap().to_owned();
        row.contains("WRONG")
    };
    assert!(row("a: d.t,xi = dropped", "automatic differentiation"));
    assert!(!row("a: d.t,xi = dropped", "symmetry"));
    assert!(row("Ddg_T: dt Dxi = dropped", "automatic differentiation"));
    assert!(row("Ddg_T: dt Dxi = dropped", "symmetry"));
    assert!(row("d|d|: n.du_hat = sign", "Taylor test"));
    assert!(!row("Dd x: rest = dropped", "Taylor test") || !row("Ddg_T: dt Dxi = dropped", "Taylor test"));
}

#[test]
fn a_special_situation_is_told_in_words() {
    let words = |state: &State| Answer::of(state).unwrap().words;
    let bar = [-1.0, 0.0, -0.25, 1.0, 0.0, -0.25];
    assert!(words(&standard()).contains("all equations of the paper hold"));
    assert!(words(&segments([-1.0, 0.0, 0.25, 1.0, 0.0, 0.25], bar)).contains("parallel"));
    let across = [0.0, -1.0, 0.0, 0.0, 1.0, 0.0];
    assert!(words(&segments([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0], across)).contains("d = 0"));
    assert!(words(&segments([-1.5, 0.0, 0.25, -0.5, 0.25, 0.25], across)).contains("second end of the beam"));
    assert!(words(&segments([-1.0, 0.0, 0.1, 1.0, 0.0, 0.1], across)).contains("overlap"));
}

#[test]
fn the_predictions_have_the_slopes_of_their_order() {
    for state in [standard(), State { along_linear: true, ..standard() }] {
        let plot = Answer::of(&state).unwrap().plot;
        let slope = |name: &str| -> f64 {
            let (_, from) = plot.split_once(&format!("{name}: slope ")).unwrap();
            from.split(';').next().unwrap().parse().unwrap()
        };
        assert!((slope("first order") - 2.0).abs() < 0.1, "{plot}");
        assert!((slope("second order") - 3.0).abs() < 0.1, "{plot}");
    }
}

#[test]
fn what_is_no_state_is_told_and_nothing_else() {
    let told = |request: &str| beamgap_explorer::answer(request);
    assert!(told("").contains("\"error\":\"EOF"), "{}", told(""));
    let mut state = standard();
    state.beam.q.pop();
    assert_eq!(
        Answer::of(&state).unwrap_err(),
        "beam: q: 12 numbers expected for the family hermite, found 11"
    );
    let point = segments([0.5; 6], [0.0, -1.0, 0.0, 0.0, 1.0, 0.0]);
    assert_eq!(Answer::of(&point).unwrap_err(), "the curve of the beam is a single point");
    let unknown = State { fault: Some("a = b".to_owned()), ..standard() };
    assert!(Answer::of(&unknown).unwrap_err().contains("a = b"));
}
