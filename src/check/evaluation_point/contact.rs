//! Residual and tangent of a contact element at a closest point, against the virtual work of automatic differentiation.

use super::EvaluationPoint;
use crate::check::element::{ContactSituations, ElementAt, ElementData};
use crate::check::verdict::{Comparison, Order};
use crate::contact::closed_form::{write, write_by_kernel};
use crate::contact::{BlockMatrix, Contribution, State, contracted};
use crate::linearization::closed_form::Points;
use crate::linearization::{Quantity, Varied};
use crate::number::{DoubleDouble, Real, RunningError};
use crate::pair::DofVector;
use crate::test_beam::{DOFS, FEW_DOFS, PaddedBeam, RunningError2, map_padded};
use crate::variant::Step;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// The two ways to the geometry that the element has, by state.
fn doors(state: State, is_crossing: bool) -> [&'static str; 2] {
    match state {
        _ if is_crossing => ["contact::closed_form, d = 0", "contact::Element, d = 0"],
        State::Open => ["contact::closed_form, open", "contact::Element, open"],
        State::Frictionless => ["contact::closed_form, frictionless", "contact::Element, frictionless"],
        State::Stick => ["contact::closed_form, stick", "contact::Element, stick"],
        State::Slip => ["contact::closed_form, slip", "contact::Element, slip"],
    }
}

/// The residual along delta and Delta, and the tangent between them in both orders.
const PARTS: [&str; 4] =
    ["residual, delta", "residual, Delta", "tangent, delta-Delta", "tangent, Delta-delta"];
/// |d| where the centroids cross, over the distance from which they were moved.
const CROSSING: f64 = 1e-9;
/// The number of comparisons of an element.
pub(crate) const ELEMENT_ENTRIES: usize = 2 * PARTS.len();

/// A jet with few dofs, the dofs and the two directions.
pub(crate) type FewDofs = PaddedBeam<f64, FEW_DOFS>;
/// What is done with an element: the beams at their contact point, the element, and its comparisons.
pub(crate) type OfElement<'a> = dyn FnMut(&EvaluationPoint<'_>, &ElementAt, Vec<Comparison>) + 'a;

impl EvaluationPoint<'_> {
    /// The comparisons of the contact elements at this point, in closed form and by automatic differentiation.
    pub(in crate::check) fn contact_elements(&self, chord: &[Varied<RunningError2>]) -> Vec<Comparison> {
        let mut all = Vec::new();
        self.each_element(chord, &mut |_, _, comparisons| all.extend(comparisons));
        all
    }

    /// Calls `each` with the contact elements that are drawn for this point: one for the two beams, and inside of both one for
    /// the bar beam moved so that the centroids cross.
    ///
    /// `chord` are the components of the quantities by automatic differentiation.
    pub(crate) fn each_element(&self, chord: &[Varied<RunningError2>], each: &mut OfElement<'_>) {
        if let Some((element, comparisons)) = self.drawn_element(&self.points(), chord) {
            each(self, &element, comparisons);
        }
        let _ = self.at_crossing(|crossing, points| {
            let (element, comparisons) = crossing.meaningful_element(points, &crossing.chord())?;
            each(crossing, &element, comparisons);
            Some(())
        });
    }

    /// The comparisons of the same elements, each with its number in double-double. `precise` are the quantities of the pair in
    /// double-double.
    pub(in crate::check) fn precise_element(
        &self,
        chord: &[Varied<RunningError2>],
        precise: &[Varied<DoubleDouble>],
    ) -> Vec<(Comparison, DoubleDouble)> {
        let with_numbers = |point: &EvaluationPoint<'_>,
                            (element, comparisons): (ElementAt, Vec<Comparison>),
                            precise: &[_]| {
            let numbers = point.numbers(&element, precise)?;
            Some(comparisons.into_iter().zip(numbers.into_iter().cycle()).collect::<Vec<_>>())
        };
        let own = self.drawn_element(&self.points(), chord);
        let own = own.and_then(|drawn| with_numbers(self, drawn, precise));
        let crossing = self.at_crossing(|crossing, points| {
            let drawn = crossing.meaningful_element(points, &crossing.chord())?;
            with_numbers(crossing, drawn, &crossing.precise()?)
        });
        own.into_iter().chain(crossing).flatten().collect()
    }

    /// Calls `of` with the pair whose bar beam is moved until the centroids cross, d = 0 up to rounding, and with the contact
    /// points before. There only the signed distance has derivatives.
    ///
    /// None if the point is not inside both beams, or if d is not small after the move, because some dof is very large.
    fn at_crossing<R>(&self, of: impl FnOnce(&EvaluationPoint<'_>, &Points<f64>) -> Option<R>) -> Option<R> {
        if !self.point.is_interior() {
            return None;
        }
        let (points, [beam, bar]) = (self.points(), self.beams);
        let bar = bar.translated(&points.d)?;
        let crossing = EvaluationPoint::regular([beam, &*bar], self.contact, &self.point).ok()?;
        if crossing.is_moved_from(&points) { of(&crossing, &points) } else { None }
    }

    /// The element for the centroids that were moved from these contact points; none if rounding hides its numbers.
    fn meaningful_element(
        &self,
        drawn_for: &Points<f64>,
        chord: &[Varied<RunningError2>],
    ) -> Option<(ElementAt, Vec<Comparison>)> {
        let drawn = self.drawn_element(drawn_for, chord)?;
        drawn.1.iter().all(Comparison::is_meaningful).then_some(drawn)
    }

    /// Whether the bar beam was moved from these contact points until the centroids cross.
    fn is_moved_from(&self, points: &Points<f64>) -> bool {
        self.points().d.norm() < CROSSING * points.d.norm()
    }

    /// The numbers of the case choose a situation. If rounding leaves its state open, or hides its numbers, the next one is
    /// taken: an open contact has no rounding.
    ///
    /// `drawn_for` are the contact points before the bar beam was moved, if it was.
    fn drawn_element(
        &self,
        drawn_for: &Points<f64>,
        chord: &[Varied<RunningError2>],
    ) -> Option<(ElementAt, Vec<Comparison>)> {
        // The parameters are the same in every unit of length.
        let seed = self.at.0.value.to_bits().rotate_left(7) ^ self.at.1.value.to_bits();
        let first = seed.rotate_right(11) % 1024;
        let is_crossing = self.is_moved_from(drawn_for);
        let mut drawn = None;
        for number in first..first + ElementData::SITUATIONS {
            let Some(element) = self.in_situation((number, seed), (drawn_for, is_crossing), chord) else {
                continue;
            };
            let Some(comparisons) = self.compared(&element, (drawn_for, is_crossing), chord) else {
                continue;
            };
            let is_clear = comparisons.iter().all(Comparison::is_meaningful);
            drawn = Some((element, comparisons));
            if is_clear {
                break;
            }
        }
        drawn
    }

    /// The element of this number. None if the point does not define it, or rounding leaves its state open.
    fn in_situation(
        &self,
        (number, seed): (u64, u64),
        (drawn_for, is_crossing): (&Points<f64>, bool),
        chord: &[Varied<RunningError2>],
    ) -> Option<ElementAt> {
        let at = (self.at.0.value, self.at.1.value);
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut contact = *self.contact;
        let element =
            ElementData::draw(number, drawn_for, at, self.held, is_crossing, &mut contact, &mut rng);
        let element = element.with_contact(self, contact).ok()?;
        element.other_state(chord).is_none().then_some(element)
    }

    /// Both jets with few dofs, and the two directions; nothing if a beam has more.
    pub(crate) fn jets_of_few(&self) -> Option<[FewDofs; 2]> {
        let value = |number: RunningError| number.value;
        self.has_few_dofs().then(|| self.padded_few(Step::Now).each_ref().map(|beam| map_padded(beam, value)))
    }

    /// The numbers of [`PARTS`], from the components of the quantities.
    fn numbers<T: Real>(&self, element: &ElementAt, all: &[Varied<T>]) -> Option<[T; 4]> {
        let exchanged: Vec<_> = all.iter().map(|varied| varied.exchanged()).collect();
        let ((work, _), (other, _)) =
            (element.numbers(all, self.form)?, element.numbers(&exchanged, self.form)?);
        Some([work.delta, work.linear, work.second, other.second])
    }

    fn compared(
        &self,
        element: &ElementAt,
        (drawn_for, is_crossing): (&Points<f64>, bool),
        chord: &[Varied<RunningError2>],
    ) -> Option<Vec<Comparison>> {
        let expected = self.numbers(element, chord)?;
        let (bounded, found_by, size, situations) = element.with(|decision| {
            let beams = self.padded(Step::Now);
            let [(jet, vectors), (jet_bar, vectors_bar)] = beams;
            let directions = |k: usize| DofVector { beam: vectors[k], bar: vectors_bar[k] };
            let along = [directions(1), directions(2)];
            let mut to = Box::new(Contribution::zeros());
            write(decision, (jet, jet_bar), self.sharp(), &mut to);
            let bounded = contracted(&to.residual, &to.tangent, &along);
            let plain = beams.each_ref().map(|beam| map_padded(beam, |number| number.value));
            let [(jet, _), (jet_bar, _)] = &plain;
            let along = along.each_ref().map(values);
            let at = (self.at.0.value, self.at.1.value);
            let mut to = Box::new(Contribution::zeros());
            write(decision, (jet, jet_bar), at, &mut to);
            let by_matrices = contracted(&to.residual, &to.tangent, &along);
            let q = values(&directions(0));
            let forces = write_by_kernel(decision, (jet, jet_bar), &q, at, &mut to);
            let energy = forces.f_n * drawn_for.d.norm();
            let size = sizes(&to.residual, &to.tangent, &along, energy);
            let situations = ContactSituations::of(element, is_crossing, forces.yield_ratio);
            (bounded, [by_matrices, contracted(&to.residual, &to.tangent, &along)], size, situations)
        })?;
        let names = doors(element.state(), is_crossing);
        let comparison = |door: usize, k: usize| {
            let (closed, other): (f64, f64) = (expected[k].value, found_by[door][k]);
            // The sums of the kernel have another order. A number that is not finite has no bound, and is wrong.
            let is_lost = closed.is_finite() && !other.is_finite();
            let bound = 2.0 * bounded[k].bound + expected[k].bound[0];
            Comparison {
                quantity: Quantity::GN,
                axis: None,
                order: Order::Function,
                part: PARTS[k],
                against: names[door],
                closed,
                other,
                scale: size[k],
                bound: bounded[k].bound,
                tolerance: if is_lost { 0.0 } else { bound },
                situations,
            }
        };
        let of_door = |door: usize| (0..PARTS.len()).map(move |k| comparison(door, k));
        Some((0..names.len()).flat_map(of_door).collect())
    }
}

/// Whether a number of a contact element belongs to R, and not to K.
pub(in crate::check) fn is_of_residual(comparison: &Comparison) -> bool {
    PARTS[..2].contains(&comparison.part)
}

fn values(v: &DofVector<RunningError, DOFS, DOFS>) -> DofVector<f64, DOFS, DOFS> {
    DofVector { beam: v.beam.map(|number| number.value), bar: v.bar.map(|number| number.value) }
}

/// The sums of the absolute values of the terms of [`contracted`], and at least the energy F_N d: a number may be zero because
/// its directions have few entries.
fn sizes(
    residual: &DofVector<f64, DOFS, DOFS>,
    tangent: &BlockMatrix<f64, DOFS, DOFS>,
    along: &[DofVector<f64, DOFS, DOFS>; 2],
    energy: f64,
) -> [f64; 4] {
    let of = |v: &DofVector<f64, DOFS, DOFS>| DofVector { beam: v.beam.abs(), bar: v.bar.abs() };
    let BlockMatrix { beam, bar_beam, beam_bar, bar } = tangent;
    let tangent =
        BlockMatrix { beam: beam.abs(), bar_beam: bar_beam.abs(), beam_bar: beam_bar.abs(), bar: bar.abs() };
    contracted(&of(residual), &tangent, &along.each_ref().map(of)).map(|size| size.max(energy))
}
