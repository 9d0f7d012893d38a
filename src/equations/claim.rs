//! The claims of the paper about symmetry, and the results of the runs.

use super::record::{Claim, EquationRow, Run};
use super::table::Reading;
use super::verdict::Symmetry;

/// The claims, with the results of the runs that they refer to.
pub(super) fn claims(equations: &[EquationRow]) -> Vec<Claim> {
    let as_corrected = |_: u8, run: &Run, corrected: bool| corrected && run.reading != Reading::Other;
    let printed = |run: &Run| run.reading == Reading::Printed;
    let hat = |number: u8| [39, 40, 57].contains(&number);
    vec![
        claim(
            equations,
            "Δδx_C and Δδx_C,ξ are symmetric",
            "sec. 3.1: (27), (30), (31)",
            |number, run, _| [27, 30, 31].contains(&number) && printed(run),
        ),
        claim(equations, "all operators are symmetric", "abstract, as corrected", as_corrected),
        claim(equations, "all operators are symmetric", "abstract, as printed", |_, run, _| printed(run)),
        claim(
            equations,
            "Δδd with Δᵤû_C is symmetric",
            "corrected: (39), (40), (57)",
            |n, run, last| hat(n) && as_corrected(n, run, last),
        ),
        claim(equations, "Δδd with total Δû_C is symmetric", "printed: (39), (40), (57)", |n, run, _| {
            hat(n) && printed(run)
        }),
    ]
}

/// A claim about the runs that `about` selects by number, and by whether they are the last correction.
fn claim(equations: &[EquationRow], says: &str, made: &str, about: impl Fn(u8, &Run, bool) -> bool) -> Claim {
    let mut claim =
        Claim { says: says.to_owned(), made: made.to_owned(), found: [0; 3], broken_by: Vec::new() };
    for entry in equations {
        for part in &entry.parts {
            for run in &part.runs {
                let last = part.corrected().is_some_and(|last| std::ptr::eq(last, run));
                let Some(symmetry) = run.symmetry().filter(|_| about(entry.number, run, last)) else {
                    continue;
                };
                let i = match symmetry {
                    Symmetry::ByForm => 0,
                    Symmetry::ByRelations => 1,
                    Symmetry::Not => 2,
                };
                claim.found[i] += 1;
                if symmetry == Symmetry::Not && !claim.broken_by.contains(&entry.number) {
                    claim.broken_by.push(entry.number);
                }
            }
        }
    }
    claim
}
