//! One case through both linearizations, entry by entry.

use super::draw::Case;
use super::verdict::{Comparison, Inconclusive, Order, Verdict};
use super::witness;
use crate::closest_point::{ClosestPoint, Degeneracy, ProjectionError, Search, closest_points};
use crate::linearization::ad::{Chord, evaluate, newton, stationary};
use crate::linearization::closed_form::{Frozen, Matrices, variations};
use crate::linearization::{COMPONENTS, Quantities, Quantity, Varied};
use crate::number::{Bounded, HyperDual, Magnitude};
use crate::pair::{Contact, DofVector};
use crate::specimen::AnyBeam;
use num_dual::HyperDual64;

/// A verdict for each closest point, and one without a point if there is none or there may be more.
pub type Compared = Vec<(Option<ClosestPoint>, Verdict)>;

/// Compares a case at each of its closest points.
pub fn compare(case: &Case) -> Compared {
    compare_beams(&case.beams, &case.contact)
}

pub(super) fn compare_beams(beams: &[Box<dyn AnyBeam>; 2], contact: &Contact) -> Compared {
    let [beam, bar] = beams.each_ref().map(|beam| &**beam);
    let found = match closest_points(beam, bar, &Search::default()) {
        Ok(found) => found,
        Err(ProjectionError::ZeroTangent { .. }) => {
            return vec![(None, Verdict::Inconclusive(Inconclusive::ZeroTangent, Vec::new()))];
        }
        Err(_) => return vec![(None, Verdict::Inconclusive(Inconclusive::SearchFailed, Vec::new()))],
    };
    let mut verdicts: Vec<_> =
        found.minima.iter().map(|point| (Some(*point), at_point(contact, [beam, bar], point))).collect();
    if !found.unresolved.is_empty() || verdicts.is_empty() {
        verdicts.push((None, Verdict::Inconclusive(Inconclusive::Unresolved, Vec::new())));
    }
    verdicts
}

fn at_point(contact: &Contact, beams: [&dyn AnyBeam; 2], point: &ClosestPoint) -> Verdict {
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
    let entries = entries(contact, beams, point, at);
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
    contact: &Contact,
    beams: [&dyn AnyBeam; 2],
    point: &ClosestPoint,
    (xi, xi_bar): (Bounded, Bounded),
) -> Vec<Comparison> {
    let active = point.active();
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
    matrices(contact, beams, point, (xi, xi_bar), &at, &mut entries);
    entries
}

fn hyper_dual(
    [beam, bar]: [&dyn AnyBeam; 2],
    lifted: (HyperDual64, HyperDual64),
    contact: &Contact,
) -> [Varied<f64>; COMPONENTS] {
    let quantities: Quantities<HyperDual64> = evaluate(beam, bar, lifted, contact);
    quantities.map(Varied::from).components()
}

/// Gradient and Hessian of the scalar quantities, contracted with the directions, against the variations.
fn matrices(
    contact: &Contact,
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
    let all = Matrices::new(&jet, &jet_bar, point.active()).all((xi, xi_bar), contact);
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
