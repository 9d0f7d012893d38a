//! The properties that beamgap claims, one module a claim; inputs come from [`strategies`].

mod allocation;
mod centroids;
mod closed_form_equals_ad;
mod closest_points;
mod command_line;
mod degenerate;
mod every_minimum;
mod families;
mod invariances;
mod jets;
mod ledger;
mod numbers;
mod pairs;
mod proof;
mod reports;
mod scalars;
mod strategies;
mod symmetry;
mod values;
