//! The unsymmetry of the tangent is exactly the predicted one.

use super::beams::{Case, HELD, LAWS, Movable, STATES, Wish, numbers};
use crate::contact::{BlockMatrix, State, Work};
use crate::curve::{Arc, Bezier, Hermite};
use crate::linearization::closed_form::{Matrices, VectorQuantity, jets};
use crate::pair::{Contact, DofVector};
use nalgebra::Vector3;

/// Adds factor (a bᵀ − b aᵀ).
fn add_wedge<const N: usize, const M: usize>(
    to: &mut BlockMatrix<f64, N, M>,
    factor: f64,
    a: &DofVector<f64, N, M>,
    b: &DofVector<f64, N, M>,
) {
    for i in 0..N + M {
        for j in 0..N + M {
            let wedge = a.entry(i) * b.entry(j) - b.entry(i) * a.entry(j);
            to.set(i, j, to.entry(i, j) + factor * wedge);
        }
    }
}

/// The largest entry.
fn size<const N: usize, const M: usize>(matrix: &BlockMatrix<f64, N, M>) -> f64 {
    matrix.to_dense().iter().fold(0.0, |size, entry| size.max(entry.abs()))
}

/// K − Kᵀ less its prediction, and K − Kᵀ, both relative to K.
fn unsymmetry<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(
    curve: A,
    curve_bar: B,
    wish: Wish,
    seed: u32,
) -> [f64; 2] {
    let case: Case<A, B, f64, N, M> = Case::new(curve, curve_bar, wish, numbers(seed));
    let decision = case.decision();
    let (to, values) = case.closed(&decision);
    let (k, transposed) = (to.tangent, to.tangent.transposed());
    let mut rest = BlockMatrix::<f64, N, M>::zeros();
    for i in 0..N + M {
        for j in 0..N + M {
            rest.set(i, j, k.entry(i, j) - transposed.entry(i, j));
        }
    }
    let found = size(&rest) / size(&k);
    if decision.state.has_friction() {
        let start = decision.start.unwrap();
        let [xi_n, xi_bar_n] =
            [(wish.held.xi, case.at.0, start.xi), (wish.held.xi_bar, case.at.1, start.xi_bar)]
                .map(|(held, at, start)| if held { at } else { start });
        let contact = Contact { xi_0: xi_n, xi_bar_0: xi_bar_n, ..case.pair.contact };
        let (jet, jet_bar) = jets(&case.pair, &case.q, case.at);
        let matrices = Matrices::in_formulation(&jet, &jet_bar, decision.form);
        let all = matrices.all(case.at, &contact);
        let of = |quantity, w: Vector3<f64>| matrices.vector(quantity, &w, [&all.xi, &all.xi_bar]).gradient;
        let (t, t_bar) = (all.t.value, all.t_bar.value);
        let (tau, tau_bar) = (jet.geometry.t / t, jet_bar.geometry.t / t_bar);
        let c = tau.dot(&tau_bar);
        let grad_c = of(VectorQuantity::T, (tau_bar - tau * c) / t)
            .plus(1.0, &of(VectorQuantity::TBar, (tau - tau_bar * c) / t_bar));
        let (u, u_bar) = (case.at.0 - xi_n, case.at.1 - xi_bar_n);
        let (e, e_bar) = (start.e + all.g_t.value, start.e_bar + all.g_t_bar.value);
        let (g, g_bar) = (&all.xi.gradient, &all.xi_bar.gradient);
        let (grad_t, grad_t_bar) = (&all.t.gradient, &all.t_bar.gradient);
        let (grad_e, grad_e_bar) = (&all.g_t.gradient, &all.g_t_bar.gradient);
        let is_paper = wish.parameters.work == Work::Paper;
        let (a, a_bar) = if is_paper { (*grad_e, *grad_e_bar) } else { (g.times(t), g_bar.times(t_bar)) };
        let force = wish.parameters.eps_t * values.rho;
        // −ε_T (ē A + e Ā) ∧ ∇c
        add_wedge(&mut rest, force, &a.times(e_bar).plus(e, &a_bar), &grad_c);
        if !is_paper {
            // F g ∧ ∇t + F̄ ḡ ∧ ∇t̄ + ε_T [u t g ∧ ∇t + ū t̄ ḡ ∧ ∇t̄ + c (u ∇t ∧ ∇ē + ū ∇t̄ ∧ ∇e)]
            add_wedge(&mut rest, -values.f - force * u * t, g, grad_t);
            add_wedge(&mut rest, -values.f_bar - force * u_bar * t_bar, g_bar, grad_t_bar);
            add_wedge(&mut rest, -force * c * u, grad_t, grad_e_bar);
            add_wedge(&mut rest, -force * c * u_bar, grad_t_bar, grad_e);
        }
        if decision.state == State::Slip {
            // μ (m A + m̄ Ā) ∧ ∇F_N − ε_T ρ (m A + m̄ Ā) ∧ ∇γ
            let gamma = (e * e + e_bar * e_bar - 2.0 * c * e * e_bar).sqrt();
            let (l, l_bar) = (e - c * e_bar, e_bar - c * e);
            let m = a.times(l / gamma).plus(l_bar / gamma, &a_bar);
            let stiffness = crate::contact::NormalLaw::stiffness(
                &wish.parameters.law,
                decision.piece.unwrap(),
                values.g_n,
            );
            let side = if decision.is_crossed { -1.0 } else { 1.0 };
            add_wedge(&mut rest, wish.parameters.mu * stiffness * side, &m, &all.d.gradient);
            let grad_gamma =
                grad_e.times(l).plus(l_bar, grad_e_bar).plus(-e * e_bar, &grad_c).times(1.0 / gamma);
            add_wedge(&mut rest, force, &m, &grad_gamma);
        }
    }
    [size(&rest) / size(&k), found]
}

fn check<A: Movable<N>, B: Movable<M>, const N: usize, const M: usize>(curve: A, curve_bar: B) {
    for held in HELD {
        for state in &STATES[1..] {
            for work in [Work::Rate, Work::Paper] {
                for seed in 0..8 {
                    let mut wish = Wish::new(held, *state, LAWS[seed as usize % 3]);
                    wish.parameters.work = work;
                    wish.distance *= if seed % 4 == 3 { -0.25 } else { 1.0 };
                    let [rest, found] = unsymmetry(curve, curve_bar, wish, seed);
                    assert!(rest < 1e-13, "{rest:e}, {wish:?}");
                    let is_free = !held.xi && !held.xi_bar;
                    let symmetric = *state == State::Frictionless || held.xi && held.xi_bar;
                    assert!(!symmetric || found < 1e-14, "{found:e}, {wish:?}");
                    assert!(*state != State::Slip || !is_free || found > 1e-4, "{found:e}, {wish:?}");
                }
            }
        }
    }
}

#[test]
fn the_unsymmetry_is_the_predicted_one() {
    check(Hermite::new(), Hermite::new());
    check(Bezier::<4>::new(), Arc::new(0.7));
}
