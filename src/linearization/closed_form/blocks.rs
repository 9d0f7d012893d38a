//! The matrices once more, for speed: by blocks of three rows and columns, four numbers at a time.
//!
//! A curve that is linear in its dofs is a sum of control vectors times shape functions, so that a gradient is a vector
//! spread over the dofs by shape functions, and a Hessian a sum of such gradients for every shape function:
//!
//! ```text
//! row (a, i) of H = s_a K_i + s′_a L_i + s″_a M_i      i = x, y, z
//! ```
//!
//! with rows K, L and M that all a share. [`Matrices`] is the reference of what is here: the same equations with each of
//! their terms in sight, for every curve. Here they are sorted by what they multiply, and what the quantities share is done
//! once.
//!
//! Where the machine has AVX2 and fused products and sums they are used, whatever the build was made for. The two ways
//! round differently, no more.

mod arithmetic;
mod batch;
#[cfg(target_arch = "x86_64")]
mod by_four;
mod choice;
mod distance;
mod frame;
#[cfg(target_arch = "x86_64")]
mod in_lanes;
mod lengths;
mod parameters;
mod request;
mod side;
mod slips;
mod target;

pub use batch::{Encounter, write_all_batch, write_d_batch};
pub use request::Targets;
pub use target::{Full, Gradient, Packed, Target};

use super::{Form, Matrices, Points, Sound, jets};
use crate::closest_point::{Active, ClosestPoint};
use crate::curve::{Curve, DofDerivatives};
use crate::linearization::Linearization;
use crate::linearization::fastest::with_the_fastest;
use crate::number::Real;
use crate::pair::{DofVector, Pair};
use arithmetic::{Arithmetic, ByOne};
#[cfg(target_arch = "x86_64")]
use by_four::ByFour;
use choice::{Best, Choice, Chosen, Given, Regular};
use frame::{Frame, Gradients, Products, Variations, along, points};
use request::{DistanceAlone, Request, WithSlips};
use side::{Side, Spread, shapes, spread};

/// d with its derivatives, at a closest point of the pair, written over `to`.
#[inline]
pub fn write_d<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut impl Target<f64, N, M>,
) {
    write(pair, q, point, &mut DistanceAlone(to));
}

/// All scalar quantities but the slips, at a closest point of the pair, written over `to`.
#[inline]
pub fn write_all<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut Targets<'_, impl Target<f64, N, M>>,
) {
    write(pair, q, point, to);
}

/// All scalar quantities with the slips, at a closest point of the pair, written over `to` and `slips`, g_T and g_T_bar.
#[inline]
pub fn write_all_with_slips<
    A: Curve<N>,
    B: Curve<M>,
    W: Target<f64, N, M>,
    const N: usize,
    const M: usize,
>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut Targets<'_, W>,
    slips: [&mut W; 2],
) {
    let origin = (pair.contact.xi_0, pair.contact.xi_bar_0);
    write(pair, q, point, &mut WithSlips { targets: to, slips, origin });
}

/// [`write_all_with_slips`] into a [`Linearization`].
#[inline]
pub fn write_linearization<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut Linearization<f64, N, M>,
) {
    let Linearization { d, t, t_bar, xi, xi_bar, g_t, g_t_bar, radii } = to;
    *radii = pair.contact.radius + pair.contact.radius_bar;
    write_all_with_slips(pair, q, point, &mut Targets { d, xi, xi_bar, t, t_bar }, [g_t, g_t_bar]);
}

/// [`write_d`] over any scalar, in the form asked for; `false`, and nothing written, if a curve has no shape functions.
///
/// For those who check and count: [`write_d`] does the same, with fused products and sums.
pub fn write_d_over<T: Real, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    form: Form,
    to: &mut impl Target<T, N, M>,
) -> bool {
    evaluate(ByOne, pair, q, at, Given(form), &mut DistanceAlone(to)).is_some()
}

/// [`write_all`] over any scalar, and otherwise [`write_d_over`].
pub fn write_all_over<T: Real, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    form: Form,
    to: &mut Targets<'_, impl Target<T, N, M>>,
) -> bool {
    evaluate(ByOne, pair, q, at, Given(form), to).is_some()
}

/// [`write_all_with_slips`] over any scalar, and otherwise [`write_d_over`].
pub fn write_all_with_slips_over<T, A, B, W, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    form: Form,
    to: &mut Targets<'_, W>,
    slips: [&mut W; 2],
) -> bool
where
    T: Real,
    A: Curve<N>,
    B: Curve<M>,
    W: Target<T, N, M>,
{
    let origin = (pair.contact.xi_0, pair.contact.xi_bar_0);
    evaluate(ByOne, pair, q, at, Given(form), &mut WithSlips { targets: to, slips, origin }).is_some()
}

/// What is asked for, by the form that loses the fewest digits.
///
/// The common normal with the paper's system, inside both beams and at wide angles, has a kernel of its own, in which there is
/// nothing to choose.
#[inline]
fn write<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    request: &mut impl Request<f64, N, M>,
) {
    let inside = point.active() == Active::default();
    if !(inside && may_have_shapes(pair)) || fast(pair, q, point, Regular, request).is_none() {
        write_rarer(pair, q, point, request);
    }
}

/// At ends, at small angles, beyond the radius of curvature, and of curves without shape functions.
#[cold]
#[inline(never)]
fn write_rarer<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    request: &mut impl Request<f64, N, M>,
) {
    if !may_have_shapes(pair) || fast(pair, q, point, Best(point.active()), request).is_none() {
        let at = (point.xi, point.xi_bar);
        let (jet, jet_bar) = jets(pair, q, at);
        let form = Form::at(&Points::new(&jet.geometry, &jet_bar.geometry), point.active());
        request.copy(&Matrices::with(Sound, &jet, &jet_bar, form), at, &pair.contact);
    }
}

/// Whether both curves are linear in their dofs: of others the jets need not be found to see that they have no shape
/// functions.
#[inline(always)]
fn may_have_shapes<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(_: &Pair<A, B, N, M>) -> bool {
    A::Dofs::<f64>::LINEAR && B::Dofs::<f64>::LINEAR
}

#[inline]
fn fast<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    choice: impl Choice<f64>,
    request: &mut impl Request<f64, N, M>,
) -> Option<Chosen<f64>> {
    let at = (point.xi, point.xi_bar);
    with_the_fastest!(f: ByFour, ByOne => evaluate(f, pair, q, at, choice, request))
}

/// Nothing, if a curve has no shape functions or the choice knows no form for the point.
#[inline(always)]
fn evaluate<T: Real, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    f: impl Arithmetic<T>,
    pair: &Pair<A, B, N, M>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    choice: impl Choice<T>,
    request: &mut impl Request<T, N, M>,
) -> Option<Chosen<T>> {
    let dofs = pair.curve.jet(&q.beam, at.0).dofs;
    let dofs_bar = pair.curve_bar.jet(&q.bar, at.1).dofs;
    let (of_beam, of_bar) = (shapes(&dofs)?, shapes(&dofs_bar)?);
    let one = T::one();
    let (n, n_xi, n_xixi) = spread(f, of_beam, one);
    let beam = Side::new(f, of_beam, &q.beam, Spread { n: &n, n_xi: &n_xi, n_xixi: &n_xixi });
    let (n, n_xi, n_xixi) = spread(f, of_bar, -one);
    let bar = Side::new(f, of_bar, &q.bar, Spread { n: &n, n_xi: &n_xi, n_xixi: &n_xixi });
    let products = Products::new(f, &beam, &bar);
    let chosen = choice.choose(
        #[inline(always)]
        || products.squares(f, &beam, &bar),
        #[inline(always)]
        || points(f, &beam, &bar),
    )?;
    let Variations { over_c2, inverse, u, u_bar } = Variations::new(f, (&beam, &bar), &products, chosen);
    let [p, q, q_bar] = inverse;
    let (xi, xi_bar) = along(f, &beam, (u, u_bar), ([-p, q], products.d));
    let g = Gradients { xi: &xi, xi_bar: &xi_bar };
    let (xi, xi_bar) = along(f, &bar, (u, u_bar), ([-q, -q_bar], products.d));
    let g_bar = Gradients { xi: &xi, xi_bar: &xi_bar };
    let frame = Frame { beam: &beam, bar: &bar, g, g_bar, products, over_c2, chosen, inverse, u, u_bar };
    request.write(f, &frame, at);
    Some(chosen)
}
