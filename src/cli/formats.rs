//! Results in the formats of continuous integration, written from an [`Outcome`](super::outcome::Outcome) alone.

mod github;
mod junit;
mod markdown;
mod sarif;

pub(super) use github::{github, write_step_summary};
pub(super) use junit::junit;
pub(super) use markdown::markdown;
pub(super) use sarif::sarif;

#[cfg(test)]
mod tests;
