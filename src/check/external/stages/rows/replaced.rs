//! Terms in which something else stands in the place of a factor.

use super::row::{Group, Row, What};
use super::substitutes::{substitutes, substitutes_of};
use crate::check::external::stages::terms::{Factor, Number, Reach, Term, Terms, Vector, scaled};
use crate::check::external::stages::words::{number_words, vector_words};
use crate::linearization::Quantity;

/// A factor with the sides that the name of its group is on: of a scalar product one or both, else all or nothing.
type Reached<'a> = (&'a Factor, [bool; 2]);

/// The factors of a term that the name of its group is on.
fn reached(term: &Term, reach: Reach) -> impl Iterator<Item = Reached<'_>> {
    let sides = move |i: usize| [0, 1].map(|side| reach >> (2 * i + side) & 1 == 1);
    term.factors.iter().enumerate().map(move |(i, factor)| (factor, sides(i)))
}

/// The change of terms if each factor becomes a sum of products.
fn changed(group: &Group, change: impl Fn(Reached) -> Option<Vec<(f64, Vec<Factor>)>>) -> Terms {
    let mut sum = Vec::new();
    for (term, reach) in group.terms.iter().zip(&group.reach) {
        let changes: Vec<_> = reached(term, *reach).map(&change).collect();
        if changes.iter().all(Option::is_none) {
            continue;
        }
        let mut products = vec![(term.coefficient, Vec::new())];
        for (factor, change) in term.factors.iter().zip(changes) {
            let others = change.unwrap_or_else(|| vec![(1.0, vec![*factor])]);
            let with = |(c, factors): &(f64, Vec<Factor>)| {
                others.iter().map(|(by, more)| (c * by, [&factors[..], more].concat())).collect::<Vec<_>>()
            };
            products = products.iter().flat_map(with).collect();
        }
        sum.extend(products.into_iter().map(|(coefficient, factors)| Term {
            coefficient,
            factors,
            tags: vec![],
        }));
        sum.push(Term { coefficient: -term.coefficient, ..term.clone() });
    }
    sum
}

/// The terms with vectors in the place of others.
fn with_vectors(group: &Group, of: impl Fn(Vector) -> Vector) -> Terms {
    changed(group, |(factor, sides)| match *factor {
        Factor::Dot(a, b) => {
            let [to_a, to_b] = [(a, sides[0]), (b, sides[1])].map(|(v, is_on)| if is_on { of(v) } else { v });
            ((to_a, to_b) != (a, b)).then(|| vec![(1.0, vec![Factor::Dot(to_a, to_b)])])
        }
        _ => None,
    })
}

/// The terms with numbers in the place of others.
fn with_numbers(group: &Group, of: impl Fn(Number) -> Number) -> Terms {
    changed(group, |(factor, sides)| match *factor {
        Factor::Number(number) if sides[0] && of(number) != number => {
            Some(vec![(1.0, vec![Factor::Number(of(number))])])
        }
        _ => None,
    })
}

/// The beginning of words for several things.
const MANY: &str = "the components";
const LENGTHS: [Quantity; 3] = [Quantity::D, Quantity::T, Quantity::TBar];

fn unique<T: PartialEq + Copy>(all: impl Iterator<Item = T>) -> Vec<T> {
    all.fold(Vec::new(), |mut known, of| {
        if !known.contains(&of) {
            known.push(of);
        }
        known
    })
}

pub(super) fn replaced(group: &Group, rows: &mut Vec<Row>) {
    let mut add = |words: String, terms: Terms| {
        // Groups that overlap have some errors in common. The smallest group names them.
        if !terms.is_empty() && !rows.iter().any(|row| row.terms == terms) {
            rows.push(Row { what: What::Replaced { of: group.name.clone(), words }, terms });
        }
    };
    let factors = || group.terms.iter().zip(&group.reach).flat_map(|(term, reach)| reached(term, *reach));
    let is_on = |sides: [bool; 2]| sides[0] || sides[1];
    let dots = unique(factors().filter_map(|(factor, sides)| match *factor {
        Factor::Dot(v, w) if is_on(sides) => Some((v, w)),
        _ => None,
    }));
    let numbers = unique(factors().filter_map(|(factor, sides)| match *factor {
        Factor::Number(n) if is_on(sides) => Some(n),
        _ => None,
    }));
    let vectors = unique(factors().flat_map(|(factor, sides)| match *factor {
        Factor::Dot(v, w) => {
            [(v, sides[0]), (w, sides[1])].into_iter().filter(|of| of.1).map(|of| of.0).collect()
        }
        _ => Vec::new(),
    }));
    for &v in &vectors {
        for w in substitutes(v).into_iter().chain(v.permuted()) {
            let terms = with_vectors(group, |of| if of == v { w } else { of });
            add(in_place(&vector_words(w), &vector_words(v)), terms);
        }
        components(group, v, &mut add);
    }
    // The vectors that the terms are multiplied by.
    let others = Group { reach: group.reach.iter().map(|reach| !reach).collect(), ..group.clone() };
    for v in unique(factors().filter_map(|(factor, sides)| match *factor {
        Factor::Dot(v, _) if !sides[0] => Some(v),
        Factor::Dot(_, w) if !sides[1] => Some(w),
        _ => None,
    })) {
        for w in substitutes(v) {
            let terms = with_vectors(&others, |of| if of == v { w } else { of });
            add(in_place(&vector_words(w), &vector_words(v)), terms);
        }
    }
    of_a_beam(group, &mut add);
    for (v, w) in dots {
        let terms = changed(group, |(factor, sides)| {
            (is_on(sides) && *factor == Factor::Dot(v, w)).then(|| vec![(1.0, vec![Factor::Size(v, w)])])
        });
        add(
            format!("the absolute value of {}.{} stands in its place", vector_words(v), vector_words(w)),
            terms,
        );
    }
    for &number in &numbers {
        let mut others: Vec<(String, Vec<Factor>)> = substitutes_of(number)
            .into_iter()
            .map(|other| (number_words(other), vec![Factor::Number(other)]))
            .collect();
        if matches!(number, Number::Moved(..) | Number::Of(_, 1 | 2)) {
            others.push((format!("|{}|", number_words(number)), vec![Factor::SizeOf(number)]));
        }
        if matches!(number, Number::Of(Quantity::D | Quantity::T | Quantity::TBar, 0)) {
            others.push(("1".into(), vec![]));
        }
        for (words, with) in others {
            let terms = changed(group, |(factor, sides)| {
                (is_on(sides) && *factor == Factor::Number(number)).then(|| vec![(1.0, with.clone())])
            });
            add(in_place(&words, &number_words(number)), terms);
        }
    }
    multiplied(group, &mut add);
}

/// Words for something in the place of something else.
fn in_place(w: &str, v: &str) -> String {
    let verb = if w.starts_with(MANY) { "stand" } else { "stands" };
    format!("{w} {verb} in the place of {v}")
}

/// All variations of a beam, or the beam, taken for others.
fn of_a_beam(group: &Group, add: &mut impl FnMut(String, Terms)) {
    for beam in 0..2 {
        for order in 0..3 {
            for other in (0..3).filter(|k| *k != order) {
                let terms = with_vectors(group, |of| match of {
                    Vector::U(side, b, k) if (b, k) == (beam, order) => Vector::U(side, b, other),
                    of => of,
                });
                let of = |k| vector_words(Vector::U(0, beam, k));
                add(in_place(&of(other), &of(order)), terms);
            }
        }
        let xi = [Quantity::Xi, Quantity::XiBar];
        let terms = with_numbers(group, |of| match of {
            Number::Of(q, part @ 1..) if q == xi[beam] => Number::Of(xi[1 - beam], part),
            of => of,
        });
        let [of, other] = [xi[beam], xi[1 - beam]].map(Quantity::name);
        add(in_place(&format!("the derivative of {other}"), &format!("that of {of}")), terms);
        let terms = with_vectors(group, |of| match of {
            Vector::T(b, k) if b == beam => Vector::T(1 - b, k),
            Vector::U(s, b, k) if b == beam => Vector::U(s, 1 - b, k),
            of => of,
        });
        add(in_place(["bar beam", "beam"][beam], ["beam", "bar beam"][beam]), terms);
    }
}

/// The terms multiplied by powers of lengths.
fn multiplied(group: &Group, add: &mut impl FnMut(String, Terms)) {
    let mut powers: Vec<(String, Vec<Factor>)> = Vec::new();
    for length in LENGTHS {
        for power in [1_i32, -1, 2, -2] {
            let by = if power > 0 { "multiplied" } else { "divided" };
            let square = if power.abs() == 2 { "^2" } else { "" };
            powers.push((
                format!("it is {by} by {}{square}", length.name()),
                vec![Factor::Power(length, power)],
            ));
        }
    }
    for power in [2_i32, -2] {
        let both = [Quantity::T, Quantity::TBar].map(|of| Factor::Power(of, power)).to_vec();
        powers.push((
            format!("it is {} by t^2 t_bar^2", if power > 0 { "multiplied" } else { "divided" }),
            both,
        ));
    }
    for (words, by) in powers {
        let mut terms: Terms = group.terms.clone();
        for term in &mut terms {
            term.factors.extend(&by);
        }
        terms.extend(scaled(-1.0, &group.terms));
        add(words, terms);
    }
}

/// A component of v, or of its partner, left out, or taken for another one.
fn components(group: &Group, v: Vector, add: &mut impl FnMut(String, Terms)) {
    let axis = ["x", "y", "z"];
    let name = vector_words(v);
    for j in 0..3 {
        let of_dot = |with: &dyn Fn(Vector) -> Vec<(f64, Factor)>| {
            changed(group, |(factor, sides)| match *factor {
                Factor::Dot(a, b) if (sides[0] && a == v) || (sides[1] && b == v) => {
                    let partner = if sides[0] && a == v { b } else { a };
                    let mut others = vec![(1.0, vec![*factor])];
                    others.extend(with(partner).into_iter().map(|(c, factor)| (c, vec![factor])));
                    Some(others)
                }
                _ => None,
            })
        };
        let minus = |w: Vector| (-1.0, Factor::Entry(v, j, w, j));
        add(format!("the component {} of {name} is missing", axis[j]), of_dot(&|w| vec![minus(w)]));
        add(
            format!("the component {} of {name} has the wrong sign", axis[j]),
            of_dot(&|w| vec![minus(w), minus(w)]),
        );
        for i in (0..3).filter(|i| *i != j) {
            let terms = of_dot(&|w| vec![minus(w), (1.0, Factor::Entry(v, i, w, j))]);
            add(format!("the component {} of {name} stands in the place of {}", axis[i], axis[j]), terms);
            let terms = of_dot(&|w| vec![minus(w), (1.0, Factor::Entry(v, j, w, i))]);
            add(
                format!(
                    "the component {} stands in the place of {} in the products with {name}",
                    axis[i], axis[j]
                ),
                terms,
            );
            let terms = of_dot(&|w| vec![minus(w), (1.0, Factor::Entry(v, i, w, i))]);
            add(
                format!(
                    "the component {} counts twice, and {} is missing in the products with {name}",
                    axis[i], axis[j]
                ),
                terms,
            );
        }
    }
}
