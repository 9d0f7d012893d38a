//! Pairs of beams at a closest point that is constructed, over any scalar.

use crate::closest_point::Held;
use crate::contact::{
    BlockMatrix, Contribution, Decision, History, Law, Parameters, Slips, State, Values, ad, closed_form,
};
use crate::curve::{Arc, Bezier, Curve, Helix, Hermite, NurbsWeighted, Segment};
use crate::linearization::closed_form::{Points, jets};
use crate::number::{Differentiable, Extends, Real};
use crate::pair::{Contact, DofVector, Pair};
use nalgebra::{SVector, Vector3};

/// A curve whose dofs can be translated.
pub(super) trait Movable<const N: usize>: Curve<N> + Copy {
    /// Dofs of a curve of about length 2 along x.
    fn dofs() -> SVector<f64, N>;

    /// The same curve along y: the starts of the vectors among the dofs, and that of a quaternion.
    const VECTORS: &'static [usize];
    const QUATERNION: Option<usize> = None;

    /// Adds a vector to all points.
    fn translate<T: Real>(q: &mut SVector<T, N>, v: &Vector3<T>);
}

/// The dofs of a curve along y.
fn across<C: Movable<N>, const N: usize>() -> SVector<f64, N> {
    let mut q = C::dofs();
    for &i in C::VECTORS {
        (q[i], q[i + 1]) = (-q[i + 1], q[i]);
    }
    if let Some(i) = C::QUATERNION {
        // The product with the quaternion (1, 0, 0, 1).
        let [w, x, y, z] = [q[i], q[i + 1], q[i + 2], q[i + 3]];
        for (k, value) in [w - z, x - y, y + x, z + w].into_iter().enumerate() {
            q[i + k] = value;
        }
    }
    q
}

/// Adds a vector to the dofs that begin at `starts`.
fn add<T: Real, const N: usize>(q: &mut SVector<T, N>, v: &Vector3<T>, starts: &[usize]) {
    for start in starts {
        for c in 0..3 {
            q[start + c] += v[c];
        }
    }
}

impl Movable<12> for Hermite {
    const VECTORS: &'static [usize] = &[0, 3, 6, 9];

    fn dofs() -> SVector<f64, 12> {
        SVector::from([-1.0, 0.1, 0.0, 1.1, 0.4, 0.2, 1.0, -0.1, 0.1, 0.9, -0.5, 0.3])
    }

    fn translate<T: Real>(q: &mut SVector<T, 12>, v: &Vector3<T>) {
        add(q, v, &[0, 6]);
    }
}

impl Movable<6> for Segment {
    const VECTORS: &'static [usize] = &[0, 3];

    fn dofs() -> SVector<f64, 6> {
        SVector::from([-1.0, 0.2, -0.1, 1.1, 0.0, 0.3])
    }

    fn translate<T: Real>(q: &mut SVector<T, 6>, v: &Vector3<T>) {
        add(q, v, &[0, 3]);
    }
}

impl Movable<12> for Bezier<4> {
    const VECTORS: &'static [usize] = &[0, 3, 6, 9];

    fn dofs() -> SVector<f64, 12> {
        SVector::from([-1.0, 0.0, 0.1, -0.4, 0.3, 0.0, 0.3, 0.2, -0.2, 1.1, -0.3, 0.1])
    }

    fn translate<T: Real>(q: &mut SVector<T, 12>, v: &Vector3<T>) {
        add(q, v, &[0, 3, 6, 9]);
    }
}

impl Movable<9> for Arc {
    const VECTORS: &'static [usize] = &[0];
    const QUATERNION: Option<usize> = Some(4);

    fn dofs() -> SVector<f64, 9> {
        SVector::from([0.0, -1.4, 0.1, 1.5, 0.9, 0.1, -0.2, 0.1, 1.6])
    }

    fn translate<T: Real>(q: &mut SVector<T, 9>, v: &Vector3<T>) {
        add(q, v, &[0]);
    }
}

impl Movable<10> for Helix {
    const VECTORS: &'static [usize] = &[0];
    const QUATERNION: Option<usize> = Some(3);

    fn dofs() -> SVector<f64, 10> {
        SVector::from([0.0, -1.2, 0.0, 0.8, 0.2, -0.1, 0.1, 1.4, 0.9, 1.5])
    }

    fn translate<T: Real>(q: &mut SVector<T, 10>, v: &Vector3<T>) {
        add(q, v, &[0]);
    }
}

impl Movable<16> for NurbsWeighted<4> {
    const VECTORS: &'static [usize] = &[0, 4, 8, 12];

    fn dofs() -> SVector<f64, 16> {
        let points = [-1.0, 0.0, 0.1, 1.0, -0.4, 0.3, 0.0, 1.3, 0.3, 0.2, -0.2, 0.8, 1.1, -0.3, 0.1, 1.1];
        SVector::from(points)
    }

    fn translate<T: Real>(q: &mut SVector<T, 16>, v: &Vector3<T>) {
        add(q, v, &[0, 4, 8, 12]);
    }
}

/// What is asked of a contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wish {
    pub(super) held: Held,
    pub(super) state: State,
    pub(super) parameters: Parameters,
    /// d, negative if crossed.
    pub(super) distance: f64,
    /// The size of the slips.
    pub(super) slip: f64,
}

/// The radius of both beams.
pub(super) const RADIUS: f64 = 0.125;
const EPS: f64 = 100.0;

impl Wish {
    /// The wish for a state: mu and eps_T are chosen so that it occurs.
    pub(super) fn new(held: Held, state: State, law: Law) -> Self {
        let mut parameters = Parameters::with_friction(law, EPS, 0.0);
        let (eps_t, mu) = match state {
            State::Open | State::Frictionless => (EPS, 0.0),
            State::Stick => (EPS / 16.0, 8.0),
            State::Slip => (4.0 * EPS, 0.25),
        };
        (parameters.eps_t, parameters.mu) = (eps_t, mu);
        let distance = if state == State::Open { 0.75 } else { 0.1875 };
        Self { held, state, parameters, distance, slip: 0.03125 }
    }
}

pub(super) const LAWS: [Law; 3] =
    [Law::Linear { eps: EPS }, Law::Lpqp { eps: EPS, g_0: 0.0625 }, Law::Augmented { eps: EPS, lambda: 2.0 }];

pub(super) const HELD: [Held; 4] = [
    Held { xi: false, xi_bar: false },
    Held { xi: true, xi_bar: false },
    Held { xi: false, xi_bar: true },
    Held { xi: true, xi_bar: true },
];

pub(super) const STATES: [State; 4] = [State::Open, State::Frictionless, State::Stick, State::Slip];

/// A pair of beams at a closest point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Case<A, B, T, const N: usize, const M: usize> {
    pub(super) pair: Pair<A, B, N, M>,
    pub(super) q: DofVector<T, N, M>,
    pub(super) at: (T, T),
    pub(super) history: History,
    pub(super) wish: Wish,
}

/// A scalar that has its own value in `f64`.
pub(super) trait Valued: Real {
    fn value_of(self) -> f64;
}

impl Valued for f64 {
    fn value_of(self) -> f64 {
        self
    }
}

impl Valued for crate::number::DoubleDouble {
    fn value_of(self) -> f64 {
        self.value()
    }
}

impl<A: Movable<N>, B: Movable<M>, T: Valued, const N: usize, const M: usize> Case<A, B, T, N, M> {
    /// Two curves that cross at about a right angle, with the distance of the wish. `change` moves the dofs by up to about 1.
    pub(super) fn new(curve: A, curve_bar: B, wish: Wish, mut change: impl FnMut() -> f64) -> Self {
        let contact = Contact { radius: RADIUS, radius_bar: RADIUS, ..Contact::default() };
        let pair = Pair::new(curve, curve_bar).with_contact(contact);
        let mut number = |value: f64| T::from(value + 0.125 * change());
        let mut q = DofVector { beam: A::dofs().map(&mut number), bar: across::<B, M>().map(&mut number) };
        let at = |held: bool, end: f64, inside: f64| T::from(if held { end } else { inside });
        let at = (at(wish.held.xi, -1.0, 0.1875), at(wish.held.xi_bar, 1.0, -0.3125));
        let (jet, jet_bar) = jets(&pair, &q, at);
        let points = Points::new(&jet.geometry, &jet_bar.geometry);
        let unit = |v: Vector3<T>| v / v.dot(&v).sqrt();
        let (tau, tau_bar) = (unit(points.beam.t), unit(points.bar.t));
        let some = Vector3::new(T::from(0.1), T::from(0.3), T::from(1.0));
        let n = unit(match (wish.held.xi, wish.held.xi_bar) {
            (false, false) => tau.cross(&tau_bar),
            (true, false) => some - tau_bar * some.dot(&tau_bar),
            (false, true) => some - tau * some.dot(&tau),
            (true, true) => some,
        });
        B::translate(&mut q.bar, &(points.d - n * T::from(wish.distance)));
        let held = |held: bool, value: f64| if held { 0.0 } else { value };
        let slips = Slips {
            xi: at.0.value_of() - wish.slip,
            xi_bar: at.1.value_of() + 1.5 * wish.slip,
            e: held(wish.held.xi, 0.25 * wish.slip),
            e_bar: held(wish.held.xi_bar, -0.75 * wish.slip),
            held: wish.held,
            ..Slips::default()
        };
        let normal = n.map(T::value_of);
        let history = History { normal: Some(normal / normal.norm()), slips: Some(slips) };
        Self { pair, q, at, history, wish }
    }

    /// The decision in `f64`. It has the wished state.
    pub(super) fn decision(&self) -> Decision<'_, Law> {
        let (jet, jet_bar) = jets(&self.pair, &self.q, self.at);
        let points = Points::new(&jet.geometry, &jet_bar.geometry).map(T::value_of);
        let at = (self.at.0.value_of(), self.at.1.value_of());
        let Self { pair, wish, history, .. } = self;
        Decision::new(&wish.parameters, pair.contact, &points, at, wish.held, history).unwrap()
    }

    /// R and K in closed form.
    pub(super) fn closed(&self, decision: &Decision<'_, Law>) -> (Box<Contribution<T, N, M>>, Values<T>) {
        let (jet, jet_bar) = jets(&self.pair, &self.q, self.at);
        let mut to = Box::new(Contribution::zeros());
        let values = closed_form::write(decision, (&jet, &jet_bar), self.at, &mut to);
        (to, values)
    }

    /// R and K by automatic differentiation.
    pub(super) fn by_ad(&self, decision: &Decision<'_, Law>) -> (DofVector<T, N, M>, BlockMatrix<T, N, M>)
    where
        T: Differentiable,
        T::Dual: Differentiable,
        <T::Dual as Differentiable>::Dual: Extends<T>,
    {
        ad::residual_and_tangent(decision, &self.pair, &self.q, self.at)
    }
}

/// Numbers in [-1, 1] from a seed.
pub(super) fn numbers(seed: u32) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(2_654_435_761).wrapping_add(12345);
    move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 23) - 1.0
    }
}

/// The largest difference of R and of K, relative to their largest entries.
pub(super) fn differences<T: Valued, const N: usize, const M: usize>(
    of: &Contribution<T, N, M>,
    (residual, tangent): &(DofVector<T, N, M>, BlockMatrix<T, N, M>),
) -> [f64; 2] {
    let (mut r, mut k, mut r_size, mut k_size) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    // A number that is not one counts as infinite.
    let size = |x: T| if x.value_of().is_nan() { f64::INFINITY } else { x.value_of().abs() };
    for i in 0..N + M {
        r = r.max(size(of.residual.entry(i) - residual.entry(i)));
        r_size = r_size.max(size(residual.entry(i)));
        for j in 0..N + M {
            k = k.max(size(of.tangent.entry(i, j) - tangent.entry(i, j)));
            k_size = k_size.max(size(tangent.entry(i, j)));
        }
    }
    [if r == 0.0 { 0.0 } else { r / r_size }, if k == 0.0 { 0.0 } else { k / k_size }]
}
