//! The residuals of a sum, and which possible errors leave only rounding of them.

use super::equations::{Equation, Zero};
use super::point::Point;
use super::rows::Row;
use super::terms::{Earlier, Reading, Term};
use crate::number::RunningError;
use crate::parallel;
use std::collections::{BTreeMap, HashMap};

/// The residual of a sum at the samples.
pub(super) struct System<'a> {
    pub(super) points: Vec<&'a Point<'a>>,
    residuals: Vec<RunningError>,
    terms: &'a [Term],
    reading: Reading<'a>,
}

/// The cases, and the samples in each, that a row with a factor of its own in each case must explain.
const CLEAR_CASES: usize = 3;
const CLEAR_SAMPLES: usize = 4;

pub(super) fn is_zero(of: &RunningError) -> bool {
    of.value.abs() <= of.bound || of.value.is_nan()
}

pub(super) fn cases(points: &[&Point]) -> Vec<usize> {
    let mut cases: Vec<_> = points.iter().map(|point| point.sample.case).collect();
    cases.dedup();
    cases
}

impl<'a> System<'a> {
    pub(super) fn new(
        equation: &'a Equation,
        zero: &'a Zero,
        points: &'a [Point<'a>],
        earlier: Earlier,
    ) -> Self {
        let reading = Reading { results: &equation.results, earlier };
        let (mut kept, mut residuals) = (Vec::new(), Vec::new());
        for point in points.iter().filter(|point| equation.at.holds(point.sample.held)) {
            if let Some(residual) = point.value(&zero.terms, &reading)
                && residual.bound.is_finite()
            {
                kept.push(point);
                residuals.push(residual);
            }
        }
        Self { points: kept, residuals, terms: &zero.terms, reading }
    }

    pub(super) fn wrong_cases(&self) -> Vec<usize> {
        let mut cases: Vec<_> = self
            .points
            .iter()
            .zip(&self.residuals)
            .filter(|(_, r)| !is_zero(r))
            .map(|(point, _)| point.sample.case)
            .collect();
        cases.dedup();
        cases
    }

    pub(super) fn retain(&mut self, keep: impl Fn(usize) -> bool) {
        let keep: Vec<bool> = self.points.iter().map(|point| keep(point.sample.case)).collect();
        let mut flags = keep.iter();
        self.points.retain(|_| *flags.next().unwrap_or(&false));
        let mut flags = keep.iter();
        self.residuals.retain(|_| *flags.next().unwrap_or(&false));
    }

    /// The samples that tell most: the clearest of each case.
    fn probes(&self, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.points.len()).collect();
        let clear = |i: &usize| {
            let RunningError { value, bound } = self.residuals[*i];
            // Zero is not clear, also if it is exact.
            if value == 0.0 { 0.0 } else { -(value.abs() / bound) }
        };
        order.sort_by(|a, b| clear(a).total_cmp(&clear(b)));
        let mut of_case = HashMap::new();
        let mut ranked: Vec<(usize, usize)> = order
            .into_iter()
            .map(|i| {
                let turn: &mut usize = of_case.entry(self.points[i].sample.case).or_default();
                *turn += 1;
                (*turn, i)
            })
            .collect();
        ranked.sort_by_key(|(turn, _)| *turn);
        ranked.into_iter().map(|(_, i)| i).take(count).collect()
    }

    fn column(&self, row: &Row, i: usize) -> Option<RunningError> {
        self.points[i].value(&row.terms, &self.reading)
    }

    /// The rows that alone leave only rounding, each with its factor.
    pub(super) fn singles(&self, rows: &[Row]) -> Vec<Vec<(usize, f64)>> {
        let probes = self.probes(6);
        let explains = |k: usize| {
            let factor = self.factor(&rows[k], &probes)?;
            self.is_explained(&[(&rows[k], factor)]).then(|| vec![(k, factor)])
        };
        parallel::indices(rows.len(), explains).into_iter().flatten().collect()
    }

    /// The rows that alone leave only rounding in each case, with a factor of its own in each.
    pub(super) fn varying(&self, rows: &[Row]) -> Vec<usize> {
        let mut of_cases: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (i, point) in self.points.iter().enumerate() {
            of_cases.entry(point.sample.case).or_default().push(i);
        }
        let explains = |k: usize| {
            let clear: Option<Vec<bool>> =
                of_cases.values().map(|of| self.is_multiple(&rows[k], of)).collect();
            (clear?.into_iter().filter(|is_clear| *is_clear).count() >= CLEAR_CASES).then_some(k)
        };
        parallel::indices(rows.len(), explains).into_iter().flatten().collect()
    }

    /// Whether the residuals of a case are clearly a multiple of a row; nothing if they are not.
    fn is_multiple(&self, row: &Row, of_case: &[usize]) -> Option<bool> {
        let clearness = |i: &usize| self.residuals[*i].value.abs() / self.residuals[*i].bound;
        let first = of_case.iter().copied().max_by(|a, b| clearness(a).total_cmp(&clearness(b)))?;
        let (residual, column) = (self.residuals[first], self.column(row, first)?);
        if is_zero(&residual) {
            return Some(false);
        }
        if is_zero(&column) {
            return None;
        }
        let factor = -residual.value / column.value;
        let doubt = residual.bound / residual.value.abs() + column.bound / column.value.abs();
        let mut clear = 0;
        for &i in of_case {
            let (residual, column) = (self.residuals[i], self.column(row, i)?);
            let left = residual.value + factor * column.value;
            let allowed = residual.bound + factor.abs() * (column.bound + doubt * column.value.abs());
            if left.abs() > 2.0 * allowed {
                return None;
            }
            clear += usize::from(residual.value.abs() > 1e3 * residual.bound);
        }
        Some(clear >= CLEAR_SAMPLES)
    }

    fn factor(&self, row: &Row, probes: &[usize]) -> Option<f64> {
        let first = *probes.first()?;
        let (residual, column) = (self.residuals[first], self.column(row, first)?);
        if is_zero(&residual) || is_zero(&column) {
            return None;
        }
        let factor = -residual.value / column.value;
        let doubt = residual.bound / residual.value.abs() + column.bound / column.value.abs();
        for &i in &probes[1..] {
            let (residual, column) = (self.residuals[i], self.column(row, i)?);
            let left = residual.value + factor * column.value;
            let allowed = residual.bound + factor.abs() * (column.bound + doubt * column.value.abs());
            if left.abs() > 2.0 * allowed {
                return None;
            }
        }
        Some(snapped(factor, 1e-6_f64.max(10.0 * doubt)))
    }

    fn is_explained(&self, of: &[(&Row, f64)]) -> bool {
        (0..self.points.len()).all(|i| {
            let (mut left, mut allowed) = (self.residuals[i].value, self.residuals[i].bound);
            for (row, factor) in of {
                let Some(column) = self.column(row, i) else { return false };
                left += factor * column.value;
                allowed += factor.abs() * column.bound;
                // A fitted factor has an error of its own.
                if !is_common(*factor) {
                    allowed += 1e-9 * (factor * column.value).abs();
                }
            }
            left.abs() <= allowed
        })
    }

    /// The largest residual over the size of its terms, and what these errors leave of it.
    pub(super) fn deviations(&self, of: &[(Row, f64)]) -> [f64; 2] {
        let mut largest = [0.0_f64; 2];
        for (point, residual) in self.points.iter().zip(&self.residuals) {
            let size = point.size(self.terms, &self.reading);
            let changes =
                of.iter().filter_map(|(row, by)| Some(by * point.value(&row.terms, &self.reading)?.value));
            let left = residual.value + changes.sum::<f64>();
            for (largest, number) in largest.iter_mut().zip([residual.value, left]) {
                *largest = largest.max(if size > 0.0 { number.abs() / size } else { 0.0 });
            }
        }
        largest
    }

    /// The pairs of rows that leave only rounding.
    pub(super) fn pairs(&self, rows: &[Row]) -> Vec<Vec<(usize, f64)>> {
        const PROBES: usize = 24;
        let probes = self.probes(PROBES);
        if cases(&self.points).len() < 3 || probes.len() < 5 {
            return vec![];
        }
        let weights: Vec<f64> = probes
            .iter()
            .map(|i| {
                let r = &self.residuals[*i];
                1.0 / r.value.abs().max(1e3 * r.bound)
            })
            .collect();
        let y: Vec<f64> = probes.iter().zip(&weights).map(|(i, w)| -self.residuals[*i].value * w).collect();
        let project = |u: &[f64; PROBES], v: &[f64; PROBES]| u.iter().zip(v).map(|(a, b)| a * b).sum::<f64>();
        let fixed =
            |of: &[f64]| -> [f64; PROBES] { std::array::from_fn(|i| of.get(i).copied().unwrap_or(0.0)) };
        let y = fixed(&y);
        let column = |k: usize| {
            let of_probe = |(i, w): (&usize, &f64)| {
                let c = self.column(&rows[k], *i)?;
                Some(if is_zero(&c) { 0.0 } else { c.value * w })
            };
            let column: Vec<f64> = probes.iter().zip(&weights).map(of_probe).collect::<Option<_>>()?;
            let norm = column.iter().map(|c| c * c).sum::<f64>().sqrt();
            let unit = fixed(&column.iter().map(|c| c / norm).collect::<Vec<_>>());
            (norm > 1e-9 && norm.is_finite()).then_some((k, norm, unit))
        };
        let all = parallel::indices(rows.len(), column);
        let mut columns: Vec<(usize, f64, [f64; PROBES])> = Vec::new();
        for column in all.into_iter().flatten() {
            // Rows with the same numbers.
            if !columns.iter().any(|other| 1.0 - project(&other.2, &column.2).abs() < 1e-12) {
                columns.push(column);
            }
        }
        let on: Vec<f64> = columns.iter().map(|c| project(&c.2, &y)).collect();
        let yy = project(&y, &y);
        let of_pair = |i: usize, j: usize| {
            let rho = project(&columns[i].2, &columns[j].2);
            let left = yy - (on[i] * on[i] + on[j] * on[j] - 2.0 * rho * on[i] * on[j]) / (1.0 - rho * rho);
            (left < 1e-8 * yy).then_some((left, i, j))
        };
        let mut best: Vec<(f64, usize, usize)> =
            parallel::indices(columns.len(), |i| (0..i).filter_map(|j| of_pair(i, j)).collect::<Vec<_>>())
                .concat();
        best.sort_by(|a, b| a.0.total_cmp(&b.0));
        best.truncate(60);
        let mut found = Vec::new();
        for (_, i, j) in best {
            let rho = project(&columns[i].2, &columns[j].2);
            let det = 1.0 - rho * rho;
            let (ci, cj) =
                ((on[i] - rho * on[j]) / det / columns[i].1, (on[j] - rho * on[i]) / det / columns[j].1);
            let pair = [(columns[i].0, snapped(ci, 1e-5)), (columns[j].0, snapped(cj, 1e-5))];
            if !pair.iter().all(|(_, f)| is_common(*f)) {
                continue;
            }
            if self.is_explained(&pair.map(|(k, f)| (&rows[k], f))) {
                found.push(pair.to_vec());
            }
        }
        found
    }
}

pub(super) const COMMON: [f64; 12] = [-1.0, -2.0, 1.0, -0.5, 2.0, 0.5, -3.0, 3.0, -4.0, -0.25, -0.75, 5.0];

pub(super) fn snapped(factor: f64, within: f64) -> f64 {
    COMMON.into_iter().find(|c| (factor - c).abs() <= within).unwrap_or(factor)
}

pub(super) fn is_common(factor: f64) -> bool {
    COMMON.contains(&factor)
}
