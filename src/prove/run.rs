//! Draws, comparisons and what they amount to.

use super::{SCALAR_COMPONENTS, Sides, sides};
use crate::closest_point::Active;
use crate::linearization::{COMPONENTS, Quantity};
use crate::number::{Degree, Residue};
use crate::pair::Contact;
use crate::specimen::{AnyBeam, ExactBeam, Family};
use nalgebra::Vector3;
use num_traits::{One, Zero};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// What is compared of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Layer {
    /// The value.
    Value,
    /// delta and Delta.
    First,
    /// Delta-delta.
    Second,
    /// Gradient and Hessian, contracted with the directions.
    Matrix,
}

impl Layer {
    /// All layers.
    pub const ALL: [Self; 4] = [Self::Value, Self::First, Self::Second, Self::Matrix];

    /// The name, as tables have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Value => "value",
            Self::First => "first",
            Self::Second => "second",
            Self::Matrix => "matrix",
        }
    }
}

/// One quantity of one layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The quantity.
    pub quantity: Quantity,
    /// The layer.
    pub layer: Layer,
    /// Draws in which the two sides were equal.
    pub equal: u64,
    /// Draws in which they were not.
    pub refuted: u64,
    /// The largest bound on the degree of the difference over all pairs of families.
    pub degree: f64,
}

impl Row {
    /// The decimal logarithm of the bound on the probability that a wrong formula passes one draw: 64 n / p.
    pub fn log_probability(&self) -> f64 {
        (64.0 * self.degree.max(1.0)).log10() - 61.0 * 2.0_f64.log10()
    }
}

/// One draw in which closed form and AD are not equal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refutation {
    /// The families of beam and bar beam.
    pub families: [Family; 2],
    /// The number of the draw.
    pub draw: u64,
    /// Which parameters were held at an end.
    pub active: Active,
    /// The quantity, the index among all components, and the layer.
    pub quantity: (Quantity, usize, Layer),
    /// The residues of closed form and AD.
    pub residues: [u64; 2],
}

/// The result of a proof.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Proof {
    /// Quantity by quantity and layer by layer.
    pub rows: Vec<Row>,
    /// Pairs of families.
    pub pairs: usize,
    /// The first inequality of each pair of families.
    pub refutations: Vec<Refutation>,
}

impl Proof {
    /// Whether everything was equal, and there was something.
    pub fn holds(&self) -> bool {
        self.refutations.is_empty() && self.rows.iter().all(|row| row.refuted == 0 && row.equal > 0)
    }
}

/// Matrices cost ten times what the variations cost: they are compared in every so manieth eight draws.
const MATRICES_EVERY: u64 = 8;

/// A table over the components (the scalars once more for the matrices) and layers.
type Counts = [[u64; 4]; COMPONENTS];

/// Proves the closed form for every pair of the families, with so many draws each.
pub fn prove(seed: u64, families: &[Family], draws: u64) -> Proof {
    let pairs: Vec<[Family; 2]> =
        families.iter().flat_map(|&one| families.iter().map(move |&other| [one, other])).collect();
    let results: Vec<_> = pairs.par_iter().map(|&pair| prove_pair(seed, pair, draws)).collect();
    let mut proof = Proof { pairs: pairs.len(), ..Proof::default() };
    for quantity in Quantity::ALL {
        for (k, layer) in Layer::ALL.into_iter().enumerate() {
            let mut row = Row { quantity, layer, equal: 0, refuted: 0, degree: 0.0 };
            for (equal, refuted, degrees, _) in &results {
                for i in (0..COMPONENTS).filter(|&i| Quantity::of_component(i) == quantity) {
                    row.equal += equal[i][k];
                    row.refuted += refuted[i][k];
                    row.degree = row.degree.max(degrees[i][k]);
                }
            }
            if row.equal + row.refuted > 0 {
                proof.rows.push(row);
            }
        }
    }
    proof.refutations = results.into_iter().filter_map(|(_, _, _, refutation)| refutation).collect();
    proof
}

type PairResult = (Counts, Counts, [[f64; 4]; COMPONENTS], Option<Refutation>);

fn prove_pair(seed: u64, families: [Family; 2], draws: u64) -> PairResult {
    let (mut equal, mut refuted) = ([[0; 4]; COMPONENTS], [[0; 4]; COMPONENTS]);
    let mut first = None;
    let contact = Contact { radius: 0.125, radius_bar: 0.25, xi_0: 0.5, xi_bar_0: -0.75 };
    for draw in 0..draws {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream((draw * 256 + families[0] as u64) * 256 + families[1] as u64);
        let active = Active { xi: draw % 8 == 5 || draw % 8 == 7, xi_bar: draw % 8 >= 6 };
        let models = families.map(|family| family.model(&mut rng));
        let (beams, at) = stationary(&models, active, &mut rng);
        // Eight draws go through all combinations of active ends.
        let with_matrices = draw / 8 % MATRICES_EVERY == 0;
        let results = sides([&*beams[0], &*beams[1]], at, active, &contact, with_matrices);
        for (i, k, closed, ad) in entries(&results) {
            if closed == ad {
                equal[i][k] += 1;
            } else {
                refuted[i][k] += 1;
                first.get_or_insert_with(|| Refutation {
                    families,
                    draw,
                    active,
                    quantity: (Quantity::of_component(i), i, Layer::ALL[k]),
                    residues: [closed.value(), ad.value()],
                });
            }
        }
    }
    (equal, refuted, degrees(families, &contact), first)
}

/// The entries that are compared: component, layer, and both sides.
fn entries<T: Copy>(sides: &Sides<T>) -> Vec<(usize, usize, T, T)> {
    let mut entries = Vec::with_capacity(4 * COMPONENTS + 3 * SCALAR_COMPONENTS.len());
    for i in 0..COMPONENTS {
        let (closed, ad) = (&sides.closed[i], &sides.ad[i]);
        entries.push((i, 0, closed.value, ad.value));
        entries.push((i, 1, closed.delta, ad.delta));
        entries.push((i, 1, closed.linear, ad.linear));
        entries.push((i, 2, closed.second, ad.second));
    }
    for (&i, [delta, linear, second]) in SCALAR_COMPONENTS.iter().zip(sides.matrices.into_iter().flatten()) {
        let ad = &sides.ad[i];
        entries.extend([(i, 3, delta, ad.delta), (i, 3, linear, ad.linear), (i, 3, second, ad.second)]);
    }
    entries
}

/// Bounds on the degrees of the differences, with all drawn numbers as variables.
fn degrees(families: [Family; 2], contact: &Contact) -> [[f64; 4]; COMPONENTS] {
    let mut rng = ChaCha8Rng::seed_from_u64(0);
    let beams = families.map(|family| family.model(&mut rng).degrees());
    let at = (Degree::VARIABLE, Degree::VARIABLE);
    let mut degrees = [[0.0_f64; 4]; COMPONENTS];
    let results = sides([&*beams[0], &*beams[1]], at, Active::default(), contact, true);
    for (i, k, closed, ad) in entries(&results) {
        degrees[i][k] = degrees[i][k].max(closed.of_difference(ad));
    }
    degrees
}

/// Two beams at a stationary point.
pub(crate) type Stationary = ([Box<dyn ExactBeam<Residue>>; 2], (Residue, Residue));

/// Draws dofs until d, t and t_bar have square roots, and moves the first beam to where the point is stationary.
pub(crate) fn stationary(models: &[Box<dyn AnyBeam>; 2], active: Active, rng: &mut ChaCha8Rng) -> Stationary {
    let random = |rng: &mut ChaCha8Rng| Residue::new(rng.random());
    loop {
        let mut beams = models.each_ref().map(|model| model.residues(&mut || random(rng)));
        let end = |held: bool, rng: &mut ChaCha8Rng| match (held, rng.random()) {
            (false, _) => random(rng),
            (true, false) => Residue::one(),
            (true, true) => -Residue::one(),
        };
        let at = (end(active.xi, rng), end(active.xi_bar, rng));
        let (x, x_bar) = (beams[0].geometry(at.0), beams[1].geometry(at.1));
        let (t, t_bar): (Vector3<Residue>, Vector3<Residue>) = (x.t, x_bar.t);
        let w = Vector3::from_fn(|_, _| random(rng));
        let normal_to = |t: &Vector3<Residue>| w - t * (w.dot(t) / t.dot(t));
        let d = match (active.xi, active.xi_bar) {
            (false, false) => t.cross(&t_bar) * w.x,
            (true, false) => normal_to(&t_bar),
            (false, true) => normal_to(&t),
            (true, true) => w,
        };
        let squares = [&d, &t, &t_bar].map(|v| v.dot(v));
        if squares.iter().all(|v| v.is_square() && !v.is_zero()) {
            beams[0].translate(&(d - (x.x - x_bar.x)));
            return (beams, at);
        }
    }
}
