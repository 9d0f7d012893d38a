//! The system of xi and xi_bar, eq. (50) to (59), and its solution.

use super::equation::{At, Equation, XI, Zero};
use super::variations::{d, delta_d, delta_t, of, second, second_d, t};
use crate::check::external::stages::terms::{
    Beam, Part, Side, Terms, Vector, dot, minus, numbers, product, scaled, tag, tagged, vector,
};

/// The system of eq. (50): a, b, a_bar.
pub(super) fn a(beam: Beam) -> Terms {
    let sign = [1.0, -1.0][beam];
    let square = scaled(sign, &dot(&t(beam), &t(beam)));
    let names = [["t.t of a", "d.t,xi of a"], ["t_bar.t_bar of a_bar", "d.t_bar,xi of a_bar"]][beam];
    let bend = dot(&d(), &vector(Vector::T(beam, 1)));
    tag(["a", "a_bar"][beam], [tag(names[0], square), tag(names[1], bend)].concat())
}

pub(super) fn b() -> Terms {
    tag("b", dot(&t(0), &t(1)))
}

/// R or R_bar of first order, eq. (51).
pub(super) fn r_first(side: Side, beam: Beam) -> Terms {
    let fixed = |beam| tagged(["du of du_hat", "du_bar of du_hat"][beam], vector(Vector::U(side, beam, 0)));
    let u_hat = tagged("du_hat", [fixed(0), minus(fixed(1))].concat());
    let all = [dot(&u_hat, &t(beam)), dot(&d(), &vector(Vector::U(side, beam, 1)))];
    tag(["R", "R_bar"][beam], scaled(-1.0, &all.concat()))
}

/// R or R_bar of second order, eq. (55).
pub(super) fn r_second(beam: Beam) -> Terms {
    let all = [
        tag(["dd.Dt", "dd.Dt_bar"][beam], dot(&delta_d(0), &delta_t(1, beam))),
        tag(["Dd.dt", "Dd.dt_bar"][beam], dot(&delta_d(1), &delta_t(0, beam))),
        tag(["t.Ddd", "t_bar.Ddd"][beam], dot(&t(beam), &second_d())),
        tag(["d.Ddt", "d.Ddt_bar"][beam], dot(&d(), &second(beam, 1))),
    ];
    tag(["R", "R_bar"][beam], scaled(-1.0, &all.concat()))
}

/// The system, eq. (50) or (55): a xi - b xi_bar = R, b xi + a_bar xi_bar = R_bar.
pub(super) fn implicit(beam: Beam, part: Part, r: &Terms) -> Terms {
    let [xi, xi_bar] = XI.map(|xi| numbers(1.0, &[of(xi, part)]));
    let left = if beam == 0 {
        [product(&a(0), &xi), scaled(-1.0, &product(&b(), &xi_bar))]
    } else {
        [product(&b(), &xi), product(&a(1), &xi_bar)]
    };
    [left.concat(), scaled(-1.0, r)].concat()
}

/// The solution of the system by its inverse, eq. (52), (56): D xi - (a_bar R + b R_bar) = 0.
pub(super) fn solved(beam: Beam, part: Part, [r, r_bar]: [&Terms; 2]) -> Zero {
    let determinant =
        [tag("a a_bar of D", product(&a(0), &a(1))), tag("b^2 of D", product(&b(), &b()))].concat();
    let result = numbers(1.0, &[of(XI[beam], part)]);
    let left = tag(["D xi", "D xi_bar"][beam], product(&determinant, &result));
    let (first, other) = if beam == 0 { (a(1), b()) } else { (scaled(-1.0, &b()), a(0)) };
    let products = [["a_bar R of xi", "b R_bar of xi"], ["-b R of xi_bar", "a R_bar of xi_bar"]][beam];
    let right = [tag(products[0], product(&first, r)), tag(products[1], product(&other, r_bar))].concat();
    let of_xi = XI[beam].name();
    let mut extras = vec![(format!("{of_xi} is not divided by D"), [result, scaled(-1.0, &left)].concat())];
    let entries = [("a", a(0)), ("b", b()), ("a_bar", a(1))];
    let names = [["a_bar", "b"], ["-b", "a"]][beam];
    for (name, entry) in &entries {
        for (place, right_one, by) in [(0, &first, r), (1, &other, r_bar)] {
            if *name != names[place].trim_start_matches('-') {
                for sign in [1.0, -1.0] {
                    let difference =
                        [scaled(sign, &product(entry, by)), scaled(-1.0, &product(right_one, by))].concat();
                    let minus = if sign < 0.0 { "-" } else { "" };
                    let words = format!(
                        "{minus}{name} stands in the place of {} in the row of {of_xi}",
                        names[place]
                    );
                    extras.push((words, scaled(-1.0, &difference)));
                }
            }
        }
    }
    let swapped = |with: &Terms, entry: &Terms, by: &Terms| {
        [product(entry, with), scaled(-1.0, &product(entry, by))].concat()
    };
    extras.push((
        format!("R_bar stands in the place of R in {of_xi}"),
        scaled(-1.0, &swapped(r_bar, &first, r)),
    ));
    extras.push((
        format!("R stands in the place of R_bar in {of_xi}"),
        scaled(-1.0, &swapped(r, &other, r_bar)),
    ));
    Zero {
        terms: [left, scaled(-1.0, &right)].concat(),
        extras,
        number: None,
        is_wrong_form: None,
        is_elementary: false,
    }
}

/// A held parameter does not vary.
pub(super) fn held(beam: Beam, part: Part, number: &'static str, r: &[Terms; 2]) -> Equation {
    let zero = Zero::of(numbers(1.0, &[of(XI[beam], part)]));
    let words = "a parameter that is held at an end is varied";
    let free = |beam: Beam| Zero { is_wrong_form: Some(words), ..Zero::of(implicit(beam, part, &r[beam])) };
    let forms = vec![vec![zero], vec![free(0), free(1)], vec![free(beam)]];
    Equation { results: vec![(XI[beam], part)], number, at: At::Held(beam), forms }
}

/// The equations of xi and xi_bar where both are free, and where one of them is.
pub(super) fn system(part: Part, number: &'static str, r: &[Terms; 2]) -> [Equation; 3] {
    let results = XI.map(|xi| (xi, part));
    let implicit = |beam: Beam| Zero::of(implicit(beam, part, &r[beam]));
    let solved = |beam: Beam| solved(beam, part, [&r[0], &r[1]]);
    let both = Equation {
        results: results.to_vec(),
        number,
        at: At::Free,
        forms: vec![vec![implicit(0), implicit(1)], vec![solved(0), solved(1)]],
    };
    let alone = |beam: Beam| {
        let exchanged = [scaled(-1.0, &r[1 - beam]), r[beam].clone()].concat();
        let words = ["R_bar stands in the place of R", "R stands in the place of R_bar"][beam];
        let zero = Zero { extras: vec![(words.into(), exchanged)], ..implicit(beam) };
        let full = Zero {
            extras: Vec::new(),
            is_wrong_form: Some("the system of both parameters is solved, although one is held"),
            ..solved(beam)
        };
        let results = results[beam..=beam].to_vec();
        Equation { results, number, at: At::Alone(beam), forms: vec![vec![zero], vec![full]] }
    };
    [both, alone(0), alone(1)]
}
