mod segment {
#[test]
fn x_x_delta() {
    use beamgap::curve::Segment;
    use beamgap::linearization::{ad, closed_form};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Segment::new(), Segment::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([-1.0, 0.0, 0.25, 1.0, 0.0, 0.25]),
        bar: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).x.x.delta;
    let other = ad::vary(ad::Route::Chord(ad::chord(&pair, &q, point), 2), &pair, &q, point, &dq, &linear_dq).x.x.delta;
    assert!((closed - other).abs() <= 8.3e-15, "{closed:e}, not {other:e}");
}
}
mod quadratic {
#[test]
fn symmetry_of_x_z_second() {
    use beamgap::curve::{Quadratic, Segment};
    use beamgap::linearization::closed_form;
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Segment::new(), Quadratic::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
        bar: SVector::from([-1.0, 0.0, 0.25, 0.0, 0.0, 0.0, 1.0, 0.0, 0.25]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).x.z.second;
    let other = closed_form::vary(&pair, &q, point, &linear_dq, &dq).x.z.second;
    assert!((closed - other).abs() <= 4.3e-15, "{closed:e}, not {other:e}");
}
}
mod cubic {
#[test]
fn x_bar_z_linear() {
    use beamgap::curve::{Cubic, Segment};
    use beamgap::linearization::{ad, closed_form};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Cubic::new(), Segment::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([-1.0, 0.0, 0.25, -0.5, 0.0, 0.0625, 0.5, 0.0, 0.0625, 1.0, 0.0, 0.25]),
        bar: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).x_bar.z.linear;
    let other = ad::vary(ad::Route::Newton, &pair, &q, point, &dq, &linear_dq).x_bar.z.linear;
    assert!((closed - other).abs() <= 1.3e-15, "{closed:e}, not {other:e}");
}
}
mod hermite {
#[test]
fn d_vector_y_delta() {
    use beamgap::curve::{Hermite, Segment};
    use beamgap::linearization::{ad, closed_form};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Segment::new(), Hermite::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
        bar: SVector::from([-1.0, 0.0, 0.25, 1.0, 0.0, -0.5, 1.0, 0.0, 0.25, 1.0, 0.0, 0.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).d_vector.y.delta;
    let other = ad::vary(ad::Route::Stationary, &pair, &q, point, &dq, &linear_dq).d_vector.y.delta;
    assert!((closed - other).abs() <= 3.3e-14, "{closed:e}, not {other:e}");
}
}
mod hermite_scaled {
#[test]
fn t_vector_x_value() {
    use beamgap::curve::{Hermite, Segment};
    use beamgap::linearization::{ad, closed_form};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Hermite::scaled_by(2.0), Segment::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([-1.0, 0.0, 0.25, 1.0, 0.0, -0.5, 1.0, 0.0, 0.25, 1.0, 0.0, 0.5]),
        bar: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).t_vector.x.value;
    let other = ad::vary(ad::Route::Chord(ad::chord(&pair, &q, point), 2), &pair, &q, point, &dq, &linear_dq).t_vector.x.value;
    assert!((closed - other).abs() <= 2.3e-15, "{closed:e}, not {other:e}");
}
}
mod bezier {
#[test]
fn t_vector_z_second() {
    use beamgap::curve::{Bezier, Segment};
    use beamgap::linearization::{ad, closed_form};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Segment::new(), Bezier::<6>::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
        bar: SVector::from([-1.0, 0.0, 0.25, -0.5, 0.0, 0.0625, -0.5, 0.0, 0.0625, 0.5, 0.0, 0.0625, 0.5, 0.0, 0.0625, 1.0, 0.0, 0.25]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).t_vector.z.second;
    let other = ad::vary(ad::Route::Chord(ad::chord(&pair, &q, point), 2), &pair, &q, point, &dq, &linear_dq).t_vector.z.second;
    assert!((closed - other).abs() <= 0.0e0, "{closed:e}, not {other:e}");
}
}
mod bspline {
#[test]
fn t_bar_vector_z_delta() {
    use beamgap::curve::{BSpline, Segment};
    use beamgap::linearization::{ad, closed_form};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(BSpline::<4>::new(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]).unwrap(), Segment::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([-3.0, 0.0, 2.25, -1.0, 0.0, 0.25, 1.0, 0.0, 0.25, 3.0, 0.0, 2.25]),
        bar: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).t_bar_vector.z.delta;
    let other = ad::vary(ad::Route::Newton, &pair, &q, point, &dq, &linear_dq).t_bar_vector.z.delta;
    assert!((closed - other).abs() <= 8.9e-16, "{closed:e}, not {other:e}");
}
}
mod nurbs {
#[test]
fn t_value() {
    use beamgap::curve::{Nurbs, Segment};
    use beamgap::linearization::{ad, closed_form};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Segment::new(), Nurbs::<3>::new(&[0.0, 1.0, 2.0, 3.0], [1.0, 0.5, 2.0]).unwrap()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
        bar: SVector::from([-2.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 1.0]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).t.value;
    let other = ad::vary(ad::Route::Stationary, &pair, &q, point, &dq, &linear_dq).t.value;
    assert!((closed - other).abs() <= 4.0e-15, "{closed:e}, not {other:e}");
}
}
mod nurbs_weighted {
#[test]
fn xi_second() {
    use beamgap::curve::{NurbsWeighted, Segment};
    use beamgap::linearization::{ad, closed_form};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(NurbsWeighted::<4>::new(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]).unwrap(), Segment::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([-3.0, 0.0, 2.25, 1.0, -1.0, 0.0, 0.25, 2.0, 1.0, 0.0, 0.25, 1.0, 3.0, 0.0, 2.25, 0.5]),
        bar: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).xi.second;
    let other = ad::vary(ad::Route::Stationary, &pair, &q, point, &dq, &linear_dq).xi.second;
    assert!((closed - other).abs() <= 5.1e-12, "{closed:e}, not {other:e}");
}
}
mod arc {
#[test]
fn g_n_linear() {
    use beamgap::curve::{Arc, Segment};
    use beamgap::linearization::{ad, closed_form};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Segment::new(), Arc::new(0.75)).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
        bar: SVector::from([0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, -1.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).g_n.linear;
    let other = ad::vary(ad::Route::Chord(ad::chord(&pair, &q, point), 2), &pair, &q, point, &dq, &linear_dq).g_n.linear;
    assert!((closed - other).abs() <= 1.9e-14, "{closed:e}, not {other:e}");
}
}
mod helix {
#[test]
fn matrix_of_d_delta() {
    use beamgap::curve::{Helix, Segment};
    use beamgap::linearization::closed_form;
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Helix::new(0.75), Segment::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.5, -1.5]),
        bar: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).d.delta;
    let other = pair.linearize(&q, point).d.gradient.along(&dq);
    assert!((closed - other).abs() <= 3.0e-14, "{closed:e}, not {other:e}");
}
}
mod d_alone_value {
#[test]
fn function_of_d_value() {
    use beamgap::curve::{Hermite, Segment};
    use beamgap::linearization::closed_form;
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Hermite::new(), Segment::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([-1.0, 0.0, 0.25, 1.0, 0.0, -0.5, 1.0, 0.0, 0.25, 1.0, 0.0, 0.5]),
        bar: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).d.value;
    let other = {
        let mut d = beamgap::linearization::Derivatives::zero();
        pair.write(&q, point, closed_form::kernel::DistanceAlone { d: &mut d });
        d.value
    };
    assert!((closed - other).abs() <= 2.0e-14, "{closed:e}, not {other:e}");
}
}
mod d_alone_delta_delta {
#[test]
fn function_of_d_second() {
    use beamgap::curve::{Hermite, Segment};
    use beamgap::linearization::closed_form;
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{Contact, DofVector, Pair};

    let contact = Contact { radius: 0.0, radius_bar: 0.0, xi_0: 0.0, xi_bar_0: 0.5 };
    let pair = Pair::new(Hermite::new(), Segment::new()).with_contact(contact);
    let q = DofVector {
        beam: SVector::from([-1.0, 0.0, 0.25, 1.0, 0.0, -0.5, 1.0, 0.0, 0.25, 1.0, 0.0, 0.5]),
        bar: SVector::from([0.25, -1.0, -0.5, 0.25, 1.0, -0.5]),
    };
    let dq = DofVector {
        beam: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0, 0.5, -0.25, 0.25, -0.5, 0.0]),
        bar: SVector::from([-0.5, 0.0, 0.5, -0.25, 0.25, -0.5]),
    };
    let linear_dq = DofVector {
        beam: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25, -0.25, 0.5, 0.0, -0.5, 0.25]),
        bar: SVector::from([-0.5, 0.25, -0.25, 0.5, 0.0, -0.5]),
    };
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[0];

    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).d.second;
    let other = {
        let mut d = beamgap::linearization::Derivatives::zero();
        pair.write(&q, point, closed_form::kernel::DistanceAlone { d: &mut d });
        d.hessian.along(&dq, &linear_dq)
    };
    assert!((closed - other).abs() <= 1.5e-13, "{closed:e}, not {other:e}");
}
}
