//! The order and the scale of the dofs of another program.

use super::Conventions;
use crate::test_beam::Family;

/// The order of the dofs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Dofs {
    /// Node by node: x, y and z of each.
    #[default]
    NodeMajor,
    /// All x, then all y, then all z.
    ComponentMajor,
    /// All x of both beams, then all y, then all z.
    PairComponentMajor,
}

impl Conventions {
    /// For each dof of the program, its index among the dofs of both beams, and its factor.
    pub(in crate::check::external) fn dofs(&self, families: [Family; 2]) -> Vec<(usize, f64)> {
        let of_beam = |start: usize, family: Family| {
            let count = family.units().len();
            let tangents = match family {
                Family::Hermite => vec![3, 4, 5, 9, 10, 11],
                _ => Vec::new(),
            };
            // Rows of three coordinates, or of four with a weight. Arcs and helices have no nodes.
            let width = match family {
                Family::Arc | Family::Helix => count,
                Family::NurbsWeighted => 4,
                _ => 3,
            };
            let nodes = count / width;
            let place = move |k: usize| match self.dofs {
                Dofs::NodeMajor | Dofs::PairComponentMajor => k,
                Dofs::ComponentMajor if width == count => k,
                Dofs::ComponentMajor => (k % nodes) * width + k / nodes,
            };
            (0..count).map(move |k| {
                let factor = if tangents.contains(&place(k)) { self.hermite_tangent } else { 1.0 };
                (start + place(k), factor)
            })
        };
        let [beam, bar] = families;
        let first = of_beam(0, beam).collect::<Vec<_>>();
        let second = of_beam(beam.units().len(), bar).collect::<Vec<_>>();
        let both = if self.bar_first { [second, first].concat() } else { [first, second].concat() };
        if self.dofs != Dofs::PairComponentMajor {
            return both;
        }
        // Coordinates and weights of both beams, one after the other. Dofs that belong to no node come last.
        let start = beam.units().len();
        let component = |(place, _): &(usize, f64)| {
            let (family, place) = if *place < start { (beam, *place) } else { (bar, *place - start) };
            match family {
                Family::Arc | Family::Helix => 4,
                Family::NurbsWeighted => place % 4,
                _ => place % 3,
            }
        };
        let mut sorted = both;
        sorted.sort_by_key(component);
        sorted
    }

    /// A direction in the dofs of the program.
    pub(in crate::check::external) fn direction(&self, families: [Family; 2], dq: &[f64]) -> Vec<f64> {
        // x,ξ = f q: if q is varied by δq, x,ξ is varied by f δq.
        self.dofs(families).into_iter().map(|(place, factor)| dq[place] / factor).collect()
    }
}
