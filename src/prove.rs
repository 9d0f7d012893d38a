//! The proof without a tolerance: both linearizations over a prime field, compared by `==`.
//!
//! For every pair of families, dofs, directions and parameters are drawn at random from the field of 2^61 - 1 elements.
//! One beam is translated so that d is normal to the tangents of the free parameters, so the point is stationary by
//! construction; draws whose d, t or t_bar have no square root in the field are drawn again. The orthogonality
//! conditions are then lifted by two chord steps in hyper-dual arithmetic, which is exact since the parts are nilpotent,
//! and every value, first and second variation of the closed form must be equal to that of AD; so must gradients and
//! Hessians, contracted with the same directions. Ends of the beams are active in turn.
//!
//! # What equality proves
//! The difference of the two sides is a function of the drawn numbers, rational but for three square roots. If it is
//! not identically zero, then, multiplied by its conjugates in the roots and its denominators, it is a polynomial of
//! degree at most 8 n, where n bounds the degree of numerator and denominator of either side; the bound is computed by
//! running both sides over [`Degree`](crate::number::Degree). A polynomial of degree m vanishes at a random point with probability m / p at
//! most (Schwartz and Zippel), and one point in eight at least is not drawn again, so one draw overlooks a wrong
//! formula with probability 64 n / p at most, and independent draws multiply.

mod run;

pub(crate) use run::stationary;
pub use run::{Layer, Proof, Refutation, Row, prove};

use crate::closest_point::Active;
use crate::linearization::ad::{Chord, evaluate};
use crate::linearization::closed_form::{Matrices, variations};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::{Differentiable, Dual, HyperDual, Real};
use crate::pair::{Contact, DofVector};
use crate::specimen::ExactBeam;

/// The number of scalar quantities that the matrices are made for.
const SCALARS: usize = 7;

/// The components (of the variations) that the matrices are made for.
const SCALAR_COMPONENTS: [usize; SCALARS] = [15, 16, 17, 18, 19, 21, 22];

/// All results of both sides at a stationary point.
struct Sides<T> {
    closed: [Varied<T>; COMPONENTS],
    ad: [Varied<T>; COMPONENTS],
    /// Gradients (along both directions) and Hessians of the scalars, contracted; on request.
    matrices: Option<[[T; 3]; SCALARS]>,
}

/// Runs the closed form and AD at a stationary point.
fn sides<T>(
    beams: [&dyn ExactBeam<T>; 2],
    at: (T, T),
    active: Active,
    contact: &Contact,
    with_matrices: bool,
) -> Sides<T>
where
    T: Differentiable<Dual = Dual<T>>,
{
    let [beam, bar] = beams;
    let closed = variations(&beam.frozen(at.0), &bar.frozen(at.1), at, active, contact).components();

    let lifted = Chord::<T>::new(beam, bar, at, active).lift::<HyperDual<T>, _, _>(beam, bar, at, 2);
    let ad = evaluate::<HyperDual<T>>(beam, bar, lifted, contact).map(Varied::from).components();

    let matrices = with_matrices.then(|| matrices(beams, at, active, contact));
    Sides { closed, ad, matrices }
}

fn matrices<T: Real>(
    [beam, bar]: [&dyn ExactBeam<T>; 2],
    at: (T, T),
    active: Active,
    contact: &Contact,
) -> [[T; 3]; SCALARS] {
    let (jet, [dq, linear_dq]) = beam.padded(at.0);
    let (jet_bar, [dq_bar, linear_dq_bar]) = bar.padded(at.1);
    let dq = DofVector { beam: dq, bar: dq_bar };
    let linear_dq = DofVector { beam: linear_dq, bar: linear_dq_bar };
    let all = Matrices::new(&jet, &jet_bar, active).all(at, contact);
    [&all.d, &all.t, &all.t_bar, &all.xi, &all.xi_bar, &all.g_t, &all.g_t_bar]
        .map(|e| [e.gradient.along(&dq), e.gradient.along(&linear_dq), e.hessian.along(&dq, &linear_dq)])
}
