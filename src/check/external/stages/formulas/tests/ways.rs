//! Errors in ways of writing other than the first.

use super::{all_changes, answered_in, right_answers, with_geometry};
use crate::check::external::stages::formulas::change::Change;
use crate::check::external::stages::formulas::list::FORMULAS;
use crate::check::external::stages::formulas::names::{Set, WAYS};
use crate::check::external::stages::formulas::point::points;
use crate::check::external::stages::formulas::search::{found, of_all};
use crate::check::external::stages::formulas::ways::Ways;
use crate::check::external::stages::sample::Sample;
use crate::linearization::Quantity;
use crate::test_beam::Family;

/// Whether rounding hides no answer of the changed formulas.
fn is_clear(sample: &Sample, way: usize, change: &Change) -> bool {
    let [point] = &points(std::slice::from_ref(sample))[..] else { unreachable!() };
    let changed = point.changed(way, change, (0..FORMULAS.names.0.len()).collect());
    point.answers.iter().all(|answer| answer.ways[way] && point.is_explained(answer, way, &changed))
}

/// A formula of a change takes the changed value of each name, also of one that the right formula does not have: here that of
/// Dtau, which stands in the derivative of d|t| alone.
#[test]
fn the_formulas_of_a_change_take_changed_values() {
    let words = "d|t|, eq. (41), has the wrong sign, and in its derivative";
    let change = all_changes().iter().find(|change| change.words() == words).unwrap();
    let with_second_order = |sample: &Sample| {
        let mut sample = with_geometry(0, sample, change);
        for (component, numbers) in sample.own.iter_mut().enumerate() {
            let is_meant = component == Quantity::T.component();
            *numbers = [None, None, None, numbers[3].filter(|_| is_meant)];
        }
        sample
    };
    let mut answered: Vec<Sample> = right_answers(&[Family::Hermite]).iter().map(with_second_order).collect();
    answered.retain(|sample| is_clear(sample, 0, change));
    let points = points(&answered);
    let second = Set::from_iter([FORMULAS.name("Dd|t|")]);
    assert!(points.iter().filter(|point| point.is_wrong(second)).count() > 10);
    assert!(Ways::of(&points, second).yield_answers(change, points.iter()));
}

/// Errors of programs with unit rows for held parameters, or that differentiate the quotients (52), the system (51), the normal,
/// or the residual. Samples at which rounding hides them, or for which the way of writing is not valid, are left out.
#[test]
fn errors_in_other_ways_of_writing_are_told() {
    let samples: Vec<Sample> = right_answers(&[Family::Hermite]).into_iter().step_by(2).collect();
    let of_element = |samples: &[Sample]| {
        found(samples, &|_| Vec::new(), &Vec::new).map_or_else(Vec::new, |traced| traced.causes)
    };
    for (way, is_of_element, words) in [
        (7, true, "in i11, eq. (52), h11 stands in the place of h22"),
        (7, false, "in Ddh_bar Ddp_bar is taken whatever free_xi_bar is"),
        (8, false, "in ddet, eq. (52), the term a da_bar_all is missing"),
        (8, false, "in Ddxi, eq. (59), the term Da_bar_all dp is missing"),
        (6, false, "in Ddp_bar, eq. (55), the term Da_bar_all dxi_bar has the wrong sign"),
        (4, false, "in Ddp, eq. (55), the term t.t_bar,xi dxi_bar Dxi_bar is missing"),
        (7, false, "in Ddg_T, eq. (21), the term xi_0 has the wrong sign"),
        (6, true, "in v the term t_bar dxi_bar has the wrong sign"),
        (6, true, "in H_v the term t Ddxi is missing"),
        (6, true, "in dn gap stands in the place of d_s"),
        (6, true, "in dd, eq. (32), the term dx_bar is missing"),
        (9, true, "in h12 and h21 -b is taken whatever both_free is"),
        (0, true, "in dgap the term du_bar has the wrong sign, in the tangent alone"),
        (9, true, "in H_v the term slip d|t| Dtau is missing"),
        (9, true, "in dnormal the term cross(t, dt_bar) has the wrong sign"),
        (9, true, "in dn the term n n.(side dnormal) is missing"),
        (0, false, "in Ddx_bar, eq. (27), dxi stands in the place of dxi_bar along both directions"),
        (9, true, "in Ddp_bar, eq. (55), t stands in the place of t_bar in t_bar.Ddx"),
        (0, false, "in Ddt and Ddt_bar, eq. (30), the term du,xixi Dxi is missing, as its transpose"),
        (2, true, "in y t stands in the place of t_bar"),
        (0, true, "in a, eq. (50), n stands in the place of d in d.t,xi"),
    ] {
        let change = all_changes().iter().find(|change| change.words() == words).unwrap();
        let with = if is_of_element { answered_in } else { with_geometry };
        let mut answered: Vec<Sample> = samples.iter().map(|sample| with(way, sample, change)).collect();
        // Of an element the geometry is not answered.
        answered.iter_mut().filter(|_| is_of_element).for_each(|sample| sample.own.fill([None; 4]));
        answered.retain(|sample| is_clear(sample, way, change));
        assert!(2 * answered.len() > samples.len(), "{words}: {} of {}", answered.len(), samples.len());
        let causes = if is_of_element { of_element(&answered) } else { of_all(&answered) };
        assert!(causes.iter().any(|cause| cause.words == words), "{words}: {causes:?}");
    }
}

/// Errors of one product of a formula that is multiplied out, and of a formula where one other formula uses it.
#[test]
fn errors_of_one_use_of_a_formula_are_told() {
    let samples: Vec<Sample> = right_answers(&[Family::Hermite]);
    let formula = |name: &str| FORMULAS.all.iter().find(|of| of.name == FORMULAS.name(name)).unwrap();
    for (name, way, is_of_element, words) in [
        ("Dd|t|", 0, false, "in Dd|t|, eq. (42), the division by |t| in dt.Dt/|t| is left out"),
        ("dF", 2, true, "in dF and dF_bar the term e_bar dc is missing"),
        ("dm", 2, true, "in dm and dm_bar the term c de_bar is missing"),
        (
            "Ddg_T_bar",
            6,
            false,
            "in Ddg_T_bar, eq. (21), moved stands in the place of moved_bar in moved_bar \
             tau_bar.du_bar,xixi Dxi_bar, as its transpose",
        ),
    ] {
        let all = FORMULAS.expanded_changes(formula(name), |_| true);
        let is_meant = |change: &&Change| change.words() == words && change.ways[way];
        let change = all.iter().find(is_meant).unwrap_or_else(|| panic!("{words}"));
        let with = if is_of_element { answered_in } else { with_geometry };
        let mut answered: Vec<Sample> = samples.iter().map(|sample| with(way, sample, change)).collect();
        answered.iter_mut().filter(|_| is_of_element).for_each(|sample| sample.own.fill([None; 4]));
        let causes = if is_of_element {
            found(&answered, &|_| Vec::new(), &Vec::new).map_or_else(Vec::new, |traced| traced.causes)
        } else {
            of_all(&answered)
        };
        assert!(causes.iter().any(|cause| cause.words == words), "{words}: {causes:?}");
    }
}

/// The error of a formula where another one and its twin use it is in all its places there, and in no other formula.
#[test]
fn an_error_of_one_use_is_in_all_its_places() {
    let formula = FORMULAS.all.iter().find(|of| of.name == FORMULAS.name("Ddp")).unwrap();
    let words = "in dd, eq. (32), the term t_bar dxi_bar has the wrong sign, in Ddp and Ddp_bar alone";
    let all = FORMULAS.expanded_changes(formula, |_| true);
    let change = all.iter().find(|change| change.words() == words && change.ways[0]).unwrap();
    let names: Set = ["Ddp", "Ddp_bar"].map(|name| FORMULAS.name(name)).into_iter().collect();
    assert_eq!(change.names(), names);
    let text = change.new[0].tree.text(&FORMULAS.names);
    assert_eq!(
        text,
        "-(du + t dxi - du_bar - (-t_bar dxi_bar)).Dt - (Du + t Dxi - Du_bar - (-t_bar Dxi_bar)).dt \
         - t.(Ddx - Ddx_bar) - d.Ddt"
    );
}

/// A division of a sum that is of one term alone.
#[test]
fn a_division_may_be_of_one_term_alone() {
    let words = "in Ddgap the division by d_s is left out of all terms but dgap Dgap";
    let change = all_changes().iter().find(|change| change.words() == words && change.ways[8]).unwrap();
    assert_eq!(
        change.new[0].tree.text(&FORMULAS.names),
        "(du - du_bar).(Du - Du_bar) + d.(Ddu - Ddu_bar) - dp Dxi + dp_bar Dxi_bar - (dgap Dgap)/d_s"
    );
}

/// Programs with other formulas lose more digits at some samples. That is no error.
#[test]
fn the_rounding_of_another_way_of_writing_is_no_error() {
    let none = Change::of(String::new());
    let results: Set = ["R", "K"].iter().map(|name| FORMULAS.name(name)).collect();
    let mut compared = 0;
    for sample in right_answers(&[Family::Hermite]) {
        for way in 0..WAYS {
            let answered = [answered_in(way, &sample, &none)];
            let points = points(&answered);
            let is_valid = points[0].among(results).all(|answer| answer.ways[way]);
            compared += u32::from(is_valid);
            assert!(!is_valid || !points[0].is_wrong(results), "way {way}, case {}", sample.case);
        }
    }
    assert!(compared > 100, "{compared}");
}
