//! One case through both linearizations, entry by entry.

use super::arbitration::DIFFERENCES;
use super::draw::{Case, turn};
use super::oracle::differences;
use super::site::Site;
use super::verdict::{Comparison, Inconclusive, Order, Verdict, is_decided};
use crate::closest_point::{ClosestPoint, ProjectionError, Search, closest_points};
use crate::linearization::ad::{evaluate, newton, stationary};
use crate::linearization::closed_form::{Frozen, Matrices, variations};
use crate::linearization::{COMPONENTS, Quantities, Quantity, Varied};
use crate::number::{Bounded, Magnitude};
use crate::pair::DofVector;
use num_dual::HyperDual64;

/// The routes of automatic differentiation.
const ROUTES: [&str; 3] = ["hyper-dual, Newton", "hyper-dual, stationary", "own hyper-dual, chord"];

/// Which oracles the closed form is compared with.
///
/// Where it disagrees with automatic differentiation the differences are always asked, to arbitrate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Oracles {
    /// Automatic differentiation.
    #[default]
    Ad,
    /// Also the differences in double-double: in every thirteenth case of each regime, which meets all pairs of
    /// families, and wherever the tolerance for AD means nothing.
    Sample,
    /// Also the differences in double-double, in every case.
    All,
}

impl Oracles {
    fn asks_differences(self, number: u64) -> bool {
        match self {
            Self::Ad => false,
            Self::Sample => turn(number).is_multiple_of(13),
            Self::All => true,
        }
    }
}

/// Compares a case with automatic differentiation at each of its closest points.
pub fn compare(case: &Case) -> Vec<(Option<ClosestPoint>, Verdict)> {
    compare_with(case, Oracles::Ad)
}

/// Compares a case with the oracles at each of its closest points.
pub fn compare_with(case: &Case, oracles: Oracles) -> Vec<(Option<ClosestPoint>, Verdict)> {
    let [beam, bar] = case.beams();
    let found = match closest_points(beam, bar, &Search::default()) {
        Ok(found) => found,
        Err(ProjectionError::ZeroTangent { .. }) => {
            return vec![(None, Verdict::Inconclusive(Inconclusive::ZeroTangent, Vec::new()))];
        }
        Err(_) => return vec![(None, Verdict::Inconclusive(Inconclusive::SearchFailed, Vec::new()))],
    };
    let mut verdicts: Vec<_> =
        found.minima.iter().map(|point| (Some(*point), at_point(case, point, oracles))).collect();
    if !found.unresolved.is_empty() || verdicts.is_empty() {
        verdicts.push((None, Verdict::Inconclusive(Inconclusive::Unresolved, Vec::new())));
    }
    verdicts
}

fn at_point(case: &Case, point: &ClosestPoint, oracles: Oracles) -> Verdict {
    let site = match Site::new(case, point) {
        Ok(site) => site,
        Err(reason) => return Verdict::Inconclusive(reason, Vec::new()),
    };
    let mut entries = entries(&site);
    let apart = |entries: &[Comparison]| entries.iter().any(|entry| entry.is_meaningful() && !entry.agrees());
    let unclear = oracles != Oracles::Ad && !is_decided(entries.iter());
    if apart(&entries) || unclear || oracles.asks_differences(case.number) {
        by_differences(&site, &mut entries);
    }
    if apart(&entries) {
        Verdict::Mismatch(entries)
    } else if is_decided(entries.iter()) {
        Verdict::Pass(entries)
    } else {
        Verdict::Inconclusive(Inconclusive::NotMeaningful, entries)
    }
}

/// Adds the comparisons with the differences, where they exist.
fn by_differences(site: &Site, entries: &mut Vec<Comparison>) {
    let Some(differences) = differences(site) else { return };
    // All components are compared with the first route, part by part.
    let first: Vec<_> = entries.iter().filter(|entry| entry.against == ROUTES[0]).copied().collect();
    let told = differences.into_iter().flat_map(Varied::parts);
    entries.extend(first.into_iter().zip(told).map(|(entry, told)| {
        let other = told.value.value();
        // Half an ulp for what is shown of the double-double.
        let tolerance = entry.bound + told.error + 0.5 * f64::EPSILON * other.abs();
        Comparison { against: DIFFERENCES, other, tolerance, ..entry }
    }));
}

/// The closed form's variations: in plain `f64`, the magnitudes of their terms, and with bounds.
struct Sides {
    closed: [Varied<f64>; COMPONENTS],
    scales: [Varied<Magnitude>; COMPONENTS],
    bounds: [Varied<Bounded>; COMPONENTS],
}

/// All comparisons at one closest point.
fn entries(site: &Site) -> Vec<Comparison> {
    let Site { beams: [beam, bar], contact, active, at: (xi, xi_bar), .. } = *site;
    let at = (xi.value, xi_bar.value);

    // The closed form: in plain f64, its terms' magnitudes, and with bounds.
    let plain = [beam.frozen_plain(at.0), bar.frozen_plain(at.1)];
    let closed = variations(&plain[0], &plain[1], at, active, contact).components();
    let exchanged = plain.map(Frozen::exchanged);
    let exchanged = variations(&exchanged[0], &exchanged[1], at, active, contact).components();
    let (scales, bounds) = (site.scales(&plain), site.closed(site.at));

    // Automatic differentiation: two routes of num-dual, and our own numbers with bounds.
    let by_newton = hyper_dual(site, newton(beam, bar, at, active));
    let by_stationarity = hyper_dual(site, stationary(beam, bar, at, active));
    // .. the former solve for the closest point in f64 again, and are as far off as that may take them.
    let by_chord = site.chord(site.at);
    let loose = [site.closed(site.loose), site.chord(site.loose)];

    let mut entries = Vec::with_capacity(16 * COMPONENTS);
    for i in 0..COMPONENTS {
        let (quantity, axis) = (Quantity::of_component(i), Quantity::axis_of_component(i));
        let closed = closed[i].parts();
        let scale = scales[i].parts().map(|scale| scale.scale);
        let bound = bounds[i].parts().map(|bounded| bounded.bound);
        let own = by_chord[i].parts();
        let routes = [by_newton[i].parts(), by_stationarity[i].parts(), own.map(|bounded| bounded.value)];
        let [of_closed, of_chord] = loose.map(|side| side[i].parts().map(|bounded| bounded.bound));
        let far: [f64; 4] = std::array::from_fn(|k| of_closed[k] + of_chord[k]);
        let near: [f64; 4] = std::array::from_fn(|k| bound[k] + own[k].bound);
        for ((against, other), tolerance) in ROUTES.into_iter().zip(routes).zip([far, far, near]) {
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
                    bound: bound[k],
                    tolerance: tolerance[k],
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
            bound: bound[3],
            tolerance: 2.0 * bound[3],
        });
    }
    matrices(site, &Sides { closed, scales, bounds }, &mut entries);
    entries
}

fn hyper_dual(site: &Site, lifted: (HyperDual64, HyperDual64)) -> [Varied<f64>; COMPONENTS] {
    let [beam, bar] = site.beams;
    let quantities: Quantities<HyperDual64> = evaluate(beam, bar, lifted, site.contact);
    quantities.map(Varied::from).components()
}

/// Gradient and Hessian of the scalar quantities, contracted with the directions, against the variations.
fn matrices(site: &Site, Sides { closed, scales, bounds }: &Sides, entries: &mut Vec<Comparison>) {
    let Site { beams, contact, active, at: (xi, xi_bar), .. } = *site;
    let (jet, [dq, linear_dq]) = beams[0].padded(xi);
    let (jet_bar, [dq_bar, linear_dq_bar]) = beams[1].padded(xi_bar);
    let dq = DofVector { beam: dq, bar: dq_bar };
    let linear_dq = DofVector { beam: linear_dq, bar: linear_dq_bar };
    let all = Matrices::new(&jet, &jet_bar, active).all((xi, xi_bar), contact);
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
                bound: bounds[i].parts()[k].bound,
                tolerance: bounds[i].parts()[k].bound + other.bound,
            });
        }
    }
}
