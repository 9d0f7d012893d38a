//! No evaluation of the curves, the closed form or AD allocates; the first linearization by value of a thread does.

use crate::pairs::{Contacting, contacting, hermite};
use beamgap::linearization::closed_form::kernel::{Packed, PairAtPoint, write_d_batch};
use beamgap::linearization::{Linearization, ad, closed_form};
use beamgap::number::Lanes;
use proptest::{strategy::Strategy, strategy::ValueTree, test_runner::TestRunner};

#[test]
fn nothing_is_allocated_in_an_evaluation() {
    let mut runner = TestRunner::deterministic();
    let case = contacting(hermite(), hermite()).new_tree(&mut runner).unwrap().current();
    let Contacting { pair, q, point, dq, linear_dq } = &case;
    let at = (point.xi, point.xi_bar);
    let mut all = Linearization::<f64, 12, 12>::zeros();
    let mut four = Packed::<Lanes, 24, 300>::zeros();
    drop(pair.linearize(q, point));
    let counted = allocation_counter::measure(|| {
        let (jet, jet_bar) = closed_form::jets(pair, q, at);
        closed_form::Matrices::new(&jet, &jet_bar, point.held()).write_all(at, &pair.contact, &mut all);
        let written =
            write_d_batch(&[(); 4].map(|()| PairAtPoint { pair, q, point }), std::slice::from_mut(&mut four));
        assert_eq!(std::hint::black_box((written, &four)).0, 4);
        std::hint::black_box(pair.linearize(q, point));
        std::hint::black_box(closed_form::vary(pair, q, point, dq, linear_dq));
        std::hint::black_box(ad::vary(ad::Route::Newton, pair, q, point, dq, linear_dq));
        std::hint::black_box(ad::expand_by_orders::<_, _, 12, 12, 8, 1>(pair, q, point, |q| [q.xi]));
    });
    assert_eq!(counted.count_total, 0);
    // Checks that the counter counts.
    assert_eq!(allocation_counter::measure(|| drop(std::hint::black_box(vec![0_u8; 8]))).count_total, 1);
}
