//! The contact points of both beams, with d.

use crate::curve::Geometry;
use crate::number::Real;
use nalgebra::Vector3;

/// The geometry from which the entries of the matrix are computed.
#[derive(Clone, Copy, Debug)]
pub struct Points<T> {
    /// The beam at its contact point.
    pub beam: Geometry<T>,
    /// The bar beam at its contact point.
    pub bar: Geometry<T>,
    /// d = x_C - x_bar_C.
    pub d: Vector3<T>,
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
