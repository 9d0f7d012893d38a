//! Sums of products: the terms of an equation, and their values.

use crate::linearization::Quantity;

/// A direction: delta or Delta.
pub(super) type Side = usize;
/// The beam, 0, or the bar beam, 1.
pub(super) type Beam = usize;

/// A vector that formulas are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Vector {
    /// d.
    D,
    /// x.
    X(Beam),
    /// t and its derivatives by the parameter.
    T(Beam, usize),
    /// The variation of x at a fixed parameter, and its derivatives by the parameter.
    U(Side, Beam, usize),
    /// The second variation of x at a fixed parameter, or its derivative.
    Mixed(Beam, usize),
    /// A unit vector.
    Axis(usize),
    /// t x t_bar, on the side of d.
    Cross,
    /// A vector of the table with its components in another order.
    Permuted(usize, [usize; 3]),
}

impl Vector {
    /// The vector with its components in other orders.
    pub(super) fn permuted(self) -> Vec<Self> {
        let orders = [[1, 2, 0], [2, 0, 1], [2, 1, 0], [1, 0, 2], [0, 2, 1]];
        place(self).map_or_else(Vec::new, |at| orders.map(|order| Self::Permuted(at, order)).to_vec())
    }
}

/// A number that formulas are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Number {
    /// A part of a quantity of the program: value, delta, Delta, Delta-delta.
    Of(Quantity, Part),
    /// A part of a component of a vector of the program.
    Component(Quantity, usize, Part),
    /// The length of d, t or t_bar as a vector.
    Length(Vector),
    /// A radius.
    Radius(Beam),
    /// The parameter of the end at which it is held.
    End(Beam),
    /// The parameter of a beam less the reference parameter of a beam.
    Moved(Beam, Beam),
    /// The penalty stiffness, or zero at an open gap.
    Stiffness,
    /// The residual along a direction, or the tangent.
    Element(usize),
}

/// 0 value, 1 delta, 2 Delta, 3 Delta-delta.
pub(super) type Part = usize;

/// A factor of a term.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Factor {
    Dot(Vector, Vector),
    /// The absolute value of a product.
    Size(Vector, Vector),
    /// The product of two components.
    Entry(Vector, usize, Vector, usize),
    Number(Number),
    /// The absolute value of a number.
    SizeOf(Number),
    /// A power of a length.
    Power(Quantity, i32),
}

/// What a term is part of, such as delta d.
pub(super) type Tag = &'static str;

/// The factors of a term that a tag is on: two bits each, for both sides of a scalar product.
pub(super) type Reach = u64;

/// These factors.
fn reach(of: std::ops::Range<usize>) -> Reach {
    of.map(|i| 0b11 << (2 * i)).sum()
}

/// A term of an equation.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Term {
    pub(super) coefficient: f64,
    pub(super) factors: Vec<Factor>,
    pub(super) tags: Vec<(Tag, Reach)>,
}

/// A sum of terms.
pub(super) type Terms = Vec<Term>;

/// A vector in terms: each a vector with numbers as factors.
pub(super) type Sum = Vec<(f64, Vec<Number>, Vector, Vec<Tag>)>;

/// A vector alone.
pub(super) fn vector(of: Vector) -> Sum {
    vec![(1.0, vec![], of, vec![])]
}

/// A vector times numbers.
pub(super) fn times(numbers: &[Number], of: Vector) -> Sum {
    vec![(1.0, numbers.to_vec(), of, vec![])]
}

/// The sum with a tag on each term.
pub(super) fn tagged(tag: Tag, of: Sum) -> Sum {
    of.into_iter()
        .map(|(c, numbers, v, mut tags)| {
            tags.push(tag);
            (c, numbers, v, tags)
        })
        .collect()
}

/// The sum with several tags on each term.
pub(super) fn all_tagged(tags: &[Tag], of: Sum) -> Sum {
    tags.iter().fold(of, |sum, tag| tagged(tag, sum))
}

/// The sum with the opposite sign.
pub(super) fn minus(of: Sum) -> Sum {
    of.into_iter().map(|(c, numbers, v, tags)| (-c, numbers, v, tags)).collect()
}

/// The scalar product of two sums.
pub(super) fn dot(one: &Sum, other: &Sum) -> Terms {
    let product = |(c, n, v, t): &(f64, Vec<Number>, Vector, Vec<Tag>)| {
        other
            .iter()
            .map(|(d, m, w, s)| {
                let numbers = n.iter().chain(m).map(|n| Factor::Number(*n));
                // The first factor is the product of the vectors.
                let middle = 1 + n.len();
                let [left, right] = [0b01 | reach(1..middle), 0b10 | reach(middle..middle + m.len())];
                let tags = t.iter().map(|tag| (*tag, left)).chain(s.iter().map(|tag| (*tag, right)));
                Term {
                    coefficient: c * d,
                    factors: [Factor::Dot(*v, *w)].into_iter().chain(numbers).collect(),
                    tags: tags.collect(),
                }
            })
            .collect::<Vec<_>>()
    };
    one.iter().flat_map(product).collect()
}

/// A product of numbers.
pub(super) fn numbers(coefficient: f64, of: &[Number]) -> Terms {
    vec![Term { coefficient, factors: of.iter().map(|n| Factor::Number(*n)).collect(), tags: vec![] }]
}

/// The product of two sums of terms.
pub(super) fn product(one: &Terms, other: &Terms) -> Terms {
    one.iter()
        .flat_map(|a| {
            other.iter().map(|b| Term {
                coefficient: a.coefficient * b.coefficient,
                factors: a.factors.iter().chain(&b.factors).copied().collect(),
                tags: {
                    let moved = |(tag, reach): &(Tag, Reach)| (*tag, reach << (2 * a.factors.len()));
                    a.tags.iter().copied().chain(b.tags.iter().map(moved)).collect()
                },
            })
        })
        .collect()
}

pub(super) fn scaled(factor: f64, of: &Terms) -> Terms {
    of.iter().map(|term| Term { coefficient: factor * term.coefficient, ..term.clone() }).collect()
}

pub(super) fn tag(tag: Tag, of: Terms) -> Terms {
    of.into_iter()
        .map(|mut term| {
            term.tags.push((tag, reach(0..term.factors.len())));
            term
        })
        .collect()
}

/// Which numbers of earlier equations are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Earlier {
    /// Those of the program, where it has them.
    Own,
    /// The exact ones.
    Exact,
}

/// How the numbers of a sample are read: which are the results of the equation, and which others are used.
#[derive(Clone, Debug)]
pub(super) struct Reading<'a> {
    pub(super) results: &'a [(Quantity, Part)],
    pub(super) earlier: Earlier,
}

/// The place of a vector in the table.
pub(super) fn place(of: Vector) -> Option<usize> {
    Some(match of {
        Vector::D => 0,
        Vector::X(beam) => 1 + beam,
        Vector::T(beam, order) => 3 + 3 * beam + order,
        Vector::U(side, beam, order) => 9 + 6 * side + 3 * beam + order,
        Vector::Mixed(beam, order) => 21 + 2 * beam + order,
        Vector::Axis(axis) => 25 + axis,
        Vector::Cross => 28,
        Vector::Permuted(..) => return None,
    })
}
