//! The scene of friction.

use super::{chosen, frame, frame_at, number, text};
use beamgap_explorer::{asymmetry, opening};
use serde_json::{Value, json};

#[test]
fn friction_sticks_and_then_slips() {
    let first = chosen("friction", &[]);
    assert!(text(&first, "state").contains("sticks") && number(&first, "Phi") < 0.0);
    let [x, y] =
        first["places"]["move"].as_array().map(|at| [0, 1].map(|i| at[i].as_f64().unwrap())).unwrap();
    let moved = frame_at("friction", "move", [x + 25.0, y]);
    assert!(text(&moved, "state").contains("slips") && number(&moved, "Phi") > 0.0);
    assert_eq!(text(&moved, "T"), text(&moved, "mu_F_N"));
    // After the step the same place is at the edge of the cone, and the way back sticks.
    let accepted =
        frame("friction", &moved["state"], &json!({ "choose": { "name": "accept", "value": "" } }));
    assert!(number(&accepted, "Phi").abs() < 5e-3);
    assert_eq!(text(&accepted, "state"), "The trial force is on the edge of the cone.");
    // The slip of the step is zero, and the spring keeps its stretch.
    assert!(number(&accepted, "g_T").abs() < 1e-3 && number(&accepted, "trial_size") > 0.2);
    let back =
        frame("friction", &accepted["state"], &json!({ "drag": { "handle": "move", "to": [x + 20.0, y] } }));
    assert!(text(&back, "state").contains("sticks"), "{back}");
    // Farther back the force along the beam has changed its sign, and the contact still sticks.
    let farther =
        frame("friction", &accepted["state"], &json!({ "drag": { "handle": "move", "to": [x + 10.0, y] } }));
    assert!(text(&farther, "state").contains("sticks"), "{farther}");
    assert!(number(&accepted, "F") * number(&farther, "F") < 0.0, "{farther}");
}

/// The tangent of friction is nearly symmetric in stick, and not in slip.
#[test]
fn the_tangent_of_friction_is_not_symmetric() {
    let opening = opening("friction").unwrap().state;
    assert_eq!(opening["moved"], json!([0.04, 0.01]));
    let mut shifted = opening;
    shifted["moved"] = json!([0.1, 0.0]);
    let slips = frame("friction", &shifted, &Value::Null);
    assert!(
        text(&slips, "state").contains("slips") && text(&chosen("friction", &[]), "state").contains("sticks")
    );
    assert!(asymmetry([0.04, 0.01]).unwrap() < 0.01 && asymmetry([0.1, 0.0]).unwrap() > 0.3);
    // The normal force is that of the penalty.
    let frame = chosen("friction", &[]);
    assert!((number(&frame, "F_N") + 20.0 * number(&frame, "g_N")).abs() < 0.02);
}
