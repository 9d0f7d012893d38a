//! The contribution of a contact by penalty to residual and tangent, and tangents with a missing or wrong term.

use super::elastic::DOFS;
use crate::closest_point::{ClosestPoint, Held};
use crate::curve::{Geometry, Hermite, Jet, Shapes};
use crate::linearization::BlockHessian;
use crate::linearization::closed_form::{Matrices, jets};
use crate::number::{Faulty, Formula, Label, TermChange, with_terms};
use crate::pair::{DofVector, Pair};

/// How the tangent of the contact force is computed. The force itself is always correct.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tangent {
    /// The exact tangent.
    Exact,
    /// Without the terms d.t,xi and d.t_bar,xi_bar in the system for the parameters.
    NoCurvature,
    /// With the parameters of the closest point held: without the motion of the point along the beams.
    FrozenProjection,
    /// With b (g g_barᵀ + g_bar gᵀ) subtracted instead of added in the Hessian of d.
    WrongSign,
    /// With one term of the closed form multiplied by a factor.
    Term(Label, f64),
}

impl Tangent {
    /// The tangents that are compared.
    pub const ALL: [Self; 4] = [Self::Exact, Self::NoCurvature, Self::FrozenProjection, Self::WrongSign];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::NoCurvature => "without d.t,xi",
            Self::FrozenProjection => "frozen projection",
            Self::WrongSign => "one wrong sign",
            Self::Term(label, _) => label.term,
        }
    }

    /// The terms that have a factor.
    fn terms(self) -> Vec<(Label, f64)> {
        match self {
            Self::Exact | Self::FrozenProjection => Vec::new(),
            Self::NoCurvature => vec![
                (Label::of_beam(Formula::A, "d.t,xi"), 0.0),
                (Label::of_beam(Formula::ABar, "d.t_bar,xi"), 0.0),
            ],
            Self::WrongSign => vec![(Label::of_beam(Formula::HessianD, "b gg_bar'"), -1.0)],
            Self::Term(label, factor) => vec![(label, factor)],
        }
    }
}

/// The contribution of the contact to residual and tangent.
#[derive(Clone, Debug, PartialEq)]
pub struct Contribution {
    /// eps g_N ∇g_N.
    pub force: DofVector<f64, DOFS, DOFS>,
    /// eps (∇g_N ∇g_Nᵀ + g_N Hess g_N).
    pub stiffness: BlockHessian<f64, DOFS, DOFS>,
    /// g_N.
    pub gap: f64,
}

/// The contribution at a closest point: the gradient of the energy eps g_N²/2, and its Hessian or the replacement of it.
pub fn contact(
    pair: &Pair<Hermite, Hermite, DOFS, DOFS>,
    q: &DofVector<f64, DOFS, DOFS>,
    point: &ClosestPoint,
    penalty: f64,
    tangent: Tangent,
) -> Contribution {
    // mark: contact
    let (jet, jet_bar) = jets(pair, q, (point.xi, point.xi_bar));
    let d = Matrices::new(&jet, &jet_bar, point.held()).d();
    let gap = d.value - pair.contact.radius - pair.contact.radius_bar;
    let force = d.gradient.times(penalty * gap);
    let half = d.gradient.times(0.5 * penalty);
    let mut stiffness = BlockHessian::zeros();
    let hessian = hessian(tangent, &d.hessian, [&jet, &jet_bar], point.held());
    stiffness.set_sum(&[(penalty * gap, &hessian)], &[[&d.gradient, &half]]);
    // end: contact
    Contribution { force, stiffness, gap }
}

/// The Hessian of d by (40), or its replacement.
fn hessian(
    tangent: Tangent,
    exact: &BlockHessian<f64, DOFS, DOFS>,
    [jet, jet_bar]: [&Jet<f64, Shapes<f64, 4>>; 2],
    held: Held,
) -> BlockHessian<f64, DOFS, DOFS> {
    match tangent {
        Tangent::Exact => *exact,
        Tangent::FrozenProjection => Matrices::new(jet, jet_bar, Held { xi: true, xi_bar: true }).d().hessian,
        _ => {
            let [jet, jet_bar] = [jet, jet_bar].map(faulty);
            let changes = tangent.terms().into_iter();
            let changes = changes.map(|(label, factor)| (label, TermChange::Times(factor))).collect();
            let hessian: BlockHessian<Faulty<f64>, DOFS, DOFS> =
                with_terms(changes, || Matrices::new(&jet, &jet_bar, held).d()).hessian;
            let BlockHessian { beam, mixed, bar } = hessian;
            let plain = |Faulty(number): Faulty<f64>| number;
            BlockHessian { beam: beam.map(plain), mixed: mixed.map(plain), bar: bar.map(plain) }
        }
    }
}

/// The jet in numbers whose terms can have a factor.
fn faulty(jet: &Jet<f64, Shapes<f64, 4>>) -> Jet<Faulty<f64>, Shapes<Faulty<f64>, 4>> {
    let Geometry { x, t, t_xi, t_xixi } = jet.geometry;
    let [x, t, t_xi, t_xixi] = [x, t, t_xi, t_xixi].map(|v| v.map(Faulty));
    let derivatives = jet.dofs.derivatives.map(|row| row.map(Faulty));
    Jet { geometry: Geometry { x, t, t_xi, t_xixi }, dofs: Shapes { derivatives } }
}
