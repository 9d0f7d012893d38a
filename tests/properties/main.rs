//! The properties that beamgap claims, one module a claim.

mod closest_points;
mod degenerate;
mod jets;
mod strategies;
