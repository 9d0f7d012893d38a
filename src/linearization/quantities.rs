//! The quantities that are linearized, by name. Their type may be a value, a value with its variations, or a dual
//! number.

use crate::number::{HyperDual, Real};
use nalgebra::{Scalar, Vector3};
use num_dual::HyperDual64;

/// The contact geometry of a pair of beams: all quantities that are varied.
///
/// Lengths are in the user's unit; xi and xi_bar have none.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Quantities<S> {
    /// x_C, the closest point on the beam.
    pub x: Vector3<S>,
    /// x_bar_C, the closest point on the other beam.
    pub x_bar: Vector3<S>,
    /// d = x_C - x_bar_C, as a vector.
    pub d_vector: Vector3<S>,
    /// t = x_C,xi, as a vector.
    pub t_vector: Vector3<S>,
    /// t_bar = x_bar_C,xi_bar, as a vector.
    pub t_bar_vector: Vector3<S>,
    /// d, the distance.
    pub d: S,
    /// t, the length of the tangent.
    pub t: S,
    /// t_bar, the length of the other tangent.
    pub t_bar: S,
    /// xi_C, the parameter of the closest point.
    pub xi: S,
    /// xi_bar_C, the parameter of the other closest point.
    pub xi_bar: S,
    /// g_N, the distance between the surfaces.
    #[doc(alias = "normal gap")]
    #[doc(alias = "penetration")]
    pub g_n: S,
    /// g_T, the slip along the beam.
    #[doc(alias = "tangential gap")]
    pub g_t: S,
    /// g_T_bar, the slip along the other beam.
    pub g_t_bar: S,
}

/// The number of scalars in the quantities: five vectors and eight scalars.
pub const COMPONENTS: usize = 2 * VECTORS + Quantity::ALL.len();

/// The number of vectors; they are the first quantities.
const VECTORS: usize = 5;

impl<S: Scalar> Quantities<S> {
    /// The same quantities, with `f` applied to each number.
    pub fn map<U: Scalar>(self, mut f: impl FnMut(S) -> U) -> Quantities<U> {
        Quantities {
            x: self.x.map(&mut f),
            x_bar: self.x_bar.map(&mut f),
            d_vector: self.d_vector.map(&mut f),
            t_vector: self.t_vector.map(&mut f),
            t_bar_vector: self.t_bar_vector.map(&mut f),
            d: f(self.d),
            t: f(self.t),
            t_bar: f(self.t_bar),
            xi: f(self.xi),
            xi_bar: f(self.xi_bar),
            g_n: f(self.g_n),
            g_t: f(self.g_t),
            g_t_bar: f(self.g_t_bar),
        }
    }

    /// All components in one row, the vectors first; [`Quantity::of_component`] names them.
    #[doc(alias = "Eq. (17)")]
    pub fn components(self) -> [S; COMPONENTS] {
        let [[x0, x1, x2]] = self.x.data.0;
        let [[y0, y1, y2]] = self.x_bar.data.0;
        let [[d0, d1, d2]] = self.d_vector.data.0;
        let [[t0, t1, t2]] = self.t_vector.data.0;
        let [[s0, s1, s2]] = self.t_bar_vector.data.0;
        let Self { d, t, t_bar, xi, xi_bar, g_n, g_t, g_t_bar, .. } = self;
        [
            x0, x1, x2, y0, y1, y2, d0, d1, d2, t0, t1, t2, s0, s1, s2, d, t, t_bar, xi, xi_bar, g_n, g_t,
            g_t_bar,
        ]
    }

    /// The quantities with these components.
    #[cfg(feature = "check")]
    pub(crate) fn from_components(of: &[S; COMPONENTS]) -> Self {
        let vector = |v: usize| Vector3::from_fn(|c, _| of[3 * v + c].clone());
        let scalar = |quantity: Quantity| of[quantity.component()].clone();
        Self {
            x: vector(0),
            x_bar: vector(1),
            d_vector: vector(2),
            t_vector: vector(3),
            t_bar_vector: vector(4),
            d: scalar(Quantity::D),
            t: scalar(Quantity::T),
            t_bar: scalar(Quantity::TBar),
            xi: scalar(Quantity::Xi),
            xi_bar: scalar(Quantity::XiBar),
            g_n: scalar(Quantity::GN),
            g_t: scalar(Quantity::GT),
            g_t_bar: scalar(Quantity::GTBar),
        }
    }
}

#[cfg(feature = "check")]
impl<T: Real> Quantities<HyperDual<T>> {
    /// The quantities with these variations as dual parts, component by component.
    pub(crate) fn of_varied(all: &[Varied<T>]) -> Self {
        let of: [HyperDual<T>; COMPONENTS] = std::array::from_fn(|i| {
            let Varied { value, delta, linear, second } = all[i];
            HyperDual::new(value, delta, linear, second)
        });
        Self::from_components(&of)
    }
}

enumeration! {
    /// The name of a quantity, in the order of [`Quantities`].
    ///
    /// It ends in `_vector` if a vector and its length have the same letter.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    #[non_exhaustive]
    pub enum Quantity {
        /// x_C.
        X => "x",
        /// x_bar_C.
        XBar => "x_bar",
        /// d, the vector.
        DVector => "d_vector",
        /// t = x_C,xi, the vector.
        TVector => "t_vector",
        /// t_bar = x_bar_C,xi_bar, the vector.
        TBarVector => "t_bar_vector",
        /// d.
        D => "d",
        /// t.
        T => "t",
        /// t_bar.
        TBar => "t_bar",
        /// xi_C.
        Xi => "xi",
        /// xi_bar_C.
        XiBar => "xi_bar",
        /// g_N.
        GN => "g_N",
        /// g_T.
        GT => "g_T",
        /// g_T_bar.
        GTBar => "g_T_bar",
    }
}

impl Quantity {
    /// The quantity to which a number of [`Quantities::components`] belongs.
    ///
    /// # Panics
    /// If `component` is not below [`COMPONENTS`].
    pub fn of_component(component: usize) -> Self {
        let is_of_vector = component < 3 * VECTORS;
        Self::ALL[if is_of_vector { component / 3 } else { component - 2 * VECTORS }]
    }

    /// The place of its number in [`Quantities::components`], or of the first of the three numbers of a vector.
    pub const fn component(self) -> usize {
        let place = self as usize;
        if place < VECTORS { 3 * place } else { 2 * VECTORS + place }
    }

    /// The axis of a number of [`Quantities::components`], if it belongs to a vector.
    pub fn axis_of_component(component: usize) -> Option<char> {
        (component < 3 * VECTORS).then(|| ['x', 'y', 'z'][component % 3])
    }
}

/// Quantities of the beam and of the bar beam.
#[cfg(feature = "check")]
impl Quantity {
    /// The points of both beams.
    pub(crate) const POINTS: [Self; 2] = [Self::X, Self::XBar];
    /// The tangents of both beams.
    pub(crate) const TANGENTS: [Self; 2] = [Self::TVector, Self::TBarVector];
    /// The lengths of the tangents.
    pub(crate) const LENGTHS: [Self; 2] = [Self::T, Self::TBar];
    /// The parameters of both beams.
    pub(crate) const PARAMETERS: [Self; 2] = [Self::Xi, Self::XiBar];
    /// The slips of both beams.
    pub(crate) const SLIPS: [Self; 2] = [Self::GT, Self::GTBar];
}

/// A quantity with its variations in two directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Varied<T> {
    /// The quantity itself.
    pub value: T,
    /// delta, the (virtual) variation: the derivative along dq.
    pub delta: T,
    /// Delta, the linearization: the derivative along Dq.
    pub linear: T,
    /// Delta-delta, the linearization of the variation: the mixed second derivative.
    pub second: T,
}

impl<T> Varied<T> {
    /// The names of [`Varied::parts`].
    pub const PARTS: [&str; 4] = ["value", "delta", "Delta", "Delta-delta"];

    /// The four parts.
    pub fn parts(self) -> [T; 4] {
        [self.value, self.delta, self.linear, self.second]
    }

    /// A number that does not vary.
    #[cfg(feature = "check")]
    pub(crate) fn constant(value: T) -> Self
    where
        T: Real,
    {
        Self { value, delta: T::zero(), linear: T::zero(), second: T::zero() }
    }

    /// All parts, with `f` applied to each.
    #[must_use]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Varied<U> {
        Varied { value: f(self.value), delta: f(self.delta), linear: f(self.linear), second: f(self.second) }
    }

    /// The same with delta and Delta exchanged.
    #[must_use]
    pub fn exchanged(self) -> Self {
        Self { delta: self.linear, linear: self.delta, ..self }
    }
}

impl From<HyperDual64> for Varied<f64> {
    fn from(number: HyperDual64) -> Self {
        Self { value: number.re, delta: number.eps1, linear: number.eps2, second: number.eps1eps2 }
    }
}

impl<T: Real> From<HyperDual<T>> for Varied<T> {
    fn from(number: HyperDual<T>) -> Self {
        Self { value: number.re, delta: number.eps1, linear: number.eps2, second: number.eps1eps2 }
    }
}
