//! Compares the oracle's numbers and estimates with the closed form in double-double.

use super::{Estimated, differences};
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::{Case, Regime, Selection};
use crate::closest_point::{Search, closest_points};
use crate::linearization::{COMPONENTS, Quantity, Varied};
use crate::number::DoubleDouble;
use crate::parallel;

/// One entry: its name, the oracle's number, the true number, and the closed form's own bound.
type Entry = (Quantity, &'static str, Estimated, DoubleDouble, f64);

/// All entries at the closest points of a case.
fn entries(number: u64) -> Vec<Entry> {
    let case = Case::draw(0xdd, number);
    let [beam, bar] = case.beams();
    // The search may fail for badly scaled beams.
    let Ok(found) = closest_points(beam, bar, &Search::default()) else { return Vec::new() };
    let minima = found.minima;
    let mut entries = Vec::new();
    for evaluation in
        minima.iter().filter_map(|point| EvaluationPoint::new([beam, bar], &case.contact, point).ok())
    {
        let (Some(precise), Some(oracle)) = (evaluation.precise(), differences(&evaluation)) else {
            continue;
        };
        let closed = evaluation.closed(&crate::variant::Variant::Unmodified);
        for i in 0..COMPONENTS {
            for (k, part) in Varied::<f64>::PARTS.into_iter().enumerate() {
                let (told, truth) = (oracle[i].parts()[k], precise[i].parts()[k]);
                entries.push((Quantity::of_component(i), part, told, truth, closed[i].parts()[k].bound[0]));
            }
        }
    }
    entries
}

#[test]
fn estimates_are_honest_and_below_the_bounds_of_f64() {
    for regime in Regime::ALL {
        let numbers = Selection { regimes: vec![regime], family: None, cases: 121 }.numbers();
        let entries: Vec<Entry> = parallel::flat_map(&numbers, |&number| entries(number));
        let (mut sharp, mut all) = (0, 0);
        // A stencil that is too wide for a badly scaled curve is not detected. There the estimate may be too small by
        // a factor of up to four.
        let most = if regime == Regime::BadlyScaled { 4.0 } else { 1.0 };
        for (quantity, part, told, truth, bound) in entries {
            let error = (told.value - truth).abs().value();
            assert!(error <= most * told.error, "{regime:?} {part} of {quantity:?}: {error:e}, not {told:?}");
            // d'' contains 1/d, and rounding over h² with a step that must be well below d.
            if bound > 0.0 && !(regime == Regime::NearlyCrossing && part == "Delta-delta") {
                sharp += u32::from(told.error <= bound);
                all += 1;
            }
        }
        assert!(all > 7000 && f64::from(sharp) >= 0.9 * f64::from(all), "{regime:?}: {sharp} of {all}");
    }
}
