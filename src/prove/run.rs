//! All draws of all pairs of families, and their result.

use super::element::Situation;
use super::entry::{Entry, Layer, entries};
use super::{Draw, Sides, differentiated};
use crate::closest_point::Held;
use crate::linearization::closed_form::formulation::{Distance, System};
use crate::linearization::closed_form::{Formulation, variations_in};
use crate::linearization::{COMPONENTS, Quantity};
use crate::number::PrimeField;
use crate::parallel;
use crate::test_beam::Family;
use crate::variant::{CONTACT, Variant, contracted, every_layout};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

/// One quantity of one layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The quantity.
    pub quantity: Quantity,
    /// The layer.
    pub layer: Layer,
    /// Draws in which the two sides were equal.
    pub equal: u64,
    /// Draws in which the two sides were not equal.
    pub refuted: u64,
    /// The largest bound on the degree of the difference over all pairs of families.
    pub degree: f64,
}

impl Row {
    /// The decimal logarithm of the bound on the probability that a wrong formula passes one draw: 64 n / p with three square
    /// roots, 256 n / p with the fourth of a contact element.
    pub fn log_probability(&self) -> f64 {
        let roots = if matches!(self.layer, Layer::Residual | Layer::Tangent) { 4 } else { 3 };
        (4.0_f64.powi(roots) * self.degree.max(1.0)).log10() - 61.0 * 2.0_f64.log10()
    }
}

/// Numbers have two digits, because the others depend on the machine.
impl Serialize for Row {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut row = serializer.serialize_struct("Row", 6)?;
        row.serialize_field("quantity", &self.quantity)?;
        row.serialize_field("layer", &self.layer)?;
        row.serialize_field("equal", &self.equal)?;
        row.serialize_field("unequal", &self.refuted)?;
        row.serialize_field("degree", &rounded(self.degree))?;
        row.serialize_field("log10_probability", &rounded(self.log_probability()))?;
        row.end()
    }
}

fn rounded(number: f64) -> f64 {
    format!("{number:.1e}").parse().unwrap_or(number)
}

/// The result of a proof.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Proof {
    /// Quantity by quantity and layer by layer.
    pub rows: Vec<Row>,
    /// Pairs of families.
    pub pairs: usize,
    /// The first draw of each pair of families in which something is not equal.
    pub refutations: Vec<Draw>,
}

impl Proof {
    /// Whether something was compared, and everything was equal.
    pub fn holds(&self) -> bool {
        let equal = self.rows.iter().all(|row| row.refuted == 0 && row.equal > 0);
        equal && self.refutations.is_empty() && !self.rows.is_empty()
    }
}

/// A table over the components (the scalars again for the matrices) and layers.
type Counts = [[u64; Layer::ALL.len()]; COMPONENTS];

/// Proves the closed form for every pair of the families, with this number of draws each. `step` is called after each
/// pair.
pub fn prove(variant: &Variant, seed: u64, families: &[Family], draws: u64, step: impl Fn() + Sync) -> Proof {
    let pairs: Vec<[Family; 2]> =
        families.iter().flat_map(|&one| families.iter().map(move |&other| [one, other])).collect();
    let of_pair = |&pair: &[Family; 2]| {
        let result = prove_pair(variant, seed, pair, draws);
        step();
        result
    };
    let results = parallel::map(&pairs, of_pair);
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

type Degrees = [[f64; Layer::ALL.len()]; COMPONENTS];

type PairResult = (Counts, Counts, Degrees, Option<Draw>);

fn prove_pair(variant: &Variant, seed: u64, families: [Family; 2], draws: u64) -> PairResult {
    let (mut equal, mut refuted): (Counts, Counts) = Default::default();
    let mut first = None;
    for number in 0..draws {
        let draw = Draw::new(variant, seed, families, number);
        for entry in &draw.entries {
            let counts = if entry.is_equal() { &mut equal } else { &mut refuted };
            counts[entry.component][entry.layer as usize] += 1;
        }
        if first.is_none() && draw.unequal().next().is_some() {
            first = Some(draw);
        }
    }
    (equal, refuted, degrees(families), first)
}

/// Bounds on the degrees of the differences, with all drawn numbers as variables.
fn degrees(families: [Family; 2]) -> Degrees {
    let mut rng = ChaCha8Rng::seed_from_u64(0);
    let models = families.map(|family| family.model(&mut rng));
    let mut variable = || PrimeField::new(rng.random()).variable();
    let beams = models.map(|model| model.residues(&mut variable));
    let at = (variable(), variable());
    let mut degrees = Degrees::default();
    let held = Held::default();
    let forms = [Distance::Length, Distance::Normal { reversed: false }].into_iter().flat_map(|distance| {
        [System::Determinants, System::CrossProducts].map(|system| Formulation { held, distance, system })
    });
    for form in forms {
        let [beam, bar] = [&*beams[0], &*beams[1]];
        let (partial, partial_bar) = (beam.partial_variations(at.0), bar.partial_variations(at.1));
        let padded = [beam.padded(at.0), bar.padded(at.1)];
        let ad = differentiated([beam, bar], at, held, &CONTACT);
        let sides = Sides {
            closed: variations_in(form, &partial, &partial_bar, at, &CONTACT).components(),
            matrices: Some(contracted(&padded, at, form, &CONTACT)),
            kernel: every_layout(&padded, [beam.dofs(), bar.dofs()], at, form, &CONTACT),
            element: Some(Situation::of_highest_degree(held).sides(&padded, at, form, &ad)),
            ad,
        };
        for Entry { component, layer, closed, ad, .. } in entries(&sides) {
            let degree = &mut degrees[component][layer as usize];
            *degree = degree.max(closed.degree().of_difference(ad.degree()));
        }
    }
    degrees
}
