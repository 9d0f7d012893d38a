//! The closed forms of the standard pair, compared with the peak rates of their machine.

use crate::benchmark::{Benchmark, Measured};
use crate::methods::method_name;
use crate::{Task, spread};
use beamgap::report::number::number;

/// A method whose arithmetic is counted.
pub(crate) struct Below<'a> {
    pub(crate) task: Task,
    pub(crate) measured: &'a Measured,
    /// The number of multiply-adds for a pair.
    pub(crate) multiply_adds: usize,
    pub(crate) bytes: usize,
    /// The nanoseconds of a pair, and those of its multiply-adds and of its bytes alone: medians over the rounds.
    pub(crate) time: f64,
    pub(crate) roofline: [f64; 2],
    /// The time over the roofline bound: the median of the ratios of each round.
    pub(crate) times: f64,
}

impl Below<'_> {
    /// The task and the layout.
    pub(crate) fn name(&self) -> String {
        let task = match self.task {
            Task::Distance | Task::DistanceOfMany => Task::Distance,
            _ => Task::All,
        };
        let method = method_name(task.name(), &self.measured.method);
        format!("{}, {}", task.name(), method.split(", ").nth(1).unwrap_or("blocks"))
    }

    /// Multiply-adds for each stored byte.
    pub(crate) fn density(&self) -> f64 {
        number(self.multiply_adds) / number(self.bytes)
    }

    /// Multiply-adds in a nanosecond.
    pub(crate) fn rate(&self) -> f64 {
        number(self.multiply_adds) / self.time
    }

    /// Multiply-adds and bytes that the machine processes in a nanosecond, each alone.
    fn limits(&self) -> [f64; 2] {
        [number(self.multiply_adds) / self.roofline[0], number(self.bytes) / self.roofline[1]]
    }
}

impl Benchmark {
    /// All of these methods: first d, then the other quantities with it.
    pub(crate) fn below_the_roof(&self) -> impl Iterator<Item = Below<'_>> {
        let tasks = [(Task::Distance, 1), (Task::DistanceOfMany, 1), (Task::All, 5)];
        tasks.into_iter().flat_map(move |(task, quantities)| {
            self.of(task).filter_map(move |measured| {
                // A quantity also has a value and a gradient.
                let bytes = quantities * (measured.stored() + measured.dofs + 1) * size_of::<f64>();
                let (multiply_adds, rounds) = measured.with_lower_bounds(number(bytes))?;
                let median = |of: fn(&[f64; 3]) -> f64| {
                    let samples: Vec<f64> = rounds.iter().map(of).collect();
                    spread(&samples).map(|spread| spread.median)
                };
                Some(Below {
                    task,
                    measured,
                    multiply_adds,
                    bytes,
                    time: median(|[time, ..]| *time)?,
                    roofline: [median(|[_, roofline, _]| *roofline)?, median(|[.., roofline]| *roofline)?],
                    times: median(|[time, roofline, other]| time / roofline.max(*other))?,
                })
            })
        })
    }

    /// The peak rates of multiply-adds and of stored bytes, in a nanosecond.
    pub(crate) fn roof(&self) -> [f64; 2] {
        let highest = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a.max(c), b.max(d)];
        self.below_the_roof().map(|below| below.limits()).fold([0.0; 2], highest)
    }
}

#[cfg(test)]
mod tests {
    use crate::benchmark::tests::measured;
    use crate::{Benchmark, Rounds};
    use beamgap::report::{Environment, Record};

    #[test]
    fn a_machine_that_slows_down_changes_no_ratio() {
        // With 5 (300 + 24 + 1) numbers, 0.01 nanoseconds for a byte and 0.04 for a multiply-add; then half the speed.
        let samples = vec![[800.0, 0.04, 0.01], [1600.0, 0.08, 0.02], [1600.0, 0.08, 0.02]];
        let rounds = vec![Rounds::Roofline { multiply_adds: 10_000, samples }];
        let scenarios = vec![measured("closed form", vec![]), measured("closed form, packed", rounds)];
        let (schema, environment) = (Benchmark::SCHEMA.to_owned(), Environment::here("by hand"));
        let benchmark = Benchmark { schema, environment, scenarios, instructions: None, peers: None };
        let rows: Vec<_> = benchmark.below_the_roof().collect();
        let [row] = &rows[..] else { panic!("one method is counted") };
        assert_eq!(row.name(), "all but the slips, packed");
        assert_eq!((row.multiply_adds, row.bytes), (10_000, 13_000));
        let found = [row.time, row.roofline[0], row.roofline[1], row.times];
        assert_eq!(found.map(f64::to_bits), [1600.0, 800.0, 260.0, 2.0].map(f64::to_bits));
        assert_eq!(benchmark.roof().map(f64::to_bits), [12.5, 50.0].map(f64::to_bits));
    }
}
