//! Interleaved rounds of a method and of its references.

use crate::roofline::{multiply_adds_by, roofline};
use crate::scenario::Scenario;
use crate::timed::Timed;
use beamgap_benchmark::{CLOSED_FORM, Rounds};
use std::time::Duration;

/// The number of rounds with the roofline, and with one thread.
const MANY: usize = 101;
/// The number of rounds with the closed form. Nearly all methods have these rounds, so they are most of the record.
const FEW: usize = 41;
/// The minimum time of a round.
const SHORT: Duration = Duration::from_micros(100);
/// The minimum time of a round with threads. After waking, threads may share one core for some milliseconds.
const LONG: Duration = Duration::from_millis(50);

/// The rounds of a scenario of the group. The closed form is a reference if it is another method of the group. For four
/// pairs at once it is the closed form one by one. The roofline is a reference if the arithmetic is counted. One thread
/// is a reference for two threads.
pub(crate) fn rounds(scenario: &Scenario, group: &[Scenario]) -> Vec<Rounds> {
    let timed = |scenario: &Scenario, round| Timed::new(scenario.runner(), scenario.pairs, round);
    let find =
        |method: &str| group.iter().find(|other| other.method == method && other.method != scenario.method);
    let one_by_one = scenario.one_by_one().and_then(|method| find(&method)).map(|other| (other, LONG));
    let closed_form = find(CLOSED_FORM).map(|other| (other, SHORT)).or(one_by_one);
    let with_closed_form = closed_form.map(|(closed_form, round)| Rounds::ClosedForm {
        samples: in_rounds(FEW, [timed(scenario, round), timed(closed_form, round)]),
    });
    let with_floors = scenario.multiply_adds.map(|multiply_adds| {
        let [multiply_add, store] = roofline(SHORT);
        Rounds::Roofline {
            multiply_adds,
            samples: in_rounds(MANY, [timed(scenario, SHORT), multiply_add, store]),
        }
    });
    let with_one_thread = scenario.by_one_thread().and_then(|method| find(&method)).map(|by_one| {
        let [of_all, of_one] = [2, 1].map(|threads| multiply_adds_by(threads, LONG));
        let methods = [timed(scenario, LONG), timed(by_one, LONG), of_all, of_one];
        Rounds::OneThread { samples: in_rounds(MANY, methods) }
    });
    [with_closed_form, with_floors, with_one_thread].into_iter().flatten().collect()
}

fn in_rounds<const K: usize>(rounds: usize, mut methods: [Timed; K]) -> Vec<[f64; K]> {
    (0..rounds).map(|_| methods.each_mut().map(Timed::round)).collect()
}
