//! Newton's method for two elastic beams in contact needs the exact tangent.
//!
//! `cargo run --example newton`
//!
//! Each beam is one cubic Hermite element with linear axial and bending stiffness. Its first node is clamped: point and
//! tangent are fixed. Its second node is free. The clamp of the upper beam is moved down in steps. A penalty eps g_N²/2
//! at the closest point keeps the beams apart. The residual is always exact. In the last step the tangent is exact, or
//! it has a missing or a wrong term.

use beamgap::teaching::{Problem, Tangent};

fn main() {
    let problem = Problem::default();
    let runs = Tangent::ALL.map(|tangent| problem.solve(tangent));
    println!("The last step: residual over the first, at each iteration\n");
    print!("{:>4}", "");
    for tangent in Tangent::ALL {
        print!("{:>19}", tangent.name());
    }
    println!();
    let longest = runs.iter().map(|run| run.iterates.len()).max().unwrap_or_default();
    for i in 0..longest.min(16) {
        print!("{i:>4}");
        for run in &runs {
            let residual = run.iterates.get(i).map(|iterate| format!("{:.1e}", iterate.residual));
            print!("{:>19}", residual.unwrap_or_default());
        }
        println!();
    }
    println!();
    for (tangent, run) in Tangent::ALL.iter().zip(&runs) {
        match &run.stopped {
            None => println!("{}: converged after {} iterations", tangent.name(), run.iterations()),
            Some(why) => println!("{}: {why}", tangent.name()),
        }
    }
    if let Some(last) = runs[0].iterates.last() {
        println!("\nAt equilibrium g_N = {:.6}, xi = {:.6}, xi_bar = {:.6}", last.gap, last.at.0, last.at.1);
    }
}
