//! The tangent of the contact element as a sum of named terms, so that single terms can be left out.
//!
//! [`closed_form`](crate::contact::closed_form) adds up the same tangent for speed. Here each term is a matrix of its own. The
//! symbols are those of `docs/contact-element.md`.

use super::DOFS;
use crate::closest_point::Held;
use crate::contact::{Decision, NormalLaw, State, Work};
use crate::curve::{DofDerivatives, Jet};
use crate::linearization::closed_form::Matrices;
use crate::linearization::{BlockHessian, Derivatives, Linearization};
use crate::pair::DofVector;
use nalgebra::{DMatrix, DVector, Vector3};

enumeration! {
    /// A term of the tangent. Friction is all of K_T, and `Projection` and `Angle` are parts of other terms; the rest adds up
    /// to the tangent.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Term {
        /// k ∇g_N ∇g_Nᵀ.
        Penalty => "k grad g_N grad g_N'",
        /// −F_N Hess g_N.
        NormalHessian => "-F_N Hess g_N",
        /// The motion of the closest point along the beams, in −F_N Hess g_N.
        Projection => "motion of the closest point",
        /// K_T.
        Friction => "K_T, all of friction",
        /// A ∇Fᵀ + Ā ∇F̄ᵀ in stick.
        Elastic => "A grad F' in stick",
        /// μ F_N (A ∇mᵀ + Ā ∇m̄ᵀ) in slip: A ∇Fᵀ + Ā ∇F̄ᵀ at constant F_N.
        Direction => "mu F_N A grad m' in slip",
        /// The change of the angle between the tangents, ∇c, in these terms.
        Angle => "grad c in grad F",
        /// μ (m A + m̄ Ā) ∇F_Nᵀ in slip.
        Cone => "mu (m A + m_bar A_bar) grad F_N'",
        /// F g ∇tᵀ and its twin.
        Stretch => "F g grad t'",
        /// F t Hess ξ and its twin: second variations of the parameters.
        ParameterHessian => "F t Hess xi",
        /// F (u Hess t + ∇t gᵀ) and its twin, with [`Work::Paper`].
        PaperWork => "F (u Hess t + grad t g')",
    }
}

impl Term {
    /// The terms of an element with [`Work::Rate`].
    pub fn of_rate() -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(|&term| term != Self::PaperWork)
    }

    /// Whether it belongs to K_T.
    pub fn is_of_friction(self) -> bool {
        !matches!(self, Self::Penalty | Self::NormalHessian | Self::Projection)
    }

    /// Whether it is a part of another term.
    pub fn is_part(self) -> bool {
        matches!(self, Self::Projection | Self::Friction | Self::Angle)
    }
}

/// Which components of the friction force do work on the slips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Components {
    /// F = T·τ with the slip vector e τ − ē τ̄: the mechanics.
    Covariant,
    /// F along τ in T = F τ + F̄ τ̄ with the slip vector e τ + ē τ̄.
    Contravariant,
}

/// Which element and which tangent of it Newton's method uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tangent {
    /// The components of friction, in residual and tangent.
    pub components: Components,
    /// The term that the tangent lacks.
    pub left_out: Option<Term>,
    /// Whether friction is lagged, in the tangent only: [`Terms::lagged`].
    pub is_lagged: bool,
}

impl Tangent {
    /// The tangent of the element.
    pub const EXACT: Self = Self { components: Components::Covariant, left_out: None, is_lagged: false };
    /// The tangent with lagged friction.
    pub const LAGGED: Self = Self { is_lagged: true, ..Self::EXACT };
    /// The tangent of an element with [`Components::Contravariant`].
    pub const CONTRAVARIANT: Self = Self { components: Components::Contravariant, ..Self::EXACT };

    /// This tangent without one term.
    #[must_use]
    pub const fn without(self, term: Term) -> Self {
        Self { left_out: Some(term), ..self }
    }
}

/// Residual and tangent, term by term, over the dofs of both beams.
#[derive(Clone, Debug, PartialEq)]
pub struct Terms {
    /// R.
    pub residual: DVector<f64>,
    /// Its terms: −F_N ∇g_N, F A and F̄ Ā.
    pub forces: Vec<DVector<f64>>,
    /// The state, which depends on the components.
    pub state: State,
    /// The elastic slips after the return, lengths; 0 without friction.
    pub returned: [f64; 2],
    matrices: Vec<(Term, DMatrix<f64>)>,
    lagged: Option<DMatrix<f64>>,
}

impl Terms {
    /// The terms of a decided contact with a force, from the jets of both curves at its points.
    pub fn new<U, V, L>(
        decision: &Decision<'_, L>,
        (jet, jet_bar): (&Jet<f64, U>, &Jet<f64, V>),
        at: (f64, f64),
        components: Components,
    ) -> Self
    where
        U: DofDerivatives<f64, DOFS>,
        V: DofDerivatives<f64, DOFS>,
        L: NormalLaw,
    {
        let all = Matrices::in_formulation(jet, jet_bar, decision.form).all(at, &decision.contact);
        let Linearization { d, t, t_bar, xi, xi_bar, .. } = &all;
        let side = if decision.is_crossed { -1.0 } else { 1.0 };
        let law = &decision.parameters.law;
        let g_n = side * d.value - all.radii;
        let (f_n, k) =
            decision.piece.map_or((0.0, 0.0), |piece| (law.force(piece, g_n), law.stiffness(piece, g_n)));
        let n = vector(&d.gradient) * side;
        let curvature = dense(&d.hessian) * (-f_n * side);
        let both = Held { xi: true, xi_bar: true };
        let frozen = Matrices::<_, _, _, DOFS, DOFS>::new(jet, jet_bar, both).d();
        let projection = &curvature - dense(&frozen.hessian) * (-f_n * side);
        let mut matrices = vec![
            (Term::Penalty, &n * n.transpose() * k),
            (Term::NormalHessian, curvature),
            (Term::Projection, projection),
        ];
        let mut residual = &n * -f_n;
        let Some(start) = decision.start.filter(|_| decision.state.has_friction()) else {
            let (forces, state) = (vec![residual.clone()], decision.state);
            return Self { residual, forces, state, returned: [0.0; 2], matrices, lagged: None };
        };
        let mut forces = vec![residual.clone()];

        // e = eₙ + t u   ∇e = t g + u ∇t   ∇c = J_tᵀ(τ̄ − c τ)/t + J_t̄ᵀ(τ − c τ̄)/t̄
        let held = decision.form.held;
        let free = |held: bool| if held { 0.0 } else { 1.0 };
        let (x, y) = (&jet.geometry, &jet_bar.geometry);
        let (tau, tau_bar) = (x.t / t.value, y.t / t_bar.value);
        let c = tau.dot(&tau_bar);
        let (v, v_bar) = ((tau_bar - tau * c) / t.value, (tau - tau_bar * c) / t_bar.value);
        let beam = Side::new(t, xi, start.xi, start.e, free(held.xi));
        let bar = Side::new(t_bar, xi_bar, start.xi_bar, start.e_bar, free(held.xi_bar));
        let with = |v: &Vector3<f64>, v_bar: &Vector3<f64>| {
            vector(&DofVector { beam: jet.dofs.gradient(1, v), bar: jet_bar.dofs.gradient(1, v_bar) })
        };
        let grad_c = with(&v, &v_bar) + &beam.g * v.dot(&x.t_xi) + &bar.g * v_bar.dot(&y.t_xi);

        // γ² = e² + ē² ∓ 2 c e ē   F = ε_T ρ l
        let sign = if components == Components::Covariant { -1.0 } else { 1.0 };
        let (e, e_bar) = (beam.e, bar.e);
        let gamma = (e * e + e_bar * e_bar + 2.0 * sign * c * e * e_bar).sqrt();
        let along = [e + sign * c * e_bar, e_bar + sign * c * e];
        let (eps_t, mu) = (decision.parameters.eps_t, decision.parameters.mu);
        let state = match components {
            Components::Covariant => decision.state,
            Components::Contravariant if eps_t * gamma > mu * f_n * (1.0 - ON_CONE) => State::Slip,
            Components::Contravariant => State::Stick,
        };
        let slips = state == State::Slip;
        let rho = if slips { mu * f_n / (eps_t * gamma) } else { 1.0 };
        let sides = [&beam, &bar];
        let l = match components {
            Components::Covariant => [along[0] * beam.free, along[1] * bar.free],
            Components::Contravariant => [e * beam.free, e_bar * bar.free],
        };
        // ∇F = ε_T ρ (∇l − l ∇γ/γ) in slip, at constant F_N. It is linear in ∇e, ∇ē and ∇c.
        let grad_f = |grad_e: [&DVector<f64>; 2], grad_c: &DVector<f64>| {
            let grad_gamma =
                (grad_e[0] * along[0] + grad_e[1] * along[1] + grad_c * (sign * e * e_bar)) / gamma;
            [(0, e_bar), (1, e)].map(|(i, other)| {
                let grad_l = match components {
                    Components::Covariant => grad_e[i] - grad_e[1 - i] * c - grad_c * other,
                    Components::Contravariant => grad_e[i].clone(),
                };
                let back = if slips { &grad_gamma * (l[i] / gamma) } else { grad_c * 0.0 };
                (grad_l * sides[i].free - back) * (eps_t * rho)
            })
        };
        let zero = DVector::zeros(2 * DOFS);
        let rates = sides.map(|side| &side.g * side.t);
        let gradients = grad_f([&beam.grad_e, &bar.grad_e], &grad_c);
        let of_angle = grad_f([&zero, &zero], &grad_c);
        let at_lagged_tangents = grad_f([&rates[0], &rates[1]], &zero);
        let [mut direction, mut angle, mut cone, mut stretch, mut hessian, mut paper, mut lagged] =
            std::array::from_fn(|_| DMatrix::zeros(2 * DOFS, 2 * DOFS));
        for (i, side) in sides.into_iter().enumerate() {
            let f = eps_t * rho * l[i];
            let mut a = rates[i].clone();
            if decision.parameters.work == Work::Paper {
                a += &side.grad_t * side.u;
                paper += (dense(side.hess_t) * side.u + &side.grad_t * side.g.transpose()) * f;
            }
            forces.push(&a * f);
            residual += &a * f;
            direction += &a * gradients[i].transpose();
            angle += &a * of_angle[i].transpose();
            lagged += &rates[i] * at_lagged_tangents[i].transpose();
            if slips {
                // ∇F_N = −k ∇g_N
                cone += &a * n.transpose() * (-k * f / f_n);
            }
            stretch += &side.g * side.grad_t.transpose() * f;
            hessian += dense(side.hess_xi) * (f * side.t);
        }
        let friction = &direction + &cone + &stretch + &hessian + &paper;
        matrices.extend([
            (Term::Friction, friction),
            (if slips { Term::Direction } else { Term::Elastic }, direction),
            (Term::Angle, angle),
            (Term::Cone, cone),
            (Term::Stretch, stretch),
            (Term::ParameterHessian, hessian),
            (Term::PaperWork, paper),
        ]);
        Self { residual, forces, state, returned: [rho * e, rho * e_bar], matrices, lagged: Some(lagged) }
    }

    /// K, the sum of the terms.
    pub fn tangent(&self) -> DMatrix<f64> {
        let whole = self.matrices.iter().filter(|(term, _)| !term.is_part());
        whole.fold(DMatrix::zeros(2 * DOFS, 2 * DOFS), |sum, (_, matrix)| sum + matrix)
    }

    /// One term; nothing if this state does not have it.
    pub fn term(&self, term: Term) -> Option<&DMatrix<f64>> {
        self.matrices.iter().find(|(name, _)| *name == term).map(|(_, matrix)| matrix)
    }

    /// K with lagged friction: the derivative of R with F_N, A, Ā and the tangents of the beams constant in R_T. It is symmetric.
    pub fn lagged(&self) -> DMatrix<f64> {
        let normal = [Term::Penalty, Term::NormalHessian].into_iter().filter_map(|term| self.term(term));
        normal.chain(&self.lagged).fold(DMatrix::zeros(2 * DOFS, 2 * DOFS), |sum, matrix| sum + matrix)
    }

    /// K without one term.
    pub fn without(&self, term: Term) -> DMatrix<f64> {
        let all = self.tangent();
        self.term(term).map_or_else(|| all.clone(), |matrix| &all - matrix)
    }
}

/// Phi/(mu F_N) within which a trial force counts as on the cone: it slips on.
const ON_CONE: f64 = 1e-9;

/// What friction uses of one beam.
struct Side<'a> {
    t: f64,
    u: f64,
    e: f64,
    /// 1, or 0 if the parameter is held.
    free: f64,
    g: DVector<f64>,
    grad_t: DVector<f64>,
    grad_e: DVector<f64>,
    hess_t: &'a BlockHessian<f64, DOFS, DOFS>,
    hess_xi: &'a BlockHessian<f64, DOFS, DOFS>,
}

impl<'a> Side<'a> {
    fn new(
        t: &'a Derivatives<f64, DOFS, DOFS>,
        xi: &'a Derivatives<f64, DOFS, DOFS>,
        start: f64,
        e: f64,
        free: f64,
    ) -> Self {
        let u = (xi.value - start) * free;
        let (g, grad_t) = (vector(&xi.gradient), vector(&t.gradient));
        let grad_e = &g * t.value + &grad_t * u;
        let (hess_t, hess_xi) = (&t.hessian, &xi.hessian);
        Self { t: t.value, u, e: e + t.value * u, free, g, grad_t, grad_e, hess_t, hess_xi }
    }
}

fn vector(of: &DofVector<f64, DOFS, DOFS>) -> DVector<f64> {
    DVector::from_fn(2 * DOFS, |i, _| of.entry(i))
}

fn dense(of: &BlockHessian<f64, DOFS, DOFS>) -> DMatrix<f64> {
    DMatrix::from_fn(2 * DOFS, 2 * DOFS, |i, j| of.entry(i, j))
}
