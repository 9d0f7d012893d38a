//! Three beam problems with many elements, solved by Newton's method with the contact element.
//!
//! `cargo run --release --example beam_problems -- crossed`, `crossed-friction`, `crossing` or `dragged`
//!
//! Each line is a step: the state of the contact, F_N, the length of the residual at each iterate, and the order of convergence
//! from the last four norms in double-double. After that the problem is solved with single terms of the tangent
//! of the contact left out. The residual is always exact.

use beamgap::teaching::chains::Problem;
use beamgap::teaching::terms::{Tangent, Term};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let name = std::env::args().nth(1).unwrap_or_default();
    let problem = match name.as_str() {
        "crossed" => Problem::crossed_beams(0.0),
        "crossed-friction" => Problem::crossed_beams(0.3),
        "dragged" => Problem::dragged_beam(0.3),
        "crossing" => Problem::crossing_centroids(10),
        _ => return Err("name a problem: crossed, crossed-friction, crossing or dragged".into()),
    };
    println!("step  state          F_N            |F_T|/F_N  order  residuals");
    let (steps, u) = problem.solve(Tangent::EXACT)?;
    let orders = problem.orders()?;
    for (i, (step, order)) in steps.iter().zip(orders).enumerate() {
        let values = &step.outcome.values;
        let ratio = if values.f_n > 0.0 { values.traction.norm() / values.f_n } else { 0.0 };
        let order = order.map_or_else(|| "-".to_owned(), |p| format!("{p:.2}"));
        let residuals: Vec<String> = step.residuals.iter().map(|r| format!("{r:.1e}")).collect();
        println!(
            "{:4}  {:13}  {:<13.6e}  {ratio:9.4}  {order:>5}  {}",
            i + 1,
            format!("{:?}", step.outcome.state),
            values.f_n,
            residuals.join(" ")
        );
    }
    if name == "crossing" {
        let beam = &problem.model.chains[0];
        let tip = beam.node(beam.elements);
        println!(
            "\nThe tip moves by {:.10e} along the beam and {:.10e} across.",
            u[tip] - beam.end.x,
            u[tip + 1]
        );
    }

    println!("\nLeft out of the tangent: iterations in each step with contact");
    for left_out in std::iter::once(None).chain(Term::of_rate().map(Some)) {
        let text = match problem.solve(Tangent { left_out, ..Tangent::EXACT }) {
            Ok((steps, _)) => {
                let count = |step: &beamgap::teaching::chains::Step| {
                    let n = step.residuals.len();
                    if step.converged { n.to_string() } else { format!("none in {n}") }
                };
                steps
                    .iter()
                    .skip_while(|step| step.outcome.values.f_n == 0.0)
                    .map(count)
                    .collect::<Vec<_>>()
                    .join(" ")
            }
            Err(error) => error.to_string(),
        };
        println!("  {:38} {text}", left_out.map_or("nothing", Term::name));
    }
    Ok(())
}
