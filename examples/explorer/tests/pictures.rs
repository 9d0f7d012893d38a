//! What the pictures are computed from.

use beamgap_explorer::{Label, frozen_part, hull, placed};

#[test]
fn letters_of_one_place_do_not_collide() {
    let at = |name| Label { name, at: [300.0, 200.0], towards: [1.0, 0.0] };
    let line = [[300.0, 0.0], [300.0, 400.0]];
    let places = placed(&[at("a"), at("b"), at("c"), at("d")], &[(line, 1.0)]);
    for (i, [x, y]) in places.iter().enumerate() {
        assert!((x - 300.0).abs() > 14.0, "{places:?}");
        for [x_other, y_other] in &places[..i] {
            assert!((x - x_other).hypot(y - y_other) > 28.0, "{places:?}");
        }
    }
}

#[test]
fn the_hull_is_convex_and_contains_the_corners_alone() {
    let points = vec![[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0], [1.0, 0.0]];
    assert_eq!(hull(points), [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    assert_eq!(hull(Vec::new()).len(), 0);
}

/// With frozen parameters d Hess d is GᵀG - ∇d ∇dᵀ, where G is the matrix of the displacement between the points.
#[test]
fn the_first_part_has_the_terms_that_the_page_of_the_scenes_states() {
    let [stated, computed] = frozen_part().unwrap();
    assert!((stated - computed).abs() < 1e-12, "{stated} {computed}");
}
