//! The properties that beamgap claims, one module a claim; inputs come from [`strategies`].

mod allocation;
mod bounds;
mod case_files;
mod centroids;
mod closed_form_equals_ad;
mod closest_points;
mod command_line;
mod degenerate;
mod every_minimum;
mod families;
mod faults;
mod invariances;
mod jets;
mod ledger;
mod numbers;
mod oracles;
mod pairs;
mod pasted;
mod proof;
mod reports;
mod scalars;
mod shrinking;
mod strategies;
mod symmetry;
mod threads;
mod values;
