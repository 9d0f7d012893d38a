//! The closed forms of the standard pair, in terms of what their machine does at best.

use super::Task;
use super::benchmark::{Benchmark, Measured};
use super::number::number;

/// A way whose arithmetic is counted.
pub(super) struct Below<'a> {
    pub(super) task: Task,
    pub(super) measured: &'a Measured,
    /// What it takes for a pair.
    pub(super) multiply_adds: usize,
    pub(super) bytes: usize,
    /// The nanoseconds that these take at best.
    pub(super) floors: [f64; 2],
}

impl Below<'_> {
    /// The task and the layout.
    pub(super) fn name(&self) -> String {
        let task = match self.task {
            Task::Distance | Task::DistanceOfMany => Task::Distance,
            _ => Task::All,
        };
        format!("{}, {}", task.name(), self.measured.way.split(", ").nth(1).unwrap_or("in blocks"))
    }

    /// The time over the higher floor.
    pub(super) fn times(&self) -> f64 {
        self.measured.median / self.floors[0].max(self.floors[1])
    }

    /// Multiply-adds for a byte stored.
    pub(super) fn density(&self) -> f64 {
        number(self.multiply_adds) / number(self.bytes)
    }

    /// Multiply-adds in a nanosecond.
    pub(super) fn rate(&self) -> f64 {
        number(self.multiply_adds) / self.measured.median
    }
}

impl Benchmark {
    /// All of them: d first, then the rest with it.
    pub(super) fn below_the_roof(&self) -> impl Iterator<Item = Below<'_>> {
        let tasks = [(Task::Distance, 1), (Task::DistanceOfMany, 1), (Task::All, 5), (Task::AllOfMany, 5)];
        tasks.into_iter().flat_map(move |(task, quantities)| {
            self.of(task).filter_map(move |measured| {
                let multiply_adds = measured.multiply_adds?;
                // A quantity has a value and a gradient too.
                let bytes = quantities * (measured.stored() + measured.dofs + 1) * size_of::<f64>();
                let floors = self.floors.least(number(multiply_adds), number(bytes));
                Some(Below { task, measured, multiply_adds, bytes, floors })
            })
        })
    }
}
