//! The gap of two cubic Hermite beams, with its derivatives with respect to all dofs.
//!
//! `cargo run --example gap`

use beamgap::closest_point::ProjectionError;
use beamgap::curve::Hermite;
use beamgap::pair::{Contact, Pair};

fn main() -> Result<(), ProjectionError> {
    let contact = Contact { radius: 0.1, radius_bar: 0.1, ..Contact::default() };
    let pair = Pair::new(Hermite::new(), Hermite::new()).with_contact(contact);
    // The dofs are point, tangent, point, tangent. The parameter runs from -1 to 1.
    let beam = [-1.0, 0.0, 0.0, 1.0, 0.2, 0.0, 1.0, 0.0, 0.0, 1.0, -0.2, 0.0];
    let bar = [0.0, -1.0, 0.15, 0.0, 1.0, -0.1, 0.0, 1.0, 0.15, 0.0, 1.0, 0.1];
    let q = (beam, bar).into();

    let found = pair.closest_points(&q)?;
    let point = found.interior()?;
    let gap = pair.linearize(&q, point).g_n();
    println!("closest at xi = {:.6}, xi_bar = {:.6}", point.xi, point.xi_bar);
    println!("g_N = {:.6}: the beams {}", gap.value, if gap.value < 0.0 { "overlap" } else { "are apart" });

    // A penalty eps g_N^2/2 gives the force and the tangent stiffness that a finite element code assembles.
    let eps = 1e4;
    let force = gap.gradient.times(eps * gap.value);
    let stiffness =
        |i, j| eps * (gap.gradient.entry(i) * gap.gradient.entry(j) + gap.value * gap.hessian.entry(i, j));
    println!("force on the first point of the beam, z: {:.4}", force.entry(2));
    println!("stiffness between it and the last point of the bar beam, z: {:.4}", stiffness(2, 20));
    Ok(())
}
