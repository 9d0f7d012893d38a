//! The Rust part of the comparison with peers: the pairs, the exact result for each, and the candidates of this crate.
//!
//! All data have the layouts of `peer.h`. The functions are C functions, which `run` loads like those of the peers.

mod cases;
mod reference;
mod candidates;
mod differences;
