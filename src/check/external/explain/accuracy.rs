//! The quality of explanations: programs with faults of the catalogue, alone and in pairs, are explained.

use super::answered_case::Memo;
use super::known::Known;
use super::search::memo;
use super::{Cause, Explanation, of_faults};
use crate::check::Regime;
use crate::check::external::answers::Answers;
use crate::check::external::compare::{Demands, compare_answers};
use crate::check::external::evaluate::{Evaluator, Formulas};
use crate::check::external::report::Report;
use crate::check::external::stages::{Traced, traced, traced_in_equations};
use crate::check::external::vectors::{Drawing, Outcome, Vector};
use crate::parallel;
use crate::test_beam::Family;
use crate::variant::{Fault, Variant, catalogue, classes};
use rand::RngExt;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::collections::{BTreeMap, BTreeSet};
use std::slice;

/// Cases of each kind of pair: inside both beams, and with an end held.
const OF_A_KIND: usize = 2;
/// The maximum number of cases that are drawn.
const DRAWN: u64 = 1200;

enumeration! {
    /// Whether the faults of a program were named.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Naming {
        /// Only they were named.
        First => "first",
        /// They were named together with others that yield the same results for all beams.
        Equivalent => "equivalent",
        /// They were named together with others that yield the same numbers at these cases, but not elsewhere.
        Among => "among",
        /// One of two faults was named.
        Fewer => "fewer",
        /// Only other faults were named.
        Other => "other",
        /// Nothing was named.
        None => "none",
        /// The answers differ so little that their digits do not show which term is wrong. None is named.
        Faint => "faint",
        /// All answers agree: these cases do not detect the faults.
        Undetected => "undetected",
    }
}

/// The faults of a program and the explanation of its answers.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplainedFault {
    /// The faults: one, or two.
    pub faults: Vec<Fault>,
    /// Whether they were named.
    pub naming: Naming,
    /// What was named.
    pub named: Vec<String>,
    /// The deviation before the explanation and after it.
    pub deviation: [f64; 2],
}

/// The programs that are explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Programs {
    /// The seed of the cases, and of the choice of pairs.
    pub seed: u64,
    /// If given, the programs answer gradients and Hessians alone, and print this number of digits.
    pub digits: Option<u8>,
    /// The step through the catalogue: one of this many faults is taken.
    pub every: usize,
    /// The number of pairs of faults. In every other pair both faults belong to the same formula.
    pub pairs: usize,
}

/// Lets programs with faults of the catalogue, alone and in pairs, answer cases, and explains the answers.
pub fn explained_faults(programs: Programs) -> Vec<ExplainedFault> {
    let Programs { seed, digits, every, pairs } = programs;
    let vectors = chosen(seed);
    let demands = Demands { digits, ..Demands::default() };
    let plain = Evaluator { formulas: Formulas::Paper, ..Evaluator::default() };
    let known: Vec<_> = answered(&plain, &vectors).iter().filter_map(Known::new).collect();
    let memo: Memo = known
        .iter()
        .filter_map(|known| Some((known.vector.id.clone(), memo(&known.case(&demands)?))))
        .collect();
    let catalogue = catalogue();
    let classes = classes(&catalogue);
    let singles = catalogue.iter().step_by(every.max(1)).map(|&fault| vec![fault]);
    let all: Vec<Vec<Fault>> = singles.chain(drawn_pairs(&catalogue, seed, pairs)).collect();
    parallel::map(&all, |faults| explained(faults.clone(), &vectors, &demands, &memo, &classes))
}

/// Pairs of faults of different terms. In every other pair both terms belong to the same formula.
fn drawn_pairs(catalogue: &[Fault], seed: u64, count: usize) -> Vec<Vec<Fault>> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut pairs = Vec::new();
    while pairs.len() < count {
        let one = catalogue[random.random_range(0..catalogue.len())];
        let is_second = |two: &&Fault| {
            two.label != one.label && (pairs.len() % 2 == 0 || two.label.formula == one.label.formula)
        };
        let seconds: Vec<_> = catalogue.iter().filter(is_second).collect();
        if !seconds.is_empty() {
            let mut pair = vec![one, *seconds[random.random_range(0..seconds.len())]];
            pair.sort_unstable_by_key(|fault| catalogue.iter().position(|of| of == fault));
            pairs.push(pair);
        }
    }
    pairs
}

fn explained(
    faults: Vec<Fault>,
    vectors: &[Vector],
    demands: &Demands,
    memo: &Memo,
    classes: &BTreeMap<String, usize>,
) -> ExplainedFault {
    let deviation = |found: &Explanation| [found.before, found.after.unwrap_or(found.before)];
    let Some(report) = judged(&faults, vectors, demands) else {
        return ExplainedFault { faults, naming: Naming::Undetected, named: Vec::new(), deviation: [0.0; 2] };
    };
    let Some(found) = of_faults(&report.kept, &report.right, demands, memo, true) else {
        return ExplainedFault { faults, naming: Naming::None, named: Vec::new(), deviation: [0.0; 2] };
    };
    if found.causes.is_empty()
        && !found.is_faint
        && let Some(traced) = traced_in(&report, demands, traced)
    {
        let (naming, named) = in_equations(&faults, traced, vectors, demands);
        return ExplainedFault { faults, naming, named, deviation: deviation(&found) };
    }
    let all_named = |Cause { name, alike, .. }: &Cause| [slice::from_ref(name), alike].concat();
    let named: Vec<String> = found.causes.iter().flat_map(all_named).collect();
    let class = |name: &str| classes.get(name).map_or_else(|| name.to_owned(), ToString::to_string);
    let of_names = |names: &[String]| names.iter().map(|name| class(name)).collect::<BTreeSet<_>>();
    let words = |name: &String| name.split(" and ").map(str::to_owned).collect::<Vec<_>>();
    let own_names: BTreeSet<_> = faults.iter().map(ToString::to_string).collect();
    let own = of_names(&own_names.iter().cloned().collect::<Vec<_>>());
    let sets: Vec<_> = named.iter().map(|name| of_names(&words(name))).collect();
    let naming = match sets.as_slice() {
        [] if found.is_faint => Naming::Faint,
        [] => Naming::None,
        [_] if words(&named[0]).into_iter().collect::<BTreeSet<_>>() == own_names => Naming::First,
        all if all.iter().all(|one| *one == own) => Naming::Equivalent,
        all if all.contains(&own) => Naming::Among,
        all if all.iter().any(|one| one.is_subset(&own)) => Naming::Fewer,
        _ => Naming::Other,
    };
    ExplainedFault { faults, naming, named, deviation: deviation(&found) }
}

/// How the answers are put into the equations.
type Search = fn(&[&(Vector, Answers)], &Demands) -> Option<Traced>;

fn traced_in(report: &Report, demands: &Demands, search: Search) -> Option<Traced> {
    search(&report.kept.iter().chain(&report.right).collect::<Vec<_>>(), demands)
}

/// Whether faults are named if the answers are put into the equations: with the names that each of them has alone.
fn in_equations(
    faults: &[Fault],
    found: Traced,
    vectors: &[Vector],
    demands: &Demands,
) -> (Naming, Vec<String>) {
    let names = |found: Traced| -> BTreeSet<String> {
        let all = found.causes.into_iter().chain(found.beyond);
        // Where an error is, is no name of an error.
        all.filter(|reading| !reading.is_place).flat_map(|reading| reading.names).collect()
    };
    // One fault is told by the list of formulas, and two by the equations, so both names are known.
    let alone = |fault: &Fault| -> BTreeSet<String> {
        let report = judged(slice::from_ref(fault), vectors, demands);
        let by = |search: Search| report.as_ref().and_then(|report| traced_in(report, demands, search));
        [traced, traced_in_equations].into_iter().filter_map(by).flat_map(names).collect()
    };
    let own: Vec<_> = faults.iter().map(alone).collect();
    let named = names(found);
    let known = own.iter().filter(|of| !of.is_disjoint(&named)).count();
    let naming = match known {
        _ if named.is_empty() => Naming::None,
        0 => Naming::Other,
        known if known < faults.len() => Naming::Fewer,
        _ if named.iter().all(|name| own.iter().any(|of| of.contains(name))) => Naming::First,
        _ => Naming::Among,
    };
    (naming, named.into_iter().collect())
}

/// The answers of a program with these faults, compared; nothing if all agree.
fn judged(faults: &[Fault], vectors: &[Vector], demands: &Demands) -> Option<Report> {
    // Some terms occur in one formulation only.
    for formulas in [Formulas::Paper, Formulas::Robust] {
        let program = Evaluator {
            variant: Variant::Faulty(faults.to_vec()),
            formulas,
            digits: demands.digits.map(usize::from),
            ..Evaluator::default()
        };
        let mut report = Report::default();
        for (vector, mut answers) in answered(&program, vectors) {
            if demands.digits.is_some() {
                for answer in &mut answers.answers {
                    (answer.value, answer.variations) = (None, [None; 3]);
                }
            }
            if let Ok(compared) = compare_answers(&vector, &answers, demands) {
                report.add(vector, Some(answers), compared);
            }
        }
        if report.wrong > 0 {
            return Some(report);
        }
    }
    None
}

/// The answers of a program, written as text and read again.
fn answered(program: &Evaluator, vectors: &[Vector]) -> Vec<(Vector, Answers)> {
    vectors.iter().filter_map(|vector| Some((vector.clone(), program.answered(vector)?))).collect()
}

/// Cases of all kinds of pairs, at which no term vanishes.
fn chosen(seed: u64) -> Vec<Vector> {
    let regimes = vec![Regime::Generic, Regime::NearEnd];
    let drawing = Drawing {
        seed,
        regimes,
        families: Family::ALL.to_vec(),
        cases: DRAWN,
        penetrating: false,
        elements: false,
        steps: false,
        work: None,
    };
    let mut counts: BTreeMap<_, usize> = BTreeMap::new();
    let mut chosen = Vec::new();
    // A step that is coprime to the number of pairs of families, so that every pair occurs.
    for number in (0..DRAWN).map(|i| 37 * i % drawing.count()) {
        let vector = drawing.vector(number);
        let Ok(held) = vector.evaluated(|evaluation| evaluation.held) else { continue };
        if (held.xi && held.xi_bar) || vector.outcome() != Outcome::Valid {
            continue;
        }
        let linear = vector.families().map(Family::is_linear);
        let count = counts.entry((linear, held.xi, held.xi_bar)).or_default();
        if *count < OF_A_KIND {
            *count += 1;
            chosen.push(vector);
        }
        if chosen.len() == 12 * OF_A_KIND {
            break;
        }
    }
    chosen
}
