//! A user-defined scalar: the prime field of 2^61 - 1, over which the library's formulas are exact.
//!
//! No operation rounds, so identities are compared by `==`. Sine and cosine are not those of analysis. They are a map
//! to the unit circle x^2 + y^2 = 1, which is sufficient for derivatives by the chain rule.

use beamgap::curve::{Bezier, Curve, DofDerivatives, Helix, Hermite, NurbsWeighted};
use beamgap::number::{Dual, HyperDual, Real};
use nalgebra::{SVector, Vector3};
use num_traits::{One, Zero};
use proptest::prelude::*;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

const PRIME: u64 = (1 << 61) - 1;

/// An element of the field, between 0 and `PRIME` - 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct PrimeField(u64);

impl PrimeField {
    fn new(value: i64) -> Self {
        Self(value.rem_euclid(PRIME.cast_signed()).cast_unsigned())
    }

    fn power(self, mut exponent: u64) -> Self {
        let (mut power, mut square) = (Self(1), self);
        while exponent > 0 {
            if exponent % 2 == 1 {
                power *= square;
            }
            square *= square;
            exponent /= 2;
        }
        power
    }
}

impl From<f64> for PrimeField {
    /// Exact: an `f64` is an integer times a power of two, and 2^61 = 1.
    fn from(value: f64) -> Self {
        let bits = value.to_bits();
        let (exponent, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
        let mantissa = if exponent == 0 { fraction } else { fraction | (1 << 52) };
        // value = mantissa 2^(exponent - 1075), and 2^(-1075) = 2^(61 * 18 - 1075) = 2^23.
        let size = Self(mantissa) * Self(2).power(exponent.max(1) + 23);
        if value.is_sign_negative() { -size } else { size }
    }
}

impl Add for PrimeField {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self((self.0 + other.0) % PRIME)
    }
}

impl Sub for PrimeField {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for PrimeField {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = u128::from(self.0) * u128::from(other.0) % u128::from(PRIME);
        Self(u64::try_from(product).expect("below the prime"))
    }
}

impl Div for PrimeField {
    type Output = Self;
    /// By Fermat, 1 / a = a^(p - 2).
    fn div(self, other: Self) -> Self {
        self * other.power(PRIME - 2)
    }
}

impl Neg for PrimeField {
    type Output = Self;
    fn neg(self) -> Self {
        Self((PRIME - self.0) % PRIME)
    }
}

impl AddAssign for PrimeField {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for PrimeField {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for PrimeField {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl DivAssign for PrimeField {
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl Zero for PrimeField {
    fn zero() -> Self {
        Self(0)
    }

    fn is_zero(&self) -> bool {
        self.0 == 0
    }
}

impl One for PrimeField {
    fn one() -> Self {
        Self(1)
    }
}

impl Real for PrimeField {
    /// The square root of a square; the prime is 3 modulo 4.
    fn sqrt(self) -> Self {
        self.power((PRIME + 1) / 4)
    }

    /// A rational point of the unit circle.
    fn sin_cos(self) -> (Self, Self) {
        let square = self * self;
        let one = Self::one();
        ((self + self) / (one + square), (one - square) / (one + square))
    }
}

fn residue() -> impl Strategy<Value = PrimeField> {
    (0..PRIME).prop_map(PrimeField)
}

fn residues<const N: usize>() -> impl Strategy<Value = SVector<PrimeField, N>> {
    proptest::array::uniform::<_, N>(residue()).prop_map(SVector::from)
}

/// Every identity between the jet and the position that a first-order dual number can test, exactly.
fn jet_is_exact<const N: usize>(
    curve: &impl Curve<N>,
    q: &SVector<PrimeField, N>,
    dq: [&SVector<PrimeField, N>; 2],
    xi: PrimeField,
) -> Result<(), TestCaseError> {
    let jet = curve.jet(q, xi);
    let g = jet.geometry;
    prop_assert_eq!(g.x, curve.position(q, xi));

    let moving = Dual::new(xi, PrimeField::one());
    let constant = |q: PrimeField| Dual::new(q, PrimeField::zero());
    prop_assert_eq!(g.t, curve.position(&q.map(constant), moving).map(|x| x.eps));
    let along = curve.jet(&q.map(constant), moving).geometry;
    prop_assert_eq!(g.t_xi, along.t.map(|x| x.eps));
    prop_assert_eq!(g.t_xixi, along.t_xi.map(|x| x.eps));

    let varied = SVector::from_fn(|i, _| HyperDual::new(q[i], dq[0][i], dq[1][i], PrimeField::zero()));
    let still = HyperDual::new(xi, PrimeField::zero(), PrimeField::zero(), PrimeField::zero());
    let along = curve.jet(&varied, still).geometry;
    let x = curve.position(&varied, still);
    prop_assert_eq!(x, along.x);
    for (k, x) in [x, along.t, along.t_xi].into_iter().enumerate() {
        let parts = |part: fn(&HyperDual<PrimeField>) -> PrimeField| -> Vector3<PrimeField> {
            Vector3::from_fn(|i, _| part(&x[i]))
        };
        let (w, delta) = (g.x, jet.dofs.variation(k, dq[0]));
        prop_assert_eq!(delta, parts(|x| x.eps1));
        prop_assert_eq!(jet.dofs.variation(k, dq[1]), parts(|x| x.eps2));
        prop_assert_eq!(jet.dofs.jacobian(k) * dq[0], delta);
        prop_assert_eq!(jet.dofs.gradient(k, &w).dot(dq[0]), w.dot(&delta));
        if k < 2 {
            let second = jet.dofs.second_variation(k, dq[0], dq[1]);
            prop_assert_eq!(second, parts(|x| x.eps1eps2));
            prop_assert_eq!(dq[0].dot(&(jet.dofs.hessian(k, &w) * dq[1])), w.dot(&second));
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn residues_are_a_field(a in residue(), b in residue(), c in residue(), n in -1000..1000_i32) {
        prop_assert_eq!(a * (b + c), a * b + a * c);
        prop_assert_eq!(a - b + b, a);
        prop_assert_eq!(a / b * b, a);
        let root = (a * a).sqrt();
        prop_assert_eq!(root * root, a * a);
        let (sin, cos) = a.sin_cos();
        prop_assert_eq!(sin * sin + cos * cos, PrimeField::one());
        prop_assert_eq!(PrimeField::from(f64::from(n)), PrimeField::new(n.into()));
        prop_assert_eq!(PrimeField::from(f64::from(n) / 1024.0) * PrimeField::new(1024), PrimeField::new(n.into()));
    }

    #[test]
    fn hermite_is_exact(q in residues(), dq in residues(), linear_dq in residues(), xi in residue()) {
        jet_is_exact(&Hermite::scaled_by(2.5), &q, [&dq, &linear_dq], xi)?;
    }

    #[test]
    fn bezier_is_exact(q in residues::<15>(), dq in residues(), linear_dq in residues(), xi in residue()) {
        jet_is_exact(&Bezier::<5>::new(), &q, [&dq, &linear_dq], xi)?;
    }

    #[test]
    fn nurbs_is_exact(q in residues::<16>(), dq in residues(), linear_dq in residues(), xi in residue()) {
        let curve = NurbsWeighted::<4>::new(&[0.0, 0.0, 1.0, 2.0, 3.5, 4.0]).unwrap();
        jet_is_exact(&curve, &q, [&dq, &linear_dq], xi)?;
    }

    #[test]
    fn helix_is_exact_in_its_dofs(q in residues(), dq in residues(), linear_dq in residues(), xi in residue()) {
        jet_is_exact(&Helix::new(1.25), &q, [&dq, &linear_dq], xi)?;
    }
}
