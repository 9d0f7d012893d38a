//! The sums of section 5 of the derivation, with J_d, J_t and S multiplied out.

use super::{Along, BEAMS, Error, Increment, Point, Summand, Sums};
use crate::linearization::{Quantity, Varied};
use crate::number::{Label, Which};

/// The powers of a length that derivations by hand miss or repeat.
const POWERS: [i32; 4] = [-2, -1, 1, 2];

/// The product of two first variations, the second factor along the other direction.
type Product<'a> = &'a dyn Fn(&Along, &Along) -> f64;

/// Summands under construction.
struct List<'a> {
    point: &'a Point,
    all: Vec<(Summand, Increment)>,
}

impl List<'_> {
    fn push(&mut self, label: Label, count: u8, error: Error, sums: Sums) {
        let increment = self.point.increment(sums);
        self.all.push((Summand { label, count, error, mirror: None, transposed: None }, increment));
    }

    /// A product, and the transposed one if it differs.
    fn product(
        &mut self,
        [name, transposed]: [&'static str; 2],
        (which, count): (Which, u8),
        sums: &dyn Fn(f64) -> Sums,
        product: Product,
    ) {
        let [delta, linear] = &self.point.directions;
        let values = [product(delta, linear), product(linear, delta)];
        let start = self.all.len();
        self.push(Label { name, which }, count, Error::Factor, sums(values[0]));
        if !transposed.is_empty() {
            self.push(Label { name: transposed, which }, count, Error::Factor, sums(values[1]));
            self.all[start].0.transposed = Some(start + 1);
            self.all[start + 1].0.transposed = Some(start);
        }
    }

    /// Powers of `base` on a summand.
    fn powers(&mut self, label: Label, base: f64, sums: &dyn Fn(f64) -> Sums) {
        for power in POWERS {
            self.push(label, 1, Error::Power(power), sums(base.powi(power) - 1.0));
        }
    }
}

impl Point {
    /// The summands of P, H_d, H_t and H_g_T, those of the bar beam, and powers on them.
    pub(super) fn all_summands(&self) -> Vec<(Summand, Increment)> {
        let mut list = List { point: self, all: Vec::new() };
        for beam in 0..2 {
            self.of_parameters(&mut list, beam);
            self.of_distance(&mut list, beam);
            self.of_length(&mut list, beam);
            self.of_slip(&mut list, beam);
        }
        self.of_both(&mut list);
        list.all
    }

    /// P = −[J_dᵀJ_t + J_tᵀJ_d + S_x(t) − S_x̄(t) + S_t(d)]
    fn of_parameters(&self, list: &mut List, own: usize) {
        let (which, other) = (BEAMS[own], 1 - own);
        let sign = [1.0, -1.0];
        let [e, e_other] = [sign[own], sign[other]];
        let Self { t, t_xi, t_xixi, d, .. } = self;
        let sums =
            |value: f64| Sums { p: if own == 0 { [-value, 0.0] } else { [0.0, -value] }, ..Sums::default() };
        let mut add = |names, count, product: Product| list.product(names, (which, count), &sums, product);
        add(["P: G'A1", "P: A1'G"], 1, &|one, two| one.u_hat.dot(&two.u[own][1]));
        add(["P: A0'A1", "P: A1'A0"], 1, &|one, two| e * one.u[own][0].dot(&two.u[own][1]));
        add(["P: B0'A1", "P: A1'B0"], 1, &|one, two| e_other * one.u[other][0].dot(&two.u[own][1]));
        add(["P: G't,xi g'", "P: g (G't,xi)'"], 1, &|one, two| one.u_hat.dot(&t_xi[own]) * two.xi[own]);
        add(["P: A0't,xi g'", "P: g (A0't,xi)'"], 1, &|one, two| {
            e * one.u[own][0].dot(&t_xi[own]) * two.xi[own]
        });
        add(["P: B0't,xi g'", "P: g (B0't,xi)'"], 1, &|one, two| {
            e_other * one.u[other][0].dot(&t_xi[own]) * two.xi[own]
        });
        add(["P: A1't g'", "P: g (A1't)'"], 2, &|one, two| e * one.u[own][1].dot(&t[own]) * two.xi[own]);
        add(["P: A1't_bar g_bar'", "P: g_bar (A1't_bar)'"], 1, &|one, two| {
            e_other * one.u[own][1].dot(&t[other]) * two.xi[other]
        });
        add(["P: B1't g_bar'", "P: g_bar (B1't)'"], 1, &|one, two| {
            e_other * one.u[other][1].dot(&t[own]) * two.xi[other]
        });
        add(["P: A2'd g'", "P: g (A2'd)'"], 1, &|one, two| one.u[own][2].dot(d) * two.xi[own]);
        add(["P: t.t,xi gg'", ""], 3, &|one, two| e * t[own].dot(&t_xi[own]) * one.xi[own] * two.xi[own]);
        add(["P: t.t_bar,xi g_bar g_bar'", ""], 1, &|one, two| {
            e_other * t[own].dot(&t_xi[other]) * one.xi[other] * two.xi[other]
        });
        add(["P: t_bar.t,xi g_bar g'", "P: t_bar.t,xi g g_bar'"], 1, &|one, two| {
            e_other * t[other].dot(&t_xi[own]) * one.xi[other] * two.xi[own]
        });
        add(["P: d.t,xixi gg'", ""], 1, &|one, two| d.dot(&t_xixi[own]) * one.xi[own] * two.xi[own]);
    }

    /// H_d = [Gᵀ(I − nnᵀ)G − a ggᵀ + b(gḡᵀ + ḡgᵀ) + ā ḡḡᵀ]/d, also with J_dᵀd in the place of the last three.
    fn of_distance(&self, list: &mut List, own: usize) {
        let (which, e) = (BEAMS[own], [1.0, -1.0][own]);
        let Self { t, t_xi, d, .. } = self;
        let length = self.varied[Quantity::D.component()].value;
        let sums = |value: f64| Sums { d: value / length, ..Sums::default() };
        let t2 = t[own].dot(&t[own]);
        let curvature = e * d.dot(&t_xi[own]);
        let squared = |one: &Along, two: &Along| one.xi[own] * two.xi[own];
        let mut add = |names, product: Product| {
            list.product(names, (which, 1), &sums, product);
        };
        add(["H_d: a gg'", ""], &|one, two| -(t2 + curvature) * squared(one, two));
        add(["H_d: t.t gg'", ""], &|one, two| -t2 * squared(one, two));
        add(["H_d: d.t,xi gg'", ""], &|one, two| -curvature * squared(one, two));
        add(["H_d: G't g'", "H_d: g (G't)'"], &|one, two| e * one.u_hat.dot(&t[own]) * two.xi[own]);
        add(["H_d: A1'd g'", "H_d: g (A1'd)'"], &|one, two| e * one.u[own][1].dot(d) * two.xi[own]);
        add(["H_d: A0'A0", ""], &|one, two| one.u[own][0].dot(&two.u[own][0]));
    }

    /// The summands in both beams, and each sum as a whole.
    fn of_both(&self, list: &mut List) {
        let Self { d, varied, .. } = self;
        let length = varied[Quantity::D.component()].value;
        let n = d / length;
        let sums = |value: f64| Sums { d: value / length, ..Sums::default() };
        let label = |name| Label { name, which: Which::Beam };
        let [delta, linear] = &self.directions;
        let of_b = |one: &Along, two: &Along| self.projection.b * one.xi[0] * two.xi[1];
        let of_n = |one: &Along, two: &Along| one.u_hat.dot(&n) * two.u_hat.dot(&n);
        let of_one = |one: &Along, two: &Along| one.u_hat.dot(&two.u_hat);
        let mut add = |names, product: Product| list.product(names, (Which::Beam, 1), &sums, product);
        add(["H_d: b gg_bar'", "H_d: b g_bar g'"], &of_b);
        add(["H_d: A0'B0", "H_d: B0'A0"], &|one, two| -one.u[0][0].dot(&two.u[1][0]));
        add(["H_d: G'G", ""], &of_one);
        add(["H_d: G'nn'G", ""], &|one, two| -of_n(one, two));
        list.powers(label("H_d: G'nn'G"), length, &|factor| sums(-factor * of_n(delta, linear)));
        list.powers(label("H_d: G'G"), length, &|factor| sums(factor * of_one(delta, linear)));
        let moved =
            length * varied[Quantity::D.component()].second - of_one(delta, linear) + of_n(delta, linear);
        list.powers(label("H_d: the terms in g and g_bar"), length, &|factor| sums(factor * moved));
        list.powers(label("H_d"), length, &|factor| Sums {
            d: factor * varied[Quantity::D.component()].second,
            ..Sums::default()
        });
        let det = self.projection.det();
        let seconds = Quantity::PARAMETERS.map(|of| varied[of.component()].second);
        list.powers(label("H_xi and H_xi_bar"), det, &|factor| Sums {
            h: seconds.map(|second| factor * second),
            ..Sums::default()
        });
        let mut first = |name, of: &[Quantity], base: f64| {
            for power in POWERS {
                let summand = Summand {
                    label: label(name),
                    count: 1,
                    error: Error::Power(power),
                    mirror: None,
                    transposed: None,
                };
                list.all.push((summand, self.of_first(of, base.powi(power))));
            }
        };
        first("grad d", &[Quantity::D, Quantity::GN], length);
        first("grad t", &[Quantity::T], varied[Quantity::T.component()].value);
        first("grad t_bar", &[Quantity::TBar], varied[Quantity::TBar.component()].value);
    }

    /// H_t = (w·t,ξ) H_ξ + S_t(w) + (J_tᵀJ_t − ∇t∇tᵀ)/t
    fn of_length(&self, list: &mut List, own: usize) {
        let which = BEAMS[own];
        let Varied { value: length, delta, linear, .. } = self.varied[Quantity::LENGTHS[own].component()];
        let [t, t_xi, t_xixi] = [self.t[own], self.t_xi[own], self.t_xixi[own]];
        let w = t / length;
        let sums = |value: f64| {
            let mut sums = Sums::default();
            sums.t[own] = value;
            sums
        };
        let second = self.varied[Quantity::PARAMETERS[own].component()].second;
        let squared = |one: &Along, two: &Along| one.xi[own] * two.xi[own];
        let jacobian = |one: &Along, two: &Along| {
            (one.u[own][1] + t_xi * one.xi[own]).dot(&(two.u[own][1] + t_xi * two.xi[own])) / length
        };
        let mut add = |names, product: Product| list.product(names, (which, 1), &sums, product);
        add(["H_t: w.t,xi H_xi", ""], &|_, _| w.dot(&t_xi) * second);
        add(["H_t: w.t,xixi gg'", ""], &|one, two| w.dot(&t_xixi) * squared(one, two));
        add(["H_t: A2'w g'", "H_t: g (A2'w)'"], &|one, two| one.u[own][2].dot(&w) * two.xi[own]);
        add(["H_t: J_t'J_t", ""], &jacobian);
        add(["H_t: A1'A1", ""], &|one, two| one.u[own][1].dot(&two.u[own][1]) / length);
        add(["H_t: A1't,xi g'", "H_t: g (A1't,xi)'"], &|one, two| {
            one.u[own][1].dot(&t_xi) * two.xi[own] / length
        });
        add(["H_t: t,xi.t,xi gg'", ""], &|one, two| t_xi.dot(&t_xi) * squared(one, two) / length);
        add(["H_t: grad t grad t'", ""], &|_, _| -delta * linear / length);
        let [first, last] = &self.directions;
        let label = |name| Label { name, which };
        list.powers(label("H_t: J_t'J_t"), length, &|factor| sums(factor * jacobian(first, last)));
        list.powers(label("H_t: grad t grad t'"), length, &|factor| sums(-factor * delta * linear / length));
        let whole = self.varied[Quantity::LENGTHS[own].component()].second;
        list.powers(label("H_t"), length, &|factor| sums(factor * whole));
    }

    /// H_g_T = (ξ − ξ₀)H_t + ∇t gᵀ + g∇tᵀ + t H_ξ
    fn of_slip(&self, list: &mut List, own: usize) {
        let [t, xi] = [
            self.varied[Quantity::LENGTHS[own].component()],
            self.varied[Quantity::PARAMETERS[own].component()],
        ];
        let slip = self.slips[own];
        let sums = |value: f64| {
            let mut sums = Sums::default();
            sums.g_t[own] = value;
            sums
        };
        let mut add = |names, product: Product| list.product(names, (BEAMS[own], 1), &sums, product);
        add(["H_g_T: slip H_t", ""], &|_, _| slip * t.second);
        add(["H_g_T: t H_xi", ""], &|_, _| t.value * xi.second);
        add(["H_g_T: grad t g'", "H_g_T: g grad t'"], &|one, two| one.length[own] * two.xi[own]);
    }
}
