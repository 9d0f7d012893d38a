//! Linearizations with running error bounds: the tolerances of the properties.

use crate::pairs::Contacting;
use beamgap::closest_point::Held;
use beamgap::curve::Curve;
use beamgap::linearization::closed_form::{Formulation, Matrices, Points, Projection, jets};
use beamgap::linearization::{Derivatives, Linearization};
use beamgap::number::RunningError;
use beamgap::pair::{DofVector, Pair};
use nalgebra::SVector;

pub(crate) fn exact<const N: usize>(q: &SVector<f64, N>) -> SVector<RunningError, N> {
    q.map(RunningError::from)
}

pub(crate) fn exact_dofs<const N: usize, const M: usize>(
    q: &DofVector<f64, N, M>,
) -> DofVector<RunningError, N, M> {
    DofVector { beam: exact(&q.beam), bar: exact(&q.bar) }
}

/// The parameters of the exact closest point near `at`, with bounds on their distance from it.
pub(crate) fn parameters<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<RunningError, N, M>,
    at: (f64, f64),
    held: Held,
) -> (RunningError, RunningError) {
    let (jet, jet_bar) = jets(pair, q, (at.0.into(), at.1.into()));
    let (x, x_bar) = (jet.geometry, jet_bar.geometry);
    let residual = [x.t, x_bar.t].map(|t| (x.x - x_bar.x).dot(&t)).map(|f| f.value.abs() + f.bound);
    let [step, step_bar] = Projection::new(&x, &x_bar, held)
        .inverse()
        .map(|row| 2.0 * row.into_iter().zip(residual).map(|(entry, f)| entry.value.abs() * f).sum::<f64>());
    (RunningError::new(at.0, step), RunningError::new(at.1, step_bar))
}

/// The linearization at the exact closest point near `at`; the dofs may have error bounds themselves.
pub(crate) fn linearized<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<RunningError, N, M>,
    near: (f64, f64),
    held: Held,
) -> Linearization<RunningError, N, M> {
    let values = DofVector { beam: q.beam.map(|q| q.value), bar: q.bar.map(|q| q.value) };
    let point = pair.refine(&values, near, held).expect("a stationary point");
    let at = parameters(pair, q, (point.xi, point.xi_bar), held);
    let (jet, jet_bar) = jets(pair, &values, (point.xi, point.xi_bar));
    let form = Formulation::at(&Points::new(&jet.geometry, &jet_bar.geometry), held);
    let (jet, jet_bar) = jets(pair, q, at);
    Matrices::in_formulation(&jet, &jet_bar, form).all(at, &pair.contact)
}

/// The linearization of a case.
pub(crate) fn linearized_case<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    Contacting { pair, q, point, .. }: &Contacting<A, B, N, M>,
) -> Linearization<RunningError, N, M> {
    linearized(pair, &exact_dofs(q), (point.xi, point.xi_bar), point.held())
}

/// The scalars: d, t, t_bar, xi, xi_bar, g_T and g_T_bar.
pub(crate) fn scalars<const N: usize, const M: usize>(
    l: &Linearization<RunningError, N, M>,
) -> [&Derivatives<RunningError, N, M>; 7] {
    [&l.d, &l.t, &l.t_bar, &l.xi, &l.xi_bar, &l.g_t, &l.g_t_bar]
}

/// Whether both intervals can contain the same number.
pub(crate) fn is_near(x: RunningError, y: RunningError) -> bool {
    (x.value - y.value).abs() <= x.bound + y.bound
}
