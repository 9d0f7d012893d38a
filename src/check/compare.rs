//! One case through both linearizations, entry by entry.

use super::draw::Case;
use super::witness;
use crate::closest_point::{ClosestPoint, Degeneracy, ProjectionError, Search, closest_points};
use crate::linearization::ad::{Chord, evaluate, newton, stationary};
use crate::linearization::closed_form::{Frozen, Matrices, variations};
use crate::linearization::{COMPONENTS, Quantities, Quantity, Varied};
use crate::number::{Bounded, HyperDual, Magnitude};
use crate::pair::DofVector;
use crate::specimen::AnyBeam;
use num_dual::HyperDual64;

/// Which part of a quantity is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Order {
    /// The value.
    Value,
    /// The first variations, delta and Delta.
    First,
    /// The second variation, Delta-delta.
    Second,
    /// Delta-delta against itself with the directions exchanged.
    Symmetry,
    /// Gradient and Hessian, contracted with the directions, against the variations.
    Matrix,
}

impl Order {
    /// All orders.
    pub const ALL: [Self; 5] = [Self::Value, Self::First, Self::Second, Self::Symmetry, Self::Matrix];

    /// The name, as tables have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Value => "value",
            Self::First => "first",
            Self::Second => "second",
            Self::Symmetry => "symmetry",
            Self::Matrix => "matrix",
        }
    }
}

/// One entry, as the two sides have it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// The quantity.
    pub quantity: Quantity,
    /// The component, of a vector.
    pub axis: Option<char>,
    /// Which part of it.
    pub order: Order,
    /// The same in the words of [`Varied::PARTS`], which tell the two first variations apart.
    pub part: &'static str,
    /// What it was compared with.
    pub against: &'static str,
    /// The closed form's number.
    pub closed: f64,
    /// The other number.
    pub other: f64,
    /// The sum of the absolute values of the closed form's terms.
    pub scale: f64,
    /// The largest difference that rounding explains.
    pub tolerance: f64,
}

impl Comparison {
    /// The absolute difference. What is not a number is infinitely far from everything.
    pub fn difference(&self) -> f64 {
        let error = (self.closed - self.other).abs();
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// The difference relative to the scale.
    pub fn scaled_error(&self) -> f64 {
        relative(self.difference(), self.scale)
    }

    /// The difference relative to the tolerance; above 1 the two disagree.
    pub fn over_tolerance(&self) -> f64 {
        relative(self.difference(), self.tolerance)
    }

    /// Whether the two agree. What is not a number agrees with nothing.
    pub fn agrees(&self) -> bool {
        self.over_tolerance() <= 1.0
    }

    /// Whether the tolerance is small enough to mean anything: below a thousandth of the scale.
    pub fn is_meaningful(&self) -> bool {
        (self.tolerance <= 1e-3 * self.scale && self.tolerance.is_finite()) || self.tolerance == 0.0
    }
}

fn relative(error: f64, to: f64) -> f64 {
    let ratio = error / to;
    match (error == 0.0, ratio.is_nan()) {
        (true, _) => 0.0,
        (false, true) => f64::INFINITY,
        (false, false) => ratio,
    }
}

/// Why a closest point, or a whole case, was not compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Inconclusive {
    /// The search ended in an error.
    SearchFailed,
    /// The search left regions open: the centroids are too nearly parallel to be resolved.
    Unresolved,
    /// D = 0 to rounding.
    Singular,
    /// d = 0 to rounding.
    Crossing,
    /// A tangent has no length.
    ZeroTangent,
    /// A parameter is just about to leave its end: a kink.
    WeakEnd,
    /// The projection is regular, but not over the region that the closest point is known to lie in.
    IllConditioned,
    /// Rounding explains differences of more than a thousandth of some scale.
    NotMeaningful,
}

impl Inconclusive {
    /// The reason in words.
    pub fn reason(self) -> &'static str {
        match self {
            Self::SearchFailed => "the search for closest points failed",
            Self::Unresolved => "nearly parallel: the search left regions open",
            Self::Singular => "singular: D = 0 to rounding",
            Self::Crossing => "crossing centroids: d = 0 to rounding",
            Self::ZeroTangent => "a tangent has no length",
            Self::WeakEnd => "kink: a parameter just leaves an end",
            Self::IllConditioned => "the closest point is not known well enough",
            Self::NotMeaningful => "the rounding bound exceeds 1e-3 of a scale",
        }
    }
}

/// What became of a closest point.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// All entries agree.
    Pass(Vec<Comparison>),
    /// Some do not.
    Mismatch(Vec<Comparison>),
    /// They could not be compared, or to no avail: then the entries show where.
    Inconclusive(Inconclusive, Vec<Comparison>),
}

/// Compares a case at each of its closest points.
pub fn compare(case: &Case) -> Vec<(Option<ClosestPoint>, Verdict)> {
    let [beam, bar] = case.beams.each_ref().map(|beam| &**beam);
    let found = match closest_points(beam, bar, &Search::default()) {
        Ok(found) => found,
        Err(ProjectionError::ZeroTangent { .. }) => {
            return vec![(None, Verdict::Inconclusive(Inconclusive::ZeroTangent, Vec::new()))];
        }
        Err(_) => return vec![(None, Verdict::Inconclusive(Inconclusive::SearchFailed, Vec::new()))],
    };
    let mut verdicts: Vec<_> =
        found.minima.iter().map(|point| (Some(*point), at_point(case, [beam, bar], point))).collect();
    if !found.unresolved.is_empty() || verdicts.is_empty() {
        verdicts.push((None, Verdict::Inconclusive(Inconclusive::Unresolved, Vec::new())));
    }
    verdicts
}

fn at_point(case: &Case, beams: [&dyn AnyBeam; 2], point: &ClosestPoint) -> Verdict {
    match point.degeneracy() {
        None => {}
        Some(Degeneracy::Crossing) => return Verdict::Inconclusive(Inconclusive::Crossing, Vec::new()),
        Some(Degeneracy::WeakEnd { .. }) => return Verdict::Inconclusive(Inconclusive::WeakEnd, Vec::new()),
        Some(Degeneracy::ZeroTangent { .. }) => {
            return Verdict::Inconclusive(Inconclusive::ZeroTangent, Vec::new());
        }
        Some(_) => return Verdict::Inconclusive(Inconclusive::Singular, Vec::new()),
    }
    let Some(at) = witness::parameters(beams, point) else {
        return Verdict::Inconclusive(Inconclusive::IllConditioned, Vec::new());
    };
    let entries = entries(case, beams, point, at);
    if entries.iter().any(|entry| entry.is_meaningful() && !entry.agrees()) {
        return Verdict::Mismatch(entries);
    }
    if entries.iter().all(Comparison::is_meaningful) {
        Verdict::Pass(entries)
    } else {
        Verdict::Inconclusive(Inconclusive::NotMeaningful, entries)
    }
}

/// The closed form's variations: in plain `f64`, the magnitudes of their terms, and with bounds.
struct Sides {
    closed: [Varied<f64>; COMPONENTS],
    scales: [Varied<Magnitude>; COMPONENTS],
    bounds: [Varied<Bounded>; COMPONENTS],
}

/// All comparisons at one closest point.
fn entries(
    case: &Case,
    beams: [&dyn AnyBeam; 2],
    point: &ClosestPoint,
    (xi, xi_bar): (Bounded, Bounded),
) -> Vec<Comparison> {
    let (active, contact) = (point.active(), &case.contact);
    let at = (point.xi, point.xi_bar);
    let [beam, bar] = beams;

    // The closed form: in plain f64, its terms' magnitudes, and with bounds.
    let plain = [beam.frozen_plain(at.0), bar.frozen_plain(at.1)];
    let closed = variations(&plain[0], &plain[1], at, active, contact).components();
    let exchanged = plain.map(Frozen::exchanged);
    let exchanged = variations(&exchanged[0], &exchanged[1], at, active, contact).components();
    let sizes = plain.map(|frozen| frozen.map(Magnitude::vector));
    let parameters = (Magnitude::parameter(at.0), Magnitude::parameter(at.1));
    let scales = variations(&sizes[0], &sizes[1], parameters, active, contact).components();
    let bounds =
        variations(&beam.frozen(xi), &bar.frozen(xi_bar), (xi, xi_bar), active, contact).components();

    // Automatic differentiation: two routes of num-dual, and our own numbers with bounds.
    let by_newton = hyper_dual(beams, newton(beam, bar, at, active), contact);
    let by_stationarity = hyper_dual(beams, stationary(beam, bar, at, active), contact);
    let chord = Chord::<Bounded>::new(beam, bar, (xi, xi_bar), active);
    let lifted = chord.lift::<HyperDual<Bounded>, _, _>(beam, bar, (xi, xi_bar), 2);
    let by_chord = evaluate::<HyperDual<Bounded>>(beam, bar, lifted, contact).map(Varied::from).components();

    let mut entries = Vec::with_capacity(16 * COMPONENTS);
    for i in 0..COMPONENTS {
        let (quantity, axis) = (Quantity::of_component(i), Quantity::axis_of_component(i));
        let closed = closed[i].parts();
        let scale = scales[i].parts().map(|scale| scale.scale);
        let bound = bounds[i].parts().map(|bounded| bounded.bound);
        let own = by_chord[i].parts();
        let routes = [
            ("hyper-dual, Newton", by_newton[i].parts()),
            ("hyper-dual, stationary", by_stationarity[i].parts()),
            ("own hyper-dual, chord", own.map(|bounded| bounded.value)),
        ];
        for (against, other) in routes {
            for (k, order) in
                [Order::Value, Order::First, Order::First, Order::Second].into_iter().enumerate()
            {
                entries.push(Comparison {
                    quantity,
                    axis,
                    order,
                    part: Varied::<f64>::PARTS[k],
                    against,
                    closed: closed[k],
                    other: other[k],
                    scale: scale[k],
                    tolerance: bound[k] + own[k].bound,
                });
            }
        }
        entries.push(Comparison {
            quantity,
            axis,
            order: Order::Symmetry,
            part: Varied::<f64>::PARTS[3],
            against: "itself, directions exchanged",
            closed: closed[3],
            other: exchanged[i].second,
            scale: scale[3],
            tolerance: 2.0 * bound[3],
        });
    }
    let at = Sides { closed, scales, bounds };
    matrices(case, beams, point, (xi, xi_bar), &at, &mut entries);
    entries
}

fn hyper_dual(
    [beam, bar]: [&dyn AnyBeam; 2],
    lifted: (HyperDual64, HyperDual64),
    contact: &crate::pair::Contact,
) -> [Varied<f64>; COMPONENTS] {
    let quantities: Quantities<HyperDual64> = evaluate(beam, bar, lifted, contact);
    quantities.map(Varied::from).components()
}

/// Gradient and Hessian of the scalar quantities, contracted with the directions, against the variations.
fn matrices(
    case: &Case,
    beams: [&dyn AnyBeam; 2],
    point: &ClosestPoint,
    (xi, xi_bar): (Bounded, Bounded),
    Sides { closed, scales, bounds }: &Sides,
    entries: &mut Vec<Comparison>,
) {
    let (jet, [dq, linear_dq]) = beams[0].padded(xi);
    let (jet_bar, [dq_bar, linear_dq_bar]) = beams[1].padded(xi_bar);
    let dq = DofVector { beam: dq, bar: dq_bar };
    let linear_dq = DofVector { beam: linear_dq, bar: linear_dq_bar };
    let all = Matrices::new(&jet, &jet_bar, point.active()).all((xi, xi_bar), &case.contact);
    let scalars = [
        (Quantity::D, &all.d),
        (Quantity::T, &all.t),
        (Quantity::TBar, &all.t_bar),
        (Quantity::Xi, &all.xi),
        (Quantity::XiBar, &all.xi_bar),
        (Quantity::GT, &all.g_t),
        (Quantity::GTBar, &all.g_t_bar),
    ];
    for (quantity, expansion) in scalars {
        let i = (0..COMPONENTS).find(|&i| Quantity::of_component(i) == quantity).unwrap_or(0);
        let contracted = [
            (1, expansion.gradient.along(&dq)),
            (2, expansion.gradient.along(&linear_dq)),
            (3, expansion.hessian.along(&dq, &linear_dq)),
        ];
        for (k, other) in contracted {
            entries.push(Comparison {
                quantity,
                axis: None,
                order: Order::Matrix,
                part: Varied::<f64>::PARTS[k],
                against: "gradient and Hessian, contracted",
                closed: closed[i].parts()[k],
                other: other.value,
                scale: scales[i].parts()[k].scale,
                tolerance: bounds[i].parts()[k].bound + other.bound,
            });
        }
    }
}
