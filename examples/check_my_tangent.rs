//! The check of a tangent derived by hand: first the correct tangent, then the tangent with a missing term.
//!
//! `cargo run --release --example check_my_tangent`

use beamgap::check::{self, Answer, Family, Found, Situation};
use beamgap::linearization::Quantity;
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3xX, Vector2, Vector3};

/// A Hermite curve at xi: the point with its derivatives, and its Jacobians in all dofs of the pair.
struct Beam {
    x: Vector3<f64>,
    t: Vector3<f64>,
    t_xi: Vector3<f64>,
    jacobian: Matrix3xX<f64>,
    jacobian_xi: Matrix3xX<f64>,
}

impl Beam {
    /// `first` is the index of the beam's first dof among the `dofs` of the pair.
    fn new(q: &[f64], xi: f64, first: usize, dofs: usize) -> Self {
        let shapes = [
            [(2.0 - 3.0 * xi + xi.powi(3)) / 4.0, (3.0 * xi * xi - 3.0) / 4.0, 1.5 * xi],
            [(1.0 - xi - xi * xi + xi.powi(3)) / 4.0, (3.0 * xi * xi - 2.0 * xi - 1.0) / 4.0, 1.5 * xi - 0.5],
            [(2.0 + 3.0 * xi - xi.powi(3)) / 4.0, (3.0 - 3.0 * xi * xi) / 4.0, -1.5 * xi],
            [(xi.powi(3) + xi * xi - xi - 1.0) / 4.0, (3.0 * xi * xi + 2.0 * xi - 1.0) / 4.0, 1.5 * xi + 0.5],
        ];
        let sum = |k: usize| {
            let terms =
                shapes.iter().zip(q.chunks_exact(3)).map(|(n, q)| Vector3::from_column_slice(q) * n[k]);
            terms.sum::<Vector3<f64>>()
        };
        let jacobian = |k: usize| {
            let mut jacobian = Matrix3xX::zeros(dofs);
            for (a, n) in shapes.iter().enumerate() {
                for c in 0..3 {
                    jacobian[(c, first + 3 * a + c)] = n[k];
                }
            }
            jacobian
        };
        Self { x: sum(0), t: sum(1), t_xi: sum(2), jacobian: jacobian(0), jacobian_xi: jacobian(1) }
    }
}

/// The gap with gradient and Hessian, and the gradients of both parameters.
fn tangent(at: &Situation<'_>, forgets_curvature: bool) -> Vec<Answer> {
    let dofs = at.q.len() + at.q_bar.len();
    let (beam, bar) = (Beam::new(at.q, at.at.0, 0, dofs), Beam::new(at.q_bar, at.at.1, at.q.len(), dofs));
    let d = beam.x - bar.x;
    let gap = d.norm();
    let n = d / gap;
    let g = &beam.jacobian - &bar.jacobian;

    // The gradients of xi and xi_bar, from the variations of d . t = 0 and d . t_bar = 0; zero for a held parameter.
    let mut matrix = Matrix2::new(
        beam.t.dot(&beam.t) + d.dot(&beam.t_xi),
        -beam.t.dot(&bar.t),
        beam.t.dot(&bar.t),
        d.dot(&bar.t_xi) - bar.t.dot(&bar.t),
    );
    let mut right = [
        -(g.tr_mul(&beam.t) + beam.jacobian_xi.tr_mul(&d)),
        -(g.tr_mul(&bar.t) + bar.jacobian_xi.tr_mul(&d)),
    ];
    for (i, held) in [at.held.xi, at.held.xi_bar].into_iter().enumerate() {
        if held {
            matrix.set_row(i, &Vector2::ith(i, 1.0).transpose());
            right[i].fill(0.0);
        }
    }
    let Some(inverse) = matrix.try_inverse() else { return Vec::new() };
    let xi: DVector<f64> = &right[0] * inverse[(0, 0)] + &right[1] * inverse[(0, 1)];
    let xi_bar: DVector<f64> = &right[0] * inverse[(1, 0)] + &right[1] * inverse[(1, 1)];

    // The Hessian: (I - nn')/d contracted with the total change of d, plus n . Delta-delta d.
    let change = &g + beam.t * xi.transpose() - bar.t * xi_bar.transpose();
    let across = &change - n * change.tr_mul(&n).transpose();
    let mut hessian: DMatrix<f64> = change.tr_mul(&across) / gap;
    for (of, xi, sign) in [(&beam, &xi, 1.0), (&bar, &xi_bar, -1.0)] {
        let along = of.jacobian_xi.tr_mul(&n);
        let curvature = if forgets_curvature { 0.0 } else { n.dot(&of.t_xi) };
        hessian +=
            (xi * along.transpose() + &along * xi.transpose() + xi * xi.transpose() * curvature) * sign;
    }
    let numbers = |v: DVector<f64>| Some(v.as_slice().to_vec());
    vec![
        Answer {
            value: Some(gap),
            gradient: numbers(g.tr_mul(&n)),
            hessian: Some(hessian.as_slice().to_vec()),
            ..Answer::of(Quantity::D)
        },
        Answer { gradient: numbers(xi), ..Answer::of(Quantity::Xi) },
        Answer { gradient: numbers(xi_bar), ..Answer::of(Quantity::XiBar) },
    ]
}

/// The tangent in 200 pairs of beams of each regime.
fn check(forgets_curvature: bool) -> Found {
    let mine = |at: &Situation<'_>| tangent(at, forgets_curvature);
    check::linearization(&mine, [Family::Hermite; 2], 200)
}

fn main() {
    let right = check(false);
    println!("The tangent as it is\n{right}\n");
    assert!(right.agrees());
    let wrong = check(true);
    println!("The same without n . t,xi and n . t_bar,xi_bar in the Hessian\n{wrong}");
    assert!(!wrong.agrees());
}
