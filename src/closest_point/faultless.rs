//! The search without faults: what is asked of `fault.rs` changes nothing, and is compiled away.

use super::{ClosestPoint, ClosestPoints};

#[inline(always)]
pub(super) fn bound(bound: f64) -> f64 {
    bound
}

#[inline(always)]
pub(super) fn contraction(contraction: f64) -> f64 {
    contraction
}

#[inline(always)]
pub(super) fn start(start: (f64, f64)) -> (f64, f64) {
    start
}

#[inline(always)]
pub(super) fn skips_edge(_: usize, _: u32) -> bool {
    false
}

#[inline(always)]
pub(super) fn skips_corners() -> bool {
    false
}

#[inline(always)]
pub(super) fn of_edge(point: ClosestPoint) -> ClosestPoint {
    point
}

#[inline(always)]
pub(super) fn result(found: ClosestPoints) -> ClosestPoints {
    found
}
