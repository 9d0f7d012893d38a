//! The catalogue of planted faults.

use beamgap::subject::{Kind, catalogue};
use std::collections::BTreeMap;

#[test]
fn the_catalogue_has_every_kind_of_fault() {
    let faults = catalogue();
    let mut kinds = BTreeMap::<_, usize>::new();
    for fault in &faults {
        *kinds.entry(fault.kind).or_default() += 1;
    }
    println!("{} {kinds:?}", faults.len());
    for f in &faults {
        println!("{f}");
    }
    assert!(faults.len() >= 200, "{} faults", faults.len());
    for kind in Kind::ALL {
        assert!(kinds.contains_key(&kind), "{kind:?}");
    }
}
