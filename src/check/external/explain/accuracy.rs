//! How well explanations are: every fault of the catalogue, answered by a program that has it.

use super::search::memo;
use super::site::Memo;
use super::{Cause, Known, site, with_memo};
use crate::check::Regime;
use crate::check::external::answers::{AnswerReader, Answers};
use crate::check::external::compare::{Demands, compare_answers};
use crate::check::external::evaluate::{Evaluator, Formulas};
use crate::check::external::report::Report;
use crate::check::external::vectors::{Drawing, Outcome, Vector};
use crate::test_beam::Family;
use crate::variant::{Fault, Variant, catalogue, classes};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Cases of each kind of pair: inside both beams, and with an end held.
const OF_A_KIND: usize = 2;
/// Cases that are drawn at most.
const DRAWN: u64 = 1200;

/// Whether a fault was named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Naming {
    /// It alone.
    First,
    /// With others that lead to the same results for all beams.
    Equivalent,
    /// With others that lead to the same numbers at these cases, and to others elsewhere.
    Among,
    /// Another fault was named.
    Other,
    /// Nothing was named.
    None,
    /// All answers agree: the fault does not show at these cases.
    Undetected,
}

impl Naming {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::First, Self::Equivalent, Self::Among, Self::Other, Self::None, Self::Undetected];

    /// The name, as tables have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::First => "first",
            Self::Equivalent => "equivalent",
            Self::Among => "among",
            Self::Other => "other",
            Self::None => "none",
            Self::Undetected => "undetected",
        }
    }
}

/// A fault and what the explanation made of its answers.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplainedFault {
    /// The fault.
    pub fault: Fault,
    /// Whether it was named.
    pub naming: Naming,
    /// What was named.
    pub named: Vec<String>,
    /// The deviation before the explanation and after it.
    pub deviation: [f64; 2],
}

/// Has every fault of the catalogue answered by a program that has it, and its answers explained.
///
/// With `digits` the program answers gradients and Hessians alone, and prints so many digits.
pub fn explained_faults(seed: u64, digits: Option<u8>) -> Vec<ExplainedFault> {
    let vectors = chosen(seed);
    let demands = Demands { digits, ..Demands::default() };
    let plain = Evaluator { formulas: Formulas::Paper, ..Evaluator::default() };
    let known: Vec<_> = answered(&plain, &vectors);
    let memo: Memo = known
        .iter()
        .filter_map(|case| {
            let beams = case.0.case.beams().ok()?;
            let point = case.0.evaluated(|evaluation| evaluation.point).ok()?;
            let known: Known = (case, beams, point);
            let none = Memo::default();
            let site = site(&known, &demands, &none)?;
            Some((case.0.id.clone(), memo(&site)))
        })
        .collect();
    let catalogue = catalogue();
    let classes = classes(&catalogue);
    catalogue.par_iter().map(|&fault| explained(fault, &vectors, &demands, &memo, &classes)).collect()
}

fn explained(
    fault: Fault,
    vectors: &[Vector],
    demands: &Demands,
    memo: &Memo,
    classes: &BTreeMap<String, usize>,
) -> ExplainedFault {
    let mut found = None;
    // Some terms are at work in one formulation only.
    for formulas in [Formulas::Paper, Formulas::Robust] {
        let program = Evaluator {
            variant: Variant::Faulty(vec![fault]),
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
                report.add(vector, answers, compared);
            }
        }
        if report.wrong > 0 {
            found = with_memo(&report.kept, demands, memo);
            break;
        }
    }
    let Some(found) = found else {
        return ExplainedFault { fault, naming: Naming::Undetected, named: Vec::new(), deviation: [0.0; 2] };
    };
    let named: Vec<String> = found.causes.iter().map(|Cause { name, .. }| name.clone()).collect();
    let (own, class) = (fault.to_string(), |name: &String| classes.get(name));
    let naming = match named.as_slice() {
        [] => Naming::None,
        [one] if *one == own => Naming::First,
        all if all.iter().all(|name| class(name).is_some() && class(name) == class(&own)) => {
            Naming::Equivalent
        }
        all if all.contains(&own) || all.iter().any(|name| class(name) == class(&own)) => Naming::Among,
        _ => Naming::Other,
    };
    ExplainedFault { fault, naming, named, deviation: [found.before, found.after.unwrap_or(found.before)] }
}

/// What a program answers, as text that is read again.
fn answered(program: &Evaluator, vectors: &[Vector]) -> Vec<(Vector, Answers)> {
    let answer = |vector: &Vector| {
        let text = format!("{}\n{}\n", program.head(), program.line(vector));
        let mut reader = AnswerReader::new(text.as_bytes(), "answers").ok()?;
        Some((vector.clone(), reader.next_answers().ok()??))
    };
    vectors.iter().filter_map(answer).collect()
}

/// Cases of all kinds of pairs, at which no term vanishes.
fn chosen(seed: u64) -> Vec<Vector> {
    let regimes = vec![Regime::Generic, Regime::NearEnd];
    let drawing = Drawing { seed, regimes, families: Family::ALL.to_vec(), cases: DRAWN, penetrating: false };
    let mut counts: BTreeMap<_, usize> = BTreeMap::new();
    let mut chosen = Vec::new();
    // A step that is coprime to the number of pairs of families, so that all are met.
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
