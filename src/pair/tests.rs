use super::{DofVector, LengthError, Pair};
use crate::curve::{Hermite, Segment};

#[test]
fn dofs_go_to_slices_and_back() {
    let all: Vec<f64> = (0..18).map(f64::from).collect();
    let pair = Pair::<_, _, 6, 12>::new(Segment::new(), Hermite::new());
    let q = pair.dofs(&all[..6], &all[6..]).unwrap();
    assert_eq!((q.beam[5], q.bar[0], q.entry(17)), (5.0, 6.0, 17.0));
    assert_eq!(DofVector::from_slice(&all), Ok(q));
    let mut back = [0.0; 18];
    q.write_to(&mut back).unwrap();
    assert_eq!(back[..], all[..]);
    assert_eq!(q.write_to(&mut back[1..]), Err(LengthError { expected: 18, found: 17 }));
    let error = pair.dofs(&all[..5], &all[6..]).unwrap_err();
    assert_eq!(error.to_string(), "5 numbers where 6 were expected");
    assert_eq!(pair.dofs(&all[..6], &[]), Err(LengthError { expected: 12, found: 0 }));
}
