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

/// Evaluates a kernel with the arithmetic of the machine's vector units, if it has any that are known here.
macro_rules! with_the_fastest {
    ($f:ident: $with:expr, $without:expr => $kernel:expr) => {{
        #[cfg(target_arch = "x86_64")]
        if let Some(avx2) = fearless_simd::Level::new().as_avx2() {
            let $f = $with(avx2);
            return fearless_simd::Simd::vectorize(
                avx2,
                #[inline(always)]
                || $kernel,
            );
        }
        let $f = $without;
        $kernel
    }};
}

mod arithmetic;
mod batch;
#[cfg(target_arch = "x86_64")]
mod by_four;
mod distance;
mod frame;
mod lengths;
mod parameters;
mod second_order;
mod side;
mod target;

pub use batch::write_d_batch;
pub use target::{Full, Gradient, Packed, Target};

use super::{Form, Matrices, Points, Sound, jets};
use crate::closest_point::{Active, ClosestPoint};
use crate::curve::Curve;
use crate::linearization::Linearization;
use crate::number::Real;
use crate::pair::{DofVector, Pair};
use arithmetic::{Arithmetic, ByOne, Separate};
#[cfg(target_arch = "x86_64")]
use by_four::ByFour;
use frame::Frame;
use side::Side;

/// Memory for all scalar quantities of a pair but the slips.
#[derive(Debug)]
pub struct Targets<'a, W> {
    /// d.
    pub d: &'a mut W,
    /// xi.
    pub xi: &'a mut W,
    /// xi_bar.
    pub xi_bar: &'a mut W,
    /// t.
    pub t: &'a mut W,
    /// t_bar.
    pub t_bar: &'a mut W,
}

/// d with its derivatives, at a closest point of the pair, written over `to`.
pub fn write_d<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut impl Target<f64, N, M>,
) {
    if !is_done(fast_d(pair, q, point, to)) {
        target::fill(&rarer(pair, q, point).d, to, |to, from| *to = from);
    }
}

/// All scalar quantities but the slips, at a closest point of the pair, written over `to`.
pub fn write_all<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut Targets<'_, impl Target<f64, N, M>>,
) {
    if !is_done(fast_all(pair, q, point, to)) {
        let Linearization { d, xi, xi_bar, t, t_bar, .. } = rarer(pair, q, point);
        target::fill(&d, to.d, |to, from| *to = from);
        target::fill(&xi, to.xi, |to, from| *to = from);
        target::fill(&xi_bar, to.xi_bar, |to, from| *to = from);
        target::fill(&t, to.t, |to, from| *to = from);
        target::fill(&t_bar, to.t_bar, |to, from| *to = from);
    }
}

/// [`write_all`] over any scalar, in the paper's form; `false`, and nothing written, if a curve has no shape functions.
///
/// For those who check: [`write_all`] does the same, with fused products and sums.
pub fn write_all_over<T: Real, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    active: Active,
    to: &mut Targets<'_, impl Target<T, N, M>>,
) -> bool {
    all(ByOne(Separate), pair, q, at, active, to).is_some()
}

/// Whether the paper's form was evaluated, at a point where no other keeps more digits.
#[inline]
fn is_done(squares: Option<[f64; 4]>) -> bool {
    squares.is_some_and(Form::is_plain)
}

/// At small angles and gaps, and of curves without shape functions.
#[cold]
#[inline(never)]
fn rarer<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
) -> Linearization<f64, N, M> {
    let at = (point.xi, point.xi_bar);
    let (jet, jet_bar) = jets(pair, q, at);
    let form = Form::at(&Points::new(&jet.geometry, &jet_bar.geometry), point.active());
    Matrices::with(Sound, &jet, &jet_bar, form).all(at, &pair.contact)
}

#[inline]
fn fast_d<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut impl Target<f64, N, M>,
) -> Option<[f64; 4]> {
    let (at, active) = ((point.xi, point.xi_bar), point.active());
    with_the_fastest!(f: ByFour, ByOne(Separate) => d(f, pair, q, at, active, to))
}

#[inline]
fn fast_all<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B>,
    q: &DofVector<f64, N, M>,
    point: &ClosestPoint,
    to: &mut Targets<'_, impl Target<f64, N, M>>,
) -> Option<[f64; 4]> {
    let (at, active) = ((point.xi, point.xi_bar), point.active());
    with_the_fastest!(f: ByFour, ByOne(Separate) => all(f, pair, q, at, active, to))
}

/// t·t, t̄·t̄, t·t̄ and d·d of what was written; nothing if a curve has no shape functions.
#[inline(always)]
fn d<T: Real, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    f: impl Arithmetic<T>,
    pair: &Pair<A, B>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    active: Active,
    to: &mut impl Target<T, N, M>,
) -> Option<[T; 4]> {
    let frame = frame(f, pair, q, at, active)?;
    frame.write_d(f, to);
    Some(frame.squares)
}

/// The same of all quantities.
#[inline(always)]
fn all<T: Real, A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    f: impl Arithmetic<T>,
    pair: &Pair<A, B>,
    q: &DofVector<T, N, M>,
    at: (T, T),
    active: Active,
    to: &mut Targets<'_, impl Target<T, N, M>>,
) -> Option<[T; 4]> {
    let frame = frame(f, pair, q, at, active)?;
    frame.write_d(f, to.d);
    frame.write_xi(f, at.0, to.xi, to.t);
    frame.write_xi_bar(f, at.1, to.xi_bar, to.t_bar);
    Some(frame.squares)
}

/// The pair at its closest point.
#[inline(always)]
fn frame<T: Real, A: Curve<N>, B: Curve<M>, F: Arithmetic<T>, const N: usize, const M: usize>(
    f: F,
    pair: &Pair<A, B>,
    q: &DofVector<T, N, M>,
    (xi, xi_bar): (T, T),
    active: Active,
) -> Option<Frame<T, F::Vector, N, M>> {
    let beam = Side::new(f, &pair.curve.jet(&q.beam, xi).dofs, &q.beam, T::one())?;
    let bar = Side::new(f, &pair.curve_bar.jet(&q.bar, xi_bar).dofs, &q.bar, -T::one())?;
    Some(Frame::new(f, beam, bar, active))
}
