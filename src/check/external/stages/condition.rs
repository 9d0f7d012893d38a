//! What the cases that are wrong have in common.

use super::point::Point;
use super::terms::Vector;
use crate::contact::State;

/// A statement on a case: its words, the words of its opposite, and whether it holds.
type Statement = (&'static str, &'static str, bool);

/// The maximum number of statements of a condition.
const STATEMENTS: usize = 3;
/// The largest probability that some statement is common to the wrong cases by chance.
const CHANCE: f64 = 1e-3;

fn statements(point: &Point) -> Vec<Statement> {
    let v = |of| point.vector(of).map(|n| n.value);
    let s = point.sample;
    let (d, t, t_bar) = (v(Vector::D), v(Vector::T(0, 0)), v(Vector::T(1, 0)));
    let cross = t.cross(&t_bar);
    let (angle, side) = (t.dot(&t_bar), d.dot(&cross));
    let is_parallel = cross.norm() < 0.1 * t.norm() * t_bar.norm();
    let is = |state| s.inputs.decided.is_some_and(|(of, _)| of == state);
    vec![
        ("the contact slips", "the contact does not slip", is(State::Slip)),
        ("the contact sticks", "the contact does not stick", is(State::Stick)),
        (
            "the beams have crossed",
            "the beams have not crossed",
            s.inputs.decided.is_some_and(|(state, is_crossed)| is_crossed && state != State::Open),
        ),
        ("xi < 0", "xi >= 0", s.xi[0].value < 0.0),
        ("xi_bar < 0", "xi_bar >= 0", s.xi[1].value < 0.0),
        ("t.t_bar < 0", "t.t_bar >= 0", angle < 0.0),
        ("d.(t x t_bar) < 0", "d.(t x t_bar) >= 0", side < 0.0),
        ("d.t,xi < 0", "d.t,xi >= 0", d.dot(&v(Vector::T(0, 1))) < 0.0),
        ("d.t_bar,xi < 0", "d.t_bar,xi >= 0", d.dot(&v(Vector::T(1, 1))) < 0.0),
        ("xi < xi_0", "xi >= xi_0", s.xi[0].value < s.contact.xi_0),
        ("xi_bar < xi_bar_0", "xi_bar >= xi_bar_0", s.xi[1].value < s.contact.xi_bar_0),
        ("xi is held", "xi is free", s.held[0]),
        ("xi_bar is held", "xi_bar is free", s.held[1]),
        ("both parameters are held", "a parameter is free", s.held == [true; 2]),
        ("a parameter is held", "both parameters are free", s.held != [false; 2]),
        ("the tangents are nearly parallel", "the tangents are not nearly parallel", is_parallel),
        ("d_x < 0", "d_x >= 0", d.x < 0.0),
        ("d_y < 0", "d_y >= 0", d.y < 0.0),
        ("d_z < 0", "d_z >= 0", d.z < 0.0),
        (
            "d.(t x t_bar) and t.t_bar have different signs",
            "d.(t x t_bar) and t.t_bar have the same sign",
            side * angle < 0.0,
        ),
        ("the gap is closed", "the gap is open", d.norm() < s.contact.radius + s.contact.radius_bar),
        ("the law is lpqp", "the law is not lpqp", s.inputs.holds("lpqp")),
        ("the law is augmented", "the law is not augmented", s.inputs.holds("augmented")),
        (
            "a normal of the last step is given",
            "no normal of the last step is given",
            s.inputs.holds("has_n"),
        ),
        (
            "the same parameters are held as at the last step",
            "other parameters are held than at the last step",
            ["xi", "xi_bar"].iter().zip(s.held).all(|(of, is_held)| {
                !s.inputs.holds("has_slips") || s.inputs.holds(&format!("was_free_{of}")) != is_held
            }),
        ),
    ]
}

/// What the wrong cases have in common, as a clause: the fewest statements that hold at them, and at no right one all of them. If
/// there are none, the one that holds at the fewest right ones, unless it may be common to the wrong ones by chance.
pub(super) fn condition(points: &[Point], wrong: &[usize], right: &[usize]) -> Option<String> {
    let of = |case: &usize| points.iter().find(|point| point.sample.case == *case).map(statements);
    let wrong: Vec<Vec<Statement>> = wrong.iter().filter_map(of).collect();
    let right: Vec<Vec<Statement>> = right.iter().filter_map(of).collect();
    let first = wrong.first()?;
    let is_common = |k: &usize| wrong.iter().all(|of| of[*k].2 == first[*k].2);
    let common: Vec<usize> = (0..first.len()).filter(is_common).collect();
    let found = (1..=STATEMENTS)
        .find_map(|count| separating(&common, count, &|k| first[k].2, &right.iter().collect::<Vec<_>>()));
    let words = |k: usize| if first[k].2 { first[k].0 } else { first[k].1 };
    if let Some(found) = found {
        return Some(format!(", where {}", found.into_iter().map(words).collect::<Vec<_>>().join(" and ")));
    }
    let count = |k: &usize| right.iter().filter(|of| of[*k].2 == first[*k].2).count();
    let rarest = common.into_iter().min_by_key(count)?;
    let share = of_count(count(&rarest)) / of_count(right.len());
    let is_by_chance = of_count(first.len()) * wrong.iter().map(|_| share).product::<f64>() > CHANCE;
    (!is_by_chance).then(|| format!(", in all of which {}", words(rarest)))
}

fn of_count(count: usize) -> f64 {
    u32::try_from(count).map_or(f64::MAX, f64::from)
}

/// So many of these statements, of which at least one does not hold as at the wrong cases at each of the others.
fn separating(
    among: &[usize],
    count: usize,
    value: &dyn Fn(usize) -> bool,
    others: &[&Vec<Statement>],
) -> Option<Vec<usize>> {
    if count == 0 {
        return others.is_empty().then(Vec::new);
    }
    among.iter().enumerate().find_map(|(i, &k)| {
        let left: Vec<_> = others.iter().copied().filter(|of| of[k].2 == value(k)).collect();
        let rest = separating(&among[i + 1..], count - 1, value, &left)?;
        Some([vec![k], rest].concat())
    })
}
