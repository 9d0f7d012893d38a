//! The request and the result of `beamgap prove`.

use beamgap::prove::Proof;
use beamgap::test_beam::Family;

/// The request and the result.
pub(super) struct Proved {
    pub(super) plant: Vec<String>,
    pub(super) seed: u64,
    pub(super) families: Vec<Family>,
    pub(super) draws: u64,
    pub(super) proof: Proof,
}
