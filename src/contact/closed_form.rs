//! Residual and tangent in closed form, over any scalar and for every curve.
//!
//! The formulas are in `docs/contact-element.md`. Gradients and Hessians of the geometry are those of
//! [`Matrices`]. "row" is the dof of the residual.

mod assemble;
mod contribution;
mod forces;

use super::geometry::Trial;
use super::{Decision, NormalLaw, Values};
use crate::curve::{DofDerivatives, Jet};
use crate::linearization::Derivatives;
use crate::linearization::closed_form::kernel::{self, DistanceAlone, WithoutSlips};
use crate::linearization::closed_form::{Matrices, Points};
use crate::number::Real;
use crate::pair::{Contact, DofVector};
use assemble::assemble;
pub(super) use assemble::set_sum;
pub use contribution::Contribution;
pub(super) use contribution::Kinematics;
pub(super) use forces::Forces;
use nalgebra::Vector3;

/// Writes residual and tangent at contact points, from the jets of both curves there.
pub fn write<T, U, V, L, const N: usize, const M: usize>(
    decision: &Decision<'_, L>,
    jets: (&Jet<T, U>, &Jet<T, V>),
    at: (T, T),
    to: &mut Contribution<T, N, M>,
) -> Values<T>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
    L: NormalLaw,
{
    write_with(decision, jets, at, to, |_, _| false)
}

/// [`write`] with the kernel, as far as it applies to the curves.
pub(crate) fn write_by_kernel<U, V, L, const N: usize, const M: usize>(
    decision: &Decision<'_, L>,
    jets: (&Jet<f64, U>, &Jet<f64, V>),
    q: &DofVector<f64, N, M>,
    at: (f64, f64),
    to: &mut Contribution<f64, N, M>,
) -> Values<f64>
where
    U: DofDerivatives<f64, N>,
    V: DofDerivatives<f64, M>,
    L: NormalLaw,
{
    // The slips of the pair are not requested, so its reference parameters are not used.
    let unused = &Contact::default();
    write_with(decision, jets, at, to, |has_friction, [d, t, t_bar, xi, xi_bar]| {
        if has_friction {
            let request = &mut WithoutSlips { d, xi, xi_bar, t, t_bar };
            kernel::write_of_jets(jets, q, at, decision.form, unused, request)
        } else {
            kernel::write_of_jets(jets, q, at, decision.form, unused, &mut DistanceAlone { d })
        }
    })
}

/// Writes residual and tangent. `written` may write the geometry, with friction or without it, and tells whether it did.
fn write_with<T, U, V, L, const N: usize, const M: usize>(
    decision: &Decision<'_, L>,
    (jet, jet_bar): (&Jet<T, U>, &Jet<T, V>),
    at: (T, T),
    to: &mut Contribution<T, N, M>,
    written: impl FnOnce(bool, [&mut Derivatives<T, N, M>; 5]) -> bool,
) -> Values<T>
where
    T: Real,
    U: DofDerivatives<T, N>,
    V: DofDerivatives<T, M>,
    L: NormalLaw,
{
    let points = Points::new(&jet.geometry, &jet_bar.geometry);
    let gap = decision.gap(&points);
    let Some((piece, start)) = decision.acting() else {
        to.set_zero();
        return Values::open(&gap);
    };
    let Kinematics { d, t, t_bar, xi, xi_bar } = &mut to.kinematics;
    if !written(start.is_some(), [d, t, t_bar, xi, xi_bar]) {
        let matrices = Matrices::in_formulation(jet, jet_bar, decision.form);
        if start.is_some() {
            matrices.write_without_slips(at, [d, t, t_bar, xi, xi_bar]);
        } else {
            matrices.write_d(d);
        }
    }
    let trial = start.map(|start| Trial::new(&points, at, decision.form.held, &start));
    let forces = Forces::new(decision, piece, &gap, trial.as_ref());
    let gradients = |w: &Vector3<T>, w_bar: &Vector3<T>| DofVector {
        beam: jet.dofs.gradient(1, w),
        bar: jet_bar.dofs.gradient(1, w_bar),
    };
    assemble(decision, &forces, trial.as_ref(), &points, gradients, to);
    forces.values(&gap, trial.as_ref())
}
