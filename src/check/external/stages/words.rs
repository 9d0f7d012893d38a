//! Vectors, numbers and terms in words, as the terms of the catalogue are written.

use super::terms::{Beam, Factor, Number, Term, Vector};

pub(super) fn vector_words(of: Vector) -> String {
    let bar = |beam: Beam| ["", "_bar"][beam];
    let xi = |order: usize| ["", ",xi", ",xixi"][order];
    match of {
        Vector::D => "d".into(),
        Vector::X(beam) => format!("x{}", bar(beam)),
        Vector::T(beam, order) => format!("t{}{}", bar(beam), xi(order)),
        Vector::U(side, beam, order) => format!("{}u{}{}", ["d", "D"][side], bar(beam), xi(order)),
        Vector::Mixed(beam, order) => format!("Ddu{}{}", bar(beam), xi(order)),
        Vector::Axis(axis) => ["e_x", "e_y", "e_z"][axis].into(),
        Vector::Cross => "t x t_bar".into(),
        Vector::Permuted(_, order) => {
            let axes: Vec<_> = order.iter().map(|c| ["x", "y", "z"][*c]).collect();
            format!("the components {} of it", axes.join(", "))
        }
    }
}

pub(super) fn number_words(of: Number) -> String {
    match of {
        Number::Of(quantity, part) => format!("{}{}", ["", "d", "D", "Dd"][part.min(3)], quantity.name()),
        Number::Component(quantity, axis, part) => {
            format!("{}{}.{}", ["", "d", "D", "Dd"][part], quantity.name(), ["x", "y", "z"][axis])
        }
        Number::Length(v) => format!("|{}|", vector_words(v)),
        Number::Radius(beam) => ["r", "r_bar"][beam].into(),
        Number::End(_) => "the end".into(),
        Number::Moved(b, c) => format!("{} - {}", ["xi", "xi_bar"][b], ["xi_0", "xi_bar_0"][c]),
        Number::Stiffness => "k".into(),
        Number::Element(k) => ["R", "R", "K"][k].into(),
    }
}

/// A term in words.
pub(super) fn words(term: &Term) -> String {
    let of = |factor: &Factor| match *factor {
        Factor::Dot(v, w) => format!("{}.{}", vector_words(v), vector_words(w)),
        Factor::Size(v, w) => format!("|{}.{}|", vector_words(v), vector_words(w)),
        Factor::Number(number) => number_words(number),
        _ => String::new(),
    };
    term.factors.iter().map(of).collect::<Vec<_>>().join(" ")
}
