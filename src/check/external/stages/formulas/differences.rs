//! The differences of wrong answers along some directions of rows and columns.

use super::degrees::Through;
use super::derivatives::derivatives;
use super::list::FORMULAS;
use super::names::Set;
use super::outputs::Output;
use super::point::numbers;
use super::tree::Name;
use super::values::Value;
use crate::check::candidate::CAREFUL;
use crate::check::external::stages::sample::{SIDE, Sample};
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

/// The rounding of a difference over the difference, at most.
const CLEAR: f64 = 1e-4;

/// A matrix, or a vector as a matrix of one column.
pub(super) type Matrix = Vec<Vec<f64>>;

/// The difference of a result in one case, along [`SIDE`] directions of rows and so many of columns.
pub(super) struct Difference {
    /// The result, one for each axis.
    outputs: Vec<Output>,
    /// By axis, row and column.
    pub(super) parts: Vec<Matrix>,
    /// The largest entry.
    pub(super) size: f64,
    /// What rounding adds to an entry at most.
    pub(super) rounding: f64,
    /// All values, by row and column.
    values: Arc<Vec<Vec<Value>>>,
    /// The derivatives of the result by all names, by axis, row and column.
    derivatives: OnceLock<Vec<Vec<Vec<Value>>>>,
}

/// The first of the results that are wrong, with its difference in each case.
///
/// A case has samples along each direction of rows with each one of columns.
pub(super) fn first_wrong(samples: &[Sample]) -> Option<(Name, Vec<Difference>)> {
    let mut wrong: BTreeMap<Name, Vec<Difference>> = BTreeMap::new();
    for grid in samples.chunk_by(|one, other| one.case == other.case).filter(|of| of.len() == SIDE * SIDE) {
        for (name, difference) in of_case(grid) {
            wrong.entry(name).or_default().push(difference);
        }
    }
    let names_before = |name: &Name| FORMULAS.needed(Set::from_iter([*name])).names().count();
    let first = wrong.keys().copied().min_by_key(names_before)?;
    Some((first, wrong.remove(&first)?))
}

/// The differences of a case that are larger than rounding.
fn of_case(grid: &[Sample]) -> Vec<(Name, Difference)> {
    let all: Set = (0..FORMULAS.names.0.len()).collect();
    let of_formulas = |sample: &Sample| FORMULAS.values(0, &sample.inputs.values, &sample.inputs.known, all);
    let values: Arc<Vec<Vec<Value>>> = Arc::new(grid.iter().map(of_formulas).collect());
    let answered: Vec<BTreeMap<_, _>> =
        grid.iter().map(|sample| numbers(sample).into_iter().collect()).collect();
    let mut by_name: BTreeMap<Name, Vec<Output>> = BTreeMap::new();
    for output in answered[0].keys().filter(|output| FORMULAS.kinds[output.name].varies[0]) {
        by_name.entry(output.name).or_default().push(*output);
    }
    let of_name = |(name, outputs): (Name, Vec<Output>)| {
        let columns = if FORMULAS.kinds[name].varies[1] { SIDE } else { 1 };
        let (mut size, mut rounding) = (0.0, 0.0);
        let mut entry = |output: Output, at: usize| {
            let (answer, right) = (answered[at].get(&output)?, output.of(&values[at][..]));
            let difference = answer.value - right.value;
            size = f64::max(size, difference.abs());
            rounding = f64::max(rounding, answer.bound + CAREFUL * right.bound);
            difference.is_finite().then_some(difference)
        };
        let mut row = |output: Output, row: usize| -> Option<Vec<f64>> {
            (0..columns).map(|column| entry(output, row * SIDE + column)).collect()
        };
        let part = |output: &Output| (0..SIDE).map(|of| row(*output, of)).collect();
        let parts: Vec<Matrix> = outputs.iter().map(part).collect::<Option<_>>()?;
        let is_clear = rounding <= CLEAR * size && size > 0.0;
        let (values, derivatives) = (Arc::clone(&values), OnceLock::new());
        is_clear.then_some((name, Difference { outputs, parts, size, rounding, values, derivatives }))
    };
    by_name.into_iter().filter_map(of_name).collect()
}

impl Difference {
    pub(super) fn columns(&self) -> usize {
        self.parts[0][0].len()
    }

    /// All values along a direction of rows and one of columns.
    pub(super) fn values(&self, row: usize, column: usize) -> &[Value] {
        &self.values[row * SIDE + column]
    }

    /// The derivatives of the result by all names.
    pub(super) fn derivatives(&self, axis: usize, row: usize, column: usize) -> &[Value] {
        let of = |output: &Output| -> Vec<Vec<Value>> {
            (0..SIDE * SIDE)
                .map(|at| derivatives(Through::All, &self.values[at], &[], (*output, 0)))
                .collect()
        };
        let all = self.derivatives.get_or_init(|| self.outputs.iter().map(of).collect());
        &all[axis][row * SIDE + column]
    }
}
