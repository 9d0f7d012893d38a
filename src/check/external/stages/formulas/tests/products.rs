use super::right_answers_along;
use crate::check::external::stages::formulas::list::FORMULAS;
use crate::check::external::stages::formulas::product;
use crate::check::external::stages::formulas::values::Value;
use crate::check::external::stages::sample::{Along, Sample};
use crate::test_beam::Family;
use std::sync::LazyLock;

/// The values of names, of vectors the first component, and the index of the case.
struct At<'a>(&'a [Value], usize);

impl At<'_> {
    fn of(&self, name: &str) -> f64 {
        self.0[FORMULAS.name(name)].component(Some(0)).value
    }

    /// A number that differs from case to case as no value does.
    fn other(&self) -> f64 {
        1.0 + f64::from(u8::try_from(self.1).unwrap()).sin() / 2.0
    }
}

/// What is told if this is added to an answer of the element: the residual 0, or the tangent 2.
fn told(place: usize, added: &dyn Fn(&At) -> f64) -> Option<String> {
    static RIGHT: LazyLock<Vec<Sample>> =
        LazyLock::new(|| right_answers_along(Along::Grid, &[Family::Hermite]));
    let mut samples = RIGHT.clone();
    let all = (0..FORMULAS.names.0.len()).collect();
    for sample in &mut samples {
        let inputs = &sample.inputs;
        let values: Vec<Value> = FORMULAS.values(0, &inputs.values, &inputs.known, all);
        let added = added(&At(&values, sample.case));
        let number = sample.element.as_mut().and_then(|element| element.numbers[place].as_mut());
        number.unwrap().value += added;
    }
    product(&samples)
}

#[test]
fn right_answers_have_no_difference() {
    assert_eq!(told(2, &|_| 0.0), None);
}

#[test]
fn what_the_difference_of_an_element_is_a_multiple_of_is_told() {
    let told = |place, added: &dyn Fn(&At) -> f64| told(place, added).unwrap();
    let product = |at: &At| at.of("F_N") * at.of("de") * at.of("D|t|");
    assert_eq!(told(2, &|at| 3.0 * product(at)), "the tangent differs by 3 F_N de D|t|");
    assert_eq!(told(2, &|at| -product(at) / at.of("|d|")), "the tangent differs by -F_N/|d| de D|t|");
    assert_eq!(told(2, &|at| at.other() * product(at)), "the tangent differs by a product of de with D|t|");
    let of_rho = |at: &At| at.other() * (at.of("l") * at.of("A") + at.of("l_bar") * at.of("A_bar"));
    assert_eq!(told(0, &of_rho), "the residual differs as if rho had another value");
    // Along each direction of columns another number.
    assert_eq!(
        told(2, &|at| of_rho(at) * at.of("Du").sin()),
        "the tangent differs as if Drho had another value"
    );
}
