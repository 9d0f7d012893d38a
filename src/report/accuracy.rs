//! The record of how many digits each form keeps, `beamgap-accuracy/2`.

use super::number::{finite, rounded};
use super::{Environment, Record};
use crate::check;
use serde::{Deserialize, Serialize};

/// What each form of the closed form loses, over the gap and over the angle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Accuracy {
    /// `beamgap-accuracy/2`.
    pub schema: String,
    /// Where and with what it ran.
    pub environment: Environment,
    /// The seed of all pairs.
    pub seed: u64,
    /// The pairs at each gap and angle.
    pub pairs: usize,
    /// Over the gap, in lengths of a beam: pairs of all families.
    pub gaps: Vec<AccuracyRow>,
    /// Over the angle, in radians: pairs of straight beams.
    pub angles: Vec<AccuracyRow>,
}

/// One gap or angle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct AccuracyRow {
    /// The gap or the angle.
    pub at: f64,
    /// Pairs with a closest point near where they were to cross.
    pub pairs: usize,
    /// Pairs for which the distance is varied along the normal.
    pub normal: usize,
    /// Pairs for which the system is solved by cross products.
    pub cross_products: usize,
    /// Of Delta-delta d.
    pub d: Losses,
    /// Of Delta-delta xi.
    pub xi: Losses,
}

/// Medians of relative errors, with two digits; null where there is none.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Losses {
    /// Of the paper's form.
    pub paper: Option<f64>,
    /// Of the form along the normal and by cross products.
    pub robust: Option<f64>,
    /// Of the form that is chosen.
    pub chosen: Option<f64>,
}

impl Record for Accuracy {
    const SCHEMA: &'static str = "beamgap-accuracy/2";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Accuracy {
    /// The record of a run.
    pub fn new(found: &check::Accuracy, seed: u64, pairs: usize, environment: Environment) -> Self {
        let rows = |levels: &[check::Level]| levels.iter().map(AccuracyRow::new).collect();
        Self {
            schema: Self::SCHEMA.to_owned(),
            environment,
            seed,
            pairs,
            gaps: rows(&found.gaps),
            angles: rows(&found.angles),
        }
    }

    /// The largest ratio of what the choice loses to what the better form loses, over all rows and both quantities;
    /// infinite if something was not measured.
    pub fn worst_choice(&self) -> f64 {
        let rows = self.gaps.iter().chain(&self.angles);
        rows.flat_map(|row| [row.d, row.xi]).map(|losses| losses.ratio()).fold(0.0, f64::max)
    }
}

impl AccuracyRow {
    fn new(level: &check::Level) -> Self {
        let check::Level { at, pairs, normal, cross_products, d, xi } = *level;
        Self { at, pairs, normal, cross_products, d: Losses::new(d), xi: Losses::new(xi) }
    }
}

impl Losses {
    fn new(errors: check::Errors) -> Self {
        let short = |x: f64| finite(x).map(|x| rounded(x, 2));
        Self { paper: short(errors.paper), robust: short(errors.robust), chosen: short(errors.chosen) }
    }

    /// What the choice loses over what the better form loses, which is a rounding unit at least.
    fn ratio(&self) -> f64 {
        let [paper, robust, chosen] =
            [self.paper, self.robust, self.chosen].map(|x| x.unwrap_or(f64::INFINITY));
        chosen / paper.min(robust).max(0.5 * f64::EPSILON)
    }
}
