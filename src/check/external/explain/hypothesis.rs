//! The possible errors of a program: a term, several terms, a simplification as a whole, a factor.

use super::element::Element;
use super::wording::of_fault;
use crate::check::evaluation_point::Structure;
use crate::check::external::conventions::{Conventions, ENERGY};
use crate::check::verdict::Order;
use crate::linearization::{COMPONENTS, Quantity, Varied};
use crate::variant::{Fault, Kind, Variant, labels};

/// The change in the closed form.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Change {
    /// Some of its terms.
    Variant(Variant),
    /// It is simplified as a whole.
    Structure(Structure),
    /// A quantity is multiplied, in this order.
    Factor(Quantity, Order, f64),
    /// Parts of the contact element are multiplied.
    Element(Element),
    /// Beam and bar beam are exchanged.
    BeamsExchanged,
}

impl Change {
    /// Applies changes of whole items, after the conventions. `varied` is before the conventions.
    pub(super) fn of_items(
        &self,
        all: &mut [Varied<f64>],
        varied: &[Varied<f64>],
        conventions: &Conventions,
    ) {
        match *self {
            Self::Variant(_) | Self::Structure(_) => {}
            Self::Factor(quantity, order, factor) => {
                for (i, of) in all.iter_mut().enumerate().take(COMPONENTS) {
                    let is_of = Quantity::of_component(i) == quantity;
                    if is_of && order == Order::First {
                        (of.delta, of.linear) = (factor * of.delta, factor * of.linear);
                    } else if is_of && order == Order::Second {
                        of.second *= factor;
                    } else if is_of {
                        of.value *= factor;
                    }
                }
            }
            Self::Element(element) => {
                element.apply(&mut all[ENERGY], &varied[Quantity::GN.component()], conventions);
            }
            Self::BeamsExchanged => {
                for axis in 0..3 {
                    for [beam, bar] in [Quantity::POINTS, Quantity::TANGENTS] {
                        all.swap(beam.component() + axis, bar.component() + axis);
                    }
                    let d = &mut all[Quantity::DVector.component() + axis];
                    *d = Varied { value: -d.value, delta: -d.delta, linear: -d.linear, second: -d.second };
                }
                for [beam, bar] in [Quantity::LENGTHS, Quantity::PARAMETERS, Quantity::SLIPS] {
                    all.swap(beam.component(), bar.component());
                }
            }
        }
    }

    /// Whether nothing is changed.
    pub(super) fn is_none(&self) -> bool {
        matches!(self, Self::Variant(Variant::Unmodified))
    }

    /// Whether two terms are changed.
    pub(super) fn has_two_faults(&self) -> bool {
        matches!(self, Self::Variant(Variant::Faulty(faults)) if faults.len() > 1)
    }

    /// The complexity: simpler explanations come first.
    pub(super) fn class(&self) -> usize {
        match self {
            Self::Variant(_) if self.has_two_faults() => 3,
            Self::Variant(_) => 0,
            Self::Structure(_) | Self::BeamsExchanged => 1,
            Self::Element(element) => element.class(),
            Self::Factor(..) => 2,
        }
    }

    /// The name: that of the fault in the catalogue, if it is one.
    pub(super) fn name(&self) -> String {
        match self {
            Self::Variant(Variant::Faulty(faults)) => {
                faults.iter().map(ToString::to_string).collect::<Vec<_>>().join(" and ")
            }
            Self::Variant(_) => "unmodified".into(),
            Self::Structure(Structure::FixedParameters) => "fixed-parameters".into(),
            Self::Structure(Structure::Straight) => "straight".into(),
            Self::Structure(Structure::LinearInDofs) => "linear-in-dofs".into(),
            Self::Factor(quantity, order, factor) => {
                format!("{} of {} = times {factor:.6}", order.name(), quantity.name())
            }
            Self::Element(element) => element.name(),
            Self::BeamsExchanged => "beams-exchanged".into(),
        }
    }

    /// What is wrong, as a sentence without its full stop.
    pub(super) fn words(&self) -> String {
        match self {
            Self::Variant(Variant::Faulty(faults)) => {
                faults.iter().map(of_fault).collect::<Vec<_>>().join("; and ")
            }
            Self::Variant(_) => "nothing is wrong".into(),
            Self::Structure(Structure::FixedParameters) => {
                "the parameters of the closest point are held fixed: delta xi and delta xi_bar, eq. (52), are missing"
                    .into()
            }
            Self::Structure(Structure::Straight) => {
                "the curves are taken for straight: all terms in t,xi, t,xixi and u,xixi are missing, such as d.t,xi of \
                 eq. (50)"
                    .into()
            }
            Self::Structure(Structure::LinearInDofs) => {
                "the curves are taken for linear in their dofs: the terms Delta_u delta_u u are missing, eq. (27), (30), \
                 (40) and (54)"
                    .into()
            }
            Self::Factor(quantity, order, factor) => {
                let of = match order {
                    Order::Value => "the value",
                    Order::First => "the first variation",
                    _ => "the second variation",
                };
                format!("{of} of {} as a whole is multiplied by {factor:.6}", quantity.name())
            }
            Self::Element(element) => element.words(),
            Self::BeamsExchanged => "beam and bar beam are exchanged".into(),
        }
    }
}

/// Every fault of every term.
pub(super) fn singles() -> Vec<Fault> {
    labels().into_iter().flat_map(|label| Kind::ALL.map(|kind| Fault { label, kind })).collect()
}

pub(super) fn of_faults(faults: &[Fault]) -> Change {
    Change::Variant(Variant::Faulty(faults.to_vec()))
}
