//! A bar beam is pressed on a beam and dragged along it: the contact sticks, slips, and sticks again.
//!
//! `cargo run --example contact_element`

use beamgap::contact::{Contribution, Element, History, Law, Parameters};
use beamgap::curve::Hermite;
use beamgap::pair::{Contact, Pair};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let contact = Contact { radius: 0.1, radius_bar: 0.1, ..Contact::default() };
    let pair = Pair::new(Hermite::new(), Hermite::new()).with_contact(contact);
    let parameters = Parameters::with_friction(Law::Linear { eps: 1e4 }, 1e4, 0.3);
    let element = Element::new(&pair, &parameters)?;
    // The dofs are point, tangent, point, tangent. The parameter runs from -1 to 1.
    let beam = [-1.0, 0.0, 0.0, 1.0, 0.2, 0.0, 1.0, 0.0, 0.0, 1.0, -0.2, 0.0];
    let bar = [0.0, -1.0, 0.15, 0.0, 1.0, -0.1, 0.0, 1.0, 0.15, 0.0, 1.0, 0.1];

    let mut to = Contribution::zeros();
    let mut history = History::default();
    println!("step  state             F_N         F   Phi/(mu F_N)   |K - K^T|");
    // The path along the beam: forth, and back.
    for (step, x) in [0.0, 0.005, 0.02, 0.04, 0.038, 0.02].into_iter().enumerate() {
        let mut bar = bar;
        for node in [0, 6] {
            bar[node] += x;
        }
        let q = (beam, bar).into();
        let found = pair.closest_points(&q)?;
        let outcome = element.evaluate(&q, found.interior()?, &history, &mut to)?;
        let (k, values) = (to.tangent.to_dense(), outcome.values);
        let unsymmetry = (&k - k.transpose()).amax() / k.amax();
        println!(
            "{step:4}  {:12} {:10.4} {:9.4} {:14.4} {unsymmetry:11.1e}",
            format!("{:?}", outcome.state),
            values.f_n,
            values.f,
            values.yield_ratio
        );
        // Each step counts as converged.
        history = outcome.next;
    }
    Ok(())
}
