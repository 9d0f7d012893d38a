//! Cubic curves at other parameters.

use super::Sample;
use super::shapes::Node;
use crate::number::RunningError;
use nalgebra::Vector3;

impl Sample {
    /// Whether both curves are sums of cubics times control vectors.
    pub(in crate::check::external::stages) fn is_cubic(&self) -> bool {
        let of =
            |nodes: &Vec<Node>| !nodes.is_empty() && nodes.iter().all(|node| node.coefficients.is_some());
        self.nodes.iter().all(of)
    }

    /// The curves at other parameters, if they are cubic.
    pub(in crate::check::external::stages) fn move_to(&mut self, xi: [f64; 2]) {
        for (beam, xi) in xi.into_iter().enumerate() {
            self.xi[beam].value = xi;
            let mut sums = [[Vector3::zeros(); 4]; 3];
            for node in &mut self.nodes[beam] {
                let Some([n, slope, bend, third]) = node.coefficients else { continue };
                node.shape = [
                    n + xi * (slope + xi * (bend + xi * third)),
                    slope + xi * (2.0 * bend + xi * 3.0 * third),
                    2.0 * bend + 6.0 * third * xi,
                    6.0 * third,
                ];
                for (of, vector) in sums.iter_mut().zip(&node.vectors) {
                    for (sum, shape) in of.iter_mut().zip(node.shape) {
                        *sum += vector * shape;
                    }
                }
            }
            let put = |to: &mut Vector3<RunningError>, sum: &Vector3<f64>| {
                to.iter_mut().zip(sum).for_each(|(to, sum)| to.value = *sum);
            };
            let [curve, delta, linear] = &sums;
            self.geometry[beam].iter_mut().zip(curve).for_each(|(to, sum)| put(to, sum));
            self.moved[0][beam].iter_mut().zip(delta).for_each(|(to, sum)| put(to, sum));
            self.moved[1][beam].iter_mut().zip(linear).for_each(|(to, sum)| put(to, sum));
        }
    }
}
