//! Which term of a program is wrong: its answers are fitted by the closed form with faults.
//!
//! Each fault of the catalogue is planted, and what the closed form then answers is compared with what the program
//! answered, at several cases. What leaves nothing but rounding is the explanation. It is the simplest such one: a fault
//! of one term, a simplification as a whole, a factor on a quantity, a factor on a term, two faults. Faults that lead to
//! the same numbers are named together.

mod accuracy;
mod equation;
mod hypothesis;
mod search;
mod site;

use super::answers::Answers;
use super::compare::Demands;
use super::vectors::Vector;
use crate::check::evaluation_point::EvaluationPoint;
use crate::closest_point::ClosestPoint;
use crate::test_beam::AnyBeam;
use crate::variant::Variant;
pub use accuracy::{ExplainedFault, Naming, explained_faults};
pub use equation::equation_of;
use hypothesis::Change;
use rayon::prelude::*;
use search::{Fit, measured_factor, search};
use site::{Memo, Site};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// What explains the answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// What is wrong: several where the answers cannot tell them apart; none if nothing explains them.
    pub causes: Vec<Cause>,
    /// The largest deviation of the answers over its scale.
    pub before: f64,
    /// The same after the explanation; that of the best attempt if there is none.
    pub after: Option<f64>,
    /// The best of the other attempts, and the deviation that it leaves.
    pub runner_up: Option<(String, f64)>,
    /// The cases that were used.
    pub cases: usize,
}

/// One thing that may be wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// Its name: that of the fault in the catalogue, if it is one.
    pub name: String,
    /// What is wrong, in a sentence without its end.
    pub words: String,
    /// The coefficient of the term in the deviation, as fitted: -2 wrong sign, -1 missing, 1 doubled, -1/2 halved.
    pub coefficient: Option<f64>,
}

/// Explains the answers to these cases; nothing if none of them can be compared.
pub fn explain(cases: &[(Vector, Answers)], demands: &Demands) -> Option<Explanation> {
    with_memo(cases, demands, &Memo::default())
}

fn with_memo(cases: &[(Vector, Answers)], demands: &Demands, memo: &Memo) -> Option<Explanation> {
    let known = cases.iter().filter_map(|case| {
        let beams = case.0.case.beams().ok()?;
        let point = case.0.evaluated(|evaluation| evaluation.point).ok()?;
        Some((case, beams, point))
    });
    let known: Vec<Known> = known.collect();
    let sites: Vec<Site> = known.par_iter().filter_map(|known| site(known, demands, memo)).collect();
    let sites = clearest(sites);
    if sites.is_empty() {
        return None;
    }
    let found = search(&sites);
    let cause = |of: &Fit| {
        let coefficient = match &of.change {
            Change::Variant(Variant::Faulty(faults)) if faults.len() == 1 && found.equal.len() <= 4 => {
                measured_factor(&sites, faults[0]).map(|factor| factor - 1.0)
            }
            Change::Variant(Variant::Weighted(_, factor)) => Some(factor - 1.0),
            _ => None,
        };
        Cause { name: of.change.name(), words: of.change.words(), coefficient }
    };
    Some(Explanation {
        causes: found.equal.iter().map(cause).collect(),
        before: found.before,
        after: found.equal.first().map(|of| of.worst),
        runner_up: found.runner_up.map(|of| (of.change.words(), of.worst)),
        cases: sites.len(),
    })
}

/// The cases at which rounding explains least: of each kind some, and all kinds in turn.
fn clearest(mut sites: Vec<Site>) -> Vec<Site> {
    sites.sort_by(|one, two| one.blur().total_cmp(&two.blur()));
    let mut turns = BTreeMap::new();
    let mut placed: Vec<(usize, Site)> = Vec::new();
    for site in sites {
        let turn: &mut usize = turns.entry(site.kind()).or_default();
        placed.push((*turn, site));
        *turn += 1;
    }
    // What is wrong in most numbers says most.
    placed.sort_by_key(|(turn, site)| (*turn, Reverse(site.wrong())));
    placed.into_iter().map(|(_, site)| site).take(USED).collect()
}

/// How many cases are used.
const USED: usize = 8;

/// A case with its answers, its beams and its closest point.
type Known<'a> = (&'a (Vector, Answers), [Box<dyn AnyBeam>; 2], ClosestPoint);

fn site<'a>((case, beams, point): &'a Known<'_>, demands: &Demands, memo: &'a Memo) -> Option<Site<'a>> {
    let beams = beams.each_ref().map(|beam| &**beam);
    let evaluate = || EvaluationPoint::new(beams, &case.0.case.contact, point).ok();
    let site = Site::new(case, demands, evaluate).filter(|site| !site.data.is_empty())?;
    Some(site.with_memo(memo.get(&case.0.id)))
}
