//! Residual and tangent of a contact element with friction.

use super::distance::{general, normal, symmetric};
use super::variations::of;
use super::{LENGTH, XI, Zero};
use crate::check::external::stages::sample::{Kind, Wrong};
use crate::check::external::stages::terms::{
    Beam, Factor, Number, Part, Tag, Term, Terms, Vector, numbers, product, scaled, tag,
};
use crate::linearization::Quantity::{D, GN};

fn friction(kind: Kind) -> Number {
    Number::Friction(Wrong::Nothing, kind)
}

const E: [Kind; 2] = [Kind::E, Kind::EBar];
const L: [Kind; 2] = [Kind::L, Kind::LBar];
const U: [Kind; 2] = [Kind::U, Kind::UBar];
const TURN: [Kind; 2] = [Kind::LinearOfBeam, Kind::LinearOfBar];

/// eps_T rho, with the sign of the bar's force.
fn factor_of(beam: Beam) -> Vec<Number> {
    [vec![friction(Kind::Factor)], if beam == 1 { vec![friction(Kind::BarSign)] } else { vec![] }].concat()
}

/// A product of numbers with the names of what it is part of.
fn term(by: f64, of: &[&[Number]], names: &[&[Tag]]) -> Terms {
    names.concat().into_iter().fold(numbers(by, &of.concat()), |terms, name| tag(name, terms))
}

/// The parts of A = t grad xi along a direction, each with its names. By the other work there is also (xi - xi_n) grad t.
fn a(beam: Beam, part: Part) -> [(Vec<Number>, &'static [Tag]); 2] {
    let names: [[&[Tag]; 2]; 2] = [
        [&["t grad xi of A"], &["(xi - xi_n) grad t of A"]],
        [&["t_bar grad xi_bar of A_bar"], &["(xi_bar - xi_bar_n) grad t_bar of A_bar"]],
    ];
    let [rate, rest] = names[beam];
    [
        (vec![of(LENGTH[beam], 0), of(XI[beam], part)], rate),
        (vec![friction(Kind::IsPaper), friction(U[beam]), of(LENGTH[beam], part)], rest),
    ]
}

/// The parts of the change of e along Delta: t Dxi + (xi - xi_n) Dt.
fn change_of_e(beam: Beam) -> [(Vec<Number>, &'static [Tag]); 2] {
    let names: [[&[Tag]; 2]; 2] = [
        [&["grad e", "t grad xi of grad e"], &["grad e", "(xi - xi_n) grad t of grad e"]],
        [
            &["grad e_bar", "t_bar grad xi_bar of grad e_bar"],
            &["grad e_bar", "(xi_bar - xi_bar_n) grad t_bar of grad e_bar"],
        ],
    ];
    let [along, stretched] = names[beam];
    [
        (vec![of(LENGTH[beam], 0), of(XI[beam], 2)], along),
        (vec![friction(U[beam]), of(LENGTH[beam], 2)], stretched),
    ]
}

/// R + F_N grad g_N - F A - F_bar A_bar = 0 along a direction.
pub(super) fn residual(side: usize) -> Zero {
    let part = 1 + side;
    let normal = [friction(Kind::NormalForce), friction(Kind::Side), of(GN, part)];
    let mut terms = vec![numbers(1.0, &[Number::Element(side)]), tag("F_N grad g_N", numbers(1.0, &normal))];
    let names: [[Tag; 3]; 2] =
        [["F A", "e of F", "c e_bar of F"], ["F_bar A_bar", "e_bar of F_bar", "c e of F_bar"]];
    for (beam, [all, of_own, of_other]) in names.into_iter().enumerate() {
        let factor = factor_of(beam);
        for (a, of_a) in a(beam, part) {
            terms.push(term(-1.0, &[&factor, &[friction(E[beam])], &a], &[&["friction", all, of_own], of_a]));
            let other = [friction(Kind::Cosine), friction(E[1 - beam])];
            terms.push(term(1.0, &[&factor, &other, &a], &[&["friction", all, "c", of_other], of_a]));
        }
    }
    with_errors(terms.concat(), false)
}

/// The tangent with the Hessian of g_N as a number, and with its terms: those of the forms of eq. (39) and (40).
pub(super) fn tangent_forms() -> [Zero; 4] {
    let length = [Number::Length(Vector::Cross); 4];
    [
        tangent(),
        with_terms_of_gap(&symmetric(), &[of(D, 0)]),
        with_terms_of_gap(&general(), &[of(D, 0)]),
        with_terms_of_gap(&normal(), &length),
    ]
}

/// The tangent times `by`, with the terms of a form in the place of `by` times the Hessian of g_N. These alone have names.
fn with_terms_of_gap(form: &Terms, by: &[Number]) -> Zero {
    let is_of = |number: Number| move |term: &&Term| term.factors.contains(&Factor::Number(number));
    let is_hessian = is_of(of(GN, 3));
    let mut tangent = tangent().terms;
    for term in &mut tangent {
        term.tags.clear();
    }
    let others: Terms = tangent.iter().filter(|term| !is_hessian(term)).cloned().collect();
    let force = numbers(-1.0, &[friction(Kind::NormalForce), friction(Kind::Side)]);
    let result = is_of(of(D, 3));
    let of_form: Terms = form.iter().filter(|term| !result(term)).cloned().collect();
    let terms = [product(&numbers(1.0, by), &others), product(&force, &of_form)].concat();
    Zero { number: Some("(39) and (40)"), is_elementary: false, is_last: true, ..Zero::of(terms) }
}

/// K less its terms is zero between two directions: rows belong to delta, columns to Delta.
fn tangent() -> Zero {
    let (force, side) = (friction(Kind::NormalForce), friction(Kind::Side));
    let product = [friction(Kind::Stiffness), of(GN, 1), of(GN, 2)];
    let mut terms = vec![
        numbers(1.0, &[Number::Element(2)]),
        tag("k, the stiffness of the law,", tag("k grad g_N grad g_N^T", numbers(-1.0, &product))),
        tag("F_N times the Hessian of g_N", numbers(1.0, &[force, side, of(GN, 3)])),
    ];
    for beam in 0..2 {
        for (row, of_row) in a(beam, 1).into_iter().enumerate() {
            terms.push(of_force(beam, &of_row, row == 0));
        }
        terms.push(of_vector(beam));
    }
    let of_friction = tag("the friction part", terms.split_off(3).concat());
    with_errors([terms.concat(), of_friction].concat(), true)
}

/// -A grad F^T: the change of the friction force, with a part of A; `is_rate` for t grad xi.
fn of_force(beam: Beam, (a, of_a): &(Vec<Number>, &[Tag]), is_rate: bool) -> Terms {
    let other = 1 - beam;
    let names: [[Tag; 5]; 2] = [
        ["A grad F^T", "grad l", "e_bar grad c of grad l", "t.grad T of the beam", "T.grad t of the beam"],
        [
            "A_bar grad F_bar^T",
            "grad l_bar",
            "e grad c of grad l_bar",
            "t_bar.grad T of the bar beam",
            "T.grad t_bar of the bar beam",
        ],
    ];
    let [all, of_l, of_cosine, of_traction, of_tangent] = names[beam];
    let all: &[Tag] = &[all, "A grad F^T and its twin"];
    // What stands in t.grad T in programs that compute with the vector T, and what in T.grad t.
    let (in_traction, in_tangent): (&[Tag], &[Tag]) =
        if is_rate { (&[of_traction], &[of_tangent]) } else { (&[], &[]) };
    let trial: &[Tag] = &["the change of the trial force", "A grad m^T"];
    let turned: [Tag; 2] = ["grad tau of the trial force", "grad tau_bar of the trial force"];
    let both: &[Tag] =
        &["grad c", "grad tau and grad tau_bar of the trial force", "grad tau and grad tau_bar"];
    let all_turned: [Tag; 2] = ["grad tau", "grad tau_bar"];
    let (cosine, l) = (friction(Kind::Cosine), friction(L[beam]));
    let factor = factor_of(beam);
    let gamma = [vec![friction(Kind::OfGamma)], factor[1..].to_vec()].concat();
    let mut sum = Terms::new();
    let mut add = |by: f64, numbers: &[&[Number]], names: &[&[Tag]]| {
        sum.extend(term(by, &[&numbers.concat(), a], &[all, of_a, &names.concat()]));
    };
    for (change, of_change) in change_of_e(beam) {
        add(-1.0, &[&factor, &change], &[trial, in_traction, &[of_l], of_change]);
    }
    for (change, of_change) in change_of_e(other) {
        add(1.0, &[&factor, &[cosine], &change], &[trial, in_traction, &[of_l], of_change]);
    }
    // The own tangent turns in T.grad t, the other one in the trial force.
    let numbers_of = |turns: Beam| [&factor[..], &[friction(E[other]), friction(TURN[turns])]].concat();
    // Programs that compute T.grad tau for the other work have all changes of tau.
    let in_other_work: &[Tag] = if is_rate { &[] } else { &["grad tau and grad tau_bar", all_turned[beam]] };
    let common: &[Tag] = &[of_l, of_cosine, "A grad m^T"];
    add(1.0, &[&numbers_of(beam)], &[common, &["grad c"], in_tangent, in_other_work]);
    let of_other =
        [&[turned[other], all_turned[other], "the change of the trial force"], in_traction].concat();
    add(1.0, &[&numbers_of(other)], &[common, both, &of_other]);
    // In slip: the change of F_N, and that of gamma.
    let gap = [friction(Kind::OfForce), friction(Kind::Side), of(GN, 2), l];
    let of_gap: &[Tag] = &["grad rho", "grad F_N of the slip force", "k, the stiffness of the law,"];
    add(1.0, &[&gap, &factor[1..]], &[in_traction, of_gap]);
    let of_gamma: &[Tag] = &["grad rho", "grad gamma"];
    for of_beam in 0..2 {
        for (change, of_change) in change_of_e(of_beam) {
            add(
                1.0,
                &[&gamma, &[l, friction(L[of_beam])], &change],
                &[trial, in_traction, of_gamma, of_change],
            );
        }
        let numbers = [l, friction(Kind::E), friction(Kind::EBar), friction(TURN[of_beam])];
        let of_turn = [turned[of_beam], all_turned[of_beam]];
        add(-1.0, &[&gamma, &numbers], &[trial, in_traction, of_gamma, both, &of_turn]);
    }
    sum
}

/// -F H_A: the change of A.
fn of_vector(beam: Beam) -> Terms {
    let factor = [factor_of(beam), vec![friction(L[beam])]].concat();
    let (xi, t, u, paper) = (XI[beam], LENGTH[beam], friction(U[beam]), friction(Kind::IsPaper));
    let names: [[Tag; 7]; 2] = [
        [
            "F H_A",
            "F t H_xi",
            "F grad xi grad t^T",
            "F times what the other work adds to H_A",
            "T.grad t of the beam",
            "F (xi - xi_n) H_t",
            "F grad t grad xi^T",
        ],
        [
            "F_bar H_A_bar",
            "F_bar t_bar H_xi_bar",
            "F_bar grad xi_bar grad t_bar^T",
            "F_bar times what the other work adds to H_A_bar",
            "T.grad t_bar of the bar beam",
            "F_bar (xi_bar - xi_bar_n) H_t_bar",
            "F_bar grad t_bar grad xi_bar^T",
        ],
    ];
    let [all, hessian, product, rest, of_tangent, stretched, other_product] = names[beam];
    let common: &[Tag] = &[all, "F H_A and its twin"];
    let add = |numbers: &[Number], names: &[Tag]| term(-1.0, &[&factor, numbers], &[common, names]);
    [
        add(&[of(t, 0), of(xi, 3)], &[hessian]),
        add(&[of(xi, 1), of(t, 2)], &[product, of_tangent]),
        add(&[paper, u, of(t, 3)], &[rest, stretched]),
        add(&[paper, of(t, 1), of(xi, 2)], &[rest, other_product]),
    ]
    .concat()
}

/// The sum, with the errors that change all its numbers; of the tangent also those that exchange rows and columns.
fn with_errors(terms: Terms, is_tangent: bool) -> Zero {
    let changed = |change: &dyn Fn(Number) -> Vec<Factor>| -> Terms {
        let of = |factor: &Factor| match factor {
            Factor::Number(number) => change(*number),
            other => vec![*other],
        };
        let new = terms.iter().map(|term| Term {
            factors: term.factors.iter().flat_map(of).collect(),
            tags: vec![],
            ..term.clone()
        });
        new.chain(scaled(-1.0, &terms)).collect()
    };
    let with = |change: &dyn Fn(Number) -> Number| changed(&|number| vec![Factor::Number(change(number))]);
    let mut extras: Vec<(String, Terms)> = Wrong::ALL[1..]
        .iter()
        .map(|&wrong| {
            let terms = with(&|number| match number {
                Number::Friction(_, kind) => Number::Friction(wrong, kind),
                other => other,
            });
            (wrong.name().to_owned(), terms)
        })
        .collect();
    if is_tangent {
        let exchanged = with(&|number| match number {
            Number::Of(quantity, 1) => Number::Of(quantity, 2),
            Number::Of(quantity, 2) => Number::Of(quantity, 1),
            Number::Friction(wrong, Kind::LinearOfBeam) => Number::Friction(wrong, Kind::DeltaOfBeam),
            Number::Friction(wrong, Kind::LinearOfBar) => Number::Friction(wrong, Kind::DeltaOfBar),
            other => other,
        });
        for beam in 0..2 {
            extras.push(unprojected(beam, &terms));
        }
        extras.push(("its symmetric part stands in its place".into(), scaled(0.5, &exchanged)));
        extras.push(("rows and columns are exchanged".into(), exchanged));
    }
    Zero { extras, ..Zero::of(terms) }
}

/// The change of the unit tangent with the part along itself, which it does not have.
fn unprojected(beam: Beam, terms: &Terms) -> (String, Terms) {
    let name = ["(xi - xi_n) grad t of grad e", "(xi_bar - xi_bar_n) grad t_bar of grad e_bar"][beam];
    let (t, u, e) = (LENGTH[beam], friction(U[beam]), friction(E[beam]));
    let by_length = Factor::Power(t, -1);
    // e grad t/t is added where grad e has (xi - xi_n) grad t, its last factor of this kind.
    let of_trial = terms.iter().filter(|term| term.tags.iter().any(|(tag, _)| *tag == name)).map(|term| {
        let mut factors = term.factors.clone();
        if let Some(last) = factors.iter().rposition(|factor| *factor == Factor::Number(u)) {
            factors[last] = Factor::Number(e);
        }
        Term { factors: [factors, vec![by_length]].concat(), tags: vec![], ..term.clone() }
    });
    let of_other_work =
        [&factor_of(beam)[..], &[friction(L[beam]), friction(Kind::IsPaper), u, of(t, 1), of(t, 2)]];
    let mut of_other_work = numbers(-1.0, &of_other_work.concat());
    of_other_work[0].factors.push(by_length);
    let of = ["t/|t|", "t_bar/|t_bar|"][beam];
    (
        format!("the derivative of the unit tangent {of} lacks its projection"),
        of_trial.chain(of_other_work).collect(),
    )
}
