//! Consistency checks of the list of scenarios.

use super::{Scenario, Task};
use std::collections::BTreeSet;

/// The methods have different names, each task has a closed form or a search, and the multiply-adds are correct.
pub(crate) fn check(all: &[Scenario]) {
    let names: BTreeSet<String> = all.iter().map(Scenario::to_string).collect();
    assert_eq!(names.len(), all.len(), "two scenarios have the same name");
    let has =
        |task: Task, method: &str| all.iter().any(|of| of.task == task && of.method.starts_with(method));
    for task in [Task::Distance, Task::All, Task::WithSlips, Task::Gradients, Task::Directions] {
        assert!(has(task, "closed form"), "{task:?} has no closed form");
    }
    assert!(has(Task::ClosestPoint, "search") && has(Task::ClosestPoint, "Newton"));
    check_multiply_adds(all);
}

/// An entry of a Hessian is a sum of products; all previous operations do not depend on the layout. The numbers of
/// products are two for d, three for xi and xi_bar, two for t and t_bar, and four among the dofs of their own beam.
fn check_multiply_adds(all: &[Scenario]) {
    let of = |task: Task, method: &str| {
        let is_counted =
            |of: &&Scenario| of.task == task && of.method == method && of.multiply_adds.is_some();
        all.iter().find(is_counted).and_then(|of| of.multiply_adds).expect("they are counted")
    };
    // The products between the beams, and among the dofs of each beam.
    for (task, mixed, own) in [(Task::Distance, 2, 2 + 2), (Task::All, 2 + 3 + 3 + 2 + 2, 4 + 6 + 6 + 6 + 6)]
    {
        let blocks = of(task, "closed form");
        assert_eq!(of(task, "closed form, in full"), blocks + mixed * 12 * 12, "{task:?}");
        // Six of the sixteen blocks of two control vectors of a beam.
        assert_eq!(of(task, "closed form, packed"), blocks - own * 6 * 9, "{task:?}");
    }
}
