//! Finds the wrong term of a program.
//!
//! First, its answers are put into the equations and into the list of formulas. If these do not explain all answers, they are
//! fitted by the closed form with faults. Each fault of the catalogue is injected, and the answers of the closed form with it
//! are compared with the answers of the program, at several cases: values, variations along the directions, gradients and
//! Hessians contracted with them, and single entries of these. A fault that leaves only rounding is an explanation. The
//! simplest is chosen: a fault of one term, a simplification as a whole, a factor on a quantity.
//!
//! Answers may have few digits, so that several faults leave only rounding. Deviations are squared and summed, each
//! over the probable rounding error. The explanation with the smallest sum is the best. Another one is distinct from
//! it if its sum is larger by 25, five standard deviations. All others are named together. If correct answers are among
//! them, no cause is named.

mod accuracy;
mod answered_case;
mod datum;
mod element;
mod element_search;
mod fit;
mod hypothesis;
mod known;
mod pairs;
mod search;
mod wording;

use super::answers::Answers;
use super::compare::Demands;
use super::stages::{Reading, Traced, traced};
use super::vectors::Vector;
use crate::check::serialized::short;
use crate::parallel;
use crate::variant::Variant;
pub use accuracy::{ExplainedFault, Naming, Programs, explained_faults};
use answered_case::{AnsweredCase, Memo};
use fit::{Fit, near, race};
use hypothesis::Change;
use known::Known;
use search::{Equal, KEPT, before, coefficient, ranked, search};
use serde::Serialize;
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// The explanation of the answers.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Explanation {
    /// The causes: several if the answers cannot distinguish them; none if nothing explains the answers.
    pub causes: Vec<Cause>,
    /// The largest deviation of the answers over its scale.
    #[serde(serialize_with = "short::serialize")]
    pub before: f64,
    /// The same after the explanation; that of the best attempt if there is no explanation.
    #[serde(serialize_with = "short::option")]
    pub after: Option<f64>,
    /// The best of the other attempts.
    pub runner_up: Option<RunnerUp>,
    /// The cases that were used.
    pub cases: usize,
    /// Whether correct answers explain these as well, within their digits. Then there is no cause.
    pub is_faint: bool,
    /// The first equation that the answers do not satisfy, as a sentence without its full stop, if they were put into the
    /// equations one after the other.
    pub place: Option<String>,
    /// What is wrong beyond it, as sentences.
    pub beyond: Vec<String>,
    /// Whether the causes are changes of [`LIST_OF_FORMULAS`](super::LIST_OF_FORMULAS).
    #[serde(skip)]
    pub is_of_formulas: bool,
}

/// The best attempt that is no explanation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RunnerUp {
    /// What would be wrong, as a sentence without its full stop.
    pub words: String,
    /// The remaining deviation over its scale.
    #[serde(serialize_with = "short::serialize")]
    pub left: f64,
}

/// One possible cause.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cause {
    /// Its name: that of the fault in the catalogue, if it is one.
    pub name: String,
    /// What is wrong, as a sentence without its full stop.
    pub words: String,
    /// The coefficient of the term in the deviation, as fitted: -2 wrong sign, -1 missing, 1 doubled, -1/2 halved.
    pub coefficient: Option<f64>,
    /// The names of other kinds of faults of the same terms that yield the same numbers at these cases.
    pub alike: Vec<String>,
}

/// Explains the wrong answers to these cases; nothing if none of them can be compared. `right` are cases at which nothing
/// is wrong.
///
/// The answers are put into the equations and into the list of formulas. If these do not explain all answers, faults of this
/// library's formulas are tried.
pub fn explain(
    cases: &[(Vector, Answers)],
    right: &[(Vector, Answers)],
    demands: &Demands,
) -> Option<Explanation> {
    let traced = traced(&cases.iter().chain(right).collect::<Vec<_>>(), demands);
    let is_element = cases.iter().all(|(vector, _)| vector.element.is_some());
    // The formulas of a contact element, searched as a whole, tell more than faults of single terms.
    let is_told = |of: &Traced| of.is_one() || (is_element && (of.is_of_formulas || !of.causes.is_empty()));
    match traced {
        Some(traced) if is_told(&traced) => {
            Some(Explanation { cases: traced.cases, ..Explanation::default() }.with(traced))
        }
        traced => Some(with_faults_first(of_faults(cases, right, demands, &Memo::default(), false)?, traced)),
    }
}

/// The same for answers of this library's formulas with faults: these are tried first, one and two, so they have the names of the
/// catalogue.
pub(crate) fn explain_own(
    cases: &[(Vector, Answers)],
    right: &[(Vector, Answers)],
    demands: &Demands,
) -> Option<Explanation> {
    let found = of_faults(cases, right, demands, &Memo::default(), true)?;
    let traced = || traced(&cases.iter().chain(right).collect::<Vec<_>>(), demands);
    let traced = if found.causes.is_empty() { traced() } else { None };
    Some(with_faults_first(found, traced))
}

/// The faults, if some explain the answers; else what the equations say of them.
fn with_faults_first(found: Explanation, traced: Option<Traced>) -> Explanation {
    let is_open = found.causes.is_empty() && !found.is_faint;
    match traced.filter(|_| is_open) {
        Some(traced) => found.with(traced),
        None => found,
    }
}

impl Explanation {
    /// The explanation with what the equations say of the answers.
    fn with(self, traced: Traced) -> Self {
        let cause = |Reading { names, words, coefficient, .. }: Reading| Cause {
            name: names.join(" and "),
            words,
            coefficient,
            alike: Vec::new(),
        };
        let is_known = !traced.causes.is_empty();
        let [before, after] = traced.deviation.map_or([self.before, 0.0], |deviation| deviation);
        Self {
            causes: traced.causes.into_iter().map(cause).collect(),
            before,
            after: traced.deviation.map(|_| after),
            runner_up: if is_known { None } else { self.runner_up },
            cases: if is_known { traced.cases } else { self.cases },
            is_faint: false,
            place: Some(traced.place),
            is_of_formulas: traced.is_of_formulas,
            beyond: traced.beyond.iter().take(BEYOND).map(|of| format!("Beyond it {}.", of.words)).collect(),
        }
    }
}

/// The faults that explain the answers, and do not spoil the right ones: one, or two if this is asked.
fn of_faults(
    cases: &[(Vector, Answers)],
    right: &[(Vector, Answers)],
    demands: &Demands,
    memo: &Memo,
    with_pairs: bool,
) -> Option<Explanation> {
    let known: Vec<Known> = cases.iter().filter_map(Known::new).collect();
    let case = |i: usize| Some((i, known[i].case(demands)?.with_memo(memo.get(&known[i].vector.id))));
    let clear = clearest(parallel::indices(known.len(), case).into_iter().flatten().collect());
    if clear.is_empty() {
        return None;
    }
    let cases: Vec<&AnsweredCase> = clear.iter().map(|(_, case)| case).collect();
    let mut fits = search(&cases, with_pairs);
    // More data are used only to distinguish several explanations.
    let before = before(&cases);
    if near(&fits).len() > 1 && near(&fits).iter().any(|fit| fit.explains(before)) {
        let of_entries: Vec<Known> =
            clear.iter().take(PROBED).flat_map(|(i, _)| known[*i].entries()).collect();
        let mut entries =
            parallel::filter_map(&of_entries, |known| known.case(demands).map(AnsweredCase::of_arrays));
        entries.retain(|case| !case.data.is_empty());
        fits = race(fits, &entries.iter().collect::<Vec<_>>(), KEPT);
    }
    let mut found = ranked(fits, &cases);
    let right: Vec<Known> = right.iter().take(USED).filter_map(Known::new).collect();
    let right = parallel::filter_map(&right, |known| known.case(demands));
    let right: Vec<&AnsweredCase> = right.iter().collect();
    found.equal.retain(|of| Fit::of(of.fit.change.clone(), &right).over <= 1.0);
    let cause = |Equal { fit: of, alike }: &Equal| {
        let coefficient = match &of.change {
            Change::Variant(Variant::Faulty(faults)) if faults.len() == 1 && found.equal.len() <= 4 => {
                coefficient(&cases, faults[0])
            }
            _ => None,
        };
        let alike = alike.iter().map(Change::name).collect();
        Cause { name: of.change.name(), words: of.change.words(), coefficient, alike }
    };
    Some(Explanation {
        causes: found.equal.iter().map(cause).collect(),
        before: found.before,
        after: found.equal.first().map(|of| of.fit.worst),
        runner_up: found.runner_up.map(|of| RunnerUp { words: of.change.words(), left: of.worst }),
        cases: cases.len(),
        is_faint: found.is_faint,
        place: None,
        beyond: Vec::new(),
        is_of_formulas: false,
    })
}

/// The number of sentences on what is wrong beyond the first equation.
const BEYOND: usize = 1;
/// The number of cases that are used.
const USED: usize = 24;
/// The number of these cases at which single entries of gradients and Hessians are used.
const PROBED: usize = 12;

/// The cases with the smallest rounding: some of each kind. The kinds alternate.
fn clearest(mut cases: Vec<(usize, AnsweredCase)>) -> Vec<(usize, AnsweredCase)> {
    cases.sort_by(|one, two| one.1.blur().total_cmp(&two.1.blur()));
    let mut counts = BTreeMap::new();
    let mut placed: Vec<(usize, (usize, AnsweredCase))> = Vec::new();
    for case in cases {
        let count: &mut usize = counts.entry(case.1.kind()).or_default();
        placed.push((*count, case));
        *count += 1;
    }
    // The cases with the most wrong numbers are the most informative.
    placed.sort_by_key(|(count, case)| (*count, Reverse(case.1.wrong())));
    placed.into_iter().map(|(_, case)| case).take(USED).collect()
}
