//! Rust's part of the comparison with peers: the pairs, what is right for each, and the crate's own candidates.
//!
//! Everything is handed over in the layouts of `peer.h`, through plain functions that `run` loads as it loads the peers.

mod cases;
mod reference;
mod candidates;
mod differences;
