//! Curves that are known at one or two parameters, and beams on them.

use crate::closest_point::{ClosestPoint, End, Side};
use crate::curve::{Curve, Jet, Shapes};
use crate::linearization::closed_form::kernel::PairAtPoint;
use crate::number::Real;
use crate::pair::{Contact, DofVector, Pair};
use crate::test_beam::PaddedBeam;
use nalgebra::{SVector, Vector3};

/// A curve of `P` control vectors that is known at two parameters. At any other parameter it is another curve, so that a
/// number at a wrong parameter is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tabulated<const P: usize> {
    at: [f64; 2],
    shapes: [[[f64; P]; 4]; 2],
}

/// A third parameter, at which the shape functions are zero.
const ZERO_AT: f64 = 2.0;

impl<const P: usize, const N: usize> Curve<N> for Tabulated<P> {
    type Dofs<T: Real> = Shapes<T, P>;

    fn position<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Vector3<T> {
        self.jet(q, xi).geometry.x
    }

    /// Interpolates by Lagrange's polynomials. They are exactly one and zero at the known parameters.
    fn jet<T: Real>(&self, q: &SVector<T, N>, xi: T) -> Jet<T, Self::Dofs<T>> {
        let weight = |at: f64, other: f64| {
            let towards = |zero: f64| (xi - T::from(zero)) / T::from(at - zero);
            towards(other) * towards(ZERO_AT)
        };
        let [at, other] = self.at;
        let (w, w_other) = (weight(at, other), weight(other, at));
        let [shapes, others] = &self.shapes;
        let mixed = |k: usize, a: usize| w * T::from(shapes[k][a]) + w_other * T::from(others[k][a]);
        Shapes::jet(std::array::from_fn(|k| std::array::from_fn(|a| mixed(k, a))), q)
    }

    fn third_derivative_bound(&self, _: &SVector<f64, N>) -> f64 {
        f64::INFINITY
    }
}

/// A beam on a curve with shape functions at its closest point.
#[derive(Clone, Debug)]
pub(super) struct Beam {
    xi: f64,
    shapes: [Vec<f64>; 4],
    /// Its dofs and the two directions.
    vectors: [Vec<f64>; 3],
}

impl Beam {
    /// A padded beam with its own number of dofs; nothing if it has no shape functions.
    pub(super) fn new((jet, vectors): &PaddedBeam<f64>, dofs: usize, xi: f64) -> Option<Self> {
        let shapes = jet.dofs.all_shapes()?.map(|shapes| shapes[..dofs / 3].to_vec());
        Some(Self { xi, shapes, vectors: vectors.map(|v| v.as_slice()[..dofs].to_vec()) })
    }

    pub(super) fn dofs(&self) -> usize {
        self.vectors[0].len()
    }

    /// The same beam with one more control vector: the last one twice, each with half of the shape function.
    pub(super) fn with_one_more(&self) -> Self {
        let mut more = self.clone();
        for shapes in &mut more.shapes {
            if let Some(last) = shapes.last_mut() {
                *last *= 0.5;
                let half = *last;
                shapes.push(half);
            }
        }
        for vector in &mut more.vectors {
            vector.extend_from_within(vector.len() - 3..);
        }
        more
    }

    fn vector<const N: usize>(&self, i: usize) -> SVector<f64, N> {
        SVector::from_column_slice(&self.vectors[i])
    }

    /// The curve of the beam, and of the beam with its parameter and the order of its control vectors reversed.
    fn curve<const P: usize>(&self) -> Tabulated<P> {
        let shapes: [[f64; P]; 4] = self.shapes.each_ref().map(|shapes| std::array::from_fn(|a| shapes[a]));
        let reversed = |k: usize, sign: f64| std::array::from_fn(|a| sign * shapes[k][P - 1 - a]);
        // At the middle there is no room for the reversed one.
        let other = if self.xi == 0.0 { 1.0 } else { -self.xi };
        let others = [reversed(0, 1.0), reversed(1, -1.0), reversed(2, 1.0), reversed(3, -1.0)];
        Tabulated { at: [self.xi, other], shapes: [shapes, others] }
    }
}

/// Two beams at their closest point.
pub(super) struct TabulatedBeams<'a> {
    pub(super) beams: [Beam; 2],
    pub(super) point: &'a ClosestPoint,
    pub(super) contact: Contact,
}

/// Two curves with shape functions.
pub(super) type TabulatedPair<const P: usize, const R: usize, const N: usize, const M: usize> =
    Pair<Tabulated<P>, Tabulated<R>, N, M>;

impl TabulatedBeams<'_> {
    pub(super) fn pair<const P: usize, const R: usize, const N: usize, const M: usize>(
        &self,
    ) -> TabulatedPair<P, R, N, M> {
        let [beam, bar] = &self.beams;
        Pair { curve: beam.curve(), curve_bar: bar.curve(), contact: self.contact }
    }

    /// The dofs, for 0, or a direction.
    pub(super) fn vector<const N: usize, const M: usize>(&self, i: usize) -> DofVector<f64, N, M> {
        let [beam, bar] = &self.beams;
        DofVector { beam: beam.vector(i), bar: bar.vector(i) }
    }

    /// Both directions.
    pub(super) fn directions(&self) -> [Vec<f64>; 2] {
        let [beam, bar] = &self.beams;
        [1, 2].map(|i| [&beam.vectors[i][..], &bar.vectors[i]].concat())
    }
}

/// A pair that has the same d as another one, but for its unit of length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Image {
    /// Whether xi and xi_bar are reversed, with the order of the control vectors.
    pub(super) reversed: [bool; 2],
    /// The unit of length, a power of two, so that all scaling is exact.
    pub(super) unit: f64,
    /// The coordinate whose sign is changed.
    pub(super) mirrored: Option<usize>,
}

impl Image {
    /// The same image, with only those parameters reversed that are not zero.
    pub(super) fn at(self, point: &ClosestPoint) -> Self {
        let [reversed, reversed_bar] = self.reversed;
        Self { reversed: [reversed && point.xi != 0.0, reversed_bar && point.xi_bar != 0.0], ..self }
    }

    /// Dofs, or a direction.
    pub(super) fn vector<const N: usize, const M: usize>(
        self,
        v: &DofVector<f64, N, M>,
    ) -> DofVector<f64, N, M> {
        let sign = |i: usize| if self.mirrored == Some(i % 3) { -self.unit } else { self.unit };
        let [reversed, reversed_bar] = self.reversed;
        let from = |i: usize, dofs: usize, reversed: bool| {
            if reversed { dofs - 3 + 2 * (i % 3) - i } else { i }
        };
        DofVector {
            beam: SVector::from_fn(|i, _| sign(i) * v.beam[from(i, N, reversed)]),
            bar: SVector::from_fn(|i, _| sign(i) * v.bar[from(i, M, reversed_bar)]),
        }
    }

    pub(super) fn point(self, point: &ClosestPoint) -> ClosestPoint {
        let [reversed, reversed_bar] = self.reversed;
        let turned = |end: Option<End>| {
            end.map(|end| End {
                side: if end.side == Side::Upper { Side::Lower } else { Side::Upper },
                ..end
            })
        };
        let mut image = *point;
        image.distance *= self.unit;
        if reversed {
            (image.xi, image.end) = (-point.xi, turned(point.end));
        }
        if reversed_bar {
            (image.xi_bar, image.end_bar) = (-point.xi_bar, turned(point.end_bar));
        }
        image
    }
}

/// A pair of tabulated curves at a point.
pub(super) type AtPoint<'a, const P: usize, const R: usize, const N: usize, const M: usize> =
    PairAtPoint<'a, Tabulated<P>, Tabulated<R>, N, M>;
