//! The numbers of a contact element along a pair of directions: right, and with errors.

use super::wrong::Wrong;
use crate::check::element::ElementAt;
use crate::closest_point::Held;
use crate::contact::{History, Law, NormalLaw, Piece, Slips, Start, State, Work};
use crate::linearization::{COMPONENTS, Quantity};
use crate::number::{Real, RunningError};
use nalgebra::Vector3;

enumeration! {
    /// A number of the formulas of a contact element. Bar twins follow.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub(in crate::check::external::stages) enum Kind {
        /// F_N.
        NormalForce => "F_N",
        /// k = -dF_N/dg_N.
        Stiffness => "k",
        /// f = eps_T rho.
        Factor => "eps_T rho",
        /// c, the cosine of the angle between the tangents.
        Cosine => "c",
        /// The changes of c along delta, as the tangent of the beam and that of the bar beam turn.
        DeltaOfBeam => "t_bar.dt/(|t| |t_bar|)",
        DeltaOfBar => "t.dt_bar/(|t| |t_bar|)",
        /// The same along Delta.
        LinearOfBeam => "t_bar.Dt/(|t| |t_bar|)",
        LinearOfBar => "t.Dt_bar/(|t| |t_bar|)",
        /// e.
        E => "e",
        EBar => "e_bar",
        /// l = e - c e_bar.
        L => "l",
        LBar => "l_bar",
        /// xi - xi_n.
        U => "(xi - xi_n)",
        UBar => "(xi_bar - xi_bar_n)",
        /// mu k/gamma in slip, else 0.
        OfForce => "mu k/gamma",
        /// f/gamma^2 in slip, else 0.
        OfGamma => "eps_T rho/gamma^2",
        /// 1, or -1 after crossing.
        Side => "sigma",
        /// 1, the factor of F_bar.
        BarSign => "1",
        /// 1 if the work has the variation of the slip, else 0.
        IsPaper => "work",
    }
}

/// The numbers of a contact element, by what is wrong.
#[derive(Clone, Debug)]
pub(in crate::check::external::stages) struct Friction {
    pub(in crate::check::external::stages) state: State,
    pub(in crate::check::external::stages) is_crossed: bool,
    tables: Vec<[RunningError; Kind::ALL.len()]>,
}

impl Friction {
    pub(super) fn new(
        element: &ElementAt,
        exact: &[[RunningError; 4]; COMPONENTS],
        radii: [f64; 2],
        last_tangents: Option<[Vector3<f64>; 2]>,
    ) -> Option<Self> {
        element.with(|decision| {
            let inputs = Inputs {
                law: decision.parameters.law,
                eps_t: decision.parameters.eps_t,
                mu: decision.parameters.mu,
                is_paper: decision.parameters.work == Work::Paper,
                piece: decision.piece,
                slips: decision.start.and(element.history().slips),
                state: decision.state,
                is_crossed: decision.is_crossed,
                held: decision.form.held,
                radii,
                last_tangents,
                exact,
            };
            Self {
                state: decision.state,
                is_crossed: decision.is_crossed,
                tables: Wrong::ALL.into_iter().map(|wrong| inputs.table(wrong)).collect(),
            }
        })
    }

    pub(in crate::check::external::stages) fn number(&self, wrong: Wrong, kind: Kind) -> RunningError {
        self.tables[wrong as usize][kind as usize]
    }
}

/// What the numbers are computed from.
struct Inputs<'a> {
    law: Law,
    eps_t: f64,
    mu: f64,
    is_paper: bool,
    piece: Option<Piece>,
    /// Those of the history, if friction is possible.
    slips: Option<Slips>,
    state: State,
    is_crossed: bool,
    held: Held,
    radii: [f64; 2],
    /// The unit tangents of the last converged step, if they are known.
    last_tangents: Option<[Vector3<f64>; 2]>,
    exact: &'a [[RunningError; 4]; COMPONENTS],
}

fn number(value: f64) -> RunningError {
    RunningError::from(value)
}

impl Inputs<'_> {
    fn value(&self, quantity: Quantity) -> RunningError {
        self.exact[quantity.component()][0]
    }

    /// A part of a vector.
    fn vector(&self, quantity: Quantity, part: usize) -> Vector3<RunningError> {
        Vector3::from_fn(|c, _| self.exact[quantity.component() + c][part])
    }

    /// F_N and k on a side of the bar beam.
    fn normal(&self, wrong: Wrong, side: f64) -> [RunningError; 2] {
        let zero = number(0.0);
        let radii = match wrong {
            Wrong::OneRadius => self.radii[0],
            Wrong::OtherRadius => self.radii[1],
            _ => self.radii[0] + self.radii[1],
        };
        let gap = number(side) * self.value(Quantity::D) - number(radii);
        let mut law = self.law;
        if let (Wrong::NoMultiplier, Law::Augmented { eps, .. }) = (wrong, law) {
            law = Law::Linear { eps };
        }
        let piece = match wrong {
            Wrong::ActsWhenOpen => self.piece.or(Some(Piece::Line)),
            _ => law.piece(gap.value),
        };
        let of_law = |f: &dyn Fn(Piece) -> RunningError| piece.map_or(zero, f);
        let mut force = of_law(&|piece| law.force(piece, gap));
        if let (Wrong::NoOffset, Some(Piece::Line), Law::Lpqp { eps, g_0 }) = (wrong, piece, law) {
            force -= number(0.5 * eps * g_0);
        }
        let stiffness = of_law(&|piece| law.stiffness(piece, gap));
        [force, stiffness]
    }

    /// The start of the slips; `now` is the cosine of the present tangents.
    fn start(&self, wrong: Wrong, now: f64) -> Option<Start> {
        let slips = self.slips?;
        let Slips { e, e_bar, .. } = slips;
        let slips = match wrong {
            Wrong::NoHistory => Slips { e: 0.0, e_bar: 0.0, ..slips },
            Wrong::NoE => Slips { e: 0.0, ..slips },
            Wrong::NoEBar => Slips { e_bar: 0.0, ..slips },
            Wrong::SignOfE => Slips { e: -e, ..slips },
            Wrong::SignOfEBar => Slips { e_bar: -e_bar, ..slips },
            Wrong::NoProjection => Slips { cosine: 0.0, ..slips },
            Wrong::SignOfProjection => Slips { cosine: -slips.cosine, ..slips },
            Wrong::CosineOfNow => Slips { cosine: now, ..slips },
            _ => slips,
        };
        History { normal: None, slips: Some(slips) }.start(self.held)
    }

    fn table(&self, wrong: Wrong) -> [RunningError; Kind::ALL.len()] {
        let zero = number(0.0);
        let [t, t_bar] = [Quantity::T, Quantity::TBar].map(|of| self.value(of));
        let tau = self.vector(Quantity::TVector, 0) / t;
        let tau_bar = self.vector(Quantity::TBarVector, 0) / t_bar;
        let cosine = tau.dot(&tau_bar);
        let of_beam = |part: usize| self.vector(Quantity::TVector, part).dot(&(tau_bar - tau * cosine)) / t;
        let of_bar =
            |part: usize| self.vector(Quantity::TBarVector, part).dot(&(tau - tau_bar * cosine)) / t_bar;
        let sign = match wrong {
            Wrong::Plus | Wrong::PlusInForce => -1.0,
            Wrong::Uncoupled => 0.0,
            _ => 1.0,
        };
        let [c, delta, delta_bar, linear, linear_bar] =
            [cosine, of_beam(1), of_bar(1), of_beam(2), of_bar(2)].map(|of| number(sign) * of);
        let side = if self.is_crossed && wrong != Wrong::NoSide { -1.0 } else { 1.0 };
        let [force, stiffness] = self.normal(wrong, side);
        let is_paper = self.is_paper != (wrong == Wrong::Work);
        let [length, length_bar] = match wrong {
            Wrong::OtherLength => [t_bar, t_bar],
            Wrong::OtherLengthOfBar => [t, t],
            Wrong::NoLength => [number(1.0); 2],
            _ => [t, t_bar],
        };
        let slip = |xi: Quantity, length: RunningError, start: f64, e: f64, is_held: bool| {
            let is_fixed = is_held || wrong == Wrong::NoStart;
            let u = if is_fixed { zero } else { self.value(xi) - number(start) };
            (u, number(e) + length * u)
        };
        let start = self.start(wrong, cosine.value).filter(|_| force.value > 0.0);
        let ((u, e), (u_bar, e_bar)) = start.map_or(((zero, zero), (zero, zero)), |start| {
            let Start { xi, xi_bar, e, e_bar } = start;
            (
                slip(Quantity::Xi, length, xi, e, self.held.xi),
                slip(Quantity::XiBar, length_bar, xi_bar, e_bar, self.held.xi_bar),
            )
        });
        let not_turned = self
            .last_tangents
            .filter(|_| wrong == Wrong::NotTurned && self.held == Held::default())
            .zip(start)
            .map(|([last, last_bar], Start { e: e_n, e_bar: e_bar_n, .. })| {
                let kept = (last * e_n - last_bar * e_bar_n).map(number);
                kept + tau * (e - number(e_n)) - tau_bar * (e_bar - number(e_bar_n))
            });
        let (e, e_bar) = not_turned.map_or((e, e_bar), |s| {
            let (l, l_bar, square) = (s.dot(&tau), -s.dot(&tau_bar), number(1.0) - c * c);
            ((l + c * l_bar) / square, (l_bar + c * l) / square)
        });
        let (l, l_bar) = (e - c * e_bar, e_bar - c * e);
        let gamma = match not_turned {
            Some(s) => s.dot(&s),
            None if wrong == Wrong::GammaUncoupled => e * e + e_bar * e_bar,
            None => e * l + e_bar * l_bar,
        }
        .sqrt();
        let has_friction = start.is_some();
        let slips = match wrong {
            Wrong::NoReturn => false,
            Wrong::Returned => has_friction,
            // A state that is within rounding of the other one is that of the right numbers.
            _ => {
                let excess = number(self.eps_t) * gamma - number(self.mu) * force;
                // At gamma = 0 the bound is not a number.
                let is_clear = excess.bound.is_nan() || excess.value.abs() > excess.bound;
                has_friction && if is_clear { excess.value > 0.0 } else { self.state == State::Slip }
            }
        };
        let mu = number(if wrong == Wrong::NoMu { 1.0 } else { self.mu });
        let (factor, of_force, of_gamma) = if slips {
            let factor = mu * force / gamma;
            (factor, mu * stiffness / gamma, factor / (gamma * gamma))
        } else {
            (number(if has_friction { self.eps_t } else { 0.0 }), zero, zero)
        };
        let is_paper = number(if is_paper { 1.0 } else { 0.0 });
        Kind::ALL.map(|kind| match kind {
            Kind::NormalForce => force,
            Kind::Stiffness => stiffness,
            Kind::Factor => factor,
            Kind::Cosine => c,
            Kind::DeltaOfBeam => delta,
            Kind::DeltaOfBar => delta_bar,
            Kind::LinearOfBeam => linear,
            Kind::LinearOfBar => linear_bar,
            Kind::E => e,
            Kind::EBar => e_bar,
            Kind::L => l,
            Kind::LBar => l_bar,
            Kind::U => u,
            Kind::UBar => u_bar,
            Kind::OfForce => of_force,
            Kind::OfGamma => of_gamma,
            Kind::Side => number(side),
            Kind::BarSign => number(if wrong == Wrong::PlusInForce { -1.0 } else { 1.0 }),
            Kind::IsPaper => is_paper,
        })
    }
}
