//! What the cases that are wrong have in common.

use super::point::Point;
use super::terms::Vector;

/// What a case is like.
fn features(point: &Point) -> Vec<(&'static str, bool)> {
    let v = |of| point.vector(of).map(|n| n.value);
    let s = point.sample;
    let (d, t, t_bar) = (v(Vector::D), v(Vector::T(0, 0)), v(Vector::T(1, 0)));
    let cross = t.cross(&t_bar);
    vec![
        ("xi < 0", s.xi[0].value < 0.0),
        ("xi_bar < 0", s.xi[1].value < 0.0),
        ("t.t_bar < 0", t.dot(&t_bar) < 0.0),
        ("d.(t x t_bar) < 0", d.dot(&cross) < 0.0),
        ("d.t,xi < 0", d.dot(&v(Vector::T(0, 1))) < 0.0),
        ("d.t_bar,xi < 0", d.dot(&v(Vector::T(1, 1))) < 0.0),
        ("xi < xi_0", s.xi[0].value < s.contact.xi_0),
        ("xi_bar < xi_bar_0", s.xi[1].value < s.contact.xi_bar_0),
        ("xi is held", s.held[0]),
        ("xi_bar is held", s.held[1]),
        ("both parameters are held", s.held[0] && s.held[1]),
        ("a parameter is held", s.held[0] || s.held[1]),
        ("the tangents are nearly parallel", cross.norm() < 0.1 * t.norm() * t_bar.norm()),
        ("d_x < 0", d.x < 0.0),
        ("d_y < 0", d.y < 0.0),
        ("d_z < 0", d.z < 0.0),
        ("d.(t x t_bar) and t.t_bar have different signs", d.dot(&cross) * t.dot(&t_bar) < 0.0),
        ("the gap is closed", d.norm() < s.contact.radius + s.contact.radius_bar),
    ]
}

/// The simplest statement that holds at the wrong cases and at no right one.
pub(super) fn condition(points: &[Point], wrong: &[usize], right: &[usize]) -> Option<String> {
    let of = |case: &usize| points.iter().find(|point| point.sample.case == *case).map(features);
    let (wrong, right): (Vec<_>, Vec<_>) =
        (wrong.iter().filter_map(of).collect(), right.iter().filter_map(of).collect());
    let first = wrong.first()?;
    // What all wrong cases have in common.
    let common: Vec<(usize, bool)> = (0..first.len())
        .map(|k| (k, first[k].1))
        .filter(|(k, value)| wrong.iter().all(|f| f[*k].1 == *value))
        .collect();
    let separates =
        |of: &[(usize, bool)]| right.iter().all(|f| of.iter().any(|(k, value)| f[*k].1 != *value));
    let words = |of: &[(usize, bool)]| {
        of.iter()
            .map(|(k, value)| format!("{}{}", if *value { "" } else { "not: " }, first[*k].0))
            .collect::<Vec<_>>()
            .join(" and ")
    };
    for a in &common {
        if separates(&[*a]) {
            return Some(words(&[*a]));
        }
    }
    for (i, a) in common.iter().enumerate() {
        for b in &common[..i] {
            if separates(&[*b, *a]) {
                return Some(words(&[*b, *a]));
            }
        }
    }
    for (i, a) in common.iter().enumerate() {
        for (j, b) in common[..i].iter().enumerate() {
            for c in &common[..j] {
                if separates(&[*c, *b, *a]) {
                    return Some(words(&[*c, *b, *a]));
                }
            }
        }
    }
    None
}
