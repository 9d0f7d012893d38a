//! Finite differences in `f64`, by the default rules of common tools, for comparison.
//!
//! Each tool differentiates along a direction whose largest entry is 1 and compares the result with the closed form:
//! differences of the value with delta, differences of delta with Delta-delta. Steps and tolerances are those of the tool.
//! They do not scale with the unit of length.

use super::steps::{Moved, STEPS, TAYLOR};
use super::test_points::Sample;
use crate::linearization::{COMPONENTS, Quantity, Varied};
use crate::variant::{Step, Variant};

/// Step and tolerance of a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rule {
    /// `torch.autograd.gradcheck` and `gradgradcheck`.
    Torch,
    /// `jax.test_util.check_grads`.
    Jax,
    /// `scipy.optimize.check_grad`, with the bound that its users choose.
    SciPy,
    /// The Taylor test of `pyadjoint`.
    Taylor,
}

impl Rule {
    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Torch => "torch",
            Self::Jax => "jax",
            Self::SciPy => "scipy",
            Self::Taylor => "taylor",
        }
    }

    /// A description of step and tolerance.
    pub fn what(self) -> &'static str {
        match self {
            Self::Torch => {
                "central differences, step 1e-6, within 1e-5 + 1e-3 of the number (torch gradcheck)"
            }
            Self::Jax => {
                "central differences, steps of 5e-5, within 1e-5 + 1e-5 of the number (jax check_grads)"
            }
            Self::SciPy => "forward differences, step 1.5e-8, within 1e-6 (scipy check_grad)",
            Self::Taylor => {
                "the convergence rate of the Taylor remainder must exceed 1.9 (first order) and 2.9 (second order), at \
                 steps 0.01 to 0.00125 (pyadjoint taylor_test)"
            }
        }
    }
}

/// The closed form of a variant, at a sample and at all its steps.
pub(super) struct Differences<'a> {
    variant: &'a Variant,
    sample: &'a Sample<'a>,
    here: [Varied<f64>; COMPONENTS],
}

/// The scalars among the components. A Taylor test applies to a functional.
const SCALARS: std::ops::Range<usize> = Quantity::D.component()..COMPONENTS;

impl<'a> Differences<'a> {
    pub(super) fn new(variant: &'a Variant, sample: &'a Sample<'a>) -> Self {
        Self { variant, sample, here: sample.evaluation.plain(variant) }
    }

    /// Whether the tool finds a difference beyond its tolerance, or cannot compute one.
    pub(super) fn rejects(&self, rule: Rule) -> bool {
        let near = |closed: f64, by: f64| match rule {
            Rule::Torch => (closed - by).abs() <= 1e-5 + 1e-3 * by.abs(),
            Rule::Jax => (closed - by).abs() <= 1e-5 + 1e-5 * by.abs(),
            _ => (closed - by).abs() <= 1e-6,
        };
        let passes = match rule {
            Rule::Torch => self.passes([0, 1], near),
            Rule::Jax => self.passes([2, 3], near),
            Rule::SciPy => self.passes_forward(near),
            Rule::Taylor => self.passes_taylor(),
        };
        passes != Some(true)
    }

    fn at(&self, moved: &Moved) -> Option<[Varied<f64>; COMPONENTS]> {
        let (at, partial) = moved.as_ref()?;
        let evaluation = &self.sample.evaluation;
        let of = |step: Step| partial[step as usize];
        Some(self.variant.quantities(of, *at, evaluation.form, evaluation.contact).components())
    }

    fn passes(&self, [ahead, behind]: [usize; 2], near: impl Fn(f64, f64) -> bool) -> Option<bool> {
        let width = STEPS[ahead] - STEPS[behind];
        let [along, linear] = &self.sample.steps.moved;
        let pair = |of: &[Moved; STEPS.len()]| Some([self.at(&of[ahead])?, self.at(&of[behind])?]);
        Some(self.all_near(pair(along)?, pair(linear)?, width, near))
    }

    fn passes_forward(&self, near: impl Fn(f64, f64) -> bool) -> Option<bool> {
        let [along, linear] = &self.sample.steps.moved;
        let last = STEPS.len() - 1;
        let pair = |of: &[Moved; STEPS.len()]| Some([self.at(&of[last])?, self.here]);
        Some(self.all_near(pair(along)?, pair(linear)?, STEPS[last], near))
    }

    /// First derivatives along both directions, and delta along Delta q.
    fn all_near(
        &self,
        [x, y]: [[Varied<f64>; COMPONENTS]; 2],
        [z, w]: [[Varied<f64>; COMPONENTS]; 2],
        width: f64,
        near: impl Fn(f64, f64) -> bool,
    ) -> bool {
        let [unit, linear_unit] = self.sample.steps.units;
        (0..COMPONENTS).all(|i| {
            let here = &self.here[i];
            near(here.delta / unit, (x[i].value - y[i].value) / width)
                && near(here.linear / linear_unit, (z[i].value - w[i].value) / width)
                && near(here.second / (unit * linear_unit), (z[i].delta - w[i].delta) / (unit * width))
        })
    }

    /// Whether the remainders of the derivatives along delta q decrease with the square, and with the cube, of the step.
    fn passes_taylor(&self) -> Option<bool> {
        let [unit, _] = self.sample.steps.units;
        let twice = self.at(&self.sample.steps.twice)?;
        let moved: Vec<_> =
            self.sample.steps.taylor.iter().map(|moved| self.at(moved)).collect::<Option<_>>()?;
        let falls = |remainders: &[f64], rate: f64| {
            // A constant has no remainder.
            remainders.windows(2).all(|pair| pair[1] == 0.0 || (pair[0] / pair[1]).log2() > rate)
        };
        Some(SCALARS.into_iter().all(|i| {
            let (slope, bend) = (self.here[i].delta / unit, twice[i].second / (unit * unit));
            let remainders = |with_bend: f64| -> Vec<f64> {
                let of = |(step, moved): (f64, &[Varied<f64>; COMPONENTS])| {
                    let derivatives = self.here[i].value + step * (slope + with_bend * 0.5 * step * bend);
                    (moved[i].value - derivatives).abs()
                };
                TAYLOR.into_iter().zip(&moved).map(of).collect()
            };
            falls(&remainders(0.0), 1.9) && falls(&remainders(1.0), 2.9)
        }))
    }
}
