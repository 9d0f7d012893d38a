//! Over a prime field the closed form and AD are exactly equal.

use crate::program::{blind_json, blind_text, golden, run};
use beamgap::number::PrimeField;
use beamgap::prove::{Layer, Proof, prove};
use beamgap::test_beam::Family;
use beamgap::variant::Variant;
use proptest::prelude::*;

#[test]
fn all_pairs_of_families_are_proved() {
    let proof = prove(&Variant::Unmodified, 7, &Family::ALL, 8, || ());
    assert_eq!(proof.pairs, 121);
    assert!(proof.holds(), "{:?}", proof.refutations.first());
    // Thirteen quantities in three layers, seven quantities in matrices and in the kernel, residual and tangent.
    assert_eq!(proof.rows.len(), 13 * 3 + 2 * 7 + 2);
    for row in &proof.rows {
        let draws = 8 * proof.pairs as u64;
        assert!(row.equal >= draws, "{row:?}");
        if row.layer == Layer::Kernel {
            // The kernel supports curves that are linear in their dofs. Eight families are: one of 6 dofs, two of 9, four of
            // 12, one of 18. Padded, there are three layouts of four numbers and the gradient with three, and for 6 + 9,
            // 12 + 18 and 18 + 12 dofs the three layouts again.
            assert_eq!(row.equal, 8 * (8 * 8 * (3 * 4 + 3) + (2 + 4 + 4) * 3 * 4), "{row:?}");
        } else {
            assert_eq!(row.equal % draws, 0, "{row:?}");
        }
        // The tangent of a contact element has the highest degree, and one more square root.
        let limit = if row.layer == Layer::Tangent { -2.5 } else { -4.0 };
        assert!(row.log_probability() < limit, "{row:?}");
    }
    assert!(proof.rows.iter().any(|row| row.layer == Layer::Matrix));
}

#[test]
fn nothing_proves_nothing() {
    assert!(!prove(&Variant::Unmodified, 7, &[], 8, || ()).holds() && !Proof::default().holds());
}

proptest! {
    /// A refutation reports the ratio of both sides, if it is a small fraction.
    #[test]
    fn small_fractions_are_recognized(above in -1000_i64..=1000, below in 1..=1000_u32, other: u64) {
        let (one, whole) = (PrimeField::new(above.unsigned_abs()), PrimeField::new(below.into()));
        let fraction = if above < 0 { -one / whole } else { one / whole };
        let (numerator, denominator) = fraction.fraction(1000).unwrap();
        prop_assert_eq!(i128::from(numerator) * i128::from(below), i128::from(above) * i128::from(denominator));
        prop_assert!(numerator.unsigned_abs() <= above.unsigned_abs() && denominator <= below.into());
        // Only one number in 10^12 is a small fraction.
        prop_assert_eq!(PrimeField::new(other | 1 << 20).fraction(1000), None);
    }
}

/// Standard output of a proof that must succeed. Stderr must end with the time.
fn proved(more: &[&str]) -> String {
    let output = run(&[&["prove", "--draws", "8", "--family", "segment", "--family", "arc"], more].concat());
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        told.lines().last().is_some_and(|line| line.starts_with("32 draws in ") && line.ends_with(" s")),
        "{told}"
    );
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn a_proof_is_the_golden_one() {
    let text = proved(&[]);
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    golden("prove.txt", &text, blind_text);
    golden("prove.json", &proved(&["--format", "json"]), blind_json);
}
