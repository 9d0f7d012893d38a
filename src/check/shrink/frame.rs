//! A case in its own unit and axes.

use super::super::CaseData;
use crate::closest_point::{Search, closest_points};
use crate::test_beam::TestBeam;
use nalgebra::{Matrix3, Quaternion, Rotation3, UnitQuaternion, Vector3};

/// The same pair in another unit of length, by a power of two: the longer tangent is between one and two.
pub(super) fn near_one(case: &CaseData) -> Option<CaseData> {
    let beams = case.beams().ok()?;
    let found = closest_points(&*beams[0], &*beams[1], &Search::default()).ok()?;
    let point = found.minima.first()?;
    let (t, t_bar) = (beams[0].geometry(point.xi).t, beams[1].geometry(point.xi_bar).t);
    let longest = t.norm().max(t_bar.norm());
    #[expect(clippy::cast_possible_truncation, reason = "an exponent of f64 is below 1100")]
    let power = longest.log2().floor() as i32;
    longest.is_normal().then(|| case.scaled(-power))
}

/// The same pair with t along the first axis, t x t_bar along the third, and x_bar at one on the first.
///
/// At the origin it would have no size as a scale for differences.
pub(super) fn framed(case: &CaseData) -> Option<CaseData> {
    let beams = case.beams().ok()?;
    let found = closest_points(&*beams[0], &*beams[1], &Search::default()).ok()?;
    let point = found.minima.first()?;
    let (x, x_bar) = (beams[0].geometry(point.xi), beams[1].geometry(point.xi_bar));
    let first = x.t.try_normalize(0.0)?;
    let third = x.t.cross(&x_bar.t).try_normalize(0.0)?;
    let rotation = Matrix3::from_rows(&[first, third.cross(&first), third].map(|axis| axis.transpose()));
    let mut framed = case.clone();
    for test_beam in &mut framed.test_beams {
        test_beam.translate(&-x_bar.x);
        turn(test_beam, &rotation);
        test_beam.translate(&Vector3::x());
    }
    Some(framed)
}

/// Turns a beam and its directions about the origin.
fn turn(test_beam: &mut TestBeam, rotation: &Matrix3<f64>) {
    let quaternion = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(*rotation));
    let family = test_beam.family;
    for numbers in [&mut test_beam.q, &mut test_beam.dq, &mut test_beam.linear_dq] {
        for start in family.vectors() {
            let vector = rotation * Vector3::from_column_slice(&numbers[start..start + 3]);
            numbers[start..start + 3].copy_from_slice(vector.as_slice());
        }
        if let Some(start) = family.quaternion() {
            // The product of two quaternions is one rotation after the other, and is linear in either.
            let [w, i, j, k] = [0, 1, 2, 3].map(|part| numbers[start + part]);
            let turned = quaternion.into_inner() * Quaternion::new(w, i, j, k);
            numbers[start..start + 4].copy_from_slice(&[turned.w, turned.i, turned.j, turned.k]);
        }
    }
}
