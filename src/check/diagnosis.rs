//! The identity of a mismatch: the first wrong number in the order in which numbers are computed.

use super::verdict::{Comparison, Order, Verdict};
use crate::closest_point::{ClosestPoint, Held};
use crate::linearization::Quantity;

/// The identity of a mismatch, in a few words.
///
/// A number that is computed from a wrong number is wrong too, so only the first wrong number counts. The order is:
/// values, first variations, second variations, matrices. Within an order, the parameters come before the
/// vectors, the vectors before the lengths, and the slips last. A case that is shrunk step by step
/// must keep all of this, or it ends in another fault: the same first number, wrong against the same
/// references, at a closest point with the same ends held. The number of later wrong numbers may change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnosis {
    /// The order of the first wrong number.
    pub order: Order,
    /// Its quantity.
    pub quantity: Quantity,
    /// Its part, with the names of [`Varied::PARTS`](crate::linearization::Varied::PARTS).
    pub part: &'static str,
    /// All references that it does not agree with.
    pub against: Vec<&'static str>,
    /// Which parameters are held at an end.
    pub held: Held,
}

/// A diagnosis and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// What is wrong.
    pub diagnosis: Diagnosis,
    /// The index of the closest point among the minima.
    pub minimum: usize,
    /// The closest point.
    pub point: ClosestPoint,
    /// The first wrong number.
    pub entry: Comparison,
    /// Whether all numbers at this point can be compared, so that the case passes after the correction.
    pub is_clear: bool,
}

impl Finding {
    /// The diagnosis of a comparison, if something does not agree.
    pub fn of(compared: &[(Option<ClosestPoint>, Verdict)]) -> Option<Self> {
        let wrong = compared.iter().enumerate().filter_map(|(minimum, (point, verdict))| match verdict {
            Verdict::Mismatch(entries) => Some((minimum, (*point)?, first(entries)?, entries)),
            Verdict::Pass(_) | Verdict::Inconclusive(..) => None,
        });
        let (minimum, point, entry, entries) = wrong.min_by_key(|(_, _, entry, _)| place(entry))?;
        let same = |other: &&Comparison| other.is_wrong() && place(other) == place(&entry);
        let mut against: Vec<_> = entries.iter().filter(same).map(|entry| entry.against).collect();
        against.sort_unstable();
        against.dedup();
        let Comparison { order, quantity, part, .. } = entry;
        let diagnosis = Diagnosis { order, quantity, part, against, held: point.held() };
        let is_clear = entries.iter().all(Comparison::is_meaningful);
        Some(Self { diagnosis, minimum, point, entry, is_clear })
    }
}

/// The layer of the library that is wrong if the first wrong number is of this order, in words.
pub fn layer(order: Order) -> &'static str {
    match order {
        Order::Value => "the curves or the definitions: values are wrong",
        Order::First | Order::Second | Order::Symmetry => {
            "the equations, or the jets of the curves: all values agree"
        }
        Order::Matrix => "the matrices: all equations agree",
        Order::Function => "this function or the kernel: all equations and matrices agree",
    }
}

/// The equations of the paper to look at if this is the first wrong number.
pub fn look_at(order: Order, quantity: Quantity) -> &'static str {
    match (order, quantity) {
        (Order::First, Quantity::Xi | Quantity::XiBar) => "the 2 x 2 system, eq. (50)-(52)",
        (Order::Second, Quantity::Xi | Quantity::XiBar) => {
            "the 2 x 2 system once more, eq. (53)-(56) and (59)"
        }
        (Order::First, Quantity::D | Quantity::GN) => "delta d = n . delta u, eq. (37)",
        (Order::Second, Quantity::D | Quantity::GN) => "eq. (40) and (57)",
        (Order::First, Quantity::T | Quantity::TBar) => "eq. (41)",
        (Order::Second, Quantity::T | Quantity::TBar) => "eq. (42) and (58)",
        (Order::First, Quantity::GT | Quantity::GTBar) => "eq. (20)",
        (Order::Second, Quantity::GT | Quantity::GTBar) => "eq. (21)",
        (Order::First, _) => "the variation of the curve, eq. (24) and (28)",
        (Order::Second, _) => "eq. (26), (27) and (30)-(32)",
        (Order::Symmetry, _) => "terms with delta and Delta exchanged",
        (Order::Matrix, _) => "the step from variations to matrices",
        (Order::Function, _) => "the function itself: equations and matrices agree",
        (Order::Value, _) => "its definition",
    }
}

fn first(entries: &[Comparison]) -> Option<Comparison> {
    entries.iter().filter(|entry| entry.is_wrong()).min_by_key(|entry| place(entry)).copied()
}

/// The place of a number in the order of computation. Components of a vector share one, as the axes are arbitrary.
pub(super) fn place(entry: &Comparison) -> (Order, usize, usize) {
    const QUANTITIES: [Quantity; 13] = [
        Quantity::Xi,
        Quantity::XiBar,
        Quantity::X,
        Quantity::XBar,
        Quantity::DVector,
        Quantity::TVector,
        Quantity::TBarVector,
        Quantity::D,
        Quantity::T,
        Quantity::TBar,
        Quantity::GN,
        Quantity::GT,
        Quantity::GTBar,
    ];
    let quantity = QUANTITIES.iter().position(|&quantity| quantity == entry.quantity);
    let part = crate::linearization::Varied::<f64>::PARTS.iter().position(|&part| part == entry.part);
    (entry.order, quantity.unwrap_or(QUANTITIES.len()), part.unwrap_or(0))
}
