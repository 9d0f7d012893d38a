//! Dofs that an element does not have: the program answers `null` for them.

use super::answers::Answers;
use super::conventions::Conventions;
use super::vectors::Vector;

/// null, as it is read: a value that is not a number, and can be told from all that programs print.
pub(super) const NULL: f64 = f64::from_bits(0x7ff8_6e75_6c6c_0000);

fn is_null(number: f64) -> bool {
    number.to_bits() == NULL.to_bits()
}

/// The case with directions that leave these dofs out, and the answers with zero for them.
///
/// # Errors
/// If the arrays of a case have null for different dofs, or for all.
pub(super) fn without(
    vector: Vector,
    mut answers: Answers,
    conventions: &Conventions,
) -> Result<(Vector, Answers), String> {
    let places = conventions.dofs(vector.families());
    let size = places.len();
    let mut missing: Option<Vec<bool>> = None;
    for numbers in arrays(&mut answers) {
        let of_array: Vec<bool> = match numbers.len() {
            len if len == size => numbers.iter().map(|number| is_null(*number)).collect(),
            len if len == size * size => (0..size).map(|i| is_null(numbers[i * size + i])).collect(),
            // The comparison says what is expected.
            _ => continue,
        };
        let is_missing = |i: usize| of_array[i];
        let is_even = numbers.len() == size
            || (0..size * size)
                .all(|k| is_null(numbers[k]) == (is_missing(k / size) || is_missing(k % size)));
        if !is_even || missing.as_ref().is_some_and(|known| *known != of_array) {
            return Err(
                "null expected for the same dofs in all gradients, and rows and columns of Hessians".into()
            );
        }
        for number in numbers.iter_mut().filter(|number| is_null(**number)) {
            *number = 0.0;
        }
        missing = Some(of_array);
    }
    let missing = missing.unwrap_or_default();
    if !missing.is_empty() && missing.iter().all(|is_missing| *is_missing) {
        return Err("a number expected for at least one dof, found null for all".into());
    }
    let mut vector = vector;
    for (place, _) in missing.iter().zip(places).filter_map(|(missing, place)| missing.then_some(place)) {
        let [beam, bar] = &mut vector.case.test_beams;
        let (of, at) = if place < beam.q.len() {
            (beam, place)
        } else {
            let start = beam.q.len();
            (bar, place - start)
        };
        (of.dq[at], of.linear_dq[at]) = (0.0, 0.0);
    }
    Ok((vector, answers))
}

/// All gradients, Hessians, residuals and tangents.
fn arrays(answers: &mut Answers) -> impl Iterator<Item = &mut Vec<f64>> {
    let of_answers =
        answers.answers.iter_mut().flat_map(|answer| [&mut answer.gradient, &mut answer.hessian]);
    of_answers.chain([&mut answers.residual, &mut answers.tangent]).flatten()
}
