//! What the terms of the variations are made of: both beams with all that is known of them so far.

use super::Frozen;
use super::terms::{Label, Terms};
use crate::curve::Geometry;
use crate::number::Real;
use nalgebra::Vector3;
use std::ops::Mul;

/// Both beams at their closest points, varied in two directions. It is filled in as the formulas proceed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Operands<T> {
    /// The beam.
    pub beam: Side<T>,
    /// The bar beam.
    pub bar: Side<T>,
    /// d = x_C - x_bar_C.
    pub d: Vector3<T>,
    /// d, the distance.
    pub distance: T,
    /// n, the common normal of the tangents, if the distance is varied along it.
    pub normal: Vector3<T>,
    /// Of the direction delta.
    pub delta: Between<T>,
    /// Of the direction Delta.
    pub linear: Between<T>,
}

/// What belongs to both beams and one direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Between<T> {
    /// delta_u u_hat.
    pub u_hat: Vector3<T>,
    /// delta d, of the vector.
    pub d: Vector3<T>,
    /// delta d, of the distance.
    pub distance: T,
    /// delta n.
    pub normal: Vector3<T>,
}

/// One beam.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Side<T> {
    /// x, t, t,xi and t,xixi.
    pub geometry: Geometry<T>,
    /// xi less the reference parameter.
    pub slip: T,
    /// t, the length of the tangent.
    pub length: T,
    /// First variations along delta.
    pub delta: First<T>,
    /// First variations along Delta.
    pub linear: First<T>,
    /// Second variations.
    pub second: Second<T>,
}

/// First variations of one beam.
#[derive(Clone, Copy, Debug)]
pub(crate) struct First<T> {
    /// At a frozen parameter: delta_u u, delta_u u,xi and delta_u u,xixi.
    pub u: [Vector3<T>; 3],
    /// Of the parameter.
    pub xi: T,
    /// Of the contact point.
    pub x: Vector3<T>,
    /// Of the tangent.
    pub t: Vector3<T>,
    /// Of the length of the tangent.
    pub length: T,
}

/// Second variations of one beam.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Second<T> {
    /// At a frozen parameter: Delta_u delta_u u and Delta_u delta_u u,xi.
    pub u: [Vector3<T>; 2],
    /// Of the contact point, less its term in Delta-delta xi.
    pub rest_x: Vector3<T>,
    /// Of the tangent, less its term in Delta-delta xi.
    pub rest_t: Vector3<T>,
    /// Of the parameter.
    pub xi: T,
    /// Of the contact point.
    pub x: Vector3<T>,
    /// Of the tangent.
    pub t: Vector3<T>,
    /// Of the length of the tangent.
    pub length: T,
}

impl<T: Real> Operands<T> {
    /// Two frozen beams; the rest is zero until it is computed.
    #[inline]
    pub(crate) fn new(beam: &Frozen<T>, bar: &Frozen<T>) -> Self {
        let nil = Vector3::zeros();
        let between = Between { u_hat: nil, d: nil, distance: T::zero(), normal: nil };
        Self {
            beam: Side::new(beam),
            bar: Side::new(bar),
            d: nil,
            distance: T::zero(),
            normal: nil,
            delta: between,
            linear: between,
        }
    }

    /// One of the two beams.
    #[inline]
    pub(crate) fn side(&self, bar: bool) -> &Side<T> {
        if bar { &self.bar } else { &self.beam }
    }

    /// One of the two beams.
    #[inline]
    pub(crate) fn side_mut(&mut self, bar: bool) -> &mut Side<T> {
        if bar { &mut self.bar } else { &mut self.beam }
    }

    /// The same with delta and Delta exchanged.
    #[inline]
    #[must_use]
    pub(crate) fn exchanged(&self) -> Self {
        Self {
            beam: self.beam.exchanged(),
            bar: self.bar.exchanged(),
            delta: self.linear,
            linear: self.delta,
            ..*self
        }
    }
}

impl<T: Real> Side<T> {
    #[inline]
    fn new(frozen: &Frozen<T>) -> Self {
        let Frozen { geometry, delta_u, linear_u, second_u } = *frozen;
        let (zero, nil) = (T::zero(), Vector3::zeros());
        let first = |u| First { u, xi: zero, x: nil, t: nil, length: zero };
        let second = Second { u: second_u, rest_x: nil, rest_t: nil, xi: zero, x: nil, t: nil, length: zero };
        Self { geometry, slip: zero, length: zero, delta: first(delta_u), linear: first(linear_u), second }
    }

    #[inline]
    fn exchanged(&self) -> Self {
        Self { delta: self.linear, linear: self.delta, ..*self }
    }
}

/// A formula about to be summed up, by terms of these operands; `bar` if its own beam is the bar beam.
pub(super) struct Formula<'a, F, T> {
    terms: &'a F,
    operands: &'a Operands<T>,
    bar: bool,
}

impl<'a, T: Real, F: Terms<T, Operands<T>>> Formula<'a, F, T> {
    #[inline]
    pub(super) fn new(terms: &'a F, operands: &'a Operands<T>) -> Self {
        Self { terms, operands, bar: false }
    }

    #[inline]
    pub(super) fn of_side(terms: &'a F, operands: &'a Operands<T>, bar: bool) -> Self {
        Self { terms, operands, bar }
    }

    /// A term of both beams.
    #[inline]
    pub(super) fn term<V: Mul<T, Output = V>>(
        &self,
        name: &'static str,
        term: impl Fn(&Operands<T>) -> V,
    ) -> V {
        self.terms.term(Label { name, bar: self.bar }, self.operands, term)
    }

    /// A term of the formula's own beam.
    #[inline]
    pub(super) fn own<V: Mul<T, Output = V>>(&self, name: &'static str, term: impl Fn(&Side<T>) -> V) -> V {
        self.term(name, |o| term(o.side(self.bar)))
    }
}
