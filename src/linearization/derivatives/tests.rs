use super::{BlockHessian, Linearization};
use crate::closest_point::Held;
use crate::curve::{Hermite, Segment};
use crate::linearization::closed_form::kernel::{DistanceAlone, Packed};
use crate::pair::{Contact, LengthError, Pair};

#[test]
fn a_matrix_in_each_layout_has_the_same_entries() {
    let mut matrix = BlockHessian::<f64, 2, 3>::zeros();
    for j in 0..5_u8 {
        for i in 0..=j {
            matrix.set(i.into(), j.into(), f64::from(10 * i + j));
        }
    }
    let dense = matrix.to_dense();
    let (mut rows, mut packed) = ([0.0; 25], [0.0; 15]);
    matrix.write_dense(&mut rows).unwrap();
    matrix.write_packed(&mut packed).unwrap();
    for i in 0..5 {
        for j in 0..5 {
            let entry = matrix.entry(i, j);
            assert_eq!((dense[(i, j)], rows[5 * i + j]), (entry, entry));
            let (i, j) = (i.min(j), i.max(j));
            assert_eq!(packed[i + j * (j + 1) / 2].to_bits(), entry.to_bits());
        }
    }
    assert_eq!(packed[..4], [0.0, 1.0, 11.0, 2.0]);
    assert_eq!(matrix.write_dense(&mut rows[1..]), Err(LengthError { expected: 25, found: 24 }));
    assert_eq!(matrix.write_packed(&mut packed[1..]), Err(LengthError { expected: 15, found: 14 }));
}

#[test]
fn a_pair_is_linearized_by_the_kernel() {
    let contact = Contact { radius: 0.1, radius_bar: 0.05, xi_0: -0.2, xi_bar_0: 0.3 };
    let pair = Pair::new(Segment::new(), Hermite::new()).with_contact(contact);
    let beam = [-1.0, 0.0, 0.0, 1.0, 0.25, 0.0];
    let bar = [0.0, -1.0, 0.5, 0.0, 1.0, -0.1, 0.0, 1.0, 0.5, 0.0, 1.0, 0.1];
    let q = (beam, bar).into();
    let found = pair.closest_points(&q).unwrap();
    let point = found.interior().unwrap();
    let all = pair.linearize(&q, point);
    // g_N = d - (r + r_bar) and g_T = (xi - xi_0) t
    assert!((all.g_n().value - (point.distance - 0.15)).abs() < 1e-15);
    assert!((all.g_t.value - (point.xi + 0.2) * all.t.value).abs() < 1e-15);
    assert_eq!((all.g_n().gradient, all.g_n().hessian), (all.d.gradient, all.d.hessian));
    let mut again = Linearization::zeros();
    pair.linearize_into(&q, point, &mut again);
    assert_eq!(*all, again);
    let (mut packed, mut theirs) = ([0.0; 171], Packed::<f64, 18, 171>::zeros());
    all.d.hessian.write_packed(&mut packed).unwrap();
    pair.write(&q, point, DistanceAlone { d: &mut theirs });
    let largest = packed.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    assert!(packed.iter().zip(&theirs.hessian).all(|(x, y)| (x - y).abs() <= 1e-14 * largest));
    let start = (point.xi + 0.01, point.xi_bar);
    let refined = pair.refine(&q, start, Held::default()).unwrap();
    assert!((refined.xi - point.xi).abs() < 1e-15);
}
