//! Terms with faults planted: the same code, with one term's factor or operands changed.

use super::fault::{Fault, Kind};
use crate::curve::{Geometry, Jet};
use crate::linearization::closed_form::{Frozen, Jets, Label, Operands, Points, System, Terms};
use crate::number::Real;
use crate::specimen::Padded;
use std::ops::Mul;

/// What becomes of a term.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Change<T> {
    /// It is multiplied.
    Factor(T),
    /// It is made of other operands.
    Operands(Kind),
}

impl<T: Real> Change<T> {
    /// The changes that faults make.
    pub(crate) fn of(faults: &[Fault]) -> Vec<(Label, Self)> {
        let change = |kind: Kind| match kind.factor() {
            Some(factor) => Self::Factor(T::from(factor)),
            None => Self::Operands(kind),
        };
        faults.iter().map(|fault| (fault.label, change(fault.kind))).collect()
    }
}

/// Both beams at the parameters of the step before.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stale<'a, T, const D: usize> {
    /// No fault asks for them.
    Unused,
    /// For the variations.
    Frozen(&'a [Frozen<T>; 2]),
    /// For the matrices.
    Jets(&'a [Jet<T, Padded<T, D>>; 2]),
}

impl<T: Real, const D: usize> Stale<'_, T, D> {
    fn geometry(&self) -> Option<[Geometry<T>; 2]> {
        match self {
            Self::Unused => None,
            Self::Frozen(frozen) => Some(frozen.each_ref().map(|frozen| frozen.geometry)),
            Self::Jets(jets) => Some(jets.each_ref().map(|jet| jet.geometry)),
        }
    }
}

/// Evaluates all terms, the changed ones with their changes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Planted<'a, T, const D: usize> {
    pub(crate) changes: &'a [(Label, Change<T>)],
    pub(crate) stale: Stale<'a, T, D>,
}

impl<'a, T: Real, const D: usize> Planted<'a, T, D> {
    fn changes(&self, label: Label) -> impl Iterator<Item = Change<T>> {
        self.changes.iter().filter(move |change| change.0 == label).map(|change| change.1)
    }

    /// What a term is made of instead, and what it is multiplied by, if it is changed.
    ///
    /// It is compiled once for all terms of such operands, which are not copied for the others.
    #[inline(never)]
    fn changed<O: Substitute<'a, T, D>>(&self, label: Label, operands: &O) -> Option<(O, Option<T>)> {
        self.changes(label).next()?;
        let (mut operands, mut factor) = (*operands, None);
        for change in self.changes(label) {
            match change {
                Change::Factor(by) => factor = Some(factor.map_or(by, |factor| factor * by)),
                Change::Operands(kind) => operands = operands.substituted(kind, &self.stale),
            }
        }
        Some((operands, factor))
    }
}

impl<'a, T: Real, O: Substitute<'a, T, D>, const D: usize> Terms<T, O> for Planted<'a, T, D> {
    fn term<V: Mul<T, Output = V>>(&self, label: Label, operands: &O, term: impl Fn(&O) -> V) -> V {
        let changed = self.changed(label, operands);
        let (operands, factor) =
            changed.as_ref().map_or((operands, None), |(other, factor)| (other, *factor));
        let value = term(operands);
        match factor {
            Some(factor) => value * factor,
            None => value,
        }
    }

    fn product(
        &self,
        label: Label,
        operands: &O,
        (k, l): (usize, usize),
        mut add: impl FnMut(&O, T, (usize, usize)),
    ) {
        let (mut operands, mut factor, mut orders) = (*operands, T::one(), (k, l));
        for change in self.changes(label) {
            match change {
                Change::Factor(by) => factor *= by,
                Change::Operands(Kind::Transposed) => orders = (orders.1, orders.0),
                Change::Operands(kind) => operands = operands.substituted(kind, &self.stale),
            }
        }
        add(&operands, factor, orders);
    }
}

/// Operands that can be mistaken for others.
pub(crate) trait Substitute<'a, T, const D: usize>: Copy {
    /// The operands of a fault; the same ones where it makes no sense.
    fn substituted(self, kind: Kind, stale: &Stale<'a, T, D>) -> Self;
}

impl<'a, T: Real, const D: usize> Substitute<'a, T, D> for Operands<T> {
    fn substituted(self, kind: Kind, stale: &Stale<'a, T, D>) -> Self {
        match (kind, stale) {
            (Kind::Transposed, _) => self.exchanged(),
            (Kind::Swapped, _) => Self { beam: self.bar, bar: self.beam, ..self },
            (Kind::BarForgotten, _) => Self { bar: self.beam, ..self },
            (Kind::Stale, Stale::Frozen(frozen)) => {
                let mut all = self;
                for (side, frozen) in [&mut all.beam, &mut all.bar].into_iter().zip(frozen.iter()) {
                    side.geometry = frozen.geometry;
                    (side.delta.u, side.linear.u, side.second.u) =
                        (frozen.delta_u, frozen.linear_u, frozen.second_u);
                }
                all.d = all.beam.geometry.x - all.bar.geometry.x;
                all
            }
            _ => self,
        }
    }
}

impl<'a, T: Real, const D: usize> Substitute<'a, T, D> for Points<T> {
    fn substituted(self, kind: Kind, stale: &Stale<'a, T, D>) -> Self {
        match kind {
            Kind::Swapped => Self { beam: self.bar, bar: self.beam, ..self },
            Kind::BarForgotten => Self { bar: self.beam, ..self },
            Kind::Stale => stale.geometry().map_or(self, |[beam, bar]| Self::new(&beam, &bar)),
            _ => self,
        }
    }
}

impl<'a, T: Real, const D: usize> Substitute<'a, T, D> for System<T> {
    fn substituted(self, kind: Kind, _: &Stale<'a, T, D>) -> Self {
        let Self { matrix: [a, b, a_bar], r, r_bar } = self;
        match kind {
            Kind::Swapped => Self { matrix: [a_bar, b, a], r: r_bar, r_bar: r },
            Kind::BarForgotten => Self { matrix: [a, b, a], r, r_bar: r },
            _ => self,
        }
    }
}

impl<'a, T: Real, const D: usize> Substitute<'a, T, D> for Jets<'a, T, Padded<T, D>, Padded<T, D>, D, D> {
    fn substituted(self, kind: Kind, stale: &Stale<'a, T, D>) -> Self {
        let Self { jet, jet_bar, matrix: [a, b, a_bar], g, g_bar, .. } = self;
        match (kind, stale) {
            (Kind::Swapped, _) => {
                Self { jet: jet_bar, jet_bar: jet, matrix: [a_bar, b, a], g: g_bar, g_bar: g, ..self }
            }
            (Kind::BarForgotten, _) => Self { jet_bar: jet, matrix: [a, b, a], g_bar: g, ..self },
            (Kind::Stale, Stale::Jets([jet, jet_bar])) => {
                Self { jet, jet_bar, d: jet.geometry.x - jet_bar.geometry.x, ..self }
            }
            _ => self,
        }
    }
}

/// The length of a tangent knows one beam only.
impl<'a, T: Real, const D: usize> Substitute<'a, T, D> for Geometry<T> {
    fn substituted(self, _: Kind, _: &Stale<'a, T, D>) -> Self {
        self
    }
}

/// A slip is made of what has been computed.
impl<'a, T, const D: usize> Substitute<'a, T, D> for () {
    fn substituted(self, _: Kind, _: &Stale<'a, T, D>) {}
}
