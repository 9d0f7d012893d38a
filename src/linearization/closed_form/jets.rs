//! What the terms of the matrices are made of: the jets of both curves and the gradients of their parameters.

use super::projection::{Points, System};
use super::terms::Terms;
use crate::curve::{Geometry, Jet};
use crate::pair::DofVector;
use nalgebra::Vector3;

/// Both curves at their closest points, with derivatives in their dofs.
#[derive(Debug)]
pub struct Jets<'a, T, U, V, const N: usize, const M: usize> {
    /// Of the beam.
    pub jet: &'a Jet<T, U>,
    /// Of the bar beam.
    pub jet_bar: &'a Jet<T, V>,
    /// d = x_C - x_bar_C.
    pub d: Vector3<T>,
    /// a, b and a_bar.
    pub matrix: [T; 3],
    /// The gradient of xi, g.
    pub g: DofVector<T, N, M>,
    /// The gradient of xi_bar, g_bar.
    pub g_bar: DofVector<T, N, M>,
}

impl<T: Copy, U, V, const N: usize, const M: usize> Clone for Jets<'_, T, U, V, N, M> {
    fn clone(&self) -> Self {
        *self
    }
}

/// Jets are referred to, so their dof-derivatives need not be copied.
impl<T: Copy, U, V, const N: usize, const M: usize> Copy for Jets<'_, T, U, V, N, M> {}

/// What evaluates all terms of the matrices.
pub trait MatrixTerms<'a, T: 'a, U: 'a, V: 'a, const N: usize, const M: usize>:
    Terms<T, Jets<'a, T, U, V, N, M>>
    + Terms<T, Points<T>>
    + Terms<T, System<T>>
    + Terms<T, Geometry<T>>
    + Terms<T, ()>
{
}

impl<'a, T: 'a, U: 'a, V: 'a, F, const N: usize, const M: usize> MatrixTerms<'a, T, U, V, N, M> for F where
    F: Terms<T, Jets<'a, T, U, V, N, M>>
        + Terms<T, Points<T>>
        + Terms<T, System<T>>
        + Terms<T, Geometry<T>>
        + Terms<T, ()>
{
}
