//! The library's public functions against the formulas that were compared with the references.

use super::{Closed, References};
use crate::check::element::ContactSituations;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::verdict::{Comparison, Order};
use crate::linearization::{Quantity, Varied};
use crate::variant::{Returned, scalar_of};

impl Closed {
    /// The functions of the kernel, those of the user's curve, and all routes if they are asked for.
    ///
    /// The curves of the routes are expansions of what the closed form uses, so the routes are no references here.
    pub(super) fn functions(
        &self,
        evaluation: &EvaluationPoint,
        references: &References,
        own: &[Returned],
        with_routes: bool,
    ) -> Vec<Comparison> {
        let (kernel, bounds) = evaluation.kernel().unzip();
        let [closed, differentiated] = if with_routes { evaluation.routes() } else { Default::default() };
        let bound = |[i, k]: [usize; 2]| self.bounds[i].parts()[k].bound;
        // All functions of the kernel compute the same numbers, summed in another order.
        let of_kernel = |[i, k]: [usize; 2]| {
            let number = bounds.as_ref().zip(scalar_of(i)).and_then(|(bounds, scalar)| bounds[scalar][k]);
            number.map_or(0.0, |number| number.bound)
        };
        let of_matrices = |[i, k]: [usize; 2]| {
            scalar_of(i).filter(|_| k > 0).map_or(0.0, |scalar| self.matrices[scalar][k - 1].bound)
        };
        // Like num-dual's routes, they solve for the closest point in `f64` again.
        let of_routes = |[i, k]: [usize; 2]| references.chord[i].parts()[k].bound[1];
        let mut entries = Vec::new();
        let mut add = |functions: &[Returned], tolerance: &dyn Fn([usize; 2]) -> f64| {
            entries.extend(functions.iter().flat_map(|function| self.function(function, tolerance)));
        };
        add(&kernel.unwrap_or_default(), &|of| bound(of)[0] + of_kernel(of));
        add(&closed, &|of| 2.0 * bound(of)[0] + of_matrices(of));
        add(&differentiated, &|of| bound(of)[1] + of_routes(of));
        // By the kernel, by the matrices or by a route.
        add(own, &|of| 2.0 * bound(of)[1] + of_kernel(of) + of_matrices(of) + of_routes(of));
        if with_routes {
            entries.extend(evaluation.contact_elements(&references.chord));
        }
        entries
    }

    /// What a function returns.
    fn function(
        &self,
        Returned { function, answers }: &Returned,
        tolerance: &dyn Fn([usize; 2]) -> f64,
    ) -> Vec<Comparison> {
        let numbers = answers.iter().flat_map(|(i, parts)| {
            parts.iter().enumerate().filter_map(|(k, number)| Some(([*i, k], (*number)?)))
        });
        let comparison = |([i, k], other): ([usize; 2], f64)| Comparison {
            quantity: Quantity::of_component(i),
            axis: Quantity::axis_of_component(i),
            order: Order::Function,
            part: Varied::<f64>::PARTS[k],
            against: function,
            closed: self.plain[i].parts()[k],
            other,
            scale: self.scales[i].parts()[k].scale,
            bound: self.bounds[i].parts()[k].bound[0],
            tolerance: tolerance([i, k]),
            situations: ContactSituations::NONE,
        };
        numbers.map(comparison).collect()
    }
}
