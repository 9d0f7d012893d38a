//! A description of what is special about the configuration of the beams.

use crate::html::{linked, number, short, whole};
use crate::points::Found;
use beamgap::check::CaseData;
use beamgap::closest_point::{Centroid, ClosestPoint, ClosestPoints, Degeneracy, End, Side};
use beamgap::linearization::closed_form::Projection;

/// Tangents are called nearly parallel if -D is below this part of t² t_bar². A choice; nothing is computed with it.
const NEARLY: f64 = 1e-3;

/// D, if a closest point inside both beams exists, but only just.
pub(crate) fn nearly_parallel(beams: [&dyn Centroid; 2], point: &ClosestPoint) -> Option<f64> {
    let (x, y) = (beams[0].geometry(point.xi), beams[1].geometry(point.xi_bar));
    let det = Projection::new(&x, &y, point.held()).det();
    let is_near = -det < NEARLY * x.t.norm_squared() * y.t.norm_squared();
    (point.is_interior() && is_near).then_some(det)
}

/// The paragraphs of the description; at least one. `second` is the second variation of the gap.
pub(crate) fn words(
    case: &CaseData,
    beams: [&dyn Centroid; 2],
    closest: &ClosestPoints,
    found: Option<&Found>,
    second: Option<f64>,
) -> String {
    let mut all = Vec::new();
    if !closest.unresolved.is_empty() {
        all.push(
            "The beams are parallel, or nearly so, along a part of their length. Every point of this part is as close as \
             its neighbours: the closest point is not unique, D is zero, and the parameters have no derivative. The search \
             reports the part as a region and does not choose a point in it."
                .to_owned(),
        );
    }
    match found {
        None => all.push(
            "No minimum of the distance stands alone. The equations of the paper need one: nothing is linearized here."
                .to_owned(),
        ),
        Some(found) => of_point(case, found, &mut all),
    }
    if let Some(det) = found.and_then(|found| nearly_parallel(beams, &found.point)) {
        let second = second.map(|second| format!(" The second variation of the gap is {}.", whole(second)));
        all.push(format!(
            "The beams are nearly parallel: D is {}, and the parameters are divided by it.{} The closest point runs along the \
             beams at a small turn, so the linearization holds for very small steps alone. A Newton iteration needs short steps \
             here.",
            short(det),
            second.unwrap_or_default()
        ));
    }
    if closest.minima.len() > 1 {
        all.push(format!(
            "The distance has {} minima. Each is a closest point of its own, with a gap and a linearization of its own. A \
             contact search that follows one point from step to step does not see the others.",
            closest.minima.len()
        ));
    }
    if all.is_empty() {
        all.push(
            "One closest point inside both beams, D &lt; 0 and d &gt; 0: all equations of the paper hold. Move the beams \
             until they are parallel, until they cross, or until an end comes close."
                .to_owned(),
        );
    }
    let paragraphs: Vec<_> = all.iter().map(|words| format!("<p>{}</p>\n", linked(words))).collect();
    paragraphs.concat()
}

fn of_point(case: &CaseData, found: &Found, all: &mut Vec<String>) {
    let point = &found.point;
    for (end, name, letter) in [(point.end, "beam", "ξ"), (point.end_bar, "bar beam", "ξ̄")] {
        let Some(End { side, strict, multiplier }) = end else { continue };
        let at = if side == Side::Lower { "first" } else { "second" };
        all.push(format!(
            "The closest point is at the {at} end of the {name}. {letter} is held there: its row and its column drop out \
             of the two-by-two system, δ{letter} = Δ{letter} = Δδ{letter} = 0, and d is not normal to this beam. The cosine \
             between d and the tangent is {}.{}",
            short(multiplier),
            if strict { "" } else { " It is zero to rounding: the end is about to let go." }
        ));
    }
    match point.degeneracy() {
        None => {}
        Some(Degeneracy::Crossing) => all.push(
            "The centroids cross: d = 0. The closest points and their parameters have derivatives, but d is a length, and \
             a length has none at zero. The form along the common normal, n·d, goes through zero smoothly; its sign is a choice."
                .to_owned(),
        ),
        Some(Degeneracy::Singular { .. }) => all.push(
            "D = 0 to rounding: the minimum is flat in one direction. The two-by-two system (50) has no solution, and the \
             parameters have no derivative."
                .to_owned(),
        ),
        Some(Degeneracy::WeakEnd { .. }) => all.push(
            "The parameter is just about to leave the end: a kink. The derivatives to both sides differ, so that none is shown."
                .to_owned(),
        ),
        Some(Degeneracy::ZeroTangent { which }) => all.push(format!(
            "The tangent of the {which} has no length at the closest point. t has no derivative there, and slips have none."
        )),
        Some(Degeneracy::IllConditioned { conditioning, gradient_error }) => all.push(format!(
            "D is close to zero: the conditioning is {}. Rounding takes digits from the derivatives of the parameters: \
             their relative error is up to {}. The first variation of the gap keeps its digits.",
            short(conditioning),
            short(gradient_error)
        )),
        Some(_) => all.push("The point has no derivatives that can be trusted.".to_owned()),
    }
    let gap = point.distance - case.contact.radius - case.contact.radius_bar;
    if gap < 0.0 {
        all.push(format!(
            "The beams overlap: the gap is {}. A penalty method pushes them apart with a force that is proportional to \
             this gap, along d.",
            number(gap)
        ));
    }
}
