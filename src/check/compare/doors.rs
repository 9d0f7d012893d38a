//! The library's public functions against the formulas that were compared with the references.

use super::{Closed, References};
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::verdict::{Comparison, Order};
use crate::linearization::{Quantity, Varied};
use crate::variant::{Door, SCALAR_COMPONENTS};

impl Closed {
    /// Each function of the kernel, against the variations.
    pub(super) fn kernel(&self, evaluation: &EvaluationPoint) -> Vec<Comparison> {
        let Some((doors, bounds)) = evaluation.kernel() else { return Vec::new() };
        // All functions compute the same numbers, summed in another order. g_N has the derivatives of d.
        let bound = |[i, k]: [usize; 2]| {
            let scalar = SCALAR_COMPONENTS.iter().position(|&component| component == i).unwrap_or(0);
            bounds[scalar][k].map_or(0.0, |number| number.bound)
        };
        self.doors(&doors, |of| self.bounds[of[0]].parts()[of[1]].bound[0] + bound(of))
    }

    /// The functions for any curve, of the closed form and of automatic differentiation, against the variations.
    ///
    /// The curves are expansions of what the closed form uses, so these functions are no references.
    pub(super) fn routes(&self, evaluation: &EvaluationPoint, references: &References) -> Vec<Comparison> {
        let [closed, differentiated] = evaluation.routes();
        let bound = |[i, k]: [usize; 2]| self.bounds[i].parts()[k].bound;
        let matrix = |[i, k]: [usize; 2]| {
            let scalar = SCALAR_COMPONENTS.iter().position(|&component| component == i);
            scalar.filter(|_| k > 0).map_or(0.0, |scalar| self.matrices[scalar][k - 1].bound)
        };
        // The same formulas at the same numbers: the rounding of both sides.
        let near = |of| 2.0 * bound(of)[0] + matrix(of);
        // Like num-dual's routes, they solve for the closest point in `f64` again.
        let far = |of: [usize; 2]| bound(of)[1] + references.chord[of[0]].parts()[of[1]].bound[1];
        let mut entries = self.doors(&closed, near);
        entries.extend(self.doors(&differentiated, far));
        entries
    }

    /// The functions of the user's curve, against the variations.
    pub(super) fn own(
        &self,
        doors: &[Door],
        evaluation: &EvaluationPoint,
        references: &References,
    ) -> Vec<Comparison> {
        if doors.is_empty() {
            return Vec::new();
        }
        let kernel = evaluation.kernel().map(|(_, bounds)| bounds);
        // By matrices or by the kernel, or by another route of automatic differentiation.
        let tolerance = |[i, k]: [usize; 2]| {
            let scalar = SCALAR_COMPONENTS.iter().position(|&component| component == i).unwrap_or(0);
            let of_kernel =
                kernel.as_ref().and_then(|bounds| bounds[scalar][k]).map_or(0.0, |number| number.bound);
            let of_matrix = if k > 0 { self.matrices[scalar][k - 1].bound } else { 0.0 };
            let far = references.chord[i].parts()[k].bound[1];
            2.0 * self.bounds[i].parts()[k].bound[1] + of_kernel + of_matrix + far
        };
        self.doors(doors, tolerance)
    }

    /// The answers of some functions.
    fn doors(&self, doors: &[Door], tolerance: impl Fn([usize; 2]) -> f64) -> Vec<Comparison> {
        let mut entries = Vec::new();
        for Door { name, answers } in doors {
            for (i, parts) in answers {
                for (k, other) in parts.iter().enumerate() {
                    let Some(other) = *other else { continue };
                    entries.push(Comparison {
                        quantity: Quantity::of_component(*i),
                        axis: Quantity::axis_of_component(*i),
                        order: Order::Function,
                        part: Varied::<f64>::PARTS[k],
                        against: name,
                        closed: self.plain[*i].parts()[k],
                        other,
                        scale: self.scales[*i].parts()[k].scale,
                        bound: self.bounds[*i].parts()[k].bound[0],
                        tolerance: tolerance([*i, k]),
                    });
                }
            }
        }
        entries
    }
}
