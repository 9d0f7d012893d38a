//! The possible errors of a program: a term, several terms, a simplification as a whole, a factor.

use super::element::Element;
use super::wording::{mistakes, names, of_fault, of_label, words};
use crate::check::evaluation_point::{Structure, Summand};
use crate::check::external::conventions::{Conventions, ENERGY};
use crate::check::verdict::Order;
use crate::linearization::{Quantity, Varied};
use crate::variant::Variant;

/// A summand of a Hessian with its coefficient in the deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct WrongSummand {
    /// Its index among all summands.
    pub(super) index: usize,
    pub(super) summand: Summand,
    /// The coefficient of one occurrence: -1 if one is missing.
    pub(super) coefficient: f64,
}

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
    /// Some summands of the Hessians.
    Summands(Vec<WrongSummand>),
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
            Self::Variant(_) | Self::Structure(_) | Self::Summands(_) => {}
            Self::Factor(quantity, order, factor) => {
                let items = all.len();
                for (i, of) in all.iter_mut().enumerate() {
                    let is_of = if i < items - 1 { Quantity::of_component(i) == quantity } else { false };
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
        match self {
            Self::Variant(Variant::Faulty(faults)) => faults.len() > 1,
            Self::Summands(wrong) => mistakes(wrong) > 1,
            _ => false,
        }
    }

    /// Whether a term has a factor that is none of common errors.
    pub(super) fn has_free_factor(&self) -> bool {
        match self {
            Self::Variant(Variant::Weighted(..)) => true,
            Self::Summands(wrong) => wrong.iter().any(WrongSummand::has_free_factor),
            _ => false,
        }
    }

    /// The complexity: simpler explanations come first.
    pub(super) fn class(&self) -> usize {
        match self {
            Self::Variant(Variant::Faulty(faults)) if faults.len() == 1 => 0,
            Self::Structure(_) | Self::BeamsExchanged => 1,
            Self::Element(element) => element.class(),
            Self::Factor(..) => 2,
            Self::Variant(Variant::Weighted(..)) => 3,
            Self::Summands(wrong) => 2 + mistakes(wrong),
            Self::Variant(_) => 4,
        }
    }

    /// The name: that of the fault in the catalogue, if it is one.
    pub(super) fn name(&self) -> String {
        match self {
            Self::Variant(Variant::Faulty(faults)) => {
                faults.iter().map(ToString::to_string).collect::<Vec<_>>().join(" and ")
            }
            Self::Variant(Variant::Weighted(label, factor)) => format!("{label} = times {factor:.6}"),
            Self::Variant(_) => "unmodified".into(),
            Self::Structure(Structure::FixedParameters) => "fixed-parameters".into(),
            Self::Structure(Structure::Straight) => "straight".into(),
            Self::Structure(Structure::LinearInDofs) => "linear-in-dofs".into(),
            Self::Factor(quantity, order, factor) => {
                format!("{} of {} = times {factor:.6}", order.name(), quantity.name())
            }
            Self::Element(element) => element.name(),
            Self::BeamsExchanged => "beams-exchanged".into(),
            Self::Summands(wrong) => names(wrong),
        }
    }

    /// What is wrong, as a sentence without its full stop.
    pub(super) fn words(&self) -> String {
        match self {
            Self::Variant(Variant::Faulty(faults)) => {
                faults.iter().map(of_fault).collect::<Vec<_>>().join("; and ")
            }
            Self::Variant(Variant::Weighted(label, factor)) => {
                format!("{} is multiplied by {factor:.6}", of_label(label))
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
            Self::Summands(wrong) => words(wrong),
        }
    }
}
