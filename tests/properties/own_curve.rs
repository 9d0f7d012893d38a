//! The check of a curve of the user.

use beamgap::check;
use beamgap::curve::{Bezier, Curve, DofDerivatives, Geometry, Jet};
use beamgap::number::Real;
use nalgebra::{SMatrix, SVector, Vector3};

/// a + b xi + k n xi^2/2 with the dofs a, b, n and k. It is not linear in them.
#[derive(Clone, Copy, Debug, Default)]
struct Parabola {
    /// The fault in the curve.
    fault: Option<Fault>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    Tangent,
    Third,
    Variation,
    Second,
    Gradient,
    Hessian,
    /// A fault only between two parameters, where no jet is compared.
    Narrow,
}

#[derive(Clone, Copy, Debug)]
struct Dofs<T> {
    powers: [[T; 3]; 3],
    n: Vector3<T>,
    k: T,
    fault: Option<Fault>,
}

impl Curve<10> for Parabola {
    type Dofs<T: Real> = Dofs<T>;

    fn position<T: Real>(&self, q: &SVector<T, 10>, xi: T) -> Vector3<T> {
        let [a, b, n] = [0, 3, 6].map(|i| q.fixed_rows::<3>(i).into_owned());
        a + (b + n * (q[9] * xi * T::from(0.5))) * xi
    }

    fn jet<T: Real>(&self, q: &SVector<T, 10>, xi: T) -> Jet<T, Dofs<T>> {
        let (b, n, k) = (q.fixed_rows::<3>(3).into_owned(), q.fixed_rows::<3>(6).into_owned(), q[9]);
        let half = T::from(0.5);
        let sign = |fault| if self.fault == Some(fault) { -T::one() } else { T::one() };
        let x = q.fixed_rows::<3>(0) + b * xi + n * (k * xi * xi * half);
        let t = b + n * (k * xi * sign(Fault::Tangent));
        let third = if self.fault == Some(Fault::Third) { n } else { Vector3::zeros() };
        let is_here = self.fault == Some(Fault::Narrow) && NARROW.contains(&about(&xi));
        let t_xi = if is_here { n * (k + k) } else { n * k };
        let geometry = Geometry { x, t, t_xi, t_xixi: third };
        let (zero, one) = (T::zero(), T::one());
        let powers = [[one, xi, xi * xi * half], [zero, one, xi], [zero, zero, one]];
        Jet { geometry, dofs: Dofs { powers, n, k, fault: self.fault } }
    }

    fn third_derivative_bound(&self, _: &SVector<f64, 10>) -> f64 {
        0.0
    }

    fn is_cubic(&self) -> bool {
        true
    }
}

impl<T: Real> DofDerivatives<T, 10> for Dofs<T> {
    const LINEAR: bool = false;

    fn variation(&self, k: usize, dq: &SVector<T, 10>) -> Vector3<T> {
        let [one, xi, square] = self.powers[k];
        let [a, b, n] = [0, 3, 6].map(|i| dq.fixed_rows::<3>(i).into_owned());
        let sign = if self.fault == Some(Fault::Variation) && k == 2 { -T::one() } else { T::one() };
        a * one + b * xi + (n * self.k * sign + self.n * dq[9]) * square
    }

    fn second_variation(&self, k: usize, dq: &SVector<T, 10>, linear_dq: &SVector<T, 10>) -> Vector3<T> {
        let [n, linear_n] = [dq, linear_dq].map(|dq| dq.fixed_rows::<3>(6).into_owned());
        let other = if self.fault == Some(Fault::Second) { T::zero() } else { dq[9] };
        (n * linear_dq[9] + linear_n * other) * self.powers[k][2]
    }

    fn gradient(&self, k: usize, w: &Vector3<T>) -> SVector<T, 10> {
        let unit = |i| SVector::from_fn(|j, _| if i == j { T::one() } else { T::zero() });
        let gradient = SVector::from_fn(|i, _| w.dot(&self.variation(k, &unit(i))));
        if self.fault == Some(Fault::Gradient) { gradient * T::from(2.0) } else { gradient }
    }

    fn hessian(&self, k: usize, w: &Vector3<T>) -> SMatrix<T, 10, 10> {
        let mut hessian = SMatrix::<T, 10, 10>::zeros();
        for c in 0..3 {
            hessian[(6 + c, 9)] = w[c] * self.powers[k][2];
            hessian[(9, 6 + c)] = w[c] * self.powers[k][2];
        }
        if self.fault == Some(Fault::Hessian) { hessian.upper_triangle() } else { hessian }
    }
}

const BEAMS: [[f64; 10]; 2] = [
    [0.0, 0.1, 0.2, 1.0, 0.1, -0.1, 0.2, 0.9, 0.1, 0.4],
    [1.0, -0.3, 0.2, 0.3, 1.2, 0.2, 1.1, 0.1, -0.5, 0.1],
];

#[test]
fn a_curve_that_is_right_agrees_in_every_regime() {
    let found = check::curve(&Parabola::default(), &BEAMS, 13);
    assert!(found.agrees(), "{found}");
    // Thirteen pairs in each of ten regimes. A few of them have no closest point that can be compared.
    assert!(
        found.compared > 90 && found.to_string().ends_with("nothing differs beyond rounding."),
        "{found}"
    );
    // The result depends only on the arguments.
    assert_eq!(found, check::curve(&Parabola::default(), &BEAMS, 13));
}

/// This number of dofs exceeds the size of the matrices in the check.
#[test]
fn a_curve_may_have_many_dofs() {
    let bent = [0.0, 1.0, 4.0, 9.0, 16.0, 25.0, 36.0, 49.0];
    let beam: [f64; 24] = std::array::from_fn(|i| [0.3 * bent[i / 3].sqrt(), 0.02 * bent[i / 3], 0.1][i % 3]);
    let found = check::curve(&Bezier::<8>::new(), &[beam], 2);
    assert!(found.agrees(), "{found}");
}

#[test]
fn what_is_wrong_with_a_curve_is_named() {
    for (fault, part) in [
        (Fault::Tangent, "t = x,xi of the jet"),
        (Fault::Third, "t,xixi = x,xixixi of the jet"),
        (Fault::Variation, "variation of x,xixi (k = 2)"),
        (Fault::Second, "second_variation of x (k = 0)"),
        (Fault::Gradient, "gradient, against the variation"),
        (Fault::Hessian, "hessian, against the second_variation"),
    ] {
        let found = check::curve(&Parabola { fault: Some(fault) }, &BEAMS, 1);
        assert!(!found.agrees() && found.to_string().contains("DISAGREE"), "{fault:?}: {found}");
        let jet = found.jets.iter().find(|jet| jet.part.starts_with(part));
        let jet = jet.unwrap_or_else(|| panic!("{fault:?}: {found}"));
        // The fault is shown at round numbers, with at most three digits after the point.
        assert!(jet.q.iter().all(|q| (1e3 * q - (1e3 * q).round()).abs() < 1e-9), "{fault:?}: {found}");
    }
}

const NARROW: std::ops::Range<f64> = -0.8..-0.7;

/// The value of a scalar of any type. Only this fault needs it.
fn about<T: Real>(number: &T) -> f64 {
    let text = format!("{number:?}");
    let mut words = text.split(|c: char| c.is_whitespace() || ",{}()".contains(c));
    words.find_map(|word| word.parse().ok()).unwrap_or(f64::NAN)
}

#[test]
fn a_pair_that_shows_a_fault_is_shrunk() {
    let found = check::curve(&Parabola { fault: Some(Fault::Narrow) }, &BEAMS, 13);
    assert!(found.jets.is_empty() && found.mismatches > 0, "{found}");
    let text = found.to_string();
    assert!(text.contains("first wrong: delta of xi (first)"), "{found}");
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{found}");
    for (pair, _) in &found.findings {
        // One dof varies in each direction.
        let zeros = |name: &str| {
            let lines = pair.lines().skip_while(|line| !line.starts_with(&format!("  {name} =")));
            let numbers = lines.enumerate().take_while(|(i, line)| *i == 0 || line.starts_with("    "));
            let words = numbers.flat_map(|(_, line)| line.split_whitespace());
            words.filter(|word| word.parse::<f64>().is_ok_and(|number| number != 0.0)).count()
        };
        assert_eq!([zeros("dq") + zeros("dq_bar"), zeros("Dq") + zeros("Dq_bar")], [1, 1], "{pair}");
    }
}

#[test]
fn without_beams_nothing_is_compared() {
    let found = check::curve(&Parabola::default(), &[], 13);
    assert!(!found.agrees() && found.to_string().starts_with("NOTHING COMPARED"), "{found}");
}
