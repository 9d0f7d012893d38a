//! The kernel in its layouts, over any scalar, contracted with two directions, for padded beams.

use super::SCALARS;
use super::layouts::Second;
use super::read::{Contracted, Directions, Read, along};
use crate::linearization::closed_form::Formulation;
use crate::linearization::closed_form::kernel::{Gradient, Target, write_all_by_shapes_over};
use crate::number::Real;
use crate::pair::{Contact, DofVector};
use crate::test_beam::{DOFS, PaddedBeam};

/// The dofs of both beams.
const BOTH: usize = 2 * DOFS;
/// The entries of a triangle of the Hessian.
const HALF: usize = BOTH * (BOTH + 1) / 2;

/// The numbers in the layouts, by the names of the layouts.
pub(crate) type Layouts<T> = Vec<(&'static str, Contracted<T>)>;

/// In the given formulation and this kind of memory; nothing if a curve has no shape functions.
fn contracted_kernel<T: Real, W: Target<T, DOFS, DOFS> + Read<T>>(
    beams: &[PaddedBeam<T>; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
    memory: fn() -> W,
) -> Option<Contracted<T>> {
    let [(_, of_beam), (_, of_bar)] = beams;
    let directions: Directions<T> =
        [1, 2].map(|i| of_beam[i].iter().chain(of_bar[i].iter()).copied().collect());
    let all = kernel(beams, at, form, contact, memory)?;
    Some(all.each_ref().map(|memory| along(memory, &directions)))
}

/// In the given formulation and in any memory; nothing if a curve has no shape functions.
pub(crate) fn kernel<T: Real, W: Target<T, D, D>, const D: usize>(
    beams: &[PaddedBeam<T, D>; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
    memory: fn() -> W,
) -> Option<[W; SCALARS]> {
    let [(jet, [q, ..]), (jet_bar, [q_bar, ..])] = beams;
    let (shapes, q) =
        ([jet.dofs.all_shapes()?, jet_bar.dofs.all_shapes()?], DofVector { beam: *q, bar: *q_bar });
    let mut all = std::array::from_fn(|_| memory());
    write_all_by_shapes_over(shapes, &q, at, form, contact, &mut all);
    Some(all)
}

/// The memory of padded beams.
type Memory<T> = Second<T, DOFS, DOFS, BOTH, HALF>;

/// In blocks, in the given formulation; nothing if a curve has no shape functions.
pub(crate) fn in_blocks<T: Real>(
    beams: &[PaddedBeam<T>; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
) -> Option<Contracted<T>> {
    contracted_kernel(beams, at, form, contact, Memory::ALL[0])
}

/// In every layout, in the given formulation; empty if a curve has no shape functions.
pub(crate) fn every_layout<T: Real>(
    beams: &[PaddedBeam<T>; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
) -> Layouts<T> {
    let of = |(name, memory)| Some((name, contracted_kernel(beams, at, form, contact, memory)?));
    let gradient = contracted_kernel(beams, at, form, contact, Gradient::<T, BOTH>::zeros);
    let gradient = gradient.map(|numbers| (GRADIENT, numbers));
    NAMES.into_iter().zip(Memory::ALL).filter_map(of).chain(gradient).collect()
}

/// The names of [`Second::ALL`].
const NAMES: [&str; 3] = ["kernel, blocks", "kernel, full", "kernel, packed"];

/// The name of the layout without Hessians.
const GRADIENT: &str = "kernel, gradient";
