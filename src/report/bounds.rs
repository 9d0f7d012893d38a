//! The record of how sharp the tolerances are, `beamgap-bounds/2`.

use super::number::{finite, rounded};
use super::{Environment, Record};
use crate::check::{self, Distribution, Order, Regime, Side};
use serde::{Deserialize, Serialize};

/// What the bounds allow for, against the errors that there are.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds {
    /// `beamgap-bounds/2`.
    pub schema: String,
    /// Where and with what it ran.
    pub environment: Environment,
    /// The seed of all cases.
    pub seed: u64,
    /// The cases of each regime.
    pub cases_per_regime: u64,
    /// The closest points of each regime.
    pub regimes: Vec<RegimePoints>,
    /// What was measured, by side, order and regime; first over all regimes.
    pub rows: Vec<BoundsRow>,
    /// The worst violation of each case that has one.
    pub violations: Vec<BrokenBound>,
}

/// The closest points of one regime.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RegimePoints {
    /// The regime.
    pub regime: String,
    /// Their counts.
    #[serde(flatten)]
    pub points: check::Points,
}

/// One side and one order in one regime.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BoundsRow {
    /// Whose bounds: `closed form` or `AD`.
    pub side: String,
    /// Which variations.
    pub order: String,
    /// The regime, or `all`.
    pub regime: String,
    /// Numbers with an error.
    pub entries: u64,
    /// Numbers without an error.
    pub exact: u64,
    /// Numbers without a finite bound.
    pub unbounded: u64,
    /// The bound over the true error.
    pub overestimation: Quantiles,
    /// The true error over its scale.
    pub error: Quantiles,
}

/// A distribution in four numbers, each with two digits; null where there is none.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quantiles {
    /// 5 % are below.
    pub low: Option<f64>,
    /// Half are below.
    pub median: Option<f64>,
    /// 95 % are below.
    pub high: Option<f64>,
    /// The largest.
    pub max: Option<f64>,
}

/// A bound that is none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BrokenBound {
    /// The case.
    pub case: u64,
    /// Whose bound.
    pub side: String,
    /// The quantity.
    pub quantity: String,
    /// Which part of it.
    pub part: String,
    /// The bound.
    pub bound: Option<f64>,
    /// The true error.
    pub error: Option<f64>,
}

impl Record for Bounds {
    const SCHEMA: &'static str = "beamgap-bounds/2";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Bounds {
    /// The record of a run.
    pub fn new(found: &check::Bounds, seed: u64, cases_per_regime: u64, environment: Environment) -> Self {
        let mut rows = Vec::new();
        for side in Side::ALL {
            for order in [Order::Value, Order::First, Order::Second] {
                let of_regime = |&regime: &Regime| {
                    let measured = found.measured.get(&(regime, side, order))?;
                    Some(BoundsRow::new(side, order, regime.name(), measured))
                };
                rows.push(BoundsRow::new(side, order, "all", &found.over_all(side, order)));
                rows.extend(Regime::ALL.iter().filter_map(of_regime));
            }
        }
        let regimes = found.points.iter();
        let regimes =
            regimes.map(|(regime, &points)| RegimePoints { regime: regime.name().to_owned(), points });
        let violations = found.violations.iter().map(|(&case, violation)| BrokenBound {
            case,
            side: violation.side.name().to_owned(),
            quantity: violation.quantity.name().to_owned(),
            part: violation.part.to_owned(),
            bound: finite(violation.bound),
            error: finite(violation.error),
        });
        Self {
            schema: Self::SCHEMA.to_owned(),
            environment,
            seed,
            cases_per_regime,
            regimes: regimes.collect(),
            rows,
            violations: violations.collect(),
        }
    }
}

impl BoundsRow {
    fn new(side: Side, order: Order, regime: &str, measured: &check::Measured) -> Self {
        Self {
            side: side.name().to_owned(),
            order: order.name().to_owned(),
            regime: regime.to_owned(),
            entries: measured.overestimation.count(),
            exact: measured.exact,
            unbounded: measured.unbounded,
            overestimation: Quantiles::new(&measured.overestimation),
            error: Quantiles::new(&measured.error),
        }
    }
}

impl Quantiles {
    fn new(of: &Distribution) -> Self {
        let short = |x: Option<f64>| x.and_then(finite).map(|x| rounded(x, 2));
        Self {
            low: short(of.quantile(0.05)),
            median: short(of.quantile(0.5)),
            high: short(of.quantile(0.95)),
            max: short(of.max()),
        }
    }
}
