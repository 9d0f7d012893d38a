//! Relations that hold for every curve and every pair of curves.

mod centroids;
mod closest_points;
mod degenerate;
mod every_minimum;
