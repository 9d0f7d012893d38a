//! The stiffness of a penalty element without friction in the form of the solver 4C, which assembles −K.
//!
//! The force on the beam is F_N N₁ᵀn, on the bar beam −F_N N₂ᵀn, N the matrices of the points. The stiffness is their derivative:
//! F_N changes by −k Δg_N, n by Δn, and N with the parameters of the closest points.
//!
//! Source: 4C-multiphysics/4C, `src/beamcontact/4C_beamcontact_beam3contact.cpp`, `evaluate_stiffc_contact`; C. Meier,
//! W. A. Wall, A. Popp, "A unified approach for beam-to-beam contact", 2017, doi:10.1016/j.cma.2016.11.028.

use super::DOFS;
use super::pairs::{NormalContact, RandomPair, Shapes};
use nalgebra::{DMatrix, Matrix2, Matrix3, RowSVector, SMatrix, Vector3};

const ALL: usize = 2 * DOFS;

/// The derivative of the contact forces on both beams over all dofs: −K.
pub(super) fn stiffness(pair: &RandomPair) -> DMatrix<f64> {
    let NormalContact { shapes: [x, y], f_n, k } = pair.normal_contact();
    let d = x.x - y.x;
    let (distance, n) = (d.norm(), d.normalize());
    // The variation of d at fixed parameters.
    let mut fixed = SMatrix::<f64, 3, ALL>::zeros();
    fixed.fixed_columns_mut::<DOFS>(0).copy_from(&x.n);
    fixed.fixed_columns_mut::<DOFS>(DOFS).copy_from(&-y.n);
    // d·t = 0 and d·t̄ = 0 hold before and after: the parameters follow from a system of two equations.
    let system = Matrix2::new(
        x.t.dot(&x.t) + d.dot(&x.t_xi),
        -x.t.dot(&y.t),
        x.t.dot(&y.t),
        -y.t.dot(&y.t) + d.dot(&y.t_xi),
    );
    let mut right = SMatrix::<f64, 2, ALL>::zeros();
    right.set_row(0, &-(x.t.transpose() * fixed + at(0, &d, &x)));
    right.set_row(1, &-(y.t.transpose() * fixed + at(DOFS, &d, &y)));
    let parameters = system.try_inverse().expect("the beams are not parallel") * right;
    let moving = fixed + x.t * parameters.row(0) - y.t * parameters.row(1);
    let gap = n.transpose() * moving;
    let normal = (Matrix3::identity() - n * n.transpose()) * moving / distance;
    let mut stiffness = DMatrix::zeros(ALL, ALL);
    for (row, beam, sign, of_parameter) in [(0, &x, 1.0, 0), (DOFS, &y, -1.0, 1)] {
        let force = beam.n.transpose() * n * gap * -k
            + beam.n.transpose() * normal * f_n
            + beam.n_xi.transpose() * n * parameters.row(of_parameter) * f_n;
        stiffness.rows_mut(row, DOFS).copy_from(&(force * sign));
    }
    stiffness
}

/// dᵀ times the variation of a tangent at fixed parameters, at the dofs of its beam.
fn at(first: usize, d: &Vector3<f64>, beam: &Shapes) -> RowSVector<f64, ALL> {
    let mut row = RowSVector::<f64, ALL>::zeros();
    row.fixed_columns_mut::<DOFS>(first).copy_from(&(d.transpose() * beam.n_xi));
    row
}
