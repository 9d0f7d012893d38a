//! A stationary pair of beams, with the quantities that the equations of the paper use.
//!
//! The quantities have two sources. The variations at a fixed parameter (for example delta_u u) and the derivatives of the
//! tangents are from the jets of the curves. Every total variation is from hyper-dual numbers, which use no
//! formula of the paper. An equation is judged alone: all its operands have reference values.

use crate::curve::Geometry;
use crate::linearization::ad::{PositionAt, evaluate};
use crate::linearization::closed_form::PartialVariations;
use crate::linearization::{Quantities, Varied};
use crate::number::{Differentiable, HyperDual, Real};
use crate::pair::Contact;
use nalgebra::Vector3;
use num_dual::HyperDual64;

type V<T> = Vector3<T>;

/// The two first variations of a vector.
#[derive(Clone, Copy, Debug)]
pub(super) struct Both<T> {
    pub(super) delta: V<T>,
    pub(super) linear: V<T>,
}

/// One beam of the pair.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side<T> {
    /// x, t, t,xi and t,xixi with the variations at a fixed parameter, from the jet.
    pub(super) jet: PartialVariations<T>,
    /// x_C.
    pub(super) x: Varied<V<T>>,
    /// t, the vector.
    pub(super) t: Varied<V<T>>,
    /// xi_C.
    pub(super) xi: Varied<T>,
    /// t, the length.
    pub(super) length: Varied<T>,
    /// g_T.
    pub(super) slip: Varied<T>,
    /// Delta-delta x_C and Delta-delta x_C,xi if the parameter is fixed, moves by one in delta, in Delta, or in
    /// both. The terms that are bilinear in the two motions are x,xixi and x,xixixi.
    pub(super) corners: [[V<T>; 2]; 4],
    /// delta and Delta of x_C,xixi.
    pub(super) moving_x_xixi: Both<T>,
    /// delta Delta_u u_C and Delta delta_u u_C, and the same of u_C,xi.
    pub(super) moving_u: [Both<T>; 2],
    /// X and its derivatives: any reference configuration. u is the difference of x and X.
    pub(super) reference: Geometry<T>,
    /// X_C, X_C,xi and X_C,xixi.
    pub(super) moving_reference: [Varied<V<T>>; 3],
    /// xi_C0.
    pub(super) xi_0: T,
    /// r.
    pub(super) radius: T,
}

/// Both beams at a stationary point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<T> {
    pub(super) beam: Side<T>,
    pub(super) bar: Side<T>,
    /// d, the vector.
    pub(super) d: Varied<V<T>>,
    /// d, its length.
    pub(super) distance: Varied<T>,
    /// g_N.
    pub(super) gap: Varied<T>,
    /// d and t of the same beams after a finite change.
    pub(super) after: [Varied<V<T>>; 2],
}

/// A hyper-dual number over `T`.
pub(super) trait Hyper<T>: Differentiable {
    fn hyper(self) -> HyperDual<T>;
    fn of(hyper: HyperDual<T>) -> Self;
}

impl<T: Real> Hyper<T> for HyperDual<T> {
    fn hyper(self) -> Self {
        self
    }

    fn of(hyper: Self) -> Self {
        hyper
    }
}

impl Hyper<f64> for HyperDual64 {
    fn hyper(self) -> HyperDual<f64> {
        HyperDual::new(self.re, self.eps1, self.eps2, self.eps1eps2)
    }

    fn of(hyper: HyperDual<f64>) -> Self {
        Self::new(hyper.re, hyper.eps1, hyper.eps2, hyper.eps1eps2)
    }
}

/// All quantities of two beams with the parameters lifted, by automatic differentiation.
pub(super) fn quantities<T: Real, H: Hyper<T>, B: PositionAt<H::Dual> + ?Sized>(
    [beam, bar]: [&B; 2],
    lifted: (H, H),
    contact: &Contact,
) -> Quantities<HyperDual<T>> {
    evaluate::<H>(beam, bar, lifted, contact).map(H::hyper)
}

/// A vector of hyper-dual numbers as a vector with its variations.
pub(super) fn vector<T: Real>(v: V<HyperDual<T>>) -> Varied<V<T>> {
    Varied {
        value: v.map(|x| x.re),
        delta: v.map(|x| x.eps1),
        linear: v.map(|x| x.eps2),
        second: v.map(|x| x.eps1eps2),
    }
}

impl<T: Real> Point<T> {
    /// The point of two beams with lifted parameters. `after` is d and t at another stationary point.
    pub(super) fn new<H: Hyper<T>, B: PositionAt<H::Dual> + ?Sized>(
        beams: [&B; 2],
        jets: [PartialVariations<T>; 2],
        lifted: (H, H),
        references: [Geometry<T>; 2],
        contact: &Contact,
        after: [Varied<V<T>>; 2],
    ) -> Self {
        let all = quantities(beams, lifted, contact);
        let (xi, xi_bar) = (lifted.0.hyper(), lifted.1.hyper());
        let (zero, one) = (T::zero(), T::one());
        // The mixed parts of x_C and x_C,ξ with the parameters moved by (a ε₁ + b ε₂) only.
        let moved = |[a, a_bar]: [T; 2], [b, b_bar]: [T; 2]| {
            let parameter = |xi: HyperDual<T>, a, b| H::of(HyperDual::new(xi.re, a, b, zero));
            let all = quantities(beams, (parameter(xi, a, b), parameter(xi_bar, a_bar, b_bar)), contact);
            [[all.x, all.t_vector], [all.x_bar, all.t_bar_vector]].map(|side| side.map(|v| vector(v).second))
        };
        let (deltas, linears) = ([xi.eps1, xi_bar.eps1], [xi.eps2, xi_bar.eps2]);
        let corners =
            [[zero, zero], [one, zero], [zero, one], [one, one]].map(|[a, b]| moved([a; 2], [b; 2]));
        let (delta, delta_one) = (moved(deltas, [zero; 2]), moved(deltas, [one; 2]));
        let (linear, linear_one) = (moved([zero; 2], linears), moved([one; 2], linears));

        let norms = [
            (all.t, all.g_t, contact.xi_0, contact.radius),
            (all.t_bar, all.g_t_bar, contact.xi_bar_0, contact.radius_bar),
        ];
        let vectors = [(all.x, all.t_vector, xi), (all.x_bar, all.t_bar_vector, xi_bar)];
        let side = |i: usize| {
            let (x, t, xi) = vectors[i];
            let (length, slip, xi_0, radius) = norms[i];
            Side {
                jet: jets[i],
                x: vector(x),
                t: vector(t),
                xi: Varied::from(xi),
                length: Varied::from(length),
                slip: Varied::from(slip),
                corners: corners.map(|corner| corner[i]),
                moving_x_xixi: Both {
                    delta: delta_one[i][1] - delta[i][1],
                    linear: linear_one[i][1] - linear[i][1],
                },
                moving_u: [0, 1].map(|k| Both { delta: delta[i][k], linear: linear[i][k] }),
                reference: references[i],
                moving_reference: moving(&references[i], xi),
                xi_0: T::from(xi_0),
                radius: T::from(radius),
            }
        };
        Self {
            beam: side(0),
            bar: side(1),
            d: vector(all.d_vector),
            distance: Varied::from(all.d),
            gap: Varied::from(all.g_n),
            after,
        }
    }

    /// d . t of one of the beams, as a product of hyper-dual numbers.
    pub(super) fn orthogonality(&self, side: &Side<T>) -> Varied<T> {
        let component =
            |v: &Varied<V<T>>, i: usize| HyperDual::new(v.value[i], v.delta[i], v.linear[i], v.second[i]);
        let product = |i: usize| component(&self.d, i) * component(&side.t, i);
        Varied::from(product(0) + product(1) + product(2))
    }

    /// The same point with delta and Delta exchanged.
    pub(super) fn exchanged(&self) -> Self {
        Self {
            beam: self.beam.exchanged(),
            bar: self.bar.exchanged(),
            d: self.d.exchanged(),
            distance: self.distance.exchanged(),
            gap: self.gap.exchanged(),
            after: self.after.map(Varied::exchanged),
        }
    }

    /// The same point in another scalar, number by number and vector by vector.
    pub(super) fn map<S: Real>(
        &self,
        number: &mut dyn FnMut(T) -> S,
        vector: &mut dyn FnMut(V<T>) -> V<S>,
    ) -> Point<S> {
        Point {
            beam: self.beam.map(number, vector),
            bar: self.bar.map(number, vector),
            d: self.d.map(&mut *vector),
            distance: self.distance.map(&mut *number),
            gap: self.gap.map(&mut *number),
            after: self.after.map(|v| v.map(&mut *vector)),
        }
    }
}

/// The cubic with these derivatives at the parameter, and its first two derivatives, with a moving parameter.
fn moving<T: Real>(reference: &Geometry<T>, xi: HyperDual<T>) -> [Varied<V<T>>; 3] {
    let s = HyperDual::new(T::zero(), xi.eps1, xi.eps2, xi.eps1eps2);
    let constant = |v: V<T>| v.map(|x| HyperDual::new(x, T::zero(), T::zero(), T::zero()));
    let [x, x_xi, x_xixi, x_xixixi] =
        [reference.x, reference.t, reference.t_xi, reference.t_xixi].map(constant);
    // s³ = 0.
    let squared_distance = s * s * HyperDual::from(0.5);
    [
        x + x_xi * s + x_xixi * squared_distance,
        x_xi + x_xixi * s + x_xixixi * squared_distance,
        x_xixi + x_xixixi * s,
    ]
    .map(vector)
}

impl<T: Real> Both<T> {
    fn exchanged(self) -> Self {
        Self { delta: self.linear, linear: self.delta }
    }

    fn map<S: Real>(self, vector: &mut dyn FnMut(V<T>) -> V<S>) -> Both<S> {
        Both { delta: vector(self.delta), linear: vector(self.linear) }
    }
}

impl<T: Real> Side<T> {
    fn exchanged(&self) -> Self {
        Self {
            jet: self.jet.exchanged(),
            x: self.x.exchanged(),
            t: self.t.exchanged(),
            xi: self.xi.exchanged(),
            length: self.length.exchanged(),
            slip: self.slip.exchanged(),
            corners: [self.corners[0], self.corners[2], self.corners[1], self.corners[3]],
            moving_x_xixi: self.moving_x_xixi.exchanged(),
            moving_u: self.moving_u.map(Both::exchanged),
            moving_reference: self.moving_reference.map(Varied::exchanged),
            ..*self
        }
    }

    fn map<S: Real>(&self, number: &mut dyn FnMut(T) -> S, vector: &mut dyn FnMut(V<T>) -> V<S>) -> Side<S> {
        let mut geometry = |Geometry { x, t, t_xi, t_xixi }: Geometry<T>| {
            let [x, t, t_xi, t_xixi] = [x, t, t_xi, t_xixi].map(&mut *vector);
            Geometry { x, t, t_xi, t_xixi }
        };
        let (jet, reference) = (geometry(self.jet.geometry), geometry(self.reference));
        Side {
            jet: PartialVariations {
                geometry: jet,
                delta_u: self.jet.delta_u.map(&mut *vector),
                linear_u: self.jet.linear_u.map(&mut *vector),
                second_u: self.jet.second_u.map(&mut *vector),
            },
            x: self.x.map(&mut *vector),
            t: self.t.map(&mut *vector),
            xi: self.xi.map(&mut *number),
            length: self.length.map(&mut *number),
            slip: self.slip.map(&mut *number),
            corners: self.corners.map(|corner| corner.map(&mut *vector)),
            moving_x_xixi: self.moving_x_xixi.map(vector),
            moving_u: self.moving_u.map(|u| u.map(vector)),
            reference,
            moving_reference: self.moving_reference.map(|v| v.map(&mut *vector)),
            xi_0: number(self.xi_0),
            radius: number(self.radius),
        }
    }
}
