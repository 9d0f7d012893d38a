//! Residual and tangent of a contact element at a closest point, against the virtual work of automatic differentiation.

use super::EvaluationPoint;
use crate::check::element::{ElementAt, ElementData};
use crate::check::verdict::{Comparison, Order};
use crate::contact::closed_form::{write, write_by_kernel};
use crate::contact::{BlockMatrix, Contribution};
use crate::linearization::{Quantity, Varied};
use crate::number::{Real, RunningError};
use crate::pair::DofVector;
use crate::test_beam::{DOFS, RunningError2, map_padded};
use crate::variant::Step;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// The two ways to the geometry that the element has.
const DOORS: [&str; 2] = ["contact::closed_form", "contact::Element"];
/// The residual along delta and Delta, and the tangent between them in both orders.
const PARTS: [&str; 4] =
    ["residual, delta", "residual, Delta", "tangent, delta-Delta", "tangent, Delta-delta"];
/// The number of comparisons at a closest point.
pub(crate) const ELEMENT_ENTRIES: usize = DOORS.len() * PARTS.len();

type Directions<T> = [DofVector<T, DOFS, DOFS>; 2];

impl EvaluationPoint<'_> {
    /// A contact element that is drawn for this point, in closed form and by automatic differentiation.
    ///
    /// `chord` are the components of the quantities by automatic differentiation. The situation follows from the numbers of
    /// the case. Nothing where rounding leaves the state open.
    pub(in crate::check) fn contact_element(&self, chord: &[Varied<RunningError2>]) -> Vec<Comparison> {
        let Some(element) = self.drawn_element(chord) else { return Vec::new() };
        let Some([work, ..]) = element.numbers(chord, self.form) else { return Vec::new() };
        let exchanged: Vec<_> = chord.iter().map(|varied| varied.exchanged()).collect();
        let Some([other, ..]) = element.numbers(&exchanged, self.form) else { return Vec::new() };
        let expected = [work.delta, work.linear, work.second, other.second];
        let found = element.with(|decision| {
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
            let energy = forces.f_n * self.points().d.norm();
            let size = sizes(&to.residual, &to.tangent, &along, energy);
            (bounded, [by_matrices, contracted(&to.residual, &to.tangent, &along)], size)
        });
        let Some((bounded, doors, size)) = found else { return Vec::new() };
        let comparison = |door: usize, k: usize| Comparison {
            quantity: Quantity::GN,
            axis: None,
            order: Order::Function,
            part: PARTS[k],
            against: DOORS[door],
            closed: expected[k].value,
            other: doors[door][k],
            scale: size[k],
            bound: bounded[k].bound,
            // The sums of the kernel have another order.
            tolerance: 2.0 * bounded[k].bound + expected[k].bound[0],
        };
        (0..DOORS.len()).flat_map(|door| (0..PARTS.len()).map(move |k| comparison(door, k))).collect()
    }

    /// An element in a situation that the numbers of the case choose.
    fn drawn_element(&self, chord: &[Varied<RunningError2>]) -> Option<ElementAt> {
        let points = self.points();
        let at = (self.at.0.value, self.at.1.value);
        // The parameters are the same in every unit of length.
        let seed = at.0.to_bits().rotate_left(7) ^ at.1.to_bits();
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut contact = *self.contact;
        let element =
            ElementData::draw(seed.rotate_right(11) % 1024, &points, at, self.held, &mut contact, &mut rng);
        let element = element.with_contact(self, contact).ok()?;
        element.other_state(chord).is_none().then_some(element)
    }
}

fn values(v: &DofVector<RunningError, DOFS, DOFS>) -> DofVector<f64, DOFS, DOFS> {
    DofVector { beam: v.beam.map(|number| number.value), bar: v.bar.map(|number| number.value) }
}

/// The residual along both directions, and the tangent between them in both orders.
fn contracted<T: Real>(
    residual: &DofVector<T, DOFS, DOFS>,
    tangent: &BlockMatrix<T, DOFS, DOFS>,
    along: &Directions<T>,
) -> [T; 4] {
    let [delta, linear] = along;
    [
        residual.along(delta),
        residual.along(linear),
        delta.along(&tangent.times(linear)),
        linear.along(&tangent.times(delta)),
    ]
}

/// The sums of the absolute values of the terms of [`contracted`], and at least the energy F_N d: a number may be zero because
/// its directions have few entries.
fn sizes(
    residual: &DofVector<f64, DOFS, DOFS>,
    tangent: &BlockMatrix<f64, DOFS, DOFS>,
    along: &Directions<f64>,
    energy: f64,
) -> [f64; 4] {
    let of = |v: &DofVector<f64, DOFS, DOFS>| DofVector { beam: v.beam.abs(), bar: v.bar.abs() };
    let BlockMatrix { beam, bar_beam, beam_bar, bar } = tangent;
    let tangent =
        BlockMatrix { beam: beam.abs(), bar_beam: bar_beam.abs(), beam_bar: beam_bar.abs(), bar: bar.abs() };
    contracted(&of(residual), &tangent, &along.each_ref().map(of)).map(|size| size.max(energy))
}
