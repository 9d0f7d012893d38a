//! The kernel: gradients and Hessians of d, xi, xi_bar, t, t_bar, g_T and g_T_bar, in vector arithmetic.
//!
//! It applies to curves that are linear in their dofs: section 7 of the [derivation](super::derivation). [`Matrices`]
//! has the same numbers term by term, for every curve, and is the reference of the kernel.
//!
//! On an x86-64 with AVX2 and FMA the kernel uses them, whatever the build target is. Other x86-64 machines use the matrices.
//! Other processors run the kernel in scalar arithmetic. The results differ by rounding only.

mod arithmetic;
#[cfg(target_arch = "x86_64")]
mod avx2;
mod batch;
mod choice;
mod distance;
mod frame;
#[cfg(target_arch = "x86_64")]
mod lanes;
mod lengths;
mod parameters;
mod products;
mod request;
mod side;
mod slips;
mod solution;
mod target;

pub use batch::{PairAtPoint, write_d_batch};
pub use request::{DistanceAlone, Request, WithSlips, WithoutSlips};
pub use target::{Full, Gradient, Packed, Target};

use super::{Formulation, Matrices, Points, jets};
use crate::closest_point::ClosestPoint;
use crate::curve::{Curve, DofDerivatives, Jet};
use crate::linearization::dispatch::return_with_vectors;
use crate::number::Real;
use crate::pair::{Contact, DofVector, Pair};
use arithmetic::{Arithmetic, ScalarArithmetic};
#[cfg(target_arch = "x86_64")]
use avx2::Avx2Arithmetic;
use choice::{Best, Choice, Given, points};
use frame::{Frame, Gradients, along};
use products::Products;
use side::{Point, Shapes, Side, Spread, shapes, spread};
use solution::Solution;

impl<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize> Pair<A, B, N, M> {
    /// The requested quantities with their derivatives, at a closest point of the pair, written into memory of the caller:
    /// [`DistanceAlone`], [`WithoutSlips`] or [`WithSlips`], in any layout that is a [`Target`].
    ///
    /// The numbers are those of [`Pair::linearize`], by the formulation that loses the fewest digits.
    ///
    /// # Example
    /// ```
    /// # use beamgap::curve::Segment;
    /// # use beamgap::linearization::closed_form::kernel::{DistanceAlone, Full};
    /// # use beamgap::pair::Pair;
    /// # let pair = Pair::new(Segment::new(), Segment::new());
    /// # let q = ([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0], [0.0, -1.0, -0.5, 0.0, 1.0, -0.5]).into();
    /// # let found = pair.closest_points(&q)?;
    /// # let point = found.interior()?;
    /// let mut d = Full::<f64, 12>::zeros();
    /// pair.write(&q, point, DistanceAlone { d: &mut d });
    /// assert_eq!(d.value, 0.5);
    /// # Ok::<(), beamgap::closest_point::ProjectionError>(())
    /// ```
    // The kernel only knows how many dofs the curves have. It is compiled for these numbers and not for curve families.
    #[cfg_attr(not(debug_assertions), inline)]
    pub fn write(
        &self,
        q: &DofVector<f64, N, M>,
        point: &ClosestPoint,
        mut request: impl Request<f64, N, M>,
    ) {
        // A curve that is not linear in its dofs has no shape functions, so its jet is not computed here.
        if A::Dofs::<f64>::LINEAR && B::Dofs::<f64>::LINEAR {
            let (dofs, dofs_bar) =
                (self.curve.jet(&q.beam, point.xi).dofs, self.curve_bar.jet(&q.bar, point.xi_bar).dofs);
            if let (Some(of_beam), Some(of_bar)) = (shapes(&dofs), shapes(&dofs_bar))
                && write_by_shapes((of_beam, of_bar), q, point, &self.contact, &mut request)
            {
                return;
            }
        }
        write_by_matrices(self, q, point, &mut request);
    }

    /// [`Pair::write`] over any scalar, at the parameters `at`, in the given formulation. Returns `false` and writes
    /// nothing if a curve has no shape functions.
    ///
    /// It serves checks and operation counts. [`Pair::write`] computes the same, with fused products and sums.
    pub fn write_over<T: Real>(
        &self,
        q: &DofVector<T, N, M>,
        at: (T, T),
        form: Formulation,
        mut request: impl Request<T, N, M>,
    ) -> bool {
        let (dofs, dofs_bar) = (self.curve.jet(&q.beam, at.0).dofs, self.curve_bar.jet(&q.bar, at.1).dofs);
        let (Some(of_beam), Some(of_bar)) = (shapes(&dofs), shapes(&dofs_bar)) else { return false };
        write_by_shapes_over((of_beam, of_bar), q, at, form, &self.contact, &mut request);
        true
    }
}

/// Writes the requested quantities of curves with these jets, in the given formulation. Returns `false` and writes nothing if a
/// curve has no shape functions, or on an x86-64 without the vector units.
#[cfg_attr(not(debug_assertions), inline)]
pub(crate) fn write_of_jets<const N: usize, const M: usize>(
    (jet, jet_bar): (&Jet<f64, impl DofDerivatives<f64, N>>, &Jet<f64, impl DofDerivatives<f64, M>>),
    q: &DofVector<f64, N, M>,
    at: (f64, f64),
    form: Formulation,
    contact: &Contact,
    request: &mut impl Request<f64, N, M>,
) -> bool {
    let (Some(of_beam), Some(of_bar)) = (shapes(&jet.dofs), shapes(&jet_bar.dofs)) else { return false };
    let shapes = (of_beam, of_bar);
    return_with_vectors!(f: Avx2Arithmetic => evaluate(f, shapes, q, at, Given(form), contact, request).is_some());
    if cfg!(not(target_arch = "x86_64")) {
        write_by_shapes_over(shapes, q, at, form, contact, request);
    }
    cfg!(not(target_arch = "x86_64"))
}

/// For curves with shape functions. Returns `false` and writes nothing on an x86-64 without the vector units.
#[cfg_attr(not(debug_assertions), inline)]
fn write_by_shapes<const N: usize, const M: usize>(
    shapes: (Shapes<'_, f64>, Shapes<'_, f64>),
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    contact: &Contact,
    request: &mut impl Request<f64, N, M>,
) -> bool {
    let (at, held) = ((point.xi, point.xi_bar), point.held());
    return_with_vectors!(f: Avx2Arithmetic => evaluate(f, shapes, q, at, Best(held), contact, request).is_some());
    // Few x86-64 processors lack these vector units, so the kernel is not compiled once more for them.
    if cfg!(not(target_arch = "x86_64")) {
        let (beam, bar) =
            (Point::new(ScalarArithmetic, shapes.0, &q.beam), Point::new(ScalarArithmetic, shapes.1, &q.bar));
        let form = Formulation::at(&points(ScalarArithmetic, (&beam, &bar)), held);
        write_by_shapes_over(shapes, q, at, form, contact, request);
    }
    cfg!(not(target_arch = "x86_64"))
}

/// For all curves, on all machines.
#[inline(never)]
fn write_by_matrices<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    request: &mut impl Request<f64, N, M>,
) {
    let at = (point.xi, point.xi_bar);
    let (jet, jet_bar) = jets(pair, q, at);
    let form = Formulation::at(&Points::new(&jet.geometry, &jet_bar.geometry), point.held());
    request.copy(&Matrices::in_formulation(&jet, &jet_bar, form), at, &pair.contact);
}

/// Evaluates in scalar arithmetic, one number after the other.
#[inline(never)]
pub(crate) fn write_by_shapes_over<T: Real, const N: usize, const M: usize>(
    shapes: (Shapes<'_, T>, Shapes<'_, T>),
    q: &DofVector<T, N, M>,
    at: (T, T),
    form: Formulation,
    contact: &Contact,
    request: &mut impl Request<T, N, M>,
) {
    evaluate(ScalarArithmetic, shapes, q, at, Given(form), contact, request);
}

/// Returns the lanes, as bits, that need another formulation than the others, or nothing if no lane is written.
#[inline(always)]
fn evaluate<T: Real, const N: usize, const M: usize>(
    f: impl Arithmetic<T>,
    (of_beam, of_bar): (Shapes<'_, T>, Shapes<'_, T>),
    q: &DofVector<T, N, M>,
    at: (T, T),
    choice: impl Choice<T>,
    contact: &Contact,
    request: &mut impl Request<T, N, M>,
) -> Option<u8> {
    let one = T::one();
    let (n, n_xi, n_xixi) = spread(f, of_beam, one);
    let shapes = Spread { n: &n, n_xi: &n_xi, n_xixi: &n_xixi };
    let beam = Side { at: Point::new(f, of_beam, &q.beam), shapes };
    let (n, n_xi, n_xixi) = spread(f, of_bar, -one);
    let shapes = Spread { n: &n, n_xi: &n_xi, n_xixi: &n_xixi };
    let bar = Side { at: Point::new(f, of_bar, &q.bar), shapes };
    let points = (&beam.at, &bar.at);
    let products = Products::new(f, points);
    let (solution, exceptions) = choice.solve(f, points, &products)?;
    let Solution { inverse: [p, q, q_bar], u, u_bar, .. } = solution;
    let (xi, xi_bar) = along(f, &beam, (u, u_bar), ([-p, q], products.d));
    let g = Gradients { xi: &xi, xi_bar: &xi_bar };
    let (xi, xi_bar) = along(f, &bar, (u, u_bar), ([-q, -q_bar], products.d));
    let g_bar = Gradients { xi: &xi, xi_bar: &xi_bar };
    let frame = Frame { beam: &beam, bar: &bar, g, g_bar, products, solution };
    request.write(f, &frame, at, contact);
    Some(exceptions)
}
