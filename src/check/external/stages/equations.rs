//! The defining equations in the order of evaluation, each as sums of terms that are zero.
//!
//! Where an equation is implicit in its result, as (50) and (55) are, it is used as it stands: its sum is zero to rounding if
//! this step of a program is right, whatever was wrong before.

mod distance;
mod equation;
mod system;
mod variations;

use super::terms::{
    Beam, Number, Part, Side, Sum, Terms, Vector, dot, minus, numbers, scaled, tag, tagged, times, vector,
};
use crate::linearization::Quantity;
use Quantity::{D, DVector, GN, GT, GTBar, T, TBar, TBarVector, TVector, X, XBar, Xi, XiBar};
use distance::{general, normal, printed, symmetric};
use equation::XI;
pub(super) use equation::{At, Equation, Zero};
use system::{held, r_first, r_second, system};
use variations::{d, delta_d, delta_t, delta_x, of, second, second_d, t};

const LENGTH: [Quantity; 2] = [T, TBar];

/// The parts of a contact element: the residual along both directions, and the tangent.
pub(super) const RESIDUAL: Part = 10;
pub(super) const TANGENT: Part = 12;
/// The number of the equations of the closest point.
pub(super) const CLOSEST_POINT: &str = "(3)";
const SLIP: [Quantity; 2] = [GT, GTBar];

/// The list of equations while it is made.
#[derive(Default)]
struct List(Vec<Equation>);

impl List {
    fn add(&mut self, results: &[(Quantity, Part)], number: &'static str, at: At, forms: Vec<Vec<Zero>>) {
        self.0.push(Equation { results: results.to_vec(), number, at, forms });
    }

    /// Adds an equation of one sum, valid everywhere.
    fn one(&mut self, result: (Quantity, Part), number: &'static str, terms: &[Terms]) {
        self.add(&[result], number, At::All, vec![vec![Zero::of(terms.concat())]]);
    }

    /// d and g_N, eq. (1) and (11).
    fn values(&mut self) {
        for (beam, xi) in XI.into_iter().enumerate() {
            let at_end = [numbers(1.0, &[of(xi, 0)]), numbers(-1.0, &[Number::End(beam)])].concat();
            self.add(&[(xi, 0)], CLOSEST_POINT, At::Held(beam), vec![vec![Zero::of(at_end)]]);
            let zero = Zero::of(dot(&d(), &t(beam)));
            self.add(&[(xi, 0)], CLOSEST_POINT, At::FreeOf(beam), vec![vec![zero]]);
        }
        let c = vector(Vector::Cross);
        let normal = [numbers(1.0, &[of(D, 0), Number::Length(Vector::Cross)]), scaled(-1.0, &dot(&c, &d()))];
        let forms = [length(D, Vector::D), normal.concat()].map(|terms| vec![Zero::of(terms)]);
        self.add(&[(D, 0)], "(1)", At::All, forms.to_vec());
        let radii = [0, 1].map(|beam| numbers(1.0, &[Number::Radius(beam)]));
        let gap = [numbers(1.0, &[of(GN, 0)]), numbers(-1.0, &[of(D, 0)]), radii.concat()];
        self.one((GN, 0), "(11)", &gap);
    }

    /// The first variations of xi, xi_bar, d and g_N.
    fn first_order(&mut self, side: Side) {
        let part = 1 + side;
        let r = [r_first(side, 0), r_first(side, 1)];
        self.0.extend([0, 1].map(|beam| held(beam, part, "(50)", &r)));
        self.0.extend(system(part, "(50)", &r));
        let u_hat = [
            tagged("du of du_hat", vector(Vector::U(side, 0, 0))),
            tagged("du_bar of du_hat", minus(vector(Vector::U(side, 1, 0)))),
        ]
        .concat();
        let (c, c_length) = (vector(Vector::Cross), Number::Length(Vector::Cross));
        let along_d =
            [numbers(1.0, &[of(D, 0), of(D, part)]), scaled(-1.0, &tag("d.du_hat", dot(&d(), &u_hat)))];
        let along_n =
            [numbers(1.0, &[c_length, of(D, part)]), scaled(-1.0, &tag("n.du_hat", dot(&c, &u_hat)))];
        let forms = [along_d, along_n].map(|terms| vec![Zero::of(terms.concat())]);
        self.add(&[(D, part)], "(37)", At::All, forms.to_vec());
        self.one((GN, part), "(18)", &[numbers(1.0, &[of(GN, part)]), numbers(-1.0, &[of(D, part)])]);
    }

    /// The second variations of xi, xi_bar, d and g_N.
    fn second_order(&mut self) {
        let r = [r_second(0), r_second(1)];
        self.0.extend([0, 1].map(|beam| held(beam, 3, "(55)", &r)));
        self.0.extend(system(3, "(55)", &r));
        let forms = [symmetric(), general(), printed(), normal()].map(|terms| vec![Zero::of(terms)]);
        self.add(&[(D, 3)], "(40)", At::Free, forms.to_vec());
        let by_system = Zero { number: Some("(40)"), ..Zero::of(symmetric()) };
        self.add(&[(D, 3)], "(39)", At::SomeHeld, vec![vec![Zero::of(general())], vec![by_system]]);
        self.one((GN, 3), "(19)", &[numbers(1.0, &[of(GN, 3)]), numbers(-1.0, &[of(D, 3)])]);
    }

    /// The points, the tangents and d, as vectors.
    fn vectors(&mut self) {
        for axis in 0..3 {
            for (k, vectors) in [[X, XBar], [TVector, TBarVector]].into_iter().enumerate() {
                for beam in 0..2 {
                    let here = if k == 0 { Vector::X(beam) } else { Vector::T(beam, 0) };
                    let first =
                        [0, 1].map(|side| if k == 0 { delta_x(side, beam) } else { delta_t(side, beam) });
                    let along = times(&[of(XI[beam], 3)], Vector::T(beam, k));
                    let second = [second(beam, k), along].concat();
                    self.vector(vectors[beam], axis, &vector(here), &first, &second);
                }
            }
            let along =
                [times(&[of(Xi, 3)], Vector::T(0, 0)), minus(times(&[of(XiBar, 3)], Vector::T(1, 0)))];
            let second = [second_d(), along.concat()].concat();
            self.vector(DVector, axis, &d(), &[0, 1].map(delta_d), &second);
        }
    }

    /// A component of a vector, with its variations.
    fn vector(&mut self, quantity: Quantity, axis: usize, value: &Sum, first: &[Sum; 2], second: &Sum) {
        let along = vector(Vector::Axis(axis));
        let all = [(value, "(4)"), (&first[0], "(32)"), (&first[1], "(32)"), (second, "(32)")];
        for (part, (sum, number)) in all.into_iter().enumerate() {
            let result = numbers(1.0, &[Number::Component(quantity, axis, part)]);
            self.one((quantity, part), number, &[result, scaled(-1.0, &dot(sum, &along))]);
        }
    }

    /// The length of a tangent, eq. (41) and (42).
    fn tangent(&mut self, beam: Beam) {
        let (quantity, v) = (LENGTH[beam], Vector::T(beam, 0));
        self.one((quantity, 0), "(6)", &[length(quantity, v)]);
        for side in 0..2 {
            let first = tag(["t.dt", "t_bar.dt_bar"][beam], dot(&vector(v), &delta_t(side, beam)));
            let terms = [numbers(1.0, &[of(quantity, 0), of(quantity, 1 + side)]), scaled(-1.0, &first)];
            self.one((quantity, 1 + side), "(41)", &terms);
        }
        let curved = dot(&vector(v), &times(&[of(XI[beam], 3)], Vector::T(beam, 1)));
        let products = dot(&delta_t(0, beam), &delta_t(1, beam));
        let rest = dot(&vector(v), &second(beam, 1));
        let terms = [
            numbers(1.0, &[of(quantity, 0), of(quantity, 3)]),
            tag(["dt Dt", "dt_bar Dt_bar"][beam], numbers(1.0, &[of(quantity, 1), of(quantity, 2)])),
            scaled(-1.0, &tag(["dt.Dt", "dt_bar.Dt_bar"][beam], products)),
            scaled(-1.0, &tag(["t.Ddt", "t_bar.Ddt_bar"][beam], rest)),
            scaled(-1.0, &tag(["t.t,xi Ddxi", "t_bar.t_bar,xi Ddxi_bar"][beam], curved)),
        ];
        self.one((quantity, 3), "(42)", &terms);
    }

    /// A slip, eq. (15), (20) and (21).
    fn slip(&mut self, beam: Beam) {
        let (t, xi, slip, moved) = (LENGTH[beam], XI[beam], SLIP[beam], Number::Moved(beam, beam));
        self.one((slip, 0), "(15)", &[numbers(1.0, &[of(slip, 0)]), numbers(-1.0, &[moved, of(t, 0)])]);
        for part in [1, 2] {
            let terms = [
                numbers(1.0, &[of(slip, part)]),
                numbers(-1.0, &[moved, of(t, part)]),
                numbers(-1.0, &[of(t, 0), of(xi, part)]),
            ];
            self.one((slip, part), "(20)", &terms);
        }
        let mixed = [numbers(-1.0, &[of(t, 1), of(xi, 2)]), numbers(-1.0, &[of(t, 2), of(xi, 1)])];
        let terms = [
            numbers(1.0, &[of(slip, 3)]),
            numbers(-1.0, &[moved, of(t, 3)]),
            tag(["dt Dxi + Dt dxi", "dt_bar Dxi_bar + Dt_bar dxi_bar"][beam], mixed.concat()),
            numbers(-1.0, &[of(t, 0), of(xi, 3)]),
        ];
        self.one((slip, 3), "(21)", &terms);
    }

    /// Residual and tangent of a contact element with a penalty alone: k g_N dg_N and k (dg_N Dg_N + g_N Ddg_N).
    fn element(&mut self) {
        for side in 0..2 {
            let terms = numbers(-1.0, &[Number::Stiffness, of(GN, 0), of(GN, 1 + side)]);
            self.one((GN, RESIDUAL + side), "", &[numbers(1.0, &[Number::Element(side)]), terms]);
        }
        let terms = [
            numbers(1.0, &[Number::Element(2)]),
            numbers(-1.0, &[Number::Stiffness, of(GN, 1), of(GN, 2)]),
            numbers(-1.0, &[Number::Stiffness, of(GN, 0), of(GN, 3)]),
        ];
        self.one((GN, TANGENT), "", &terms);
    }
}

/// The length of a vector.
fn length(quantity: Quantity, v: Vector) -> Terms {
    let squared = dot(&vector(v), &vector(v));
    [numbers(1.0, &[of(quantity, 0), Number::Length(v)]), scaled(-1.0, &squared)].concat()
}

/// All equations in the order of evaluation. Those of the second direction of first variations are left out if `has_arrays`,
/// because gradients say the same in both.
pub(super) fn equations(has_arrays: bool) -> Vec<Equation> {
    let mut list = List::default();
    list.values();
    list.first_order(0);
    list.first_order(1);
    list.second_order();
    list.vectors();
    for beam in 0..2 {
        list.tangent(beam);
    }
    for beam in 0..2 {
        list.slip(beam);
    }
    list.element();
    let is_second =
        |equation: &Equation| equation.results.iter().any(|(_, part)| *part == 2 || *part == RESIDUAL + 1);
    list.0.retain(|equation| !has_arrays || !is_second(equation));
    list.0
}
