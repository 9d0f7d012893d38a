//! What is timed and counted runs, and yields what it should: the scenarios of the standard pair. `cargo bench` judges all.

#[path = "../../benches/linearization/scenario/mod.rs"]
#[allow(
    dead_code,
    reason = "the other families would take minutes to compile, and are judged by the benches"
)]
mod scenario;

use beamgap::number::DoubleDouble;
use beamgap::report::Task;
use rayon::prelude::*;
use scenario::error::Error;
use scenario::truth::Exact;
use scenario::{Runner, Scenario};
use std::collections::BTreeSet;

#[test]
fn every_scenario_is_right() {
    let wrong: Vec<String> = scenario::standard()
        .par_iter()
        .filter_map(|scenario| {
            let mut run: Runner = scenario.runner();
            run();
            let verdict = scenario.verdict();
            (!verdict.is_right()).then(|| format!("{scenario}: {verdict:?}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_task_has_a_closed_form_or_a_search_and_ways_have_names_of_their_own() {
    let all = scenario::standard();
    let names: BTreeSet<String> = all.iter().map(Scenario::to_string).collect();
    assert_eq!(names.len(), all.len());
    let has = |task: Task, way: &str| all.iter().any(|of| of.task == task && of.way.starts_with(way));
    for task in [Task::Distance, Task::All, Task::WithSlips, Task::Gradients, Task::Directions] {
        assert!(has(task, "closed form"), "{task:?}");
    }
    assert!(has(Task::ClosestPoint, "search") && has(Task::ClosestPoint, "Newton"));
}

/// An entry of a Hessian is a sum of products, and all that leads to these does not depend on the layout: of d two, of xi
/// and of xi_bar three, of t and t_bar two, and four among the dofs of their own beam.
#[test]
fn layouts_differ_by_the_multiply_adds_of_the_entries_that_they_hold_twice() {
    let all = scenario::standard();
    let of = |task: Task, way: &str| {
        let found = all.iter().find(|of| of.task == task && of.way == way);
        found.and_then(|of| of.multiply_adds).unwrap()
    };
    // Between the beams, and among the dofs of both.
    for (task, mixed, own) in [(Task::Distance, 2, 2 + 2), (Task::All, 2 + 3 + 3 + 2 + 2, 4 + 6 + 6 + 6 + 6)]
    {
        let blocks = of(task, "closed form");
        assert_eq!(of(task, "closed form, in full"), blocks + mixed * 12 * 12, "{task:?}");
        // Six of the sixteen blocks of two control vectors of a beam.
        assert_eq!(of(task, "closed form, packed"), blocks - own * 6 * 9, "{task:?}");
    }
    assert_eq!(all.iter().filter(|of| of.multiply_adds.is_some()).count(), 6);
}

fn error(numbers: [f64; 2]) -> Error {
    let exact = |value: f64, tolerance| Exact { value: DoubleDouble::from(value), tolerance };
    Error::of(&vec![numbers.to_vec()], &[vec![exact(8.0, 1e-12), exact(0.0, 0.0)]], |_| 0.0)
}

#[test]
fn an_error_is_relative_to_the_largest_and_a_share_of_what_is_allowed() {
    let one_ulp = 8.0 * f64::EPSILON;
    assert_eq!(error([8.0 + one_ulp, 0.0]), Error { relative: f64::EPSILON, share: one_ulp / 1e-12 });
    assert!(error([8.0 + 0.9e-12, 0.0]).share < 1.0 && error([8.0 + 1.1e-12, 0.0]).share > 1.0);
}

#[test]
fn where_nothing_is_allowed_nothing_may_be_off_and_what_is_no_number_is_infinitely_off() {
    assert!(error([8.0, 1e-300]).share > 1.0);
    assert!(error([f64::NAN, 0.0]).share.is_infinite() && error([8.0, f64::INFINITY]).share.is_infinite());
}
