//! What is timed and counted: every task in every method, each judged against double-double.
//!
//! Benches and counts go through one list, [`all`], so that no number is reported of what was not judged by the same code
//! on the same pair.

mod automatic;
mod checks;
mod closed;
mod closest;
mod counted;
mod differences;
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

use beamgap::report::{Task, Verdict};
use std::fmt;

/// One method to do one task with one kind of beams.
pub(crate) struct Scenario {
    /// The task.
    pub(crate) task: Task,
    /// The family of both beams.
    pub(crate) family: &'static str,
    /// The dofs of both beams together.
    pub(crate) dofs: usize,
    /// The method.
    pub(crate) method: String,
    /// How many pairs a run does.
    pub(crate) pairs: usize,
    /// The multiply-adds of a pair, if they are counted.
    pub(crate) multiply_adds: Option<usize>,
    runner: Box<dyn Fn() -> Runner + Send + Sync>,
    judge: Box<dyn Fn() -> Error + Send + Sync>,
}

/// Does a scenario once each time it is called, with memory of its own for the results.
pub(crate) type Runner = Box<dyn FnMut()>;

impl Scenario {
    /// What does it; neither the input nor the result is visible to the optimizer.
    pub(crate) fn runner(&self) -> Runner {
        (self.runner)()
    }

    /// Compares what it yields with the truth.
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

    /// The name of the same method by one thread, if this is one by two.
    pub(crate) fn by_one_thread(&self) -> Option<String> {
        Some(many::by_threads(self.method.strip_suffix(&many::by_threads("", 2))?, 1))
    }

    /// The name of the same method one pair after another, if this is four pairs at once.
    pub(crate) fn one_by_one(&self) -> Option<String> {
        many::one_by_one(&self.method)
    }

    /// The task and the beams, which the methods of a group have in common.
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

/// Those of one pair of the standard family, two Hermite beams: all the code there is, compiled once.
fn standard() -> Vec<Scenario> {
    let input = input::hermites();
    let mut standard = matrices::standard(&input);
    standard.extend(variations::of_pair(input));
    standard.extend(closest::of_pair(input));
    counted::counted(standard)
}
