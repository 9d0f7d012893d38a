//! The element does not allocate.

use super::beams::{Case, STATES, Wish, numbers};
use crate::closest_point::Held;
use crate::contact::{Contribution, Element, Law};
use crate::curve::Hermite;

#[test]
fn nothing_is_allocated_in_an_evaluation() {
    for state in STATES {
        let wish = Wish::new(Held::default(), state, Law::Linear { eps: 100.0 });
        let case: Case<_, _, f64, 12, 12> = Case::new(Hermite::new(), Hermite::new(), wish, numbers(5));
        let found = case.pair.closest_points(&case.q).unwrap();
        let point = found.interior().unwrap();
        let element = Element::new(&case.pair, &wish.parameters).unwrap();
        let mut to = Box::new(Contribution::zeros());
        let mut found = None;
        let counted = allocation_counter::measure(|| {
            found = Some(element.evaluate(&case.q, point, &case.history, &mut to).unwrap().state);
        });
        assert_eq!((found, counted.count_total), (Some(state), 0));
    }
}
