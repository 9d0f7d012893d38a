//! The wrong parts of a contact element that fit its answers best.

use super::answered_case::AnsweredCase;
use super::datum::Datum;
use super::element::{CORRECT, material};
use super::hypothesis::Change;
use crate::check::external::conventions::ENERGY;

/// The factors of missing, doubled, halved parts and wrong signs. Fitted factors near them are replaced.
const COMMON: [f64; 6] = [0.0, 1.0, -1.0, 2.0, 0.5, -2.0];
/// The number of numbers of a part below which its factor is not fitted.
const FEW: usize = 3;

/// The factors that fit the residuals and the tangents best.
pub(super) fn elements(cases: &[&AnsweredCase]) -> Vec<Change> {
    // Sums of squares and products: of the residual, and of both parts of the tangent.
    let (mut residual, mut tangent) = ([0.0; 2], [0.0; 5]);
    let mut counts = [0; 2];
    for case in cases {
        for datum in &case.data {
            let [item, part] = datum.place;
            let weight = datum.scale.powi(-2);
            if item != ENERGY || !datum.answer.is_finite() || !weight.is_finite() {
                continue;
            }
            let Datum { answer, reference, .. } = *datum;
            if part < 3 {
                counts[0] += usize::from(reference != 0.0);
                residual[0] += weight * answer * reference;
                residual[1] += weight * reference * reference;
            } else if let Some(material) = material(reference, case.gap_gradients(), &case.conventions) {
                counts[1] += usize::from(reference != 0.0);
                let geometric = reference - material;
                let products = [
                    material * material,
                    material * geometric,
                    geometric * geometric,
                    answer * material,
                    answer * geometric,
                ];
                for (sum, product) in tangent.iter_mut().zip(products) {
                    *sum += weight * product;
                }
            }
        }
    }
    let common = |factor: f64| {
        COMMON
            .into_iter()
            .find(|common| (factor - common).abs() <= 1e-3 * factor.abs().max(1.0))
            .unwrap_or(factor)
    };
    let mut found = CORRECT;
    if counts[0] >= FEW {
        found.residual = common(residual[0] / residual[1]);
    }
    if counts[1] >= FEW {
        let [aa, ab, bb, ya, yb] = tangent;
        let det = aa * bb - ab * ab;
        found.material = common((ya * bb - yb * ab) / det);
        found.geometric = common((yb * aa - ya * ab) / det);
    }
    let is_finite = found.residual.is_finite() && found.material.is_finite() && found.geometric.is_finite();
    let is_changed = is_finite && found.factors().next().is_some();
    is_changed.then_some(Change::Element(found)).into_iter().collect()
}
