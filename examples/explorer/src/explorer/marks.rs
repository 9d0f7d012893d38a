//! What is drawn at the closest points: d, the tangents and the gap, other points, the varied beams, and what the closed form
//! predicts of them.

use super::BEAMS;
use super::labels::{Label, placed};
use crate::frame::Frame;
use crate::points::Found;
use crate::prediction::{Varied, alike};
use crate::state::{Shown, State};
use crate::view::View;
use beamgap::check::CaseData;
use beamgap::closest_point::{Centroid, ClosestPoint, ClosestPoints};
use beamgap::curve::Geometry;
use beamgap::linearization::{COMPONENTS, Quantity, Varied as OfQuantity};
use beamgap::nalgebra::Vector3;
use beamgap::variant::Variant;

/// The length of a tangent in the picture.
const TANGENT: f64 = 90.0;
/// The pieces of a varied beam.
const PIECES: u32 = 32;
/// Other points that the page can show.
const OTHERS: usize = 4;

/// The closest points, and the one that the numbers belong to.
pub(super) type Points<'a> = (&'a ClosestPoints, Option<&'a Found>);

/// All components after the step, as predicted with the fault and without it.
#[derive(Debug)]
pub(super) struct Predicted {
    pub(super) faulty: [f64; COMPONENTS],
    pub(super) right: [f64; COMPONENTS],
    pub(super) is_faulty: bool,
    /// The right second variation of the gap along the direction.
    pub(super) second: f64,
}

impl Predicted {
    /// The predictions of first order, or of second order if a second variation is shown.
    pub(super) fn new(
        case: &CaseData,
        state: &State,
        variant: &Variant,
        point: &ClosestPoint,
    ) -> Option<Self> {
        let both = super::by_term(&alike(case, state), variant, point)?;
        let s = state.step;
        let of = |varied: &OfQuantity<f64>| {
            let second = if state.order > 1 { 0.5 * s * s * varied.second } else { 0.0 };
            varied.value + s * varied.delta + second
        };
        let second = both[1].components[Quantity::GN.component()].second;
        let [faulty, right] = both.map(|by_term| by_term.components.each_ref().map(of));
        Some(Self { faulty, right, is_faulty: state.fault.is_some(), second })
    }
}

fn scalar(all: &[f64; COMPONENTS], of: Quantity) -> f64 {
    all[of.component()]
}

fn vector(all: &[f64; COMPONENTS], of: Quantity) -> Vector3<f64> {
    Vector3::from_fn(|c, _| all[of.component() + c])
}

/// The tip of a tangent that is drawn at this length.
fn tip(view: &View, x: &Vector3<f64>, t: &Vector3<f64>) -> Vector3<f64> {
    let length = t.norm();
    if length > 0.0 { x + t * (TANGENT / (view.scale * length)) } else { *x }
}

/// The closest points and the varied beams.
pub(super) fn draw(
    frame: &mut Frame,
    state: &State,
    view: &View,
    centroids: [&dyn Centroid; 2],
    (closest, found): Points<'_>,
    varied: Option<&Varied>,
) {
    for name in ["d", "t", "t_bar", "gap"] {
        frame.no_path(name);
        frame.hide(format!("label_{name}"));
    }
    for name in BEAMS {
        frame.hide(format!("at_{name}"));
        frame.hide(format!("varied_at_{name}"));
        frame.no_path(format!("varied_{name}"));
    }
    if let Some(found) = found {
        let beside = varied.and_then(Varied::geometry).map(|ends| ends.map(|x| view.at(&x.x)));
        at_point(frame, state, view, centroids, (&found.point, beside));
    }
    let others = closest.minima.iter().chain(&closest.stationary);
    let mut others = others.filter(|point| found.is_none_or(|found| **point != found.point));
    for i in 0..OTHERS {
        let ends = others.next().map(|point| {
            [centroids[0].geometry(point.xi), centroids[1].geometry(point.xi_bar)].map(|x| view.at(&x.x))
        });
        frame.line(format!("other{i}"), ends.into_iter().flatten());
        for (name, end) in
            BEAMS.into_iter().enumerate().map(|(beam, name)| (name, ends.map(|ends| ends[beam])))
        {
            frame.place_if(format!("other{i}{name}"), end);
        }
    }
    frame.no_path("varied_d");
    let Some(varied) = varied else { return };
    for (centroid, name) in varied.centroids.iter().zip(BEAMS) {
        let at = |i: u32| view.at(&centroid.geometry(2.0 * f64::from(i) / f64::from(PIECES) - 1.0).x);
        frame.line(format!("varied_{name}"), (0..=PIECES).map(at));
    }
    if let Some([x, y]) = varied.geometry() {
        let ends = [x.x, y.x].map(|x| view.at(&x));
        frame.line("varied_d", ends);
        for (name, end) in BEAMS.into_iter().zip(ends) {
            frame.place(format!("varied_at_{name}"), end);
        }
    }
}

/// d, both tangents and the gap at the selected closest point, with their letters; `beside` is the varied one.
fn at_point(
    frame: &mut Frame,
    state: &State,
    view: &View,
    centroids: [&dyn Centroid; 2],
    (point, beside): (&ClosestPoint, Option<[[f64; 2]; 2]>),
) {
    let [x, y] = [centroids[0].geometry(point.xi), centroids[1].geometry(point.xi_bar)];
    let [at, at_bar] = [x.x, y.x].map(|x| view.at(&x));
    let [t, t_bar] = [&x, &y].map(|x| view.at(&tip(view, &x.x, &x.t)));
    frame.solid_arrow("d", at_bar, at);
    frame.solid_arrow("t", at, t);
    frame.solid_arrow("t_bar", at_bar, t_bar);
    frame.place("at_b", at);
    frame.place("at_r", at_bar);
    let mut lines = vec![([at_bar, at], 2.0), ([at, t], 2.0), ([at_bar, t_bar], 2.0)];
    lines.extend(beside.map(|ends| (ends, 2.0)));
    // The gap is drawn beside d, on the side that is away from the varied beams or from the tangents.
    let is_left = match beside {
        Some([[x, _], _]) => x > at[0],
        None => t[0] + t_bar[0] > at[0] + at_bar[0],
    };
    let side = if is_left { -14.0 } else { 14.0 };
    let mut middle = [f64::midpoint(at[0], at_bar[0]), f64::midpoint(at[1], at_bar[1])];
    let mut labels = vec![
        Label { name: "d", at: middle, towards: [-side, 0.0] },
        Label { name: "t", at: t, towards: [t[0] - at[0], t[1] - at[1]] },
        Label { name: "t_bar", at: t_bar, towards: [t_bar[0] - at_bar[0], t_bar[1] - at_bar[1]] },
    ];
    if point.distance > 0.0 {
        let n = (x.x - y.x) / point.distance;
        let gap = [y.x + n * state.contact.radius_bar, x.x - n * state.contact.radius].map(|x| {
            let [u, v] = view.at(&x);
            [u + side, v]
        });
        frame.line("gap", gap);
        lines.push((gap, 2.0));
        middle = [f64::midpoint(gap[0][0], gap[1][0]), f64::midpoint(gap[0][1], gap[1][1])];
    }
    labels.push(Label { name: "gap", at: middle, towards: [side, 0.0] });
    for centroid in centroids {
        let drawn: Vec<_> =
            (0..=8).map(|i| view.at(&centroid.geometry(f64::from(i) / 4.0 - 1.0).x)).collect();
        lines.extend(drawn.windows(2).map(|ends| ([ends[0], ends[1]], 0.7)));
    }
    for (label, place) in labels.iter().zip(placed(&labels, &lines)) {
        frame.place(format!("label_{}", label.name), place);
    }
}

/// Two vectors that show the quantity after the step, for the numbers of a closed form.
fn shown(
    quantity: Shown,
    view: &View,
    varied: &Varied,
    [x, y]: &[Geometry<f64>; 2],
    all: &[f64; COMPONENTS],
) -> [Option<[Vector3<f64>; 2]>; 2] {
    let d = x.x - y.x;
    match quantity {
        // d along the true normal, from the true closest point.
        Shown::Gap => {
            let normal = d.try_normalize(1e-12);
            [normal.map(|n| [y.x, y.x + n * scalar(all, Quantity::D)]), None]
        }
        Shown::Xi => {
            let at = |i: usize, of| varied.centroids[i].geometry(scalar(all, of).clamp(-1.0, 1.0)).x;
            [Some([at(1, Quantity::XiBar), at(0, Quantity::Xi)]), None]
        }
        Shown::X => [Some([vector(all, Quantity::XBar), vector(all, Quantity::X)]), None],
        Shown::D => [Some([y.x, y.x + vector(all, Quantity::DVector)]), None],
        // The true tangents are drawn at a fixed length; predicted ones keep their ratio to them.
        Shown::T => [(x, Quantity::TVector), (y, Quantity::TBarVector)].map(|(x, of)| {
            let length = x.t.norm();
            (length > 0.0).then(|| [x.x, x.x + vector(all, of) * (TANGENT / (view.scale * length))])
        }),
        Shown::Length => [(x, Quantity::T), (y, Quantity::TBar)].map(|(x, of)| {
            let length = x.t.norm_squared();
            (length > 0.0).then(|| [x.x, x.x + x.t * (scalar(all, of) * TANGENT / (view.scale * length))])
        }),
        // The slip along the tangent, to the closest point.
        Shown::Slip => [(x, Quantity::GT), (y, Quantity::GTBar)].map(|(x, of)| {
            let t = x.t.try_normalize(1e-12);
            t.map(|t| [x.x - t * scalar(all, of), x.x])
        }),
    }
}

/// The prediction of the chosen quantity after the step. With a fault, the right one is beside it.
pub(super) fn draw_predicted(
    frame: &mut Frame,
    state: &State,
    view: &View,
    predicted: Option<&Predicted>,
    varied: Option<&Varied>,
) {
    let both = predicted.zip(varied).and_then(|(predicted, varied)| {
        let geometry = varied.geometry()?;
        let of = |all| shown(state.shown, view, varied, &geometry, all);
        Some((of(&predicted.faulty), predicted.is_faulty.then(|| of(&predicted.right))))
    });
    let (faulty, right) = both.map_or(([None; 2], None), |(faulty, right)| (faulty, right));
    for (name, vectors) in [("predicted", faulty), ("right", right.unwrap_or_default())] {
        for (i, vector) in vectors.into_iter().enumerate() {
            let ends = vector.map(|ends| ends.map(|x| view.at(&x)));
            match ends {
                Some([from, to]) => frame.solid_arrow(format!("{name}{i}"), from, to),
                None => frame.no_path(format!("{name}{i}")),
            }
            frame.place_if(format!("{name}_tip{i}"), ends.map(|[_, to]| to));
        }
    }
}
