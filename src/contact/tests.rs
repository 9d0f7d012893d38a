//! Tests of the contact element. The beams come from [`beams`].

mod agreement;
mod allocation;
mod beams;
mod field;
mod invariances;
mod multiplier;
mod refused;
mod symmetry;
