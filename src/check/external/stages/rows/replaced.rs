//! Terms in which something else stands in the place of a factor.

use super::{Row, What};
use crate::check::external::stages::terms::{Factor, Number, Term, Terms, Vector, scaled};
use crate::check::external::stages::words::{number_words, vector_words};
use crate::linearization::Quantity;

/// The change of terms if each factor becomes a sum of products.
fn changed(group: &Terms, change: impl Fn(&Factor) -> Option<Vec<(f64, Vec<Factor>)>>) -> Terms {
    let mut sum = Vec::new();
    for term in group {
        if term.factors.iter().all(|factor| change(factor).is_none()) {
            continue;
        }
        let mut products = vec![(term.coefficient, Vec::new())];
        for factor in &term.factors {
            let others = change(factor).unwrap_or_else(|| vec![(1.0, vec![*factor])]);
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
fn with_vectors(group: &Terms, of: impl Fn(Vector) -> Vector) -> Terms {
    changed(group, |factor| match *factor {
        Factor::Dot(a, b) if (of(a), of(b)) != (a, b) => Some(vec![(1.0, vec![Factor::Dot(of(a), of(b))])]),
        _ => None,
    })
}

/// The terms with numbers in the place of others.
fn with_numbers(group: &Terms, of: impl Fn(Number) -> Number) -> Terms {
    changed(group, |factor| match *factor {
        Factor::Number(number) if of(number) != number => Some(vec![(1.0, vec![Factor::Number(of(number))])]),
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

pub(super) fn replaced(name: &str, group: &Terms, rows: &mut Vec<Row>) {
    let mut add = |words: String, terms: Terms| {
        if !terms.is_empty() {
            rows.push(Row { what: What::Replaced { of: name.to_owned(), words }, terms });
        }
    };
    let factors = || group.iter().flat_map(|term| &term.factors);
    let dots = unique(factors().filter_map(|f| if let Factor::Dot(v, w) = *f { Some((v, w)) } else { None }));
    let numbers = unique(factors().filter_map(|f| if let Factor::Number(n) = *f { Some(n) } else { None }));
    let vectors = unique(dots.iter().flat_map(|(v, w)| [*v, *w]));
    let in_place = |w: String, v: String| {
        let verb = if w.starts_with(MANY) { "stand" } else { "stands" };
        format!("{w} {verb} in the place of {v}")
    };
    for &v in &vectors {
        for w in substitutes(v).into_iter().chain(v.permuted()) {
            let terms = with_vectors(group, |of| if of == v { w } else { of });
            add(in_place(vector_words(w), vector_words(v)), terms);
        }
        components(group, v, &mut add);
    }
    // Both variations of a beam.
    for beam in 0..2 {
        for order in 0..3 {
            for other in (0..3).filter(|k| *k != order) {
                let terms = with_vectors(group, |of| match of {
                    Vector::U(side, b, k) if (b, k) == (beam, order) => Vector::U(side, b, other),
                    of => of,
                });
                let of = |k| vector_words(Vector::U(0, beam, k));
                add(in_place(of(other), of(order)), terms);
            }
        }
        let xi = [Quantity::Xi, Quantity::XiBar];
        let terms = with_numbers(group, |of| match of {
            Number::Of(q, part @ 1..) if q == xi[beam] => Number::Of(xi[1 - beam], part),
            of => of,
        });
        let [of, other] = [xi[beam], xi[1 - beam]].map(Quantity::name);
        add(in_place(format!("the derivative of {other}"), format!("that of {of}")), terms);
        let terms = with_vectors(group, |of| match of {
            Vector::T(b, k) if b == beam => Vector::T(1 - b, k),
            Vector::U(s, b, k) if b == beam => Vector::U(s, 1 - b, k),
            of => of,
        });
        add(in_place(["bar beam", "beam"][beam].into(), ["beam", "bar beam"][beam].into()), terms);
    }
    for (v, w) in dots {
        let terms = changed(group, |factor| {
            (*factor == Factor::Dot(v, w)).then(|| vec![(1.0, vec![Factor::Size(v, w)])])
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
            let terms = changed(group, |factor| {
                (*factor == Factor::Number(number)).then(|| vec![(1.0, with.clone())])
            });
            add(in_place(words, number_words(number)), terms);
        }
    }
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
        let mut terms: Terms = group.clone();
        for term in &mut terms {
            term.factors.extend(&by);
        }
        terms.extend(scaled(-1.0, group));
        add(words, terms);
    }
}

/// A component of v, or of its partner, left out, or taken for another one.
fn components(group: &Terms, v: Vector, add: &mut impl FnMut(String, Terms)) {
    let axis = ["x", "y", "z"];
    let name = vector_words(v);
    for j in 0..3 {
        let of_dot = |with: &dyn Fn(Vector) -> Vec<(f64, Factor)>| {
            changed(group, |factor| match *factor {
                Factor::Dot(a, b) if a == v || b == v => {
                    let partner = if a == v { b } else { a };
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

/// Vectors that are taken for this one by mistake.
fn substitutes(of: Vector) -> Vec<Vector> {
    match of {
        Vector::X(beam) => vec![Vector::X(1 - beam)],
        Vector::T(beam, order) => {
            let mut all: Vec<_> = (0..3).filter(|k| *k != order).map(|k| Vector::T(beam, k)).collect();
            all.extend((0..3).map(|k| Vector::T(1 - beam, k)));
            all
        }
        Vector::U(side, beam, order) => {
            let mut all: Vec<_> = (0..3).filter(|k| *k != order).map(|k| Vector::U(side, beam, k)).collect();
            all.extend([Vector::U(side, 1 - beam, order), Vector::U(1 - side, beam, order)]);
            all
        }
        _ => vec![],
    }
}

fn substitutes_of(of: Number) -> Vec<Number> {
    use Quantity::{GT, GTBar, T, TBar, Xi, XiBar};
    match of {
        Number::Of(quantity, part) => {
            let twin = match quantity {
                Xi => XiBar,
                XiBar => Xi,
                T => TBar,
                TBar => T,
                GT => GTBar,
                GTBar => GT,
                other => other,
            };
            let mut all = Vec::new();
            if twin != quantity {
                all.push(Number::Of(twin, part));
            }
            if part == 1 || part == 2 {
                all.extend([Number::Of(quantity, 3 - part), Number::Of(quantity, 0)]);
                if twin != quantity {
                    all.push(Number::Of(twin, 3 - part));
                }
            }
            all
        }
        Number::Radius(beam) => vec![Number::Radius(1 - beam)],
        Number::Moved(beam, _) => {
            vec![
                Number::Moved(1 - beam, 1 - beam),
                Number::Moved(beam, 1 - beam),
                Number::Moved(1 - beam, beam),
            ]
        }
        _ => vec![],
    }
}
