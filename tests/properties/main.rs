//! The properties that beamgap claims, one module a claim; inputs come from [`strategies`].

mod centroids;
mod closest_points;
mod degenerate;
mod every_minimum;
mod jets;
mod reports;
mod strategies;
