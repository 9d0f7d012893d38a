//! The methods of this crate as candidates: functions with the interface of a peer, and functions that read results.

use crate::cases::{Case, PAIR};
use crate::reference::write_full;
use beamgap::curve::Hermite;
use beamgap::linearization::ad::{
    Route, chord, expand_by_orders, expand_by_sweep, expand_by_vector_dual,
    expand_d_by_orders,
};
use beamgap::linearization::closed_form::kernel::{DistanceAlone, Full, Packed, PairAtPoint, WithoutSlips, write_d_batch};
use beamgap::linearization::closed_form::{Matrices, jets};
use beamgap::linearization::{Derivatives, Linearization, Linearized, Quantities};
use beamgap::number::Lanes;
use std::cell::RefCell;

/// The number of numbers in a block of the full layout.
pub(crate) const FULL: usize = 608;

pub(crate) type Quantity = Derivatives<f64, 12, 12>;
type Row = Full<f64, 24>;

/// A method from a case to a result, and a method from the result to blocks of the full layout.
macro_rules! candidate {
    ($name:ident, $read:ident: $result:ty, $work:expr, $write:expr) => {
        /// # Safety
        /// `q` points to a case, `out` to memory for the result.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(q: *const f64, _xi: f64, _xi_bar: f64, out: *mut f64) {
            let work: fn(&Case, &mut $result) = $work;
            // the caller guarantees this.
            unsafe { work(Case::of(q), &mut *out.cast()) }
        }

        /// # Safety
        /// `out` is what the method wrote, `full` has room for its quantities.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $read(out: *const f64, _pair: usize, full: *mut f64) {
            // the caller guarantees this.
            let (result, full) = unsafe { (&*out.cast::<$result>(), std::slice::from_raw_parts_mut(full, 5 * $crate::candidates::FULL)) };
            let write: fn(&$result, &mut [f64]) = $write;
            write(result, full);
        }
    };
}

pub(crate) use candidate;

pub(crate) fn write(quantities: &[&Quantity], full: &mut [f64]) {
    for (quantity, block) in quantities.iter().zip(full.chunks_exact_mut(FULL)) {
        write_full(quantity, |x| x, block);
    }
}

fn write_rows(quantities: &[Row], full: &mut [f64]) {
    for (quantity, block) in quantities.iter().zip(full.chunks_exact_mut(FULL)) {
        block[0] = quantity.value;
        block[8..32].copy_from_slice(&quantity.gradient);
        block[32..].copy_from_slice(quantity.hessian.as_flattened());
    }
}

candidate!(crate_d, crate_d_read: Quantity, |case, to| {
    let (jet, jet_bar) = jets(&PAIR, &case.q, (case.point.xi, case.point.xi_bar));
    Matrices::new(&jet, &jet_bar, case.point.held()).write_d(to);
}, |d, full| write(&[d], full));

candidate!(crate_all, crate_all_read: Linearization<f64, 12, 12>, |case, to| {
    let at = (case.point.xi, case.point.xi_bar);
    let (jet, jet_bar) = jets(&PAIR, &case.q, at);
    Matrices::new(&jet, &jet_bar, case.point.held()).write_all(at, &PAIR.contact, to);
}, |all, full| write(&[&all.d, &all.xi, &all.xi_bar, &all.t, &all.t_bar], full));

thread_local! {
    /// The last result by value. A caller drops a result before the next call.
    static BY_VALUE: RefCell<Option<Linearized<12, 12>>> = const { RefCell::new(None) };
}

candidate!(linearize_all, linearize_all_read: [f64; 0], |case, _| {
    BY_VALUE.take();
    BY_VALUE.set(Some(PAIR.linearize(&case.q, &case.point)));
}, |_, full| BY_VALUE.with_borrow(|all| {
    let all = all.as_ref().expect("a pair was linearized");
    write(&[&all.d, &all.xi, &all.xi_bar, &all.t, &all.t_bar], full);
}));

candidate!(written_all, written_all_read: Linearization<f64, 12, 12>, |case, to| {
    PAIR.linearize_into(&case.q, &case.point, to);
}, |all, full| write(&[&all.d, &all.xi, &all.xi_bar, &all.t, &all.t_bar], full));

candidate!(blocks_d_full, blocks_d_full_read: Row, |case, to| {
    PAIR.write(&case.q, &case.point, DistanceAlone { d: to });
}, |d, full| write_rows(std::slice::from_ref(d), full));

candidate!(blocks_d_upper, blocks_d_upper_read: Quantity, |case, to| {
    PAIR.write(&case.q, &case.point, DistanceAlone { d: to });
}, |d, full| write(&[d], full));

candidate!(blocks_all_full, blocks_all_full_read: [Row; 5], |case, to| {
    let [d, xi, xi_bar, t, t_bar] = to;
    PAIR.write(&case.q, &case.point, WithoutSlips { d, xi, xi_bar, t, t_bar });
}, |all, full| write_rows(all, full));

candidate!(blocks_all_upper, blocks_all_upper_read: [Quantity; 5], |case, to| {
    let [d, xi, xi_bar, t, t_bar] = to;
    PAIR.write(&case.q, &case.point, WithoutSlips { d, xi, xi_bar, t, t_bar });
}, |all, full| write(&all.each_ref(), full));

/// A quantity of four pairs in the lanes of a vector, with half of its Hessian.
type Four = Packed<Lanes, 24, 300>;

/// A method from four cases to a result.
macro_rules! four {
    ($name:ident, $read:ident: $result:ty, $work:expr) => {
        /// # Safety
        /// `q` points to four pointers to cases, `out` to memory for the result.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $name(q: *const *const f64, out: *mut f64) {
            let work: fn(&[PairAtPoint<'_, Hermite, Hermite, 12, 12>; 4], &mut $result) = $work;
            // the caller guarantees this.
            let cases = unsafe { (&*q.cast::<[*const f64; 4]>()).map(|q| Case::of(q)) };
            // the caller guarantees this.
            let to = unsafe { &mut *out.cast() };
            work(&cases.map(|Case { q, point, .. }| PairAtPoint { pair: &PAIR, q, point }), to);
        }

        /// # Safety
        /// `out` is what the method wrote, `full` has room for its quantities.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $read(out: *const f64, pair: usize, full: *mut f64) {
            // the caller guarantees this.
            let (result, full) = unsafe { (&*out.cast::<$result>(), std::slice::from_raw_parts_mut(full, 5 * $crate::candidates::FULL)) };
            for (of, block) in result.iter().zip(full.chunks_exact_mut(FULL)) {
                write_lane(of, pair, block);
            }
        }
    };
}

fn write_lane(of: &Four, lane: usize, block: &mut [f64]) {
    block[0] = of.value.0[lane];
    for i in 0..24 {
        block[8 + i] = of.gradient[i].0[lane];
        for j in 0..24 {
            block[32 + 24 * i + j] = of.entry(i, j).0[lane];
        }
    }
}

four!(four_d, four_d_read: [Four; 1], |cases, to| {
    write_d_batch(cases, to);
});

/// The quantities of task A.
pub(crate) fn d_only<S>(of: Quantities<S>) -> [S; 1] {
    [of.d]
}

/// The quantities of task B.
pub(crate) fn all<S>(of: Quantities<S>) -> [S; 5] {
    [of.d, of.xi, of.xi_bar, of.t, of.t_bar]
}

/// A method by automatic differentiation for one quantity, and for all.
macro_rules! ad {
    ($d:ident, $d_read:ident, $all:ident, $all_read:ident: |$case:ident, $pick:ident, $steps:ident| $work:expr) => {
        candidate!($d, $d_read: [Quantity; 1], |$case, to| {
            let ($pick, $steps) = (d_only, 1);
            let _ = $steps;
            *to = $work;
        }, |d, full| write(&d.each_ref(), full));
        candidate!($all, $all_read: [Quantity; 5], |$case, to| {
            let ($pick, $steps) = (all, 2);
            let _ = $steps;
            *to = $work;
        }, |all, full| write(&all.each_ref(), full));
    };
}

ad!(chord_d, chord_d_read, chord_all, chord_all_read: |case, pick, steps| {
    let route = Route::Chord(chord(&PAIR, &case.q, &case.point), steps);
    expand_by_sweep(route, &PAIR, &case.q, &case.point, pick)
});

ad!(newton_d, newton_d_read, newton_all, newton_all_read: |case, pick, _steps| {
    expand_by_sweep(Route::Newton, &PAIR, &case.q, &case.point, pick)
});

ad!(stationary_d, stationary_d_read, stationary_all, stationary_all_read: |case, pick, _steps| {
    expand_by_sweep(Route::Stationary, &PAIR, &case.q, &case.point, pick)
});

candidate!(vector_d, vector_d_read: [Quantity; 1], |case, to| {
    let chord = chord(&PAIR, &case.q, &case.point);
    *to = expand_by_vector_dual::<_, _, 12, 12, 24, 1>(chord, 1, &PAIR, &case.q, &case.point, d_only);
}, |d, full| write(&d.each_ref(), full));

candidate!(vector_all, vector_all_read: [Quantity; 5], |case, to| {
    let chord = chord(&PAIR, &case.q, &case.point);
    *to = expand_by_vector_dual::<_, _, 12, 12, 24, 5>(chord, 2, &PAIR, &case.q, &case.point, all);
}, |all, full| write(&all.each_ref(), full));

candidate!(orders_d, orders_d_read: Quantity, |case, to| {
    *to = expand_d_by_orders::<_, _, 12, 12, 8>(&PAIR, &case.q, &case.point);
}, |d, full| write(&[d], full));

candidate!(orders_all, orders_all_read: [Quantity; 5], |case, to| {
    *to = expand_by_orders::<_, _, 12, 12, 8, 5>(&PAIR, &case.q, &case.point, all);
}, |all, full| write(&all.each_ref(), full));
