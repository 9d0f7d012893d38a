//! Ways in turns with what they are held against.

use crate::floors::{floors, multiply_adds_by};
use crate::scenario::{Runner, Scenario};
use beamgap::report::{CLOSED_FORM, Turns};
use std::time::{Duration, Instant};

/// How many turns there are with the floors, and with one thread.
const MANY: usize = 101;
/// The same with the closed form, which nearly all ways have: their samples are most of the record.
const FEW: usize = 41;
/// How long a turn is at least.
const SHORT: Duration = Duration::from_micros(100);
/// The same with threads, which a system may leave on one core for some milliseconds after they wake.
const LONG: Duration = Duration::from_millis(50);

/// The turns of a scenario of the group: with the closed form if there is one and this is another way, with the floors if
/// its arithmetic is counted, with one thread if it has two.
pub(crate) fn turns(scenario: &Scenario, group: &[Scenario]) -> Vec<Turns> {
    let timed = |scenario: &Scenario, turn| Timed::new(scenario.runner(), scenario.pairs, turn);
    let find = |way: &str| group.iter().find(|other| other.way == way && other.way != scenario.way);
    let with_closed_form = find(CLOSED_FORM).map(|closed_form| Turns::ClosedForm {
        samples: in_turns(FEW, [timed(scenario, SHORT), timed(closed_form, SHORT)]),
    });
    let with_floors = scenario.multiply_adds.map(|multiply_adds| {
        let [multiply_add, store] = floors(SHORT);
        Turns::Floors {
            multiply_adds,
            samples: in_turns(MANY, [timed(scenario, SHORT), multiply_add, store]),
        }
    });
    let with_one_thread = scenario.by_one_thread().and_then(|way| find(&way)).map(|by_one| {
        let [of_all, of_one] = [2, 1].map(|threads| multiply_adds_by(threads, LONG));
        let ways = [timed(scenario, LONG), timed(by_one, LONG), of_all, of_one];
        Turns::OneThread { samples: in_turns(MANY, ways) }
    });
    [with_closed_form, with_floors, with_one_thread].into_iter().flatten().collect()
}

fn in_turns<const K: usize>(turns: usize, mut ways: [Timed; K]) -> Vec<[f64; K]> {
    (0..turns).map(|_| ways.each_mut().map(Timed::turn)).collect()
}

/// What does so much in a run, run so many times a turn.
pub(crate) struct Timed {
    run: Runner,
    amount: usize,
    runs: u32,
}

impl Timed {
    /// With as many runs as fill a turn.
    pub(crate) fn new(run: Runner, amount: usize, turn: Duration) -> Self {
        let mut timed = Self { run, amount, runs: 1 };
        while timed.elapsed() < turn {
            timed.runs *= 2;
        }
        timed
    }

    fn elapsed(&mut self) -> Duration {
        let start = Instant::now();
        for _ in 0..self.runs {
            (self.run)();
        }
        start.elapsed()
    }

    /// The nanoseconds of one of what it does.
    #[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
    fn turn(&mut self) -> f64 {
        self.elapsed().as_nanos() as f64 / f64::from(self.runs) / self.amount as f64
    }
}
