//! The scenarios that are timed and counted: every task by every method, each verified with double-double.
//!
//! Benches and counts use one list, [`all`]. Every reported number therefore belongs to code that was verified on the
//! same pair.

mod automatic;
mod checks;
mod closed;
mod closest;
mod counted;
mod differences;
mod element;
mod error;
mod input;
mod many;
mod matrices;
mod sizes;
mod truth;
mod variations;
mod work;

use error::Error;

pub(crate) use checks::check;

use beamgap_benchmark::{Task, Verdict};
use std::fmt;

/// One method for one task with one kind of beams.
pub(crate) struct Scenario {
    /// The task.
    pub(crate) task: Task,
    /// The family of both beams.
    pub(crate) family: &'static str,
    /// The dofs of both beams together.
    pub(crate) dofs: usize,
    /// The method.
    pub(crate) method: String,
    /// The number of pairs in a run.
    pub(crate) pairs: usize,
    /// The multiply-adds of a pair, if they are counted.
    pub(crate) multiply_adds: Option<usize>,
    runner: Box<dyn Fn() -> Runner + Send + Sync>,
    judge: Box<dyn Fn() -> Error + Send + Sync>,
}

/// Runs a scenario once in each call, with separate memory for the results.
pub(crate) type Runner = Box<dyn FnMut()>;

impl Scenario {
    /// The runner; neither the input nor the result is visible to the optimizer.
    pub(crate) fn runner(&self) -> Runner {
        (self.runner)()
    }

    /// Compares the result with the exact one.
    pub(crate) fn verdict(&self) -> Verdict {
        let Error { relative, share } = (self.judge)();
        Verdict {
            task: self.task.name().to_owned(),
            family: self.family.to_owned(),
            dofs: self.dofs,
            method: self.method.clone(),
            pairs: self.pairs,
            error: relative,
            share,
        }
    }

    /// The name of the same method on one thread, if this one is on two.
    pub(crate) fn by_one_thread(&self) -> Option<String> {
        Some(many::by_threads(self.method.strip_suffix(&many::by_threads("", 2))?, 1))
    }

    /// The name of the same method one pair after another, if this one is four pairs at once.
    pub(crate) fn one_by_one(&self) -> Option<String> {
        many::one_by_one(&self.method)
    }

    /// The task and the beams, which are common to the methods of a group.
    pub(crate) fn group(&self) -> String {
        self.task.group(self.family, self.dofs)
    }
}

impl fmt::Display for Scenario {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}, {}", self.group(), self.method)
    }
}

/// All scenarios, group by group.
pub(crate) fn all() -> Vec<Scenario> {
    let inputs = input::Inputs::drawn();
    let mut all = standard();
    all.extend(matrices::others(&inputs));
    all.extend(variations::others(&inputs));
    all.extend(closest::others(&inputs));
    all.extend(sizes::scenarios());
    all.extend(counted::counted(many::scenarios()));
    all.sort_by_key(|scenario| scenario.task);
    all
}

/// The scenarios of the standard pair, two Hermite beams. They contain all methods, which are compiled once.
fn standard() -> Vec<Scenario> {
    let input = input::hermites();
    let mut standard = matrices::standard(&input);
    standard.extend(variations::of_pair(input));
    standard.extend(closest::of_pair(input));
    counted::counted(standard)
}
