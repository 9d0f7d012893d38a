//! The two-by-two system that the variations of xi and xi_bar solve, to first and to second order alike.

use super::Form;
use super::terms::{Label, Sound, Terms};
use crate::closest_point::Active;
use crate::curve::Geometry;
use crate::number::Real;
use nalgebra::Vector3;

/// What the entries of the matrix are made of.
#[derive(Clone, Copy, Debug)]
pub struct Points<T> {
    /// The beam at its contact point.
    pub beam: Geometry<T>,
    /// The bar beam at its contact point.
    pub bar: Geometry<T>,
    /// d = x_C - x_bar_C.
    pub d: Vector3<T>,
}

/// What its solutions are made of.
#[derive(Clone, Copy, Debug)]
pub struct System<T> {
    /// The entries of the matrix: a, b, a_bar.
    pub matrix: [T; 3],
    /// The right-hand side of the beam.
    pub r: T,
    /// The right-hand side of the bar beam.
    pub r_bar: T,
}

/// The matrix of the orthogonality conditions at the closest point, ready to be solved with.
///
/// At an end of a beam the parameter is held and its row and column drop out.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "Eq. (50)")]
#[doc(alias = "Eq. (55)")]
pub struct Projection<T> {
    /// a = t . t + d . t,xi.
    pub a: T,
    /// b = t . t_bar.
    pub b: T,
    /// a_bar = -t_bar . t_bar + d . t_bar,xi_bar: *minus* the twin of a.
    pub a_bar: T,
    /// Which parameters are held at an end.
    pub active: Active,
    /// What takes the place of products that cancel, in the [`Form`] that asks for it.
    pub crossed: Option<Crossed<T>>,
}

/// What the cross products of the tangents yield, in place of products that cancel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossed<T> {
    /// D.
    pub det: T,
    /// u and u_bar, which w multiplies in the solution for R = -t.w - e, R_bar = -t_bar.w - e_bar.
    pub u: [Vector3<T>; 2],
}

impl<T: Real> Crossed<T> {
    #[inline]
    fn with(terms: &impl Terms<T, Points<T>>, points: &Points<T>) -> Self {
        let term = |name, term: fn(&Points<T>) -> T| terms.term(Label::new(name), points, term);
        let vector = |name, term: fn(&Points<T>) -> Vector3<T>| terms.term(Label::new(name), points, term);
        // D = −c·c + (d·t,ξ) ā + (d·t̄,ξ̄) t·t with c = t × t̄
        let det = -term("D: c.c", |o| o.cross().dot(&o.cross()))
            + term("D: d.t,xi a_bar", |o| {
                o.d.dot(&o.beam.t_xi) * (o.d.dot(&o.bar.t_xi) - o.bar.t.dot(&o.bar.t))
            })
            + term("D: d.t_bar,xi t.t", |o| o.d.dot(&o.bar.t_xi) * o.beam.t.dot(&o.beam.t));
        // D u = t̄ × c − (d·t̄,ξ̄) t   D ū = t × c − (d·t,ξ) t̄
        let u = vector("u: t_bar x c", |o| o.bar.t.cross(&o.cross()))
            - vector("u: d.t_bar,xi t", |o| o.beam.t * o.d.dot(&o.bar.t_xi));
        let u_bar = vector("u_bar: t x c", |o| o.beam.t.cross(&o.cross()))
            - vector("u_bar: d.t,xi t_bar", |o| o.bar.t * o.d.dot(&o.beam.t_xi));
        Self { det, u: [u / det, u_bar / det] }
    }
}

impl<T: Real> Points<T> {
    /// Both beams at their contact points.
    #[inline]
    pub fn new(beam: &Geometry<T>, bar: &Geometry<T>) -> Self {
        Self { beam: *beam, bar: *bar, d: beam.x - bar.x }
    }

    /// The same over another number type.
    #[inline]
    pub fn map<U: Real>(&self, number: impl Fn(T) -> U) -> Points<U> {
        let geometry = |x: &Geometry<T>| {
            let [x, t, t_xi, t_xixi] = [x.x, x.t, x.t_xi, x.t_xixi].map(|v| v.map(&number));
            Geometry { x, t, t_xi, t_xixi }
        };
        Points { beam: geometry(&self.beam), bar: geometry(&self.bar), d: self.d.map(&number) }
    }

    /// c = t x t_bar.
    #[inline]
    pub fn cross(&self) -> Vector3<T> {
        self.beam.t.cross(&self.bar.t)
    }
}

impl<T: Real> Projection<T> {
    /// Sets the matrix up from the geometry of both curves at the closest point.
    #[inline]
    pub fn new(beam: &Geometry<T>, bar: &Geometry<T>, active: Active) -> Self {
        Self::with(&Sound, &Points::new(beam, bar), Form::paper(active))
    }

    /// The same through [`Terms`], in the form asked for.
    #[inline]
    pub(crate) fn with(terms: &impl Terms<T, Points<T>>, points: &Points<T>, form: Form) -> Self {
        let term = |name, term: fn(&Points<T>) -> T| terms.term(Label::new(name), points, term);
        // Eq. (50), (51): a = t·t + d·t,ξ   b = t·t̄   ā = −t̄·t̄ + d·t̄,ξ̄
        let a = term("a: t.t", |o| o.beam.t.dot(&o.beam.t)) + term("a: d.t,xi", |o| o.d.dot(&o.beam.t_xi));
        let b = term("b: t.t_bar", |o| o.beam.t.dot(&o.bar.t));
        let a_bar = -term("a_bar: t_bar.t_bar", |o| o.bar.t.dot(&o.bar.t))
            + term("a_bar: d.t_bar,xi", |o| o.d.dot(&o.bar.t_xi));
        let crossed = form.is_crossed().then(|| Crossed::with(terms, points));
        Self { a, b, a_bar, active: form.active, crossed }
    }

    /// D = a a_bar + b^2, negative at a strict minimum.
    #[inline]
    #[doc(alias = "Eq. (52)")]
    pub fn det(&self) -> T {
        self.crossed.map_or_else(|| self.a * self.a_bar + self.b * self.b, |crossed| crossed.det)
    }

    /// (delta xi, delta xi_bar) from the right-hand sides R and R_bar, of first or of second order.
    #[inline]
    #[doc(alias = "Eq. (56)")]
    #[doc(alias = "Eq. (59)")]
    pub fn solve(&self, r: T, r_bar: T) -> (T, T) {
        self.solve_with(&Sound, r, r_bar)
    }

    /// The same through [`Terms`].
    #[inline]
    pub(crate) fn solve_with(&self, terms: &impl Terms<T, System<T>>, r: T, r_bar: T) -> (T, T) {
        let Self { a, b, a_bar, active, crossed } = *self;
        let system = System { matrix: [a, b, a_bar], r, r_bar };
        let term = |name, term: fn(&System<T>) -> T| terms.term(Label::new(name), &system, term);
        let zero = T::zero();
        match (active.xi, active.xi_bar) {
            (false, false) => {
                // Eq. (52): D = a ā + b²
                let det = crossed.map_or_else(
                    || {
                        term("D: a a_bar", |o| o.matrix[0] * o.matrix[2])
                            + term("D: b b", |o| o.matrix[1] * o.matrix[1])
                    },
                    |crossed| crossed.det,
                );
                // Eq. (52), (59): δξ = (ā R + b R̄)/D   δξ̄ = (−b R + a R̄)/D
                let xi = term("xi: a_bar R", |o| o.matrix[2] * o.r)
                    + term("xi: b R_bar", |o| o.matrix[1] * o.r_bar);
                let xi_bar = -term("xi_bar: b R", |o| o.matrix[1] * o.r)
                    + term("xi_bar: a R_bar", |o| o.matrix[0] * o.r_bar);
                (xi / det, xi_bar / det)
            }
            // An end holds one parameter: the other row alone remains, R̄ = ā δξ̄ or R = a δξ.
            (true, false) => (zero, term("xi_bar, xi held: R_bar / a_bar", |o| o.r_bar / o.matrix[2])),
            (false, true) => (term("xi, xi_bar held: R / a", |o| o.r / o.matrix[0]), zero),
            (true, true) => (zero, zero),
        }
    }

    /// The inverse matrix [[p, q], [r, s]], so that (delta xi, delta xi_bar) = (p R + q R_bar, r R + s R_bar).
    #[inline]
    pub fn inverse(&self) -> [[T; 2]; 2] {
        self.inverse_with(&Sound)
    }

    /// The same through [`Terms`].
    #[inline]
    pub(crate) fn inverse_with(&self, terms: &impl Terms<T, System<T>>) -> [[T; 2]; 2] {
        let (zero, one) = (T::zero(), T::one());
        let ((p, r), (q, s)) = (self.solve_with(terms, one, zero), self.solve_with(terms, zero, one));
        [[p, q], [r, s]]
    }
}
