//! What a wrong answer differs by, if no change of the list explains it.
//!
//! Along some directions of rows and some of columns, the difference of a Hessian or tangent is a matrix. If it is zero for all
//! combinations of directions along which dxi is zero, it is made of products with dxi. So it is told where to look, whatever
//! stands in their place. If it is a multiple of one product, the factor may be one of numbers that are known. If it is
//! a multiple of the derivatives by a name, the value of this name is another one.

use super::differences::{Difference, first_wrong};
use super::list::{FORMULAS, Kind};
use super::names::Set;
use super::operations::value;
use super::span::Span;
use super::tree::{Name, Op, Tree};
use super::values::Value;
use crate::check::external::stages::sample::{SIDE, Sample};
use crate::number::RunningError;

/// What is left of a difference outside the multiples, over the difference.
const LEFT: f64 = 1e-6;
/// The rounding of a factor over the factor, at most.
const SHARP: f64 = 1e-7;
/// The fewest cases that tell a factor.
const CASES: usize = 3;
/// If more names may be meant, they do not tell where to look.
const TOLD: usize = 3;
/// Common factors.
const FACTORS: [f64; 10] = [1.0, -1.0, 2.0, -2.0, 0.5, -0.5, 3.0, -3.0, 1.5, -1.5];

/// A factor along the rows, and one along the columns.
type Factors = [Option<Name>; 2];

/// What the first wrong result differs by, as a clause. The samples are those of a grid.
pub(in crate::check::external::stages) fn found(samples: &[Sample]) -> Option<String> {
    let (name, all) = first_wrong(samples)?;
    let needed = FORMULAS.needed(Set::from_iter([name])).without(Set::from_iter([name]));
    let products = Products::new(&all, name, needed);
    let values = |varies: [bool; 2]| other_values(&all, needed, varies);
    let words = products
        .single()
        .or_else(|| values([false; 2]))
        .or_else(|| products.words(|of| !of.is_vector))
        .or_else(|| values([true, false]))
        .or_else(|| values([false, true]))
        .or_else(|| products.words(|_| true))
        .or_else(|| products.of_both())?;
    let result = FORMULAS.all.iter().find(|formula| formula.name == name)?;
    Some(format!("{} differs {words}", FORMULAS.words_of(result)))
}

/// Names in words, unless there are too many.
fn told(names: &[Name]) -> Option<String> {
    let names: Vec<&str> = names.iter().map(|name| &*FORMULAS.names.0[*name]).collect();
    (!names.is_empty() && names.len() <= TOLD).then(|| names.join(" or "))
}

/// Numbers, unless there are only vectors.
fn numbers_first(names: Vec<Name>) -> Vec<Name> {
    let numbers: Vec<Name> = names.iter().copied().filter(|name| !FORMULAS.kinds[*name].is_vector).collect();
    if numbers.is_empty() { names } else { numbers }
}

/// The names that all differences are products with.
struct Products<'a> {
    all: &'a [Difference],
    candidates: Vec<Name>,
    /// The result that differs.
    result: Name,
    is_matrix: bool,
    rows: Vec<Name>,
    columns: Vec<Name>,
}

impl<'a> Products<'a> {
    fn new(all: &'a [Difference], result: Name, needed: Set) -> Self {
        let is_matrix = FORMULAS.kinds[result].varies[1];
        let is_candidate = |name: &Name| {
            let kind = FORMULAS.kinds[*name];
            kind.varies == [true, false] && !kind.is_condition
        };
        // A name along Delta alone may be meant along delta.
        let along_delta: Set = needed.names().map(|name| FORMULAS.delta.get(name).unwrap_or(name)).collect();
        let candidates = along_delta.names().filter(is_candidate).collect();
        let mut found = Self { all, candidates, result, is_matrix, rows: Vec::new(), columns: Vec::new() };
        found.rows = found.with(&|name| [Some(name), None]);
        if is_matrix {
            found.columns = found.with(&|name| [None, Some(name)]);
        }
        found
    }

    /// The names with which all differences are products of such factors.
    fn with(&self, factors: &dyn Fn(Name) -> Factors) -> Vec<Name> {
        let is_factor = |name: &Name| {
            let tested: Vec<bool> = self.all.iter().filter_map(|of| of.is_multiple(factors(*name))).collect();
            2 * tested.len() > self.all.len() && !tested.contains(&false)
        };
        numbers_first(self.candidates.iter().copied().filter(is_factor).collect())
    }

    /// The factors of these kinds.
    fn words(&self, is_meant: fn(&Kind) -> bool) -> Option<String> {
        let of = |names: &[Name]| -> Vec<Name> {
            names.iter().copied().filter(|name| is_meant(&FORMULAS.kinds[*name])).collect()
        };
        let along_linear: Vec<Name> =
            of(&self.columns).into_iter().filter_map(|name| FORMULAS.linear.get(name)).collect();
        match (told(&of(&self.rows)), told(&along_linear)) {
            (Some(rows), None) if !self.is_matrix => Some(format!("by a multiple of {rows}")),
            (Some(rows), Some(columns)) => Some(format!("by a product of {rows} with {columns}")),
            (Some(one), None) | (None, Some(one)) => Some(format!("by a product of {one} with something")),
            (None, None) => None,
        }
    }

    /// A name that is in the rows or the columns of each part of the differences.
    fn of_both(&self) -> Option<String> {
        let names = if self.is_matrix { self.with(&|name| [Some(name); 2]) } else { Vec::new() };
        told(&names).map(|names| format!("by products with {names} in rows or columns"))
    }

    /// The product that all differences are: a common number times one or two numbers that are known.
    fn single(&self) -> Option<String> {
        // The names that the formula of the result has are meant.
        let of_result = FORMULAS.relations[0].uses[self.result];
        let is_used = |name: &Name| {
            [Some(*name), FORMULAS.linear.get(*name)].iter().flatten().any(|of| of_result.has(*of))
        };
        let one = |names: &[Name]| {
            let numbers = names.iter().copied().filter(|name| !FORMULAS.kinds[*name].is_vector);
            numbers.max_by_key(|name| (is_used(name), *name))
        };
        let row = one(&self.rows)?;
        let column = if self.is_matrix { Some(FORMULAS.linear.get(one(&self.columns)?)?) } else { None };
        let wanted = self.all.iter().map(|of| of.coefficient(row, column)).collect::<Option<Vec<f64>>>()?;
        if wanted.len() < CASES {
            return None;
        }
        let (factor, known) = known_factor(self.all, &wanted)?;
        let names = [Some(row), column].into_iter().flatten().map(|name| FORMULAS.names.0[name].clone());
        let known = known.map(|known| known.text(&FORMULAS.names));
        let product = known.into_iter().chain(names).collect::<Vec<_>>().join(" ");
        Some(match factor {
            1.0 => format!("by {product}"),
            -1.0 => format!("by -{product}"),
            factor => format!("by {factor} {product}"),
        })
    }
}

impl Difference {
    /// Whether nothing is left of it where these factors are zero, if they are known well enough.
    fn is_multiple(&self, [rows, columns]: Factors) -> Option<bool> {
        let of_rows: Vec<&[Value]> = (0..SIDE).map(|row| self.values(row, 0)).collect();
        let of_columns: Vec<&[Value]> = (0..SIDE).map(|column| self.values(0, column)).collect();
        let span = |name: Option<Name>, along: &[&[Value]]| match name {
            Some(name) => Some(Span::of(&components(along, name)?)),
            None => Some(Span::default()),
        };
        let rows = span(rows, &of_rows)?;
        let columns = span(columns.and_then(|name| FORMULAS.linear.get(name)), &of_columns)?;
        Some(self.parts.iter().all(|part| {
            let left: Vec<Vec<f64>> = part.iter().map(|row| columns.outside(row)).collect();
            (0..self.columns()).all(|j| {
                let column: Vec<f64> = left.iter().map(|row| row[j]).collect();
                self.is_nothing(&rows.outside(&column))
            })
        }))
    }

    fn is_nothing(&self, left: &[f64]) -> bool {
        left.iter().all(|of| of.abs() <= LEFT * self.size + 10.0 * self.rounding)
    }

    /// The factor of a product of two variations by which it is this difference, at the largest product.
    fn coefficient(&self, row: Name, column: Option<Name>) -> Option<f64> {
        let [part] = &self.parts[..] else { return None };
        let places = (0..SIDE).flat_map(|i| (0..self.columns()).map(move |j| (i, j)));
        let product = |(i, j): (usize, usize)| {
            let of = |name: Name| self.values(i, j)[name].number().value;
            of(row) * column.map_or(1.0, of)
        };
        let (size, coefficient) = places
            .map(|(i, j)| (product((i, j)).abs(), part[i][j] / product((i, j))))
            .max_by(|one, other| one.0.total_cmp(&other.0))?;
        (size > 0.0 && coefficient.is_finite()).then_some(coefficient)
    }

    /// Whether it is what another value of a name does to the result: the same one in all directions if the name does not vary
    /// with them.
    fn is_of_other_value(&self, name: Name) -> bool {
        let varies = FORMULAS.kinds[name].varies;
        let axes = if FORMULAS.kinds[name].is_vector { 3 } else { 1 };
        let places: Vec<_> = (0..SIDE).flat_map(|i| (0..self.columns()).map(move |j| (i, j))).collect();
        let groups =
            |(i, j): &(usize, usize)| [if varies[0] { *i } else { 0 }, if varies[1] { *j } else { 0 }];
        (0..SIDE).flat_map(|i| (0..SIDE).map(move |j| [i, j])).all(|group| {
            let of_group: Vec<_> = places.iter().filter(|place| groups(place) == group).collect();
            let each = |read: &dyn Fn(usize, usize, usize) -> f64| -> Vec<f64> {
                let axes = 0..self.parts.len();
                axes.flat_map(|axis| of_group.iter().map(move |(i, j)| read(axis, *i, *j))).collect()
            };
            let differences = each(&|axis, i, j| self.parts[axis][i][j]);
            let derivatives = (0..axes).map(|of| {
                let component = |axis, i, j| {
                    let by: Value = self.derivatives(axis, i, j)[name];
                    by.component(by.is_vector().then_some(of)).value
                };
                each(&component)
            });
            let derivatives: Vec<Vec<f64>> = derivatives.collect();
            let is_known = derivatives.iter().flatten().all(|of| of.is_finite());
            of_group.is_empty()
                || (is_known
                    && differences.len() > axes + 1
                    && self.is_nothing(&Span::of(&derivatives).outside(&differences)))
        })
    }
}

/// The names of which another value, in each case or along each direction, makes all differences: those that are next to the
/// result.
fn other_values(all: &[Difference], needed: Set, varies: [bool; 2]) -> Option<String> {
    let is_candidate = |name: &Name| {
        let kind = FORMULAS.kinds[*name];
        kind.varies == varies && !kind.is_condition && *name >= FORMULAS.inputs
    };
    let is_meant = |name: &Name| all.iter().all(|of| of.is_of_other_value(*name));
    let mut names = numbers_first(needed.names().filter(is_candidate).filter(is_meant).collect());
    let found: Set = names.iter().copied().collect();
    names.retain(|name| FORMULAS.relations[0].follows[*name].and(found) == Set::from_iter([*name]));
    told(&names).map(|names| format!("as if {names} had another value"))
}

/// The components of a name along each direction, if rounding is small.
fn components(along: &[&[Value]], name: Name) -> Option<Vec<Vec<f64>>> {
    let axes = if FORMULAS.kinds[name].is_vector { vec![Some(0), Some(1), Some(2)] } else { vec![None] };
    let of = |axis: &Option<usize>| along.iter().map(|values| values[name].component(*axis)).collect();
    let all: Vec<Vec<RunningError>> = axes.iter().map(of).collect();
    let largest = |read: fn(&RunningError) -> f64| all.iter().flatten().map(read).fold(0.0, f64::max);
    let is_sharp = largest(|of| of.bound) <= SHARP * largest(|of| of.value.abs());
    is_sharp.then(|| all.iter().map(|of| of.iter().map(|of| of.value).collect()).collect())
}

/// A common factor and a number, a product or a quotient of two that are these coefficients.
fn known_factor(all: &[Difference], wanted: &[f64]) -> Option<(f64, Option<Tree>)> {
    let common = |known: &dyn Fn(usize) -> f64| {
        let first = wanted[0] / known(0);
        let factor = FACTORS.into_iter().find(|factor| (first - factor).abs() <= LEFT * factor.abs())?;
        let is_same = |i: usize| (wanted[i] - factor * known(i)).abs() <= LEFT * wanted[i].abs();
        (0..wanted.len()).all(is_same).then_some(factor)
    };
    if let Some(factor) = common(&|_| 1.0) {
        return Some((factor, None));
    }
    let values = |tree: Tree| {
        let of: Vec<f64> = all.iter().map(|of| value(&tree, of.values(0, 0)).number().value).collect();
        of.iter().all(|of| of.is_finite() && *of != 0.0).then_some((tree, of))
    };
    let known: Vec<(Tree, Vec<f64>)> = atoms().into_iter().filter_map(values).collect();
    if let Some(found) = known.iter().find_map(|(tree, of)| Some((common(&|i| of[i])?, Some(tree.clone())))) {
        return Some(found);
    }
    let pairs = known.iter().flat_map(|one| known.iter().map(move |other| (one, other)));
    pairs.into_iter().find_map(|((one, of_one), (other, of_other))| {
        let product = |divides| Some(Tree::product(vec![(false, one.clone()), (divides, other.clone())]));
        let times = || Some((common(&|i| of_one[i] * of_other[i])?, product(false)));
        let over = || Some((common(&|i| of_one[i] / of_other[i])?, product(true)));
        times().or_else(over)
    })
}

/// The numbers of a case, those next to the results first, and the scalar products of its vectors.
fn atoms() -> Vec<Tree> {
    let is_fixed = |name: &Name| {
        let kind = FORMULAS.kinds[*name];
        kind.varies == [false; 2] && !kind.is_condition
    };
    let (vectors, numbers): (Vec<Name>, Vec<Name>) =
        (0..FORMULAS.names.0.len()).filter(is_fixed).partition(|name| FORMULAS.kinds[*name].is_vector);
    let dots = vectors.iter().enumerate().flat_map(|(i, one)| {
        vectors[i..].iter().map(|other| Tree::new(Op::Dot, [Tree::name(*one), Tree::name(*other)]))
    });
    numbers.iter().rev().map(|name| Tree::name(*name)).chain(dots).collect()
}
