//! Tests of the contact element. The beams come from [`beams`].

mod agreement;
mod beams;
