//! The proof without a tolerance: both linearizations over a prime field, compared by `==`.
//!
//! For every pair of families, dofs, directions and parameters are drawn at random from the field of 2^61 - 1 elements.
//! One beam is translated so that d is normal to the tangents of the free parameters, so the point is stationary by
//! construction; draws whose d, t or t_bar have no square root in the field are drawn again. The orthogonality
//! conditions are then lifted by two chord steps in hyper-dual arithmetic, which is exact since the parts are nilpotent,
//! and every value, first and second variation of the closed form must be equal to that of AD; so must gradients and
//! Hessians, contracted with the same directions. Ends of the beams are held in turn, and every other
//! draw is by the formulas of the [`Formulation`](crate::linearization::closed_form::Formulation) that is not the paper's.
//!
//! # What equality proves
//! The difference of the two sides is a function of the drawn numbers, rational but for three square roots. If it is
//! not identically zero, then, multiplied by its conjugates in the roots and its denominators, it is a polynomial of
//! degree at most 8 n, where n bounds the degree of numerator and denominator of either side; the bound is computed by
//! running both sides over [`PolynomialDegree`](crate::number::PolynomialDegree). A polynomial of degree m vanishes at a random point with probability m / p at
//! most (Schwartz and Zippel), and one point in eight at least is not drawn again, so one draw overlooks a wrong
//! formula with probability 64 n / p at most, and independent draws multiply.

mod draw;
mod entry;
mod run;

pub use draw::Draw;
pub use entry::{Entry, Layer};
pub use run::{Proof, Row, prove};

use crate::closest_point::Held;
use crate::linearization::ad::{Chord, evaluate};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::{Differentiable, Dual, HyperDual};
use crate::pair::Contact;
use crate::test_beam::ExactBeam;
use crate::variant::{Layouts, SCALARS};

/// All results of both sides at a stationary point.
struct Sides<T> {
    closed: [Varied<T>; COMPONENTS],
    ad: [Varied<T>; COMPONENTS],
    /// Gradients (along both directions) and Hessians of the scalars, contracted; on request.
    matrices: Option<[[T; 3]; SCALARS]>,
    /// The kernel in its layouts, of curves with shape functions; on request.
    kernel: Layouts<T>,
}

/// Automatic differentiation at a stationary point.
pub(crate) fn differentiated<T>(
    [beam, bar]: [&dyn ExactBeam<T>; 2],
    at: (T, T),
    held: Held,
    contact: &Contact,
) -> [Varied<T>; COMPONENTS]
where
    T: Differentiable<Dual = Dual<T>>,
{
    let lifted = Chord::<T>::new(beam, bar, at, held).lift::<HyperDual<T>, _, _>(beam, bar, at, 2);
    evaluate::<HyperDual<T>>(beam, bar, lifted, contact).map(Varied::from).components()
}
