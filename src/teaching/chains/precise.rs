//! Newton's method for one step once more, in double-double: its order is seen in norms that `f64` has no digits for.
//!
//! What is decided, the elements of the contact point and the state, is decided in `f64`. Residual and tangent, and the
//! closest point, have 32 digits. A linear system is solved by the factors of `f64` and corrected until its residual is
//! as small.

use super::model::decided;
use super::{Chain, Model, ModelError, State, search};
use crate::closest_point::ClosestPoint;
use crate::contact::{Contribution, Element, closed_form};
use crate::linearization::closed_form::{Projection, jets};
use crate::number::DoubleDouble;
use crate::pair::DofVector;
use crate::teaching::DOFS;
use nalgebra::{DMatrix, DVector};

type Number = DoubleDouble;

/// Newton's steps for a closest point, and the corrections of a linear system: each adds digits to those of `f64`.
const CLOSEST_POINT: usize = 3;
const CORRECTIONS: usize = 20;

impl Model {
    /// The energy norm sqrt(|R·δu|) of so many iterations of [`Model::step`] after its predictor, in double-double.
    ///
    /// # Errors
    /// Those of [`Model::step`].
    pub fn precise_norms(
        &self,
        state: &State,
        moves: &[(usize, f64)],
        iterations: usize,
    ) -> Result<Vec<f64>, ModelError> {
        let mut u = state.u.map(Number::from);
        let mut increment = DVector::from_element(u.len(), Number::from(0.0));
        for &(dof, by) in moves {
            increment[dof] = by.into();
        }
        let mut norms: Vec<f64> = Vec::new();
        for iteration in 0..=iterations {
            let (residual, tangent) = self.precise_system(state, &u)?;
            self.solve((&residual, &tangent), &mut increment, corrected)
                .ok_or(ModelError::Singular { iteration })?;
            u += &increment;
            if iteration > 0 {
                norms.push(self.free(&residual).dot(&self.free(&increment)).value().abs().sqrt());
            }
            increment.fill(0.0.into());
        }
        Ok(norms)
    }

    /// Residual and tangent over all dofs.
    fn precise_system(
        &self,
        converged: &State,
        u: &DVector<Number>,
    ) -> Result<(DVector<Number>, DMatrix<Number>), ModelError> {
        let zero = Number::from(0.0);
        let mut residual = DVector::from_element(u.len(), zero);
        let mut tangent = DMatrix::from_element(u.len(), u.len(), zero);
        for chain in &self.chains {
            chain.add(u, &mut residual, &mut tangent);
        }
        let rounded = u.map(Number::value);
        let place = search::nearest(&self.chains, &rounded)?;
        let (history, from) = converged.history;
        let history = search::carried(&self.chains, &converged.u, history, from, place.owner);
        let pair = search::pair(&self.chains);
        let element = Element::new(&pair, &self.parameters)?;
        let q = search::dofs(&self.chains, &rounded, place.owner);
        let outcome = element.evaluate(&q, &place.point, &history, &mut Contribution::zeros())?;
        if outcome.values.f_n <= self.tolerance {
            return Ok((residual, tangent));
        }
        let decision = decided(&element, &q, &place.point, &history, &outcome)?;
        let q = search::dofs(&self.chains, u, place.owner);
        let at = closest_point(&self.chains, &q, &place.point);
        let (jet, jet_bar) = jets(&pair, &q, at);
        let mut to = Contribution::zeros();
        closed_form::write(&decision, (&jet, &jet_bar), at, &mut to);
        self.add_contact(&to, place.owner, &mut residual, &mut tangent);
        Ok((residual, tangent))
    }
}

/// The parameters of a closest point that is known in `f64`.
fn closest_point(
    chains: &[Chain; 2],
    q: &DofVector<Number, DOFS, DOFS>,
    near: &ClosestPoint,
) -> (Number, Number) {
    let pair = search::pair(chains);
    let (mut xi, mut xi_bar) = (Number::from(near.xi), Number::from(near.xi_bar));
    for _ in 0..CLOSEST_POINT {
        let (jet, jet_bar) = jets(&pair, q, (xi, xi_bar));
        let (x, x_bar) = (jet.geometry, jet_bar.geometry);
        let d = x.x - x_bar.x;
        // The conditions d·t = d·t̄ = 0 of (48), by the matrix of (50).
        let (by, by_bar) = Projection::new(&x, &x_bar, near.held()).solve(-d.dot(&x.t), -d.dot(&x_bar.t));
        (xi, xi_bar) = (xi + by, xi_bar + by_bar);
    }
    (xi, xi_bar)
}

/// The solution of a linear system.
fn corrected(matrix: &DMatrix<Number>, right: &DVector<Number>) -> Option<DVector<Number>> {
    let factors = matrix.map(Number::value).lu();
    let (mut solution, mut left) = (DVector::from_element(right.len(), Number::from(0.0)), right.clone());
    for _ in 0..CORRECTIONS {
        let by = factors.solve(&left.map(Number::value))?;
        let size = by.amax();
        solution += by.map(Number::from);
        left = right - matrix * &solution;
        if !size.is_finite() {
            return None;
        }
        if size <= f64::EPSILON * f64::EPSILON * solution.map(Number::value).amax() {
            break;
        }
    }
    Some(solution)
}
