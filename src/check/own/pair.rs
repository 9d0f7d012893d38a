//! A beam on the user's curve, with a partner that crosses it as the regime requires.

use super::placed::Placed;
use crate::check::candidate::{contact_in_words, list};
use crate::check::draw::orthonormal;
use crate::check::regime::{Draw, Regime};
use crate::closest_point::ClosestPoint;
use crate::curve::{Curve, Hermite};
use crate::number::RunningError;
use crate::pair::Contact;
use crate::test_beam::{AnyBeam, Drawn, Family, Target};
use crate::variant::{Returned, of_curves};
use nalgebra::{Matrix3, SVector, Vector3};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use std::fmt::Debug;
use std::sync::Arc;

/// The relative variation of the dofs of a beam, over the largest of them.
const SPREAD: f64 = 0.02;

/// Two beams.
pub(super) struct Pair {
    pub(super) beams: [Box<dyn AnyBeam>; 2],
    /// Their families; none for the user's curve.
    families: [Option<Family>; 2],
    pub(super) contact: Contact,
    /// The library's functions for these two curves, if the user's curve is not moved and its partner is a Hermite curve:
    /// with the curve's own number of dofs, they are compiled for few pairs only.
    functions: Option<Functions>,
}

type Functions = Arc<dyn Fn([&dyn AnyBeam; 2], &ClosestPoint, Contact) -> Vec<Returned> + Send + Sync>;

/// A point of a beam, its tangent, and the beam's length.
struct Spot {
    x: Vector3<f64>,
    t: Vector3<f64>,
    length: f64,
}

impl Spot {
    /// The spot at a parameter; beyond an end of the beam, on the tangent there.
    fn on(beam: &dyn AnyBeam, xi: f64) -> Self {
        let within = xi.clamp(-1.0, 1.0);
        let geometry = beam.geometry_at(RunningError::from(within));
        let [x, t] = [geometry.x, geometry.t].map(|v| v.map(|c| c.value));
        Self { x: x + t * (xi - within), t, length: 2.0 * t.norm() }
    }
}

impl Pair {
    /// Draws the `place`-th case of a regime. All families and the curve itself alternate, on either side.
    pub(super) fn draw<C, const N: usize>(
        curve: &C,
        beams: &[[f64; N]],
        (regime, place): (Regime, u64),
        rng: &mut ChaCha8Rng,
    ) -> Self
    where
        C: Curve<N> + Clone + Debug + Send + Sync + 'static,
    {
        let place = usize::try_from(place).unwrap_or(0);
        let draw = regime.draw(rng);
        let unit = match regime {
            Regime::Metres => Some(1e-6),
            Regime::Millimetres => Some(1e3),
            _ => None,
        };
        let own = varied(curve, &beams[place % beams.len()], rng);
        // The mirror image of a curve is as good a curve.
        let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, draw.hand[0]));
        let is_placed = unit.is_some() || draw.hand[0] < 0.0;
        let own: Box<dyn AnyBeam> =
            if is_placed { placed(own, mirror * unit.unwrap_or(1.0)) } else { Box::new(own) };
        let partner = Family::ALL.get(place % (Family::ALL.len() + 1)).copied();
        let spot = Spot::on(&*own, draw.at[0]);
        let frame = crossing_frame(&spot.t, &draw, rng);
        let other: Box<dyn AnyBeam> = if let Some(family) = partner {
            let length = spot.length * rng.random_range(0.8..1.25);
            let (bend, hand, xi) = (draw.bend[1], draw.hand[1], draw.at[1]);
            let target = Target { point: spot.x, frame, length, bend, hand, xi };
            let mut test_beam = family.draw(&target, rng);
            test_beam.translate(&shift(&spot, &Spot::beyond(&*test_beam.drawn(), draw.at[1]), &draw));
            test_beam.drawn()
        } else {
            let second = varied(curve, &beams[(place + 1) % beams.len()], rng);
            let there = Spot::on(&second, draw.at[1]);
            // Its tangent, and any two vectors normal to it, are turned onto those of the frame.
            let tangent = there.t.normalize();
            let own_frame = with_tangent(&tangent, rng);
            let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, draw.hand[1]));
            let turn = frame * mirror * own_frame.transpose() * unit.unwrap_or(1.0);
            let mut second = Drawn {
                curve: Placed { curve: second.curve, turn, shift: Vector3::zeros() },
                q: second.q,
                dq: second.dq,
                linear_dq: second.linear_dq,
                points: Vec::new(),
            };
            second.curve.shift = shift(&spot, &Spot::on(&second, draw.at[1]), &draw);
            Box::new(second)
        };
        let contact = draw.contact(spot.length, draw.gap * spot.length, rng);
        let (mut beams, mut families) = ([own, other], [None, partner]);
        let is_bar = !rng.random::<bool>();
        if is_bar {
            beams.reverse();
            families.reverse();
        }
        let with_functions = !is_placed && partner == Some(Family::Hermite);
        Self { beams, families, contact, functions: with_functions.then(|| functions(curve.clone(), is_bar)) }
    }

    pub(super) fn beams(&self) -> [&dyn AnyBeam; 2] {
        self.beams.each_ref().map(|beam| &**beam)
    }

    /// What the library's functions return for the two curves.
    pub(super) fn functions(&self, point: &ClosestPoint) -> Vec<Returned> {
        let of = |functions: &Functions| functions(self.beams(), point, self.contact);
        self.functions.as_ref().map(of).unwrap_or_default()
    }

    /// The same pair with other numbers of the beams, and other radii and reference parameters.
    pub(super) fn with(&self, numbers: &[[Vec<f64>; 3]; 2], contact: Contact) -> Self {
        let beams = [0, 1].map(|i| self.beams[i].with_numbers(&numbers[i]));
        Self { beams, contact, families: self.families, functions: self.functions.clone() }
    }

    /// The families of the pair with all its numbers, 80 columns wide.
    pub(super) fn words(&self, regime: Regime) -> String {
        let [family, family_bar] = self.families.map(|family| family.map_or("your curve", Family::name));
        let [[q, dq, linear_dq], [q_bar, dq_bar, linear_dq_bar]] =
            self.beams.each_ref().map(|beam| beam.numbers());
        format!("{}: {family} and {family_bar}", regime.name())
            + &contact_in_words(&self.contact)
            + &[
                ("q", q),
                ("q_bar", q_bar),
                ("dq", dq),
                ("dq_bar", dq_bar),
                ("Dq", linear_dq),
                ("Dq_bar", linear_dq_bar),
            ]
            .map(|(name, numbers)| list(name, numbers))
            .concat()
    }
}

/// The library's functions for the user's curve and a Hermite curve.
fn functions<C, const N: usize>(curve: C, is_bar: bool) -> Functions
where
    C: Curve<N> + Clone + Send + Sync + 'static,
{
    Arc::new(move |beams, point, contact| {
        let (curve, hermite) = (curve.clone(), Hermite::new());
        if is_bar {
            of_curves(&crate::pair::Pair { curve: hermite, curve_bar: curve, contact }, beams, point)
        } else {
            of_curves(&crate::pair::Pair { curve, curve_bar: hermite, contact }, beams, point)
        }
    })
}

impl Spot {
    /// The spot at any parameter, for a curve that is defined beyond its ends.
    fn beyond(beam: &dyn AnyBeam, xi: f64) -> Self {
        let geometry = beam.geometry_at(RunningError::from(xi));
        let [x, t] = [geometry.x, geometry.t].map(|v| v.map(|c| c.value));
        Self { x, t, length: 2.0 * t.norm() }
    }
}

/// The shift that moves the other beam so that the gap is the drawn one, normal to both tangents.
fn shift(own: &Spot, other: &Spot, draw: &Draw) -> Vector3<f64> {
    let across = own.t.cross(&other.t).normalize();
    own.x - other.x - across * (draw.side * draw.gap * own.length)
}

/// The other beam's frame where the two cross: its tangent, and any normal.
fn crossing_frame(t: &Vector3<f64>, draw: &Draw, rng: &mut ChaCha8Rng) -> Matrix3<f64> {
    let t = t.normalize();
    let frame = with_tangent(&t, rng);
    let normal: Vector3<f64> = frame.column(1).into();
    let (sin, cos) = draw.angle.sin_cos();
    with_tangent(&(t * cos + normal.cross(&t) * sin), rng)
}

/// A right-handed frame with this tangent.
fn with_tangent(t: &Vector3<f64>, rng: &mut ChaCha8Rng) -> Matrix3<f64> {
    loop {
        let random: Vector3<f64> = orthonormal(rng).column(0).into();
        let normal = random - t * t.dot(&random);
        if normal.norm() > 0.1 {
            let normal = normal.normalize();
            return Matrix3::from_columns(&[*t, normal, t.cross(&normal)]);
        }
    }
}

fn placed<C, const N: usize>(beam: Drawn<C, N>, turn: Matrix3<f64>) -> Box<dyn AnyBeam>
where
    C: Curve<N> + Clone + Debug + Send + Sync + 'static,
{
    let Drawn { curve, q, dq, linear_dq, points } = beam;
    Box::new(Drawn { curve: Placed { curve, turn, shift: Vector3::zeros() }, q, dq, linear_dq, points })
}

/// A beam with its dofs varied a little, and two directions.
pub(super) fn varied<C: Clone, const N: usize>(
    curve: &C,
    beam: &[f64; N],
    rng: &mut ChaCha8Rng,
) -> Drawn<C, N> {
    let largest = beam.iter().fold(0.0_f64, |largest, q| largest.max(q.abs()));
    let mut random = |size: f64| SVector::<f64, N>::from_fn(|_, _| size * rng.random_range(-1.0..1.0));
    let q = SVector::from(*beam) + random(SPREAD * largest);
    Drawn { curve: curve.clone(), q, dq: random(largest), linear_dq: random(largest), points: Vec::new() }
}
