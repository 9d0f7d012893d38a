//! A beam that is dragged over a curved one.

use super::{Chain, Gauss, Model, Problem};
use crate::contact::{Law, Parameters};
use crate::teaching::Material;
use nalgebra::Vector3;

impl Problem {
    /// A beam that is dragged over a curved one. The beam is bent to an arch with a radius of curvature of 10, and a bar beam is
    /// lowered onto it beside its top. The ends of the bar beam are then moved across the top, past element boundaries, and
    /// back. The bar beam sticks until it has bent enough, and then slips; when it turns back it sticks again.
    ///
    /// The beams cross at an angle of about 60 degrees. All dofs of their ends are given.
    pub fn dragged_beam(mu: f64) -> Self {
        let material = Material { axial: 4e4, bending: 100.0, radius: 0.1 };
        let (length, angle) = (8.0, 0.4_f64);
        let beam = Chain {
            start: Vector3::zeros(),
            end: Vector3::new(length, 0.0, 0.0),
            elements: 16,
            material,
            rule: Gauss::Three,
            first: 0,
        };
        let half = Vector3::new(1.5, 2.5, 0.0);
        let center = Vector3::new(3.15, 0.1, 1.3);
        let bar =
            Chain { start: center - half, end: center + half, elements: 12, first: beam.dofs(), ..beam };
        let ends = [beam.node(0), beam.node(beam.elements), bar.node(0), bar.node(bar.elements)];
        let given = ends.iter().flat_map(|&node| node..node + 6).collect();
        let parameters = Parameters::with_friction(Law::Linear { eps: 1e4 }, 500.0, mu);
        let model = Model {
            chains: [beam, bar],
            parameters,
            given,
            tolerance: 1e-8,
            precision: 1e-10,
            iterations: 40,
        };
        // An arc of this length whose ends have these slopes.
        let arch = |from: f64, to: f64| {
            let chord = |angle: f64| length * angle.sin() / angle;
            let shorter = if from == 0.0 { chord(to) - length } else { chord(to) - chord(from) };
            let (along, up) = (to.cos() - from.cos(), to.sin() - from.sin());
            let [start, end, ..] = ends;
            vec![(start + 3, along), (start + 5, up), (end, shorter), (end + 3, along), (end + 5, -up)]
        };
        let carry = |x: f64, z: f64| ends[2..].iter().flat_map(|&node| [(node, x), (node + 2, z)]).collect();
        let mut moves =
            vec![arch(0.0, 0.5 * angle), arch(0.5 * angle, angle), carry(0.0, -0.4), carry(0.0, -0.3)];
        for (x, steps) in [(0.02, 5), (0.1, 18), (-0.02, 6), (-0.1, 3)] {
            moves.extend(std::iter::repeat_n(carry(x, 0.0), steps));
        }
        Self { model, moves, rounding: 1e-12 }
    }
}
