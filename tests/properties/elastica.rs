//! The forces of the crossed beams in the record are those of the elastica, by a program of their differential equations.
//!
//! It needs Python. If BEAMGAP_ADAPTERS is set, a missing Python is an error, otherwise it is skipped.

use beamgap::report::{BeamProblems, Record};
use std::path::Path;
use std::process::Command;

#[test]
fn crossed_beams_have_the_forces_that_the_elastica_has() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let python = std::env::var_os("BEAMGAP_PYTHON").unwrap_or("python3".into());
    let output = match Command::new(python).arg(root.join("tests/golden/elastica.py")).output() {
        Ok(output) => output,
        Err(error) => {
            assert!(std::env::var_os("BEAMGAP_ADAPTERS").is_none(), "python3: {error}");
            return;
        }
    };
    let printed = String::from_utf8(output.stdout).unwrap();
    let expected = "mu = 0.0 17.20535 34.11287 50.60173 66.56025\nmu = 0.3 33.37449 49.39758 64.83582\n";
    assert_eq!(printed, expected, "{}", String::from_utf8_lossy(&output.stderr));
    let record = std::fs::read_to_string(root.join("reports/beam-problems.json")).unwrap();
    let record = BeamProblems::from_json(&record).unwrap();
    for (line, (problem, first)) in printed.lines().zip(record.problems.iter().zip([2, 3])) {
        let forces: Vec<f64> = line.split(' ').skip(3).map(|force| force.parse().unwrap()).collect();
        assert_eq!(forces.len(), problem.steps.len() - first);
        for (force, step) in forces.iter().zip(&problem.steps[first..]) {
            assert!((step.f_n / force - 1.0).abs() < 1e-5, "{}: {} and {force}", problem.name, step.f_n);
        }
    }
}
