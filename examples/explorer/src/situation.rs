//! A description of what is special about the configuration of the beams.

use crate::html::{linked, number, short};
use crate::points::Found;
use beamgap::check::CaseData;
use beamgap::closest_point::{ClosestPoints, Degeneracy, End, Side};

/// The paragraphs of the description; at least one.
pub(crate) fn words(case: &CaseData, closest: &ClosestPoints, found: Option<&Found>) -> String {
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
