//! The proof without a tolerance: closed form and automatic differentiation over a prime field, compared by `==`.
//!
//! Dofs, directions and parameters of every pair of families are drawn at random from the field of 2^61 - 1 elements. One
//! beam is translated so that d is normal to the tangents of the free parameters; the point is then stationary by
//! construction. A draw whose d, t or t_bar has no square root in the field is drawn again. Two chord steps in hyper-dual
//! arithmetic differentiate the orthogonality conditions; they are exact, as the dual parts are nilpotent. Every value,
//! first and second variation of the closed form must be equal to that of AD. So must gradients and Hessians, contracted
//! with the same directions, and residual and tangent of a contact element in a state that is drawn. Some draws hold parameters at ends, each at both. The draws go
//! through every [`Formulation`](crate::linearization::closed_form::Formulation): both distances, with both signs of the
//! normal, and both ways to solve the system.
//!
//! # What equality proves
//! The difference of the two sides is a function of the drawn numbers, rational except for three square roots. If it is
//! not identically zero, its product with its conjugates in the roots and with its denominators is a polynomial of
//! degree at most 8 n, where n bounds the degree of numerator and denominator of either side. The bound is computed by
//! running both sides with every drawn number as a variable
//! ([`PrimeField::variable`](crate::number::PrimeField::variable)). A polynomial of degree m vanishes at a random point with
//! probability m / p at most (Schwartz and Zippel), and at least one point in eight is not drawn again. One draw therefore
//! misses a wrong formula with probability 64 n / p at most, and the probabilities of independent draws multiply. A contact element that slips
//! has a fourth square root, the length of the trial force, and so 256 n / p.

mod draw;
mod element;
mod entry;
mod run;

pub use draw::Draw;
pub(crate) use element::Situation;
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
    /// Gradients (along both directions) and Hessians of the scalars, contracted; if requested.
    matrices: Option<[[T; 3]; SCALARS]>,
    /// The kernel in its layouts, for curves with shape functions; if requested.
    kernel: Layouts<T>,
    /// Residual and tangent of a contact element; if requested.
    element: Option<Element<T>>,
}

/// Residual and tangent of a contact element: along delta and Delta, and between them in both orders.
struct Element<T> {
    candidate: &'static str,
    closed: [T; 4],
    ad: [T; 4],
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
