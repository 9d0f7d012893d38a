//! Residual and tangent by automatic differentiation of the virtual work.
//!
//! The residual along δ is the virtual work −F_N δg_N + T·(t δξ − t̄ δξ̄), evaluated in hyper-dual numbers: positions, the
//! closest point lifted by Newton steps, the definitions of gap and slip, and the return of the trial force as a vector. Its
//! derivative along Δ is the tangent. No formula of [`closed_form`](super::closed_form) is used.

use super::{BlockMatrix, Decision, NormalLaw, State, Work};
use crate::curve::Curve;
use crate::linearization::Quantities;
use crate::linearization::ad::{Chord, Perturbed, PositionAt, evaluate};
use crate::linearization::closed_form::formulation::Distance;
use crate::number::{Differentiable, Dual, Extends, HyperDual, Real};
use crate::pair::{DofVector, Pair};
use nalgebra::{SVector, Vector3};

/// R and K of a decided contact at its closest point.
pub fn residual_and_tangent<T, A, B, L, const N: usize, const M: usize>(
    decision: &Decision<'_, L>,
    pair: &Pair<A, B, N, M>,
    q: &DofVector<T, N, M>,
    at: (T, T),
) -> (DofVector<T, N, M>, BlockMatrix<T, N, M>)
where
    T: Differentiable,
    T::Dual: Differentiable,
    <T::Dual as Differentiable>::Dual: Extends<T>,
    A: Curve<N>,
    B: Curve<M>,
    L: NormalLaw,
{
    let (mut residual, mut tangent) = (DofVector::zeros(), BlockMatrix::zeros());
    let Pair { curve, curve_bar, .. } = pair;
    let (beam, bar) = (Perturbed { curve, q: q.beam }, Perturbed { curve: curve_bar, q: q.bar });
    let chord = Chord::new(&beam, &bar, at, decision.form.held);
    for i in 0..N + M {
        for j in 0..N + M {
            let (delta, linear) = (DofVector::unit(i), DofVector::unit(j));
            let beam = Perturbed { curve, q: seeded(&q.beam, &delta.beam, &linear.beam) };
            let bar = Perturbed { curve: curve_bar, q: seeded(&q.bar, &delta.bar, &linear.bar) };
            let Dual { re, eps } = lifted_work(decision, &chord, &beam, &bar, at);
            residual.set(i, re);
            tangent.set(i, j, eps);
        }
    }
    (residual, tangent)
}

/// q + eps1 dq + eps2 Dq.
fn seeded<T: Real, const N: usize>(
    q: &SVector<T, N>,
    dq: &SVector<T, N>,
    linear_dq: &SVector<T, N>,
) -> SVector<HyperDual<T>, N> {
    SVector::from_fn(|i, _| HyperDual::new(q[i], dq[i], linear_dq[i], T::zero()))
}

/// The virtual work and its linearization of perturbed beams. Compiled once for each scalar.
fn lifted_work<T, L>(
    decision: &Decision<'_, L>,
    chord: &Chord<T>,
    beam: &dyn PositionAt<Dual<HyperDual<T>>>,
    bar: &dyn PositionAt<Dual<HyperDual<T>>>,
    at: (T, T),
) -> Dual<T>
where
    T: Differentiable,
    T::Dual: Differentiable,
    L: NormalLaw,
{
    let parameters = chord.lift::<HyperDual<T>, _, _>(beam, bar, at, 2);
    virtual_work(decision, &evaluate::<HyperDual<T>>(beam, bar, parameters, &decision.contact))
}

/// A quantity without its variation δ, and the variation δ; both with their linearization.
fn value<T: Real>(x: HyperDual<T>) -> Dual<T> {
    Dual::new(x.re, x.eps2)
}

fn variation<T: Real>(x: HyperDual<T>) -> Dual<T> {
    Dual::new(x.eps1, x.eps1eps2)
}

/// The forces of a contact and the slips, with their linearization.
struct Forces<T> {
    g_n: HyperDual<T>,
    f_n: Dual<T>,
    friction: Option<Friction<T>>,
}

struct Friction<T> {
    /// T, the friction force on the beam.
    traction: Vector3<Dual<T>>,
    tau: Vector3<Dual<T>>,
    tau_bar: Vector3<Dual<T>>,
    g_t: HyperDual<T>,
    g_t_bar: HyperDual<T>,
    /// ε_T γ, the length of the trial force.
    #[cfg(feature = "check")]
    trial: Dual<T>,
    /// ε_T ρ e and ε_T ρ ē: the traction is the first times τ less the second times τ̄.
    #[cfg(feature = "check")]
    contravariant: [Dual<T>; 2],
}

/// The forces; nothing if the contact is open.
fn forces<T: Real, L: NormalLaw>(
    decision: &Decision<'_, L>,
    quantities: &Quantities<HyperDual<T>>,
) -> Option<Forces<T>> {
    let (piece, start) = decision.acting()?;
    let Decision { parameters, form, state, .. } = decision;
    let g_n = gap(decision, quantities);
    let f_n = force(&parameters.law, piece, value(g_n));
    let Some(start) = start else { return Some(Forces { g_n, f_n, friction: None }) };
    let Quantities { t_vector, t_bar_vector, t, t_bar, xi, xi_bar, .. } = *quantities;
    // Eq. (15): g_T = t (ξ − ξₙ); a held parameter does not slip.
    let slip = |t: HyperDual<T>, xi: HyperDual<T>, start: f64, held: bool| {
        if held { HyperDual::from(0.0) } else { t * (xi - HyperDual::from(start)) }
    };
    let (g_t, g_t_bar) =
        (slip(t, xi, start.xi, form.held.xi), slip(t_bar, xi_bar, start.xi_bar, form.held.xi_bar));
    let tau = t_vector.map(value) / value(t);
    let tau_bar = t_bar_vector.map(value) / value(t_bar);
    let (e, e_bar) = (value(g_t) + Dual::from(start.e), value(g_t_bar) + Dual::from(start.e_bar));
    let force = (tau * e - tau_bar * e_bar) * Dual::from(parameters.eps_t);
    let trial = force.dot(&force).sqrt();
    let rho = match state {
        State::Slip => Dual::from(parameters.mu) * f_n / trial,
        _ => Dual::from(1.0),
    };
    let traction = if *state == State::Slip { force * rho } else { force };
    let friction = Friction {
        traction,
        tau,
        tau_bar,
        g_t,
        g_t_bar,
        #[cfg(feature = "check")]
        trial,
        #[cfg(feature = "check")]
        contravariant: [e, e_bar].map(|e| e * Dual::from(parameters.eps_t) * rho),
    };
    Some(Forces { g_n, f_n, friction: Some(friction) })
}

/// −F_N δg_N plus the virtual work of friction.
pub(crate) fn virtual_work<T: Real, L: NormalLaw>(
    decision: &Decision<'_, L>,
    quantities: &Quantities<HyperDual<T>>,
) -> Dual<T> {
    let Some(Forces { g_n, f_n, friction }) = forces(decision, quantities) else { return Dual::from(0.0) };
    let normal = -f_n * variation(g_n);
    let Some(Friction { traction, tau, tau_bar, g_t, g_t_bar, .. }) = friction else { return normal };
    let Quantities { t_vector, t_bar_vector, xi, xi_bar, .. } = *quantities;
    normal
        + match decision.parameters.work {
            Work::Rate => {
                let moved: Vector3<Dual<T>> =
                    t_vector.map(value) * variation(xi) - t_bar_vector.map(value) * variation(xi_bar);
                traction.dot(&moved)
            }
            Work::Paper => traction.dot(&tau) * variation(g_t) - traction.dot(&tau_bar) * variation(g_t_bar),
        }
}

/// The forces of a contact element as values. They are 0 where there is no friction.
#[cfg(feature = "check")]
pub(crate) struct ForceValues<T> {
    /// F_N.
    pub(crate) f_n: T,
    /// F = T·τ and F̄ = −T·τ̄; 0 for a held parameter.
    pub(crate) covariant: [T; 2],
    /// ε_T ρ e and ε_T ρ ē.
    pub(crate) contravariant: [T; 2],
    /// Φ = ε_T γ − μ F_N.
    pub(crate) excess: T,
}

/// The forces, from the components of the quantities.
#[cfg(feature = "check")]
pub(crate) fn force_values<T: Real, L: NormalLaw>(
    decision: &Decision<'_, L>,
    quantities: &Quantities<HyperDual<T>>,
) -> ForceValues<T> {
    let zero = T::zero();
    let found = forces(decision, quantities);
    let f_n = found.as_ref().map_or(zero, |forces| forces.f_n.re);
    let nothing = [zero; 2];
    let without_friction = ForceValues { f_n, covariant: nothing, contravariant: nothing, excess: zero };
    let Some(Forces { f_n, friction: Some(friction), .. }) = found else { return without_friction };
    let Friction { traction, tau, tau_bar, trial, contravariant, .. } = friction;
    let held = decision.form.held;
    let along = |is_held: bool, force: Dual<T>| if is_held { zero } else { force.re };
    ForceValues {
        covariant: [along(held.xi, traction.dot(&tau)), along(held.xi_bar, -traction.dot(&tau_bar))],
        contravariant: contravariant.map(|force| force.re),
        excess: (trial - Dual::from(decision.parameters.mu) * f_n).re,
        ..without_friction
    }
}

/// g_N, along d or along the common normal of the tangents.
fn gap<T: Real, L: NormalLaw>(
    decision: &Decision<'_, L>,
    quantities: &Quantities<HyperDual<T>>,
) -> HyperDual<T> {
    let Quantities { d_vector, t_vector, t_bar_vector, d, .. } = quantities;
    let held = decision.form.held;
    let distance = match decision.form.distance {
        Distance::Normal { reversed } if !held.xi && !held.xi_bar => {
            let c = t_vector.cross(t_bar_vector);
            let distance = d_vector.dot(&c) / c.dot(&c).sqrt();
            if reversed { -distance } else { distance }
        }
        _ => *d,
    };
    let distance = if decision.is_crossed { -distance } else { distance };
    distance - HyperDual::from(decision.contact.radius) - HyperDual::from(decision.contact.radius_bar)
}

/// F_N = −dE/dg_N, or F_N of a law without energy.
fn force<T: Real, L: NormalLaw>(law: &L, piece: L::Piece, g_n: T) -> T {
    law.energy(piece, Dual::new(g_n, T::one())).map_or_else(|| law.force(piece, g_n), |energy| -energy.eps)
}
