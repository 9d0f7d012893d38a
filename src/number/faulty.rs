//! A scalar that injects a fault into one of its operations, or into the terms of one name.
//!
//! No code branches on a [`Real`], so operation k of one run is operation k of every other run of the same code. Wrong
//! operands of an operation are therefore injected by replacing its result by that of the same operation in a run with
//! other operands, for example with the directions or the beams exchanged.

mod bits;
mod runs;

pub(crate) use bits::Bits;
pub(crate) use runs::{
    Change, TermChange, counted, locate, operations, terms, terms_with, with_operation, with_terms,
};

use super::{Label, Real, field_from_operators};
use runs::{CHANGE, CHANGES, LABELS, Mode, Next, RECORD, STATE, State, TERMS, TRACE};
use std::backtrace::Backtrace;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number whose operations are counted, recorded or made faulty, separately on each thread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Faulty<T>(pub(crate) T);

/// The result of an operation, with or without a fault.
#[inline(always)]
fn done<T: Bits>(result: T) -> Faulty<T> {
    match STATE.with(State::next) {
        Next::Unchanged => {}
        Next::Recorded => record(result),
        Next::Wrong => return Faulty(wrong(result)),
    }
    Faulty(result)
}

#[cold]
#[inline(never)]
fn wrong<T: Bits>(result: T) -> T {
    if STATE.with(|state| state.mode.get()) == Mode::Locate {
        TRACE.set(Backtrace::force_capture().to_string());
    }
    CHANGE.get().of(result)
}

#[cold]
#[inline(never)]
fn record<T: Bits>(result: T) {
    RECORD.with_borrow_mut(|record| record.push(result.bits()));
}

// In a build for tests these operations are calls, so that the formulas over them compile in less time.
macro_rules! operator {
    ($($operator:ident $apply:ident),*) => {$(
        impl<T: Bits> $operator for Faulty<T> {
            type Output = Self;
            #[cfg_attr(debug_assertions, inline(never))]
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn $apply(self, other: Self) -> Self {
                done($operator::$apply(self.0, other.0))
            }
        }
    )*};
}
operator!(Add add, Sub sub, Mul mul, Div div);

impl<T: Bits> Neg for Faulty<T> {
    type Output = Self;
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(self) -> Self {
        done(-self.0)
    }
}

impl<T: Bits> From<f64> for Faulty<T> {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Self(T::from(value))
    }
}

field_from_operators!([T: Bits] Faulty<T>);

impl<T: Bits> Real for Faulty<T> {
    fn sqrt(self) -> Self {
        done(self.0.sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (done(sin), done(cos))
    }

    fn named(self, label: Label) -> Self {
        let place = TERMS.get();
        TERMS.set(place + 1);
        let (mode, after_fault) =
            STATE.with(|state| (state.mode.get(), state.count.get() > state.wrong.get()));
        if mode == Mode::RecordTerms || mode == Mode::Locate && after_fault {
            LABELS.with_borrow_mut(|labels| labels.push(label));
        }
        let value = CHANGES.with_borrow(|changes| {
            let of_label = changes.iter().filter(|(changed, _)| *changed == label);
            of_label.fold(self.0, |value, (_, change)| match change {
                TermChange::Times(factor) => value * T::from(*factor),
                TermChange::Instead(terms) => {
                    let other = terms.get(place).map(|&bits| T::from_bits(bits));
                    other.filter(|other| other.is_finite()).unwrap_or(value)
                }
                TermChange::Orders => value,
            })
        });
        if mode == Mode::RecordTerms {
            record(value);
        }
        Self(value)
    }

    fn orders(label: Label, [k, l]: [usize; 2]) -> [usize; 2] {
        let is_exchanged = |(changed, change): &(Label, TermChange)| {
            *changed == label && matches!(change, TermChange::Orders)
        };
        let exchanged = CHANGES.with_borrow(|changes| changes.iter().any(is_exchanged));
        if exchanged { [l, k] } else { [k, l] }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        Change, Faulty, TermChange, counted, operations, terms, terms_with, with_operation, with_terms,
    };
    use crate::number::{Formula, Label, Real, named, orders};

    const LABEL: Label = Label::of_beam(Formula::D, "ab");

    fn formula([a, b]: [f64; 2]) -> f64 {
        let [a, b] = [a, b].map(Faulty);
        (named(Formula::D, "ab", a * b) + named(Formula::D, "b", -b) / Faulty::from(4.0)).sqrt().0
    }

    #[test]
    fn every_operation_and_every_term_can_be_recorded() {
        assert_eq!(counted(|| formula([4.0, 8.0])), (30_f64.sqrt(), 5));
        let values = |bits: Vec<u64>| bits.into_iter().map(f64::from_bits).collect::<Vec<_>>();
        let all = operations(|| formula([4.0, 8.0]));
        assert_eq!(values(all), [32.0, -8.0, -2.0, 30.0, 30_f64.sqrt()]);
        assert_eq!(values(terms(|| formula([4.0, 8.0])).1), [32.0, -8.0]);
    }

    #[test]
    fn one_operation_is_wrong_and_no_other() {
        let with = |k, change| with_operation(k, change, || formula([4.0, 8.0])).to_bits();
        let root = |x: f64| x.sqrt().to_bits();
        assert_eq!(with(0, Change::Times(0.5)), root(14.0));
        assert_eq!(with(1, Change::Times(-1.0)), root(34.0));
        assert_eq!(with(2, Change::Instead(6.0_f64.to_bits())), root(38.0));
        assert_eq!(with(3, Change::PlusOne), root(31.0));
        assert_eq!(with(5, Change::PlusOne), root(30.0));
        // A fault in one run does not affect the next run.
        assert_eq!(formula([4.0, 8.0]).to_bits(), root(30.0));
    }

    #[test]
    fn terms_of_one_name_are_wrong() {
        let with = |change| with_terms(vec![(LABEL, change)], || formula([4.0, 8.0]));
        assert_eq!(with(TermChange::Times(2.0)).to_bits(), 62_f64.sqrt().to_bits());
        let (_, labels, bits) = terms_with(vec![(LABEL, TermChange::Times(2.0))], || formula([4.0, 8.0]));
        assert_eq!(labels[0], LABEL);
        assert_eq!(bits, [64.0_f64, -8.0].map(f64::to_bits));
        let (_, other) = terms(|| formula([5.0, 7.0]));
        assert_eq!(with(TermChange::Instead(other.into())).to_bits(), 33_f64.sqrt().to_bits());
        assert_eq!(
            with_terms(vec![(LABEL, TermChange::Orders)], || orders::<Faulty<f64>>(Formula::D, "ab", [0, 1])),
            [1, 0]
        );
        assert_eq!(orders::<Faulty<f64>>(Formula::D, "ab", [0, 1]), [0, 1]);
    }
}
