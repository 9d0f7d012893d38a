//! A pair with fewer and shorter numbers and the same diagnosis.
//!
//! The meaning of the dofs of the curve is not known, so they are only rounded. A curve may not accept zeros.

use super::jet::rounded;
use super::pair::Pair;
use crate::pair::Contact;

/// The pair with all of these changes that keep the diagnosis: no radii, no reference parameters, one dof that varies
/// by one in each direction, and fewer digits of everything.
pub(super) fn shrunk<D: PartialEq>(pair: Pair, diagnose: impl Fn(&Pair) -> D) -> Pair {
    let diagnosis = diagnose(&pair);
    let accepted = |pair: Pair| (diagnose(&pair) == diagnosis).then_some(pair);
    let mut pair = accepted(pair.with(&numbers(&pair), Contact::default())).unwrap_or(pair);
    for direction in [1, 2] {
        let before = numbers(&pair);
        let dofs = [0, 1].into_iter().flat_map(|beam| (0..before[beam][0].len()).map(move |i| (beam, i)));
        let one_alone = dofs.map(|(beam, i)| {
            let mut numbers = before.clone();
            for beam in &mut numbers {
                beam[direction].fill(0.0);
            }
            numbers[beam][direction][i] = 1.0;
            pair.with(&numbers, pair.contact)
        });
        let found = one_alone.into_iter().find_map(accepted);
        pair = found.unwrap_or(pair);
    }
    let before = numbers(&pair);
    let fewer_digits = (0..8).find_map(|digits| {
        let all = before.each_ref().map(|beam| {
            let largest = beam[0].iter().fold(0.0_f64, |largest, q| largest.max(q.abs()));
            beam.each_ref().map(|numbers| rounded(numbers, largest, digits))
        });
        accepted(pair.with(&all, pair.contact))
    });
    fewer_digits.unwrap_or(pair)
}

fn numbers(pair: &Pair) -> [[Vec<f64>; 3]; 2] {
    pair.beams.each_ref().map(|beam| beam.numbers().map(<[f64]>::to_vec))
}
