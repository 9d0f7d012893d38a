//! The compared numbers of a draw, entry by entry.

use super::{Element, Sides};
use crate::check::serialized::by_name;
use crate::linearization::{COMPONENTS, Quantity, Varied};
use crate::number::PrimeField;
use crate::variant::SCALAR_COMPONENTS;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

enumeration! {
    /// The part of a quantity that is compared.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Layer {
        /// The value.
        Value => "value",
        /// delta and Delta.
        First => "first",
        /// Delta-delta.
        Second => "second",
        /// Gradient and Hessian, contracted with the directions.
        Matrix => "matrix",
        /// Value, gradient and Hessian by the kernel, contracted in the same way.
        Kernel => "kernel",
        /// R of a contact element, along the directions.
        Residual => "residual",
        /// K of a contact element, between the directions in both orders.
        Tangent => "tangent",
    }
}

by_name!(Layer);

/// One number of both sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry<T> {
    /// Its place among [`Quantities::components`](crate::linearization::Quantities::components).
    pub component: usize,
    /// The layer.
    pub layer: Layer,
    /// The code that is compared with AD: the equations, the matrices, the kernel in one of its layouts, or a contact
    /// element.
    pub candidate: &'static str,
    /// The part, by its name in [`Varied::PARTS`]; of a contact element, the directions.
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

    /// The axis, if the quantity is a vector.
    pub fn axis(&self) -> Option<char> {
        Quantity::axis_of_component(self.component)
    }
}

impl Entry<PrimeField> {
    /// Whether both sides have the same number.
    pub fn is_equal(&self) -> bool {
        self.closed == self.ad
    }

    /// Closed form over AD as numerator and denominator, if both are at most 1000. A wrong sign of the whole gives
    /// -1 / 1, a doubled result 2 / 1. None if AD has zero, or if the fault is in one term of several.
    pub fn ratio(&self) -> Option<(i64, u64)> {
        let zero = PrimeField::new(0);
        if self.ad == zero { None } else { (self.closed / self.ad).fraction(1000) }
    }
}

/// Residues are text: some readers of JSON cannot represent 61 bits.
impl Serialize for Entry<PrimeField> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut entry = serializer.serialize_struct("Entry", 9)?;
        entry.serialize_field("quantity", &self.quantity())?;
        entry.serialize_field("component", &self.axis())?;
        entry.serialize_field("layer", &self.layer)?;
        entry.serialize_field("candidate", self.candidate)?;
        entry.serialize_field("part", self.part)?;
        entry.serialize_field("closed", &self.closed.value().to_string())?;
        entry.serialize_field("ad", &self.ad.value().to_string())?;
        entry.serialize_field("equal", &self.is_equal())?;
        entry.serialize_field("ratio", &self.ratio())?;
        entry.end()
    }
}

/// The numbers of a contact element.
const ELEMENT: [(Layer, &str); 4] = [
    (Layer::Residual, "delta"),
    (Layer::Residual, "Delta"),
    (Layer::Tangent, "delta-Delta"),
    (Layer::Tangent, "Delta-delta"),
];

/// The entries that are compared, component by component, then the matrices, the kernel and the contact element.
pub(super) fn entries<T: Copy>(sides: &Sides<T>) -> Vec<Entry<T>> {
    const LAYERS: [Layer; 4] = [Layer::Value, Layer::First, Layer::First, Layer::Second];
    let mut entries = Vec::with_capacity(4 * COMPONENTS + 3 * SCALAR_COMPONENTS.len());
    for component in 0..COMPONENTS {
        let (closed, ad) = (sides.closed[component].parts(), sides.ad[component].parts());
        for (k, layer) in LAYERS.into_iter().enumerate() {
            let part = Varied::<T>::PARTS[k];
            let candidate = "equations";
            entries.push(Entry { component, layer, candidate, part, closed: closed[k], ad: ad[k] });
        }
    }
    for (&component, contracted) in SCALAR_COMPONENTS.iter().zip(sides.matrices.into_iter().flatten()) {
        let ad = sides.ad[component].parts();
        for (k, closed) in (1..).zip(contracted) {
            let part = Varied::<T>::PARTS[k];
            let (layer, candidate) = (Layer::Matrix, "matrices");
            entries.push(Entry { component, layer, candidate, part, closed, ad: ad[k] });
        }
    }
    for (candidate, contracted) in &sides.kernel {
        for (&component, numbers) in SCALAR_COMPONENTS.iter().zip(contracted) {
            let (layer, ad) = (Layer::Kernel, sides.ad[component].parts());
            let there = numbers.iter().enumerate().filter_map(|(k, &number)| Some((k, number?)));
            entries.extend(there.map(|(k, closed)| {
                let part = Varied::<T>::PARTS[k];
                Entry { component, layer, candidate, part, closed, ad: ad[k] }
            }));
        }
    }
    if let Some(Element { candidate, closed, ad }) = &sides.element {
        let component = Quantity::GN.component();
        entries.extend(ELEMENT.into_iter().enumerate().map(|(k, (layer, part))| Entry {
            component,
            layer,
            candidate,
            part,
            closed: closed[k],
            ad: ad[k],
        }));
    }
    entries
}
