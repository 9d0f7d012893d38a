//! Causes of one answer of a contact element, beside the answers before and after it.

use super::{all_changes, answered, right_answers};
use crate::check::external::stages::Reading;
use crate::check::external::stages::formulas::change::Change;
use crate::check::external::stages::formulas::list::FORMULAS;
use crate::check::external::stages::formulas::search::found;
use crate::check::external::stages::sample::Sample;
use crate::number::RunningError;
use crate::test_beam::Family;

/// What explains a later answer must not change an earlier one. Here a program pushes at an open gap.
#[test]
fn no_cause_of_a_later_answer_contradicts_an_earlier_one() {
    let samples: Vec<Sample> = right_answers(&[Family::Segment]);
    let pushing_force = ("F_N", "force".to_owned());
    let pushing = [pushing_force.clone(), ("k", "stiffness".to_owned())];
    let pushing = FORMULAS.instead(String::new(), &pushing);
    let told = |change: &Change| {
        let answered: Vec<Sample> = samples.iter().map(|sample| answered(sample, change)).collect();
        found(&answered, &|_| Vec::new(), &Vec::new).unwrap()
    };
    let traced = told(&pushing);
    let words = |all: &[Reading]| all.iter().map(|of| of.words.clone()).collect::<Vec<_>>();
    assert_eq!(words(&traced.causes), ["in F_N force is taken whatever active is"]);
    assert_eq!(words(&traced.beyond), ["in k stiffness is taken whatever active is"]);
    // Without radii in the gap k would be the one of this program, but its state is that of the right gap.
    let stiffness = "(lpqp ? 0 < d_s : 0) ? eps_N (g_0 - d_s)/g_0 : eps_N";
    let acts = "lpqp ? d_s < g_0 : 0 < lambda + eps_N (g_0/2 - d_s)";
    let without_radii = [pushing_force, ("k", format!("({acts}) ? ({stiffness}) : 0"))];
    let without_radii = FORMULAS.instead(String::new(), &without_radii);
    let traced = told(&without_radii);
    assert_eq!(words(&traced.causes), ["in F_N force is taken whatever active is"]);
    assert_eq!(words(&traced.beyond), [""; 0]);
}

/// What explains the residual must keep the friction force, which is right here. Another error is in the tangent.
#[test]
fn a_cause_of_the_residual_keeps_the_friction_force() {
    let samples: Vec<Sample> = right_answers(&[Family::Hermite]);
    let words = "in A the term slip d|t| is missing";
    let change = all_changes().iter().find(|change| change.words() == words).unwrap();
    let with_errors = |sample: &Sample| {
        let mut with = answered(sample, change);
        with.inputs.forces.clone_from(&sample.inputs.forces);
        for tangent in with.element.iter_mut().flat_map(|element| &mut element.numbers[2]) {
            *tangent = RunningError::from(1.5) * *tangent + RunningError::from(1.0);
        }
        with
    };
    let answered: Vec<Sample> = samples.iter().map(with_errors).collect();
    let causes = found(&answered, &|_| Vec::new(), &Vec::new).unwrap().causes;
    let told: Vec<&str> = causes.iter().map(|cause| &*cause.words).collect();
    assert!(told.contains(&words), "{told:?}");
    assert!(!told.contains(&"in slip the term xi - xi_n is missing"), "{told:?}");
}
