//! The kernel in its layouts, contracted with two directions, for padded beams.

use super::SCALARS;
use super::layouts::{BOTH, Memory, Second};
use crate::closest_point::ClosestPoint;
use crate::curve::{Curve, Jet, Shapes};
use crate::linearization::closed_form::Formulation;
use crate::linearization::closed_form::kernel::{
    Gradient, PairAtPoint, Target, Targets, write_all_by_shapes_over, write_all_with_slips, write_d,
    write_d_batch,
};
use crate::number::{Lanes, Real};
use crate::pair::{Contact, DofVector, Pair};
use crate::test_beam::{DOFS, Padded, PaddedBeam};
use nalgebra::{SVector, Vector3};

/// Value, gradient along both directions, and Hessian along both, of each scalar; nothing for missing ones.
pub(crate) type Contracted<T> = [[Option<T>; 4]; SCALARS];

/// The numbers in the layouts, by the names of the layouts.
pub(crate) type Layouts<T> = Vec<(&'static str, Contracted<T>)>;

/// In scalar arithmetic, in the given formulation and this kind of memory; nothing if a curve has no shape functions.
fn contracted_kernel<T: Real, W: Memory<T>>(
    beams: &[PaddedBeam<T>; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
    memory: fn() -> W,
) -> Option<Contracted<T>> {
    let [_, directions @ ..] = vectors(beams);
    Some(read(&kernel(beams, at, form, contact, memory)?, &directions))
}

/// In scalar arithmetic, in the given formulation and in any memory; nothing if a curve has no shape functions.
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

/// In every layout, in scalar arithmetic and in the given formulation; empty if a curve has no shape functions.
pub(crate) fn every_layout<T: Real>(
    beams: &[PaddedBeam<T>; 2],
    at: (T, T),
    form: Formulation,
    contact: &Contact,
) -> Layouts<T> {
    let of = |(name, memory)| Some((name, contracted_kernel(beams, at, form, contact, memory)?));
    let gradient = contracted_kernel(beams, at, form, contact, Gradient::<T, BOTH>::zeros);
    let gradient = gradient.map(|numbers| (GRADIENT, numbers));
    NAMES.into_iter().zip(Second::ALL).filter_map(of).chain(gradient).collect()
}

/// The names of [`Second::ALL`].
const NAMES: [&str; 3] = ["kernel, blocks", "kernel, full", "kernel, packed"];

/// The name of the layout without Hessians.
const GRADIENT: &str = "kernel, gradient";

/// In every layout, by the public functions and with the vector units of the machine.
///
/// Empty if a curve has no shape functions.
pub(crate) fn fast_kernel(
    beams: &[PaddedBeam<f64>; 2],
    point: &ClosestPoint,
    contact: Contact,
) -> Layouts<f64> {
    let [Some(curve), Some(curve_bar)] = beams.each_ref().map(|(jet, _)| Tabulated::new(jet)) else {
        return Vec::new();
    };
    let pair = Pair { curve, curve_bar, contact };
    let vectors = vectors(beams);
    let one = One { pair: &pair, point, vectors: &vectors };
    let four = Four::new(&pair, point, &vectors);
    let [blocks, full, packed] = Second::ALL;
    let [of_four, ..] = Second::ALL;
    vec![
        (NAMES[0], one.all(blocks)),
        (NAMES[1], one.all(full)),
        (NAMES[2], one.all(packed)),
        (GRADIENT, one.all(Gradient::<f64, BOTH>::zeros)),
        ("kernel, d alone", one.d(blocks)),
        ("kernel in lanes, d alone", four.d(of_four)),
    ]
}

fn read<T: Real, W: Memory<T>>(
    all: &[W; SCALARS],
    directions: &[DofVector<T, DOFS, DOFS>; 2],
) -> Contracted<T> {
    all.each_ref().map(|memory| memory.contracted(directions))
}

/// Dofs and directions of both beams.
fn vectors<T: Real>([(_, of_beam), (_, of_bar)]: &[PaddedBeam<T>; 2]) -> [DofVector<T, DOFS, DOFS>; 3] {
    [0, 1, 2].map(|i| DofVector { beam: of_beam[i], bar: of_bar[i] })
}

/// A curve that is known at one parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Tabulated(Shapes<f64, { DOFS / 3 }>);

impl Tabulated {
    fn new(jet: &Jet<f64, Padded<f64>>) -> Option<Self> {
        let derivatives = jet.dofs.all_shapes()?.map(|shapes| std::array::from_fn(|i| shapes[i]));
        Some(Self(Shapes { derivatives }))
    }
}

impl Curve<DOFS> for Tabulated {
    type Dofs<T: Real> = Shapes<T, { DOFS / 3 }>;

    fn position<T: Real>(&self, q: &SVector<T, DOFS>, xi: T) -> Vector3<T> {
        self.jet(q, xi).geometry.x
    }

    fn jet<T: Real>(&self, q: &SVector<T, DOFS>, _: T) -> Jet<T, Self::Dofs<T>> {
        Shapes::jet(self.0.derivatives.map(|n| n.map(T::from)), q)
    }

    fn third_derivative_bound(&self, _: &SVector<f64, DOFS>) -> f64 {
        f64::INFINITY
    }
}

/// One pair.
struct One<'a> {
    pair: &'a Pair<Tabulated, Tabulated, DOFS, DOFS>,
    point: &'a ClosestPoint,
    vectors: &'a [DofVector<f64, DOFS, DOFS>; 3],
}

impl One<'_> {
    fn all<W: Memory<f64>>(&self, memory: fn() -> W) -> Contracted<f64> {
        let [q, directions @ ..] = self.vectors;
        let mut all: [W; SCALARS] = std::array::from_fn(|_| memory());
        let [d, t, t_bar, xi, xi_bar, g_t, g_t_bar] = &mut all;
        let to = &mut Targets { d, xi, xi_bar, t, t_bar };
        write_all_with_slips(self.pair, q, self.point, to, [g_t, g_t_bar]);
        read(&all, directions)
    }

    fn d<W: Memory<f64>>(&self, memory: fn() -> W) -> Contracted<f64> {
        let [q, directions @ ..] = self.vectors;
        let mut d = memory();
        write_d(self.pair, q, self.point, &mut d);
        alone(d.contracted(directions))
    }
}

/// The numbers of d, without other quantities.
fn alone(d: [Option<f64>; 4]) -> Contracted<f64> {
    let mut all = [[None; 4]; SCALARS];
    all[0] = d;
    all
}

/// The units of length of the four pairs in the lanes: powers of two, so that all scaling is exact.
const UNITS: [f64; 4] = [1.0, 2.0, 0.5, 4.0];

/// Four pairs that differ by the unit of length.
struct Four<'a> {
    pair: &'a Pair<Tabulated, Tabulated, DOFS, DOFS>,
    point: &'a ClosestPoint,
    q: [DofVector<f64, DOFS, DOFS>; 4],
    directions: [DofVector<Lanes, DOFS, DOFS>; 2],
}

impl<'a> Four<'a> {
    fn new(
        pair: &'a Pair<Tabulated, Tabulated, DOFS, DOFS>,
        point: &'a ClosestPoint,
        [q, dq, linear_dq]: &[DofVector<f64, DOFS, DOFS>; 3],
    ) -> Self {
        let in_lanes = |v: &DofVector<f64, DOFS, DOFS>| {
            let lanes = |x: f64| Lanes(UNITS.map(|unit| x * unit));
            DofVector { beam: v.beam.map(lanes), bar: v.bar.map(lanes) }
        };
        let q = UNITS.map(|unit| q.times(unit));
        Self { pair, point, q, directions: [in_lanes(dq), in_lanes(linear_dq)] }
    }

    fn pairs_at_points(&self) -> [PairAtPoint<'_, Tabulated, Tabulated, DOFS, DOFS>; 4] {
        self.q.each_ref().map(|q| PairAtPoint { pair: self.pair, q, point: self.point })
    }

    fn d(&self, memory: fn() -> Second<Lanes>) -> Contracted<f64> {
        let mut to = [memory()];
        write_d_batch(&self.pairs_at_points(), &mut to);
        let [d] = to.map(|memory| memory.contracted(&self.directions));
        alone(length(d, 0))
    }
}

/// A length, in one lane.
fn length(numbers: [Option<Lanes>; 4], lane: usize) -> [Option<f64>; 4] {
    numbers.map(|numbers| numbers.map(|numbers| numbers.0[lane] / UNITS[lane]))
}
