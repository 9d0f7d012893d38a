//! The kernel in its layouts, over any scalar, contracted with two directions, for padded beams.

use super::SCALARS;
use super::layouts::Second;
use super::read::{Contracted, Directions, Read, along};
use crate::linearization::closed_form::Formulation;
use crate::linearization::closed_form::kernel::{Gradient, Target, WithSlips, write_by_shapes_over};
use crate::number::{Real, RunningError};
use crate::pair::{Contact, DofVector};
use crate::test_beam::{DOFS, PaddedBeam};
use nalgebra::SVector;

/// The dofs of both beams.
const BOTH: usize = 2 * DOFS;
/// The entries of a triangle of the Hessian.
const HALF: usize = BOTH * (BOTH + 1) / 2;

/// The numbers in the layouts, by the names of the layouts.
pub(crate) type Layouts<T> = Vec<(&'static str, Contracted<T>)>;

/// A padded pair at a closest point, and the formulation.
#[derive(Clone, Copy)]
struct Padded<'a, T> {
    beams: &'a [PaddedBeam<T>; 2],
    at: (T, T),
    form: Formulation,
    contact: &'a Contact,
}

impl<T: Real> Padded<'_, T> {
    /// With the first `N` and `M` dofs, in this kind of memory; nothing if a curve has no shape functions.
    fn contracted<W: Target<T, N, M> + Read<T>, const N: usize, const M: usize>(
        self,
        memory: fn() -> W,
    ) -> Option<Contracted<T>> {
        let directions = directions::<T, N, M>(self.beams);
        let all = kernel::<_, _, N, M, DOFS>(self.beams, self.at, self.form, self.contact, memory)?;
        Some(all.each_ref().map(|memory| along(memory, &directions)))
    }

    /// In all layouts with a Hessian.
    fn layouts<const N: usize, const M: usize, const S: usize, const H: usize>(
        self,
        names: [&'static str; 3],
    ) -> Layouts<T> {
        let of = |(name, memory)| Some((name, self.contracted(memory)?));
        names.into_iter().zip(Second::<T, N, M, S, H>::ALL).filter_map(of).collect()
    }
}

/// Both directions over the first `N` and `M` dofs.
fn directions<T: Real, const N: usize, const M: usize>(
    [(_, of_beam), (_, of_bar)]: &[PaddedBeam<T>; 2],
) -> Directions<T> {
    [1, 2].map(|i| of_beam[i].iter().take(N).chain(of_bar[i].iter().take(M)).copied().collect())
}

/// In the given formulation, with the first `N` and `M` of the padded dofs, in any memory; nothing if a curve has no
/// shape functions.
pub(crate) fn kernel<T: Real, W: Target<T, N, M>, const N: usize, const M: usize, const D: usize>(
    beams: &[PaddedBeam<T, D>; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
    memory: fn() -> W,
) -> Option<[W; SCALARS]> {
    let [(jet, [q, ..]), (jet_bar, [q_bar, ..])] = beams;
    let q = DofVector { beam: SVector::from_fn(|i, _| q[i]), bar: SVector::from_fn(|i, _| q_bar[i]) };
    let (beam, bar) = (jet.dofs.all_shapes()?, jet_bar.dofs.all_shapes()?);
    let shapes = (beam.map(|shapes| &shapes[..N / 3]), bar.map(|shapes| &shapes[..M / 3]));
    let mut all = std::array::from_fn(|_| memory());
    write_by_shapes_over(shapes, &q, at, form, contact, &mut with_slips(&mut all));
    Some(all)
}

/// The request of all scalars.
pub(super) fn with_slips<W>([d, t, t_bar, xi, xi_bar, g_t, g_t_bar]: &mut [W; SCALARS]) -> WithSlips<'_, W> {
    WithSlips { d, xi, xi_bar, t, t_bar, g_t, g_t_bar }
}

/// With bounds that hold in every layout, in the given formulation; nothing if a curve has no shape functions.
pub(crate) fn bounded_kernel(
    beams: &[PaddedBeam<RunningError>; 2],
    at: (RunningError, RunningError),
    form: Formulation,
    contact: &Contact,
) -> Option<Contracted<RunningError>> {
    let [_, in_full, _] = Second::<RunningError, DOFS, DOFS, BOTH, HALF>::ALL;
    let all = kernel::<_, _, DOFS, DOFS, DOFS>(beams, at, form, contact, in_full)?;
    let directions = directions::<_, DOFS, DOFS>(beams);
    Some(all.each_ref().map(|memory| along(&InAnyLayout(memory), &directions)))
}

/// The whole Hessian, with bounds that hold in every layout: the others compute one triangle or one of two blocks alone, and
/// the entries of the two round differently.
struct InAnyLayout<'a, W>(&'a W);

impl<W: Read<RunningError>> Read<RunningError> for InAnyLayout<'_, W> {
    fn value(&self) -> RunningError {
        self.0.value()
    }

    fn first(&self, i: usize) -> RunningError {
        self.0.first(i)
    }

    fn second(&self, i: usize, j: usize) -> Option<RunningError> {
        let [of, other] = [self.0.second(i, j)?, self.0.second(j, i)?];
        Some(RunningError { bound: of.bound.max(other.bound), ..of })
    }
}

/// In every layout, in the given formulation; empty if a curve has no shape functions.
///
/// Padded beams have 18 + 18 dofs. Where the beams have 6 + 9, 12 + 18 or 18 + 12 dofs, the kernel for these is there too.
pub(crate) fn every_layout<T: Real>(
    beams: &[PaddedBeam<T>; 2],
    dofs: [usize; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
) -> Layouts<T> {
    let of = Padded { beams, at, form, contact };
    let mut all = of.layouts::<DOFS, DOFS, BOTH, HALF>(["kernel, blocks", "kernel, full", "kernel, packed"]);
    let gradient = of.contracted::<_, DOFS, DOFS>(Gradient::<T, BOTH>::zeros);
    all.extend(gradient.map(|numbers| ("kernel, gradient", numbers)));
    all.extend(match dofs {
        [6, 9] => of.layouts::<6, 9, 15, 120>([
            "kernel, blocks of 6 + 9",
            "kernel, full, 6 + 9",
            "kernel, packed, 6 + 9",
        ]),
        [12, 18] => of.layouts::<12, 18, 30, 465>([
            "kernel, blocks of 12 + 18",
            "kernel, full, 12 + 18",
            "kernel, packed, 12 + 18",
        ]),
        [18, 12] => of.layouts::<18, 12, 30, 465>([
            "kernel, blocks of 18 + 12",
            "kernel, full, 18 + 12",
            "kernel, packed, 18 + 12",
        ]),
        _ => Vec::new(),
    });
    all
}
