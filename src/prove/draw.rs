//! One draw: two beams at a stationary point, both sides run, and all entries side by side.

use super::entry::{Entry, entries};
use super::{CONTACT, sides};
use crate::closest_point::Active;
use crate::number::Residue;
use crate::specimen::{AnyBeam, ExactBeam, Family};
use nalgebra::Vector3;
use num_traits::{One, Zero};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Matrices cost ten times what the variations cost: they are compared in every so manieth eight draws.
const MATRICES_EVERY: u64 = 8;

/// One draw with all that was compared in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Draw {
    /// The families of beam and bar beam.
    pub families: [Family; 2],
    /// Its number; with the seed and the families it decides all the rest.
    pub number: u64,
    /// Which parameters were held at an end.
    pub active: Active,
    /// What was compared.
    pub entries: Vec<Entry<Residue>>,
}

impl Draw {
    /// Draws, runs both sides, and lays them side by side.
    pub fn new(seed: u64, families: [Family; 2], number: u64) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream((number * 256 + families[0] as u64) * 256 + families[1] as u64);
        // Eight draws go through all combinations of active ends.
        let active = Active { xi: number % 8 == 5 || number % 8 == 7, xi_bar: number % 8 >= 6 };
        let models = families.map(|family| family.model(&mut rng));
        let (beams, at) = stationary(&models, active, &mut rng);
        let with_matrices = (number / 8).is_multiple_of(MATRICES_EVERY);
        let results = sides([&*beams[0], &*beams[1]], at, active, &CONTACT, with_matrices);
        Self { families, number, active, entries: entries(&results) }
    }

    /// The entries in which the two sides are not equal.
    pub fn unequal(&self) -> impl Iterator<Item = &Entry<Residue>> {
        self.entries.iter().filter(|entry| !entry.is_equal())
    }
}

/// Two beams at a stationary point.
type Stationary = ([Box<dyn ExactBeam<Residue>>; 2], (Residue, Residue));

/// Draws dofs until d, t and t_bar have square roots, and moves the first beam to where the point is stationary.
fn stationary(models: &[Box<dyn AnyBeam>; 2], active: Active, rng: &mut ChaCha8Rng) -> Stationary {
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
