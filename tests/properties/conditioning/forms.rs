//! Errors of the Hessians in `f64`, by formulation.

use super::{INSIDE, ROBUST};
use beamgap::curve::Curve;
use beamgap::linearization::closed_form::{Formulation, Matrices, Points, Projection, jets};
use beamgap::linearization::{BlockHessian, Linearization};
use beamgap::number::{DoubleDouble, Real};
use beamgap::pair::{DofVector, Pair};

/// A pair of beams.
pub(super) type Beams<A, B, const N: usize, const M: usize> = (Pair<A, B, N, M>, DofVector<f64, N, M>);

/// All quantities over the scalar `T`.
pub(super) fn all<T: Real, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    (pair, q): &Beams<A, B, N, M>,
    at: (T, T),
    form: impl FnOnce(&Points<T>) -> Formulation,
) -> Linearization<T, N, M> {
    let q = DofVector { beam: q.beam.map(T::from), bar: q.bar.map(T::from) };
    let (jet, jet_bar) = jets(pair, &q, at);
    let form = form(&Points::new(&jet.geometry, &jet_bar.geometry));
    Matrices::in_formulation(&jet, &jet_bar, form).all(at, &pair.contact)
}

/// The closest point in double-double, by Newton's method.
pub(super) fn precise<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    (pair, q): &Beams<A, B, N, M>,
    (xi, xi_bar): (f64, f64),
) -> (DoubleDouble, DoubleDouble) {
    let q = DofVector { beam: q.beam.map(DoubleDouble::from), bar: q.bar.map(DoubleDouble::from) };
    let mut at = (DoubleDouble::from(xi), DoubleDouble::from(xi_bar));
    for _ in 0..5 {
        let (jet, jet_bar) = jets(pair, &q, at);
        let Points { beam, bar, d } = Points::new(&jet.geometry, &jet_bar.geometry);
        let (step, step_bar) = Projection::new(&beam, &bar, INSIDE).solve(-d.dot(&beam.t), -d.dot(&bar.t));
        at = (at.0 + step, at.1 + step_bar);
    }
    at
}

/// The difference of two matrices divided by the size of the second, both in the Frobenius norm.
pub(super) fn error<const N: usize, const M: usize>(
    of: &BlockHessian<f64, N, M>,
    exact: &BlockHessian<DoubleDouble, N, M>,
) -> f64 {
    let entries = (0..N + M).flat_map(|i| (0..N + M).map(move |j| (i, j)));
    let (off, size) = entries.fold((0.0, 0.0), |(off, size), (i, j)| {
        let exact = exact.entry(i, j);
        let difference = (DoubleDouble::from(of.entry(i, j)) - exact).value();
        (off + difference * difference, size + exact.value() * exact.value())
    });
    (off / size).sqrt()
}

/// The chosen formulation, and the errors of the Hessians of d and xi in it and in other formulations.
pub(super) fn errors<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize, const K: usize>(
    beams: &Beams<A, B, N, M>,
    near: (f64, f64),
    forms: [Formulation; K],
) -> (Formulation, [f64; 2], [[f64; 2]; K]) {
    let at = precise(beams, near);
    let rounded = (at.0.value(), at.1.value());
    let mut choice = ROBUST;
    all(beams, rounded, |points| {
        choice = Formulation::at(points, INSIDE);
        choice
    });
    // The normal n must have the same sign in both results.
    let reversed =
        |form: Formulation| if is_reversed(choice, beams, rounded) { form.reversed() } else { form };
    let exact = all(beams, at, |_| reversed(ROBUST));
    let of = |form: Formulation| {
        let found = all(beams, rounded, |_| form);
        [error(&found.d.hessian, &exact.d.hessian), error(&found.xi.hessian, &exact.xi.hessian)]
    };
    (choice, of(choice), forms.map(|form| of(reversed(form))))
}

pub(super) fn is_reversed<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    choice: Formulation,
    (pair, q): &Beams<A, B, N, M>,
    at: (f64, f64),
) -> bool {
    let (jet, jet_bar) = jets(pair, q, at);
    let robust = Formulation::robust(&Points::new(&jet.geometry, &jet_bar.geometry), choice.held);
    robust.sign() == Some(-1.0)
}
