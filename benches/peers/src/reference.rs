//! The reference result: the closed form in double-double, at the closest point in double-double.

use crate::cases::{Case, PAIR};
use crate::candidates::FULL;
use beamgap::closest_point::Held;
use beamgap::linearization::Derivatives;
use beamgap::linearization::closed_form::{Matrices, Projection, jets};
use beamgap::number::DoubleDouble;
use beamgap::pair::DofVector;

/// The number of steps of Newton's method from a point with 16 correct digits. Each step doubles the digits.
const STEPS: usize = 3;

/// The closest point in double-double.
fn closest_point(q: &DofVector<DoubleDouble, 12, 12>, at: (f64, f64)) -> (DoubleDouble, DoubleDouble) {
    let (mut xi, mut xi_bar) = (DoubleDouble::from(at.0), DoubleDouble::from(at.1));
    for _ in 0..STEPS {
        let (jet, jet_bar) = jets(&PAIR, q, (xi, xi_bar));
        let (x, y) = (jet.geometry, jet_bar.geometry);
        let d = x.x - y.x;
        let step = Projection::new(&x, &y, Held::default()).solve(-d.dot(&x.t), -d.dot(&y.t));
        xi += step.0;
        xi_bar += step.1;
    }
    (xi, xi_bar)
}

/// Writes all quantities of a pair in the full layout.
///
/// # Safety
/// `q` points to a case, `out` to five full blocks.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn right_all_full(q: *const f64, xi: f64, xi_bar: f64, out: *mut f64) {
    // SAFETY: the caller's promise.
    let (case, out) = unsafe { (Case::of(q), std::slice::from_raw_parts_mut(out, 5 * FULL)) };
    let q = DofVector { beam: case.q.beam.map(DoubleDouble::from), bar: case.q.bar.map(DoubleDouble::from) };
    let at = closest_point(&q, (xi, xi_bar));
    let (jet, jet_bar) = jets(&PAIR, &q, at);
    let all = Matrices::new(&jet, &jet_bar, Held::default()).all(at, &PAIR.contact);
    let quantities = [&all.d, &all.xi, &all.xi_bar, &all.t, &all.t_bar];
    for (quantity, block) in quantities.into_iter().zip(out.chunks_exact_mut(FULL)) {
        write_full(quantity, DoubleDouble::value, block);
    }
}

/// Writes derivatives in the full layout.
pub(crate) fn write_full<T: Copy + beamgap::number::Real>(
    quantity: &Derivatives<T, 12, 12>,
    value: impl Fn(T) -> f64,
    block: &mut [f64],
) {
    block[0] = value(quantity.value);
    for i in 0..24 {
        block[8 + i] = value(quantity.gradient.entry(i));
        for j in 0..24 {
            block[32 + 24 * i + j] = value(quantity.hessian.entry(i, j));
        }
    }
}
