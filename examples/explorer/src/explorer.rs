//! The explorer as a scene: what the reader does to its state, and the picture, the map and the formulas of a state.

mod change;
mod labels;
mod marks;
mod overlap;
mod plane;
mod sentence;
mod terms;
mod tubes;

use crate::answer::variant;
use crate::frame::Frame;
use crate::handles::{Handle, handles};
use crate::html::number;
use crate::learn::{Part, Scene};
use crate::points::select;
use crate::prediction::varied;
use crate::state::State;
use crate::view::View;
use beamgap::check::{ByTerm, CaseData};
use beamgap::closest_point::{Centroid, ClosestPoint};
use beamgap::linearization::closed_form::Projection;
use beamgap::variant::Variant;
pub use labels::{Label, placed};
use marks::Predicted;
pub use overlap::hull;
use plane::Landscape;

/// The names of both beams in the picture.
const BEAMS: [&str; 2] = ["b", "r"];
/// The number of handles of a beam that the page has.
const HANDLES: usize = 6;

impl Scene for State {
    /// By the reader of links, so that the module has one reader.
    fn read(state: serde_json::Value) -> Result<Self, String> {
        serde_json::from_str(&state.to_string()).map_err(|error| error.to_string())
    }

    fn drag(&mut self, handle: &str, [x, y]: [f64; 2]) {
        let Some(found) = self.handle(handle) else { return };
        let [from_x, from_y] = found.at;
        let view = View::new(&self.view);
        let by = (view.right * (x - from_x) - view.up * (y - from_y)) / self.view.scale;
        self.move_handle(&found, by);
    }

    fn push(&mut self, handle: &str, by: f64) {
        let Some(found) = self.handle(handle) else { return };
        self.move_handle(&found, View::new(&self.view).away * by);
    }

    fn choose(&mut self, name: &str, value: &str) {
        self.refused = self.change(name, value).err();
    }

    fn frame(&self) -> Result<Frame, String> {
        self.drawn(None)
    }

    fn part(&self, part: Part) -> Result<Frame, String> {
        self.drawn(Some(part))
    }
}

impl State {
    /// The frame, or a part of it.
    fn drawn(&self, part: Option<Part>) -> Result<Frame, String> {
        if let Some(refused) = &self.refused {
            return Err(refused.clone());
        }
        self.validate()?;
        let case = self.case()?;
        let variant = variant(self.fault.as_deref())?;
        let beams =
            case.test_beams.each_ref().map(|test_beam| test_beam.centroid().map_err(|e| e.to_string()));
        let [beam, bar] = beams;
        let (beam, bar) = (beam?, bar?);
        let centroids: [&dyn Centroid; 2] = [&*beam, &*bar];
        let (has_map, has_texts) = (part != Some(Part::Texts), part != Some(Part::Map));
        let landscape = Landscape::of(self, centroids, has_map)?;
        let found = select(&landscape.closest, self.minimum);
        let found = found.as_ref();
        let view = View::new(&self.view);
        let varied = found.and_then(|found| varied(&case, self, found));
        let predicted = found.and_then(|found| Predicted::new(&case, self, &variant, &found.point));

        let mut frame = Frame::default();
        let radii = [self.contact.radius, self.contact.radius_bar];
        tubes::draw(&mut frame, &view, centroids, radii);
        overlap::draw(&mut frame, &view, centroids, radii, &landscape.closest);
        let points = (&landscape.closest, found);
        marks::draw(&mut frame, self, &view, centroids, points, varied.as_ref());
        marks::draw_predicted(&mut frame, self, &view, predicted.as_ref(), varied.as_ref());
        place_handles(&mut frame, &handles(&case, self, &view), has_texts);
        let second = predicted.as_ref().map(|predicted| predicted.second);
        frame.text("sentence", sentence::of(centroids, radii, &landscape, found, second));
        if has_map {
            plane::draw(&mut frame, &landscape, found, predicted.as_ref(), varied.as_ref());
        }
        if has_texts {
            let by_term = found.and_then(|found| by_term(&case, &variant, &found.point));
            terms::write(&mut frame, self, by_term.as_ref());
            self.write_numbers(&mut frame, centroids, found.map(|found| &found.point));
            self.show_controls(&mut frame);
        }
        Ok(frame)
    }
}

/// The closed form with the fault, and as it is.
fn by_term(case: &CaseData, variant: &Variant, point: &ClosestPoint) -> Option<[ByTerm; 2]> {
    if *variant == Variant::Unmodified {
        let [right] = case.by_term([variant], point).ok()?.ok()?;
        return Some([right.clone(), right]);
    }
    case.by_term([variant, &Variant::Unmodified], point).ok()?.ok()
}

impl State {
    /// The numbers below the picture.
    fn write_numbers(
        &self,
        frame: &mut Frame,
        [beam, bar]: [&dyn Centroid; 2],
        point: Option<&ClosestPoint>,
    ) {
        let radii = self.contact.radius + self.contact.radius_bar;
        let text = |value: Option<f64>| value.map_or_else(|| "none".to_owned(), number);
        frame.text("gap", text(point.map(|point| point.distance - radii)));
        frame.text("d", text(point.map(|point| point.distance)));
        frame.text("xi", text(point.map(|point| point.xi)));
        frame.text("xi_bar", text(point.map(|point| point.xi_bar)));
        let det = point.filter(|point| point.is_interior()).map(|point| {
            let [x, y] = [beam.geometry(point.xi), bar.geometry(point.xi_bar)];
            Projection::new(&x, &y, point.held()).det()
        });
        frame.text("D", text(det));
        frame.text("step-value", format!("{:.2}", self.step));
    }

    /// The handle of this name, such as `b0`.
    fn handle(&self, name: &str) -> Option<Handle> {
        let case = self.case().ok()?;
        let all = handles(&case, self, &View::new(&self.view));
        named(&all).find(|(known, _)| known == name).map(|(_, handle)| handle.clone())
    }

    /// Moves the dofs of a handle. They keep three decimals, so that links are short.
    fn move_handle(&mut self, handle: &Handle, by: beamgap::nalgebra::Vector3<f64>) {
        let dragged = self.dragged;
        let beam = if handle.beam == 0 { &mut self.beam } else { &mut self.bar };
        let numbers = beam.numbers(dragged);
        for c in 0..3 {
            if let Some(number) = numbers.get_mut(handle.start + c) {
                let moved = *number + by[c] / handle.factor;
                // What is not moved keeps its digits.
                if by[c] != 0.0 {
                    *number = (moved * 1000.0).round() / 1000.0 + 0.0; // never −0, which JSON does not keep
                }
            }
        }
    }
}

/// Handles with their names: the beam, and the number among its handles.
fn named(handles: &[Handle]) -> impl Iterator<Item = (String, &Handle)> {
    let mut counts = [0; 2];
    handles.iter().map(move |handle| {
        let name = format!("{}{}", BEAMS[handle.beam], counts[handle.beam]);
        counts[handle.beam] += 1;
        (name, handle)
    })
}

/// The handles, with what they are called for those who do not see them.
fn place_handles(frame: &mut Frame, handles: &[Handle], has_labels: bool) {
    let hidden = BEAMS.iter().flat_map(|beam| (0..HANDLES).map(move |i| format!("{beam}{i}")));
    hidden.for_each(|name| frame.hide(name));
    let mut rods = [Vec::new(), Vec::new()];
    for (name, handle) in named(handles) {
        if has_labels {
            let [x, y, z] = handle.value;
            frame.labels.insert(name.clone().into(), format!("{}: {x:.3}, {y:.3}, {z:.3}", handle.name));
        }
        frame.place(name, handle.at);
        if handle.is_rod {
            rods[handle.beam].push([handle.from, handle.at]);
        }
    }
    for (name, rods) in [("rods_b", &rods[0]), ("rods_r", &rods[1])] {
        frame.lines(name, rods);
    }
}
