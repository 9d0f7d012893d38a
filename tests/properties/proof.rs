//! Over a prime field the closed form and AD are equal, not nearly equal.

use beamgap::prove::{Layer, prove};
use beamgap::specimen::Family;

#[test]
fn all_pairs_of_families_are_proved() {
    let proof = prove(7, &Family::ALL, 8);
    assert_eq!(proof.pairs, 121);
    assert!(proof.holds(), "{:?}", proof.refutations.first());
    // Thirteen quantities in three layers, and seven in matrices.
    assert_eq!(proof.rows.len(), 13 * 3 + 7);
    for row in &proof.rows {
        let entries = proof.pairs as u64 * 8;
        assert!(row.equal >= entries && row.equal % entries == 0, "{row:?}");
        assert!(row.log_probability() < -4.0, "{row:?}");
    }
    assert!(proof.rows.iter().any(|row| row.layer == Layer::Matrix));
}
