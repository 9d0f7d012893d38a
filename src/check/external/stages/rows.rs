//! Possible errors of an equation: each changes some of its terms.

mod replaced;
mod row;
mod substitutes;

use super::equations::{Equation, Zero};
use super::terms::{Factor, Number, Part, Reach, Tag, Term, Terms};
use super::words::words;
use crate::linearization::Quantity;
use replaced::replaced;
use row::Group;
pub(super) use row::{Row, What};

/// All possible errors of a form of an equation.
pub(super) fn rows(form: &Zero, Equation { results, at, .. }: &Equation) -> Vec<Row> {
    let mut rows = Vec::new();
    for (words, terms) in &form.extras {
        rows.push(Row {
            what: What::Replaced { of: String::new(), words: words.clone() },
            terms: terms.clone(),
        });
    }
    let groups = groups(form, results);
    let mut known: Vec<&Terms> = Vec::new();
    for Group { name, terms, .. } in &groups {
        if !known.contains(&terms) {
            known.push(terms);
            rows.push(Row { what: What::Factor(name.clone()), terms: terms.clone() });
        }
    }
    in_both(form, &mut rows);
    for group in &groups {
        replaced(group, &mut rows);
    }
    // A variation that is zero in the place of another one says no more than that this one is missing.
    let is_zero = |factor: &Factor| match factor {
        Factor::Number(Number::Of(of, 1..)) => at.other_is_held() == Some(*of),
        _ => false,
    };
    let has_zero = |term: &&Term| term.factors.iter().any(is_zero);
    let is_new = |term: &&Term| !form.terms.iter().any(|known| known.factors == term.factors);
    rows.retain(|row| !row.terms.is_empty() && !row.terms.iter().filter(is_new).any(|term| has_zero(&term)));
    rows
}

/// All tags of an equation.
fn tags(form: &Zero) -> Vec<Tag> {
    let mut tags: Vec<Tag> = form.terms.iter().flat_map(|term| &term.tags).map(|(tag, _)| *tag).collect();
    tags.sort_unstable();
    tags.dedup();
    tags
}

/// Terms with a tag in common, and single terms. Small groups come first.
fn groups(form: &Zero, results: &[(Quantity, Part)]) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    let mut add_group = |group: Group| {
        let is_same = |known: &Group| known.terms == group.terms && known.reach == group.reach;
        if !group.terms.is_empty() && !groups.iter().any(is_same) {
            groups.push(group);
        }
    };
    let of_tag = |tag: Tag| {
        let reach = |term: &Term| {
            let of_tag = term.tags.iter().filter(|(of, _)| *of == tag);
            of_tag.map(|(_, reach)| *reach).reduce(|one, other| one | other)
        };
        let found = form.terms.iter().filter_map(|term| Some((term.clone(), reach(term)?)));
        let (terms, reach) = found.unzip();
        Group { name: tag.into(), terms, reach }
    };
    // Of two names of the same terms, that of the whole terms is meant, but not one of both of two terms.
    let is_whole = |of: &Group| {
        let is_all = of.terms.iter().zip(&of.reach).all(|(term, reach)| *reach == all_of(term));
        is_all && !of.name.starts_with("both ")
    };
    let (whole, others): (Vec<_>, Vec<_>) = tags(form).into_iter().map(of_tag).partition(is_whole);
    whole.into_iter().chain(others).for_each(&mut add_group);
    let mut add = |name: String, terms: Terms| {
        let reach = vec![Reach::MAX; terms.len()];
        add_group(Group { name, terms, reach });
    };
    if form.is_elementary {
        let is_result = |term: &&Term| term.factors.iter().any(|factor| is_result(factor, results));
        // A result alone is what the program answers, and not a term of its own.
        let is_alone = |term: &&Term| is_result(term) && term.factors.len() == 1;
        for term in form.terms.iter().filter(|term| !is_alone(term)) {
            add(words(term), vec![term.clone()]);
        }
        let rest: Terms = form.terms.iter().filter(|term| !is_result(term)).cloned().collect();
        let result: Terms = form.terms.iter().filter(is_result).cloned().collect();
        if !result.iter().all(|term| is_alone(&term)) {
            add("the result".into(), result);
        }
        add("the right-hand side".into(), rest);
    }
    groups.sort_by_key(|group| group.terms.len());
    groups
}

/// The reach of a name that is on all factors of a term.
fn all_of(term: &Term) -> Reach {
    (1 << (2 * term.factors.len())) - 1
}

/// A part that occurs in both factors of a product, with another factor.
fn in_both(form: &Zero, rows: &mut Vec<Row>) {
    for tag in tags(form) {
        let count =
            |term: &Term| i32::try_from(term.tags.iter().filter(|(of, _)| *of == tag).count()).unwrap_or(0);
        if form.terms.iter().all(|term| count(term) < 2) {
            continue;
        }
        for (factor, words) in [(-1.0, "has the wrong sign"), (2.0, "counts twice"), (0.5, "is halved")] {
            let terms = form
                .terms
                .iter()
                .filter(|term| count(term) > 0)
                .map(|term| Term {
                    coefficient: term.coefficient * (f64::powi(factor, count(term)) - 1.0),
                    ..term.clone()
                })
                .filter(|term| term.coefficient != 0.0)
                .collect();
            rows.push(Row {
                what: What::Replaced { of: tag.into(), words: format!("it {words}, in both factors") },
                terms,
            });
        }
    }
}

fn is_result(factor: &Factor, results: &[(Quantity, Part)]) -> bool {
    match factor {
        Factor::Number(Number::Of(q, p) | Number::Component(q, _, p)) => results.contains(&(*q, *p)),
        Factor::Number(Number::Element(_)) => true,
        _ => false,
    }
}

/// Whether a result stays in the equation if these errors are made, so that they say something.
pub(super) fn leaves_a_result(form: &Zero, results: &[(Quantity, Part)], errors: &[(&Row, f64)]) -> bool {
    let mut sum: Vec<(Vec<Factor>, f64)> = Vec::new();
    let mut add = |term: &Term, by: f64| {
        let mut factors = term.factors.clone();
        factors.sort_by_cached_key(|factor| format!("{factor:?}"));
        match sum.iter_mut().find(|(known, _)| *known == factors) {
            Some((_, c)) => *c += by * term.coefficient,
            None => sum.push((factors, by * term.coefficient)),
        }
    };
    form.terms.iter().for_each(|term| add(term, 1.0));
    for (row, by) in errors {
        row.terms.iter().for_each(|term| add(term, *by));
    }
    let is_result = |factor: &Factor| is_result(factor, results);
    let left = || sum.iter().filter(|(_, c)| c.abs() > 1e-12);
    let had_result = form.terms.iter().any(|term| term.factors.iter().any(is_result));
    left().any(|(factors, _)| !had_result || factors.iter().any(is_result))
}
