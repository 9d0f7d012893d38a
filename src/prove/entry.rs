//! What is compared in a draw, entry by entry.

use super::Sides;
use crate::linearization::{COMPONENTS, Quantity, Varied};
use crate::number::Residue;
use crate::subject::SCALAR_COMPONENTS;

/// What is compared of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Layer {
    /// The value.
    Value,
    /// delta and Delta.
    First,
    /// Delta-delta.
    Second,
    /// Gradient and Hessian, contracted with the directions.
    Matrix,
}

impl Layer {
    /// All layers.
    pub const ALL: [Self; 4] = [Self::Value, Self::First, Self::Second, Self::Matrix];

    /// The name, as tables have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Value => "value",
            Self::First => "first",
            Self::Second => "second",
            Self::Matrix => "matrix",
        }
    }
}

/// One number, as the two sides have it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry<T> {
    /// Its place among [`Quantities::components`](crate::linearization::Quantities::components).
    pub component: usize,
    /// The layer.
    pub layer: Layer,
    /// The part, in the words of [`Varied::PARTS`].
    pub part: &'static str,
    /// The closed form's number.
    pub closed: T,
    /// The number of automatic differentiation.
    pub ad: T,
}

impl<T> Entry<T> {
    /// The quantity.
    pub fn quantity(&self) -> Quantity {
        Quantity::of_component(self.component)
    }

    /// The axis, of a vector.
    pub fn axis(&self) -> Option<char> {
        Quantity::axis_of_component(self.component)
    }
}

impl Entry<Residue> {
    /// Whether both sides have the same number.
    pub fn is_equal(&self) -> bool {
        self.closed == self.ad
    }

    /// Closed form over AD as numerator and denominator, if both are at most 1000: a wrong sign of the whole makes it
    /// -1 / 1, a doubled result 2 / 1. None if AD has nought, or if the fault is in one term of several.
    pub fn ratio(&self) -> Option<(i64, u64)> {
        let nought = Residue::new(0);
        if self.ad == nought { None } else { (self.closed / self.ad).fraction(1000) }
    }
}

/// The entries that are compared, component by component, then the matrices.
pub(super) fn entries<T: Copy>(sides: &Sides<T>) -> Vec<Entry<T>> {
    const LAYERS: [Layer; 4] = [Layer::Value, Layer::First, Layer::First, Layer::Second];
    let mut entries = Vec::with_capacity(4 * COMPONENTS + 3 * SCALAR_COMPONENTS.len());
    for component in 0..COMPONENTS {
        let (closed, ad) = (sides.closed[component].parts(), sides.ad[component].parts());
        for (k, layer) in LAYERS.into_iter().enumerate() {
            let part = Varied::<T>::PARTS[k];
            entries.push(Entry { component, layer, part, closed: closed[k], ad: ad[k] });
        }
    }
    for (&component, contracted) in SCALAR_COMPONENTS.iter().zip(sides.matrices.into_iter().flatten()) {
        let ad = sides.ad[component].parts();
        for (k, closed) in (1..).zip(contracted) {
            let part = Varied::<T>::PARTS[k];
            entries.push(Entry { component, layer: Layer::Matrix, part, closed, ad: ad[k] });
        }
    }
    entries
}
