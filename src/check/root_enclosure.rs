//! The parameters of a closest point, with bounds on their distance from the exact closest point.

use crate::closest_point::ClosestPoint;
use crate::curve::Geometry;
use crate::linearization::closed_form::Projection;
use crate::number::RunningError;
use crate::test_beam::AnyBeam;

/// xi and xi_bar with bounds, from the residual of the orthogonality conditions.
///
/// The residual and its rounding, multiplied by the inverse of the projection matrix, bound the step to the exact
/// closest point. The matrix must stay regular over the whole uncertain region. Nothing if it does not.
pub(super) fn parameters(
    beams: [&dyn AnyBeam; 2],
    point: &ClosestPoint,
) -> Option<(RunningError, RunningError)> {
    let held = point.held();
    let geometry = |xi, xi_bar| [beams[0].geometry_at(xi), beams[1].geometry_at(xi_bar)];
    let centre = geometry(point.xi.into(), point.xi_bar.into());
    // The residual is taken at the given parameters, the matrix over the region in which the exact ones may be.
    let d = centre[0].x - centre[1].x;
    let residual = [d.dot(&centre[0].t), d.dot(&centre[1].t)].map(|f| f.value.abs() + f.bound);
    let steps = |[x, x_bar]: [Geometry<RunningError>; 2]| {
        Projection::new(&x, &x_bar, held).inverse().map(|row| {
            row.into_iter().zip(residual).map(|(entry, f)| (entry.value.abs() + entry.bound) * f).sum::<f64>()
        })
    };
    // The region is guessed as twice the step from the matrix at its centre. It must contain the step that it yields.
    let [guess, guess_bar] = steps(centre).map(|step| 2.0 * step);
    let (xi, xi_bar) = (RunningError::new(point.xi, guess), RunningError::new(point.xi_bar, guess_bar));
    let [step, step_bar] = steps(geometry(xi, xi_bar));
    (step <= guess && step_bar <= guess_bar).then_some((xi, xi_bar))
}

#[cfg(test)]
mod tests {
    use super::parameters;
    use crate::closest_point::{Search, closest_points};
    use crate::test_beam::{AnyBeam, Family, TestBeam};

    /// Two straight beams of half-lengths 2 and 1/4 under the angle whose cosine is 0.6, closest at their centres.
    fn straight() -> [Box<dyn AnyBeam>; 2] {
        [[2.0, 0.0, 0.0], [0.15, 0.2, 0.0]].map(|t: [f64; 3]| {
            let z = if t[1] == 0.0 { 0.0 } else { 1.0 };
            let q = vec![3.0 - t[0], 4.0 - t[1], z, 3.0 + t[0], 4.0 + t[1], z];
            let none = vec![0.0; 6];
            let segment = TestBeam {
                family: Family::Segment,
                parameters: Vec::new(),
                q,
                dq: none.clone(),
                linear_dq: none,
            };
            segment.drawn()
        })
    }

    #[test]
    fn bounds_hold_the_distance_to_the_closest_point_and_little_more() {
        let beams = straight();
        let beams = [&*beams[0], &*beams[1]];
        let exact = closest_points(beams[0], beams[1], &Search::default()).unwrap().minima[0];
        let (xi, xi_bar) = parameters(beams, &exact).unwrap();
        assert!(xi.bound < 1e-13 && xi_bar.bound < 1e-12, "{xi:?}, {xi_bar:?}");
        for (off, off_bar) in [(1e-6, 0.0), (0.0, 1e-6), (1e-3, -1e-3)] {
            let mut point = exact;
            (point.xi, point.xi_bar) = (exact.xi + off, exact.xi_bar + off_bar);
            let (xi, xi_bar) = parameters(beams, &point).unwrap();
            assert_eq!((xi.value, xi_bar.value), (point.xi, point.xi_bar));
            // The distance of one parameter bounds the other one too, by the ratio of the half-lengths; twice the step.
            let (far, far_bar) = (off + off_bar.abs() / 8.0, 8.0 * off + off_bar.abs());
            assert!(xi.bound >= off && xi.bound < 5.0 * far + 1e-13, "{xi:?}");
            assert!(xi_bar.bound >= off_bar.abs() && xi_bar.bound < 5.0 * far_bar + 1e-12, "{xi_bar:?}");
        }
    }
}
