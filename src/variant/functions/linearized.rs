//! The functions that write gradients and Hessians, at the numbers of dofs that the beams have.

use super::returned::{Answers, Returned};
use super::tabulated::{AtPoint, Image, TabulatedBeams};
use crate::closest_point::ClosestPoint;
use crate::linearization::closed_form::kernel::{DistanceAlone, Gradient, WithoutSlips, write_d_batch};
use crate::linearization::closed_form::{Formulation, Points, jets};
use crate::linearization::{Derivatives, Linearization};
use crate::number::Lanes;
use crate::pair::DofVector;
use crate::variant::kernel::with_slips;
use crate::variant::layouts::Second;
use crate::variant::read::{Directions, Read, along};
use crate::variant::{G_N, SCALAR_COMPONENTS, SCALARS};
use nalgebra::{SMatrix, SVector};

/// The component d.
pub(super) const D: usize = SCALAR_COMPONENTS[0];

/// `linearize`, `linearize_into` and `write` of d, for the given names.
pub(super) fn linearized<const P: usize, const R: usize, const N: usize, const M: usize>(
    [linearize, linearize_into, d_alone]: [&'static str; 3],
    beams: &TabulatedBeams<'_>,
) -> Vec<Returned> {
    let (pair, q, directions) = (beams.pair::<P, R, N, M>(), beams.vector(0), beams.directions());
    let mut into = nowhere();
    pair.linearize_into(&q, beams.point, &mut into);
    let mut d = unwritten();
    pair.write(&q, beams.point, DistanceAlone { d: &mut d });
    vec![
        Returned::new(linearize, every_scalar(&pair.linearize(&q, beams.point), &directions)),
        Returned::new(linearize_into, every_scalar(&into, &directions)),
        Returned::new(d_alone, vec![(D, along(&d, &directions))]),
    ]
}

/// A linearization of numbers that are not numbers, to be overwritten.
pub(super) fn nowhere<const N: usize, const M: usize>() -> Linearization<f64, N, M> {
    let [d, t, t_bar, xi, xi_bar, g_t, g_t_bar] = [unwritten(); SCALARS];
    Linearization { d, t, t_bar, xi, xi_bar, g_t, g_t_bar, radii: f64::NAN }
}

pub(super) fn unwritten<const N: usize, const M: usize>() -> Derivatives<f64, N, M> {
    let mut unwritten = Derivatives::zero();
    unwritten.value = f64::NAN;
    unwritten.gradient = DofVector { beam: SVector::repeat(f64::NAN), bar: SVector::repeat(f64::NAN) };
    let blocks = &mut unwritten.hessian;
    (blocks.beam, blocks.bar) = (SMatrix::repeat(f64::NAN), SMatrix::repeat(f64::NAN));
    blocks.mixed = SMatrix::repeat(f64::NAN);
    unwritten
}

/// All scalars of a linearization.
pub(super) fn every_scalar<const N: usize, const M: usize>(
    of: &Linearization<f64, N, M>,
    directions: &Directions<f64>,
) -> Answers {
    let Linearization { d, t, t_bar, xi, xi_bar, g_t, g_t_bar, .. } = of;
    let scalars: [&dyn Read<f64>; SCALARS] = [d, t, t_bar, xi, xi_bar, g_t, g_t_bar];
    let g_n = (G_N, along(&of.g_n(), directions));
    let all = SCALAR_COMPONENTS.into_iter().zip(scalars);
    all.map(|(i, scalar)| (i, along(scalar, directions))).chain([g_n]).collect()
}

/// Every layout, without slips, without Hessians, without other quantities than d, and in lanes.
///
/// `S` is `N` + `M`, and `H` is `S` (`S` + 1)/2.
pub(super) fn layouts<
    const P: usize,
    const R: usize,
    const N: usize,
    const M: usize,
    const S: usize,
    const H: usize,
>(
    [blocks, full, packed, gradient, no_slips, full_d, packed_d, over, no_slips_over, d_over]: [&'static str;
        10],
    beams: &TabulatedBeams<'_>,
) -> Vec<Returned> {
    let (pair, q, directions) = (beams.pair::<P, R, N, M>(), beams.vector(0), beams.directions());
    let all = |memory: fn() -> Second<f64, N, M, S, H>| {
        let mut all = std::array::from_fn(|_| memory());
        pair.write(&q, beams.point, with_slips(&mut all));
        read(&all, &directions)
    };
    let d_alone = |memory: fn() -> Second<f64, N, M, S, H>| {
        let mut d = memory();
        pair.write(&q, beams.point, DistanceAlone { d: &mut d });
        vec![(D, along(&d, &directions))]
    };
    let mut gradients: [Gradient<f64, S>; SCALARS] = std::array::from_fn(|_| Gradient::zeros());
    pair.write(&q, beams.point, with_slips(&mut gradients));
    let mut first: [Gradient<f64, S>; 5] = std::array::from_fn(|_| Gradient::zeros());
    pair.write(&q, beams.point, without_slips(&mut first));
    let [in_blocks, in_full, in_packed] = Second::ALL;
    // Over any scalar, in a formulation that is given.
    let at = (beams.point.xi, beams.point.xi_bar);
    let (jet, jet_bar) = jets(&pair, &q, at);
    let form = Formulation::at(&Points::new(&jet.geometry, &jet_bar.geometry), beams.point.held());
    let mut all_over = std::array::from_fn(|_| in_blocks());
    pair.write_over(&q, at, form, with_slips(&mut all_over));
    let mut first_over = std::array::from_fn(|_| in_blocks());
    pair.write_over(&q, at, form, without_slips(&mut first_over));
    let mut d_alone_over = in_blocks();
    pair.write_over(&q, at, form, DistanceAlone { d: &mut d_alone_over });
    vec![
        Returned::new(blocks, all(in_blocks)),
        Returned::new(full, all(in_full)),
        Returned::new(packed, all(in_packed)),
        Returned::new(gradient, read(&gradients, &directions)),
        Returned::new(no_slips, read(&first, &directions)),
        Returned::new(full_d, d_alone(in_full)),
        Returned::new(packed_d, d_alone(in_packed)),
        Returned::new(over, read(&all_over, &directions)),
        Returned::new(no_slips_over, read(&first_over, &directions)),
        Returned::new(d_over, vec![(D, along(&d_alone_over, &directions))]),
    ]
}

/// The request of the first scalars.
pub(super) fn without_slips<W>([d, t, t_bar, xi, xi_bar]: &mut [W; 5]) -> WithoutSlips<'_, W> {
    WithoutSlips { d, xi, xi_bar, t, t_bar }
}

/// The first scalars.
pub(super) fn read<T: Read<f64>>(all: &[T], directions: &Directions<f64>) -> Answers {
    SCALAR_COMPONENTS.into_iter().zip(all).map(|(i, memory)| (i, along(memory, directions))).collect()
}

/// Images of the pair: no two lanes of four are alike in their parameters, and the normal's sign alternates.
const IMAGES: [Image; 7] = [
    Image { reversed: [false, false], unit: 1.0, mirrored: None },
    Image { reversed: [true, true], unit: 2.0, mirrored: Some(0) },
    Image { reversed: [true, false], unit: 0.5, mirrored: None },
    Image { reversed: [false, true], unit: 4.0, mirrored: Some(1) },
    Image { reversed: [true, false], unit: 2.0, mirrored: Some(2) },
    Image { reversed: [false, false], unit: 0.25, mirrored: Some(0) },
    Image { reversed: [true, true], unit: 1.0, mirrored: None },
];

/// Batches of four to seven images of the pair: one answer for each of their lanes.
pub(super) fn batches<const P: usize, const R: usize, const N: usize, const M: usize>(
    names: [&'static str; 4],
    beams: &TabulatedBeams<'_>,
) -> Vec<Returned> {
    let pair = beams.pair::<P, R, N, M>();
    let [q, dq, linear_dq] = [0, 1, 2].map(|i| beams.vector::<N, M>(i));
    let images = IMAGES.map(|image| image.at(beams.point));
    let points: [ClosestPoint; 7] = images.map(|image| image.point(beams.point));
    let dofs = images.map(|image| image.vector(&q));
    let all: [AtPoint<'_, P, R, N, M>; 7] =
        std::array::from_fn(|i| AtPoint { pair: &pair, q: &dofs[i], point: &points[i] });
    let in_lanes = |v: &DofVector<f64, N, M>, group: &[Image]| -> Vec<Lanes> {
        let of_lanes: Vec<_> = group.iter().map(|image| image.vector(v)).collect();
        let lane = |i: usize, lane: usize| of_lanes.get(lane).map_or(0.0, |v| v.entry(i));
        (0..N + M).map(|i| Lanes([0, 1, 2, 3].map(|k| lane(i, k)))).collect()
    };
    let of_batch = |(count, name): (usize, &'static str)| {
        let mut to = [Derivatives::<Lanes, N, M>::zero(); 2];
        write_d_batch(&all[..count], &mut to);
        let groups = images[..count].chunks(4).zip(&to);
        let answers = groups.flat_map(|(group, d)| {
            let numbers = along(d, &[&dq, &linear_dq].map(|v| in_lanes(v, group)));
            let of_lane = move |(lane, image): (usize, &Image)| {
                (D, numbers.map(|number| number.map(|number| number.0[lane] / image.unit)))
            };
            group.iter().enumerate().map(of_lane).collect::<Vec<_>>()
        });
        Returned::new(name, answers.collect())
    };
    (4..8).zip(names).map(of_batch).collect()
}
