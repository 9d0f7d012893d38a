//! The exact check: the closed form against AD over the prime field.

use crate::linearization::{COMPONENTS, Varied};
use crate::number::PrimeField;
use crate::prove::differentiated;
use crate::variant::{CONTACT, Point, SCALAR_COMPONENTS, Variant};

/// Stationary points with the results of AD.
pub(super) struct Exact(Vec<(Point, [Varied<PrimeField>; COMPONENTS])>);

impl Exact {
    pub(super) fn new() -> Self {
        let with_ad = |point: Point| {
            let beams = point.beams.each_ref().map(|beam| &**beam);
            let ad = differentiated(beams, point.at, point.form.held, &CONTACT);
            (point, ad)
        };
        Self(Point::all().into_iter().map(with_ad).collect())
    }

    /// Whether some number differs.
    pub(super) fn rejects(&self, variant: &Variant) -> bool {
        self.0.iter().any(|(point, ad)| {
            let (variations, matrices) = point.results(variant);
            let of_ad = |i: usize| ad[i].parts();
            let unequal = |(i, closed): (usize, &Varied<PrimeField>)| closed.parts() != of_ad(i);
            let apart = |(&i, matrix): (&usize, &[PrimeField; 3])| matrix[..] != of_ad(i)[1..];
            variations.iter().enumerate().any(unequal) || SCALAR_COMPONENTS.iter().zip(&matrices).any(apart)
        })
    }
}
