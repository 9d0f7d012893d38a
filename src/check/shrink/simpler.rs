//! A beam of a simpler family with the same numbers at the closest point.

use super::super::CaseData;
use crate::closest_point::{Search, closest_points};
use crate::test_beam::{Family, TestBeam};
use nalgebra::Vector3;

/// The families that replace others.
pub(super) const FAMILIES: [Family; 3] = [Family::Segment, Family::Quadratic, Family::Hermite];

/// The beam whose dofs and directions are those of the Taylor polynomial about the nearest closest point.
pub(super) fn simpler(case: &CaseData, beam: usize, family: Family) -> Option<TestBeam> {
    if family >= case.test_beams[beam].family {
        return None;
    }
    let beams = case.beams().ok()?;
    let found = closest_points(&*beams[0], &*beams[1], &Search::default()).ok()?;
    let point = found.minima.first()?;
    let xi = [point.xi, point.xi_bar][beam];
    let at = beams[beam].partial_variations_plain(xi);
    let dofs = |derivatives: &[Vector3<f64>]| {
        // Position and slope at another parameter.
        let [position, slope] = [0, 1].map(|order| {
            move |to: f64| {
                let mut term = 1.0;
                let mut sum = Vector3::zeros();
                for (i, derivative) in (0..).zip(&derivatives[order..]) {
                    sum += derivative * term;
                    term *= (to - xi) / f64::from(i + 1);
                }
                sum
            }
        });
        let nodes = match family {
            Family::Segment => vec![position(-1.0), position(1.0)],
            Family::Quadratic => vec![position(-1.0), position(0.0), position(1.0)],
            _ => vec![position(-1.0), slope(-1.0), position(1.0), slope(1.0)],
        };
        nodes.into_iter().flat_map(|node| node.data.0[0]).collect::<Vec<f64>>()
    };
    let degree = match family {
        Family::Segment => 1,
        Family::Quadratic => 2,
        _ => 3,
    };
    let geometry = [at.geometry.x, at.geometry.t, at.geometry.t_xi, at.geometry.t_xixi];
    let direction = |u: &[Vector3<f64>; 3]| dofs(&u[..=degree.min(2)]);
    Some(TestBeam {
        family,
        parameters: Vec::new(),
        q: dofs(&geometry[..=degree]),
        dq: direction(&at.delta_u),
        linear_dq: direction(&at.linear_u),
    })
}
