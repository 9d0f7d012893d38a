//! A case along a pair of directions: the vectors of both beams, the numbers of the program and the exact ones.

mod cubic;
mod numbers;
mod shapes;

use crate::check::candidate::CAREFUL;
use crate::check::element::ElementAt;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::external::answers::Answers;
use crate::check::external::compare::{Demands, half_unit};
use crate::check::external::conventions::Range;
use crate::check::external::stages::formulas::Inputs;
use crate::check::external::vectors::Vector;
use crate::linearization::closed_form::{Formulation, PartialVariations, variations_in};
use crate::linearization::{COMPONENTS, Quantity};
use crate::number::RunningError;
use crate::pair::Contact;
use crate::test_beam::{AnyBeam, RunningError2};
use nalgebra::Vector3;
pub(super) use numbers::Element;
use numbers::{element, own_numbers};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
pub(super) use shapes::Node;
use shapes::{nodes, widen};

/// The number of pairs of directions of each case.
const DIRECTIONS: u64 = 8;
/// The same of each block.
const OF_BLOCK: u64 = 2;
/// The number of directions of rows, and of columns, of a grid.
pub(super) const SIDE: usize = 6;

/// The directions of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Along {
    /// Those of the case, with the variations alone.
    Stated,
    /// Those of the case, and random ones, with the gradients and Hessians alone.
    Random,
    /// Single dofs: entries below the diagonal of Hessians.
    Lower,
    /// Entries above the diagonal.
    Upper,
    /// Random ones of the dofs of one beam each: a block of Hessians.
    Block([usize; 2]),
    /// [`SIDE`] random ones of rows with each of so many of columns.
    Grid,
}

/// A case along a pair of directions.
#[derive(Clone, Debug)]
pub(super) struct Sample {
    /// The index of the case.
    pub(super) case: usize,
    /// The parameters of the closest point.
    pub(super) xi: [RunningError; 2],
    /// Whether they are held at an end.
    pub(super) held: [bool; 2],
    /// The radii and the reference parameters.
    pub(super) contact: Contact,
    /// x, t, t,xi and t,xixi of beam and bar beam.
    pub(super) geometry: [[Vector3<RunningError>; 4]; 2],
    /// The variations along both directions at fixed parameters: by direction, beam and xi-derivative.
    pub(super) moved: [[[Vector3<RunningError>; 3]; 2]; 2],
    /// The mixed second variations at fixed parameters, by beam and xi-derivative.
    pub(super) mixed: [[Vector3<RunningError>; 2]; 2],
    /// The numbers of the program, by component; nothing where it has none.
    pub(super) own: [[Option<RunningError>; 4]; COMPONENTS],
    /// The exact numbers.
    pub(super) exact: [[RunningError; 4]; COMPONENTS],
    /// Residual along both directions, and tangent, with the penalty stiffness and whether the contact is active.
    pub(super) element: Option<Element>,
    /// The inputs of the formulas.
    pub(super) inputs: Inputs,
    /// The control vectors of both beams with their shape functions, if the curves have these.
    pub(super) nodes: [Vec<Node>; 2],
}

/// The samples of a case; none if it has no closest point or its answers cannot be read.
pub(super) fn samples(
    case: usize,
    vector: &Vector,
    answers: &Answers,
    demands: &Demands,
    along: Along,
) -> Vec<Sample> {
    let conventions = &demands.conventions;
    let positions = vector.case.test_beams.each_ref().map(|beam| rounding(&beam.q));
    let at = |evaluation: EvaluationPoint<'_>| {
        let sums = evaluation.have_shapes();
        let positions =
            std::array::from_fn(|i| if sums[i] { CAREFUL * positions[i] } else { Vector3::zeros() });
        let (xi, xi_bar) = evaluation.parameters_with(positions);
        let element = vector.element_at(&evaluation).ok().flatten();
        ([xi, xi_bar], [evaluation.held.xi, evaluation.held.xi_bar], sums, element)
    };
    let Ok((exact, held, has_shapes, element)) = vector.evaluated(at) else { return Vec::new() };
    let Ok(beams) = vector.case.beams() else { return Vec::new() };
    let half = demands.digits.map_or(0.0, half_unit);
    // The point of the program, if it is another one.
    let place = |i: usize| {
        let quantity = [Quantity::Xi, Quantity::XiBar][i];
        let value = answers.answers.iter().find(|answer| answer.quantity == quantity).and_then(|of| of.value);
        let own = value.map(|xi| if conventions.parameter == Range::Unit { 2.0 * xi - 1.0 } else { xi });
        let RunningError2 { value, bound: [near, far] } = exact[i];
        let allowed = |own: f64| CAREFUL * near + far + 4.0 * f64::EPSILON + half * own.abs().max(1.0);
        match own {
            Some(own) if own.is_finite() && (own - value).abs() > allowed(own) => {
                RunningError2 { value: own, bound: [f64::EPSILON; 2] }
            }
            _ => exact[i],
        }
    };
    let answered = &answers.answers;
    let has_arrays = answers.residual.is_some()
        || answers.tangent.is_some()
        || answered.iter().any(|of| of.gradient.is_some() || of.hessian.is_some());
    let is_stated = !has_arrays || answered.iter().any(|of| of.variations != [None; 3]);
    let last_tangents = vector.last_tangents();
    let point = Point { exact, own: [place(0), place(1)], held, has_shapes, element, last_tangents };
    let of = |k: u64| point.sample((case, vector, &beams), answers, demands, (along, k));
    match along {
        Along::Stated if is_stated => of(0).into_iter().collect(),
        Along::Random if has_arrays => (0..DIRECTIONS).filter_map(of).collect(),
        Along::Lower | Along::Upper if has_arrays => (1..=DIRECTIONS).filter_map(of).collect(),
        Along::Block(_) if has_arrays => (1..=OF_BLOCK).filter_map(of).collect(),
        Along::Grid if has_arrays => (1..=(SIDE * SIDE) as u64).filter_map(of).collect(),
        _ => Vec::new(),
    }
}

/// Half an ulp of the sum of the absolute values, by coordinate.
fn rounding(dofs: &[f64]) -> Vector3<f64> {
    let size = |c: usize| dofs.iter().skip(c).step_by(3).map(|dof| dof.abs()).sum::<f64>();
    Vector3::from_fn(|c, _| f64::EPSILON / 2.0 * size(c))
}

/// The directions of the case, or others that the program cannot know.
#[expect(clippy::cast_possible_truncation, reason = "a small number")]
fn directions(vector: &Vector, along: Along, k: u64) -> [[Vec<f64>; 2]; 2] {
    let dofs = vector.case.test_beams.iter().flat_map(|beam| &beam.q);
    let seeded = |k: u64| {
        let seed = dofs.clone().fold(k, |seed, dof| seed.rotate_left(7) ^ dof.to_bits());
        ChaCha8Rng::seed_from_u64(seed)
    };
    let [beam, bar] = &vector.case.test_beams;
    let random = |rng: &mut ChaCha8Rng, both: [&Vec<f64>; 2]| {
        let mut factor =
            || if k == 0 { 1.0 } else { rng.random_range(0.5..1.5) * if rng.random() { 1.0 } else { -1.0 } };
        both.map(|dq| dq.iter().map(|entry| entry * factor()).collect::<Vec<_>>())
    };
    let stated = [[&beam.dq, &bar.dq], [&beam.linear_dq, &bar.linear_dq]];
    let mut rng = seeded(k);
    match along {
        Along::Stated | Along::Random => stated.map(|both| random(&mut rng, both)),
        Along::Block(beams) => {
            let mut all = stated.map(|both| random(&mut rng, both));
            for (direction, beam) in all.iter_mut().zip(beams) {
                direction[1 - beam].fill(0.0);
            }
            all
        }
        Along::Grid => {
            let [row, column] = [(k - 1) / SIDE as u64, (k - 1) % SIDE as u64];
            let [of_rows, of_columns] = stated;
            [random(&mut seeded(row), of_rows), random(&mut seeded(!column), of_columns)]
        }
        Along::Lower | Along::Upper => {
            // Pairs of dofs of all blocks in turn.
            let (n, m) = (beam.q.len(), bar.q.len());
            let (low, high) = [(0..n, 0..n), (n..n + m, n..n + m), (0..n, n..n + m)][k as usize % 3].clone();
            let [mut i, mut j] = [rng.random_range(low), rng.random_range(high.clone())];
            if i == j {
                j = if j + 1 < high.end { j + 1 } else { j - 1 };
            }
            (i, j) = (i.min(j), i.max(j));
            let [row, column] = if along == Along::Lower { [j, i] } else { [i, j] };
            let unit = |at: usize| {
                let of =
                    |range: std::ops::Range<usize>| range.map(|i| if i == at { 1.0 } else { 0.0 }).collect();
                [of(0..n), of(n..n + m)]
            };
            [unit(row), unit(column)]
        }
    }
}

/// A closest point: the exact parameters and those of the program.
struct Point {
    exact: [RunningError2; 2],
    own: [RunningError2; 2],
    held: [bool; 2],
    has_shapes: [bool; 2],
    element: Option<ElementAt>,
    /// The unit tangents at the last converged step, if it is known.
    last_tangents: Option<[Vector3<f64>; 2]>,
}

/// The index of a case, the case and its beams.
type Known<'a> = (usize, &'a Vector, &'a [Box<dyn AnyBeam>; 2]);

impl Point {
    fn sample(
        &self,
        (case, vector, beams): Known,
        answers: &Answers,
        demands: &Demands,
        (kind, k): (Along, u64),
    ) -> Option<Sample> {
        let Self { exact: exact_xi, own: xi, held, has_shapes, element: ref of_element, ref last_tangents } =
            *self;
        let along = directions(vector, kind, k);
        let moved: [Box<dyn AnyBeam>; 2] = std::array::from_fn(|i| {
            beams[i].with_numbers(&[
                vector.case.test_beams[i].q.clone(),
                along[0][i].clone(),
                along[1][i].clone(),
            ])
        });
        let at = |xi: [RunningError2; 2]| {
            let of = |i: usize| {
                let mut partial = moved[i].partial_variations(xi[i]);
                if has_shapes[i] {
                    let by =
                        [&vector.case.test_beams[i].q, &along[0][i], &along[1][i]].map(|dofs| rounding(dofs));
                    widen(&mut partial, &by);
                }
                partial
            };
            [of(0), of(1)]
        };
        let (partial, exact_partial) = (at(xi), at(exact_xi));
        let contact = vector.case.contact;
        let form = Formulation::paper(crate::closest_point::Held { xi: held[0], xi_bar: held[1] });
        let [beam, bar] = &exact_partial;
        let varied = variations_in(form, beam, bar, exact_xi.into(), &contact).components();
        let careful = |number: RunningError2| RunningError {
            value: number.value,
            bound: CAREFUL * number.bound[0] + number.bound[1],
        };
        let exact = varied.map(|of| of.parts().map(careful));
        let families = vector.families();
        let dq = along
            .each_ref()
            .map(|[beam, bar]| demands.conventions.direction(families, &[&beam[..], bar].concat()));
        let own = own_numbers(answers, [&dq[0], &dq[1]], demands, &exact, kind == Along::Stated)?;
        let is_closed = exact[Quantity::GN.component()][0].value < 0.0;
        let mut inputs = Inputs::new(&partial, xi, held, contact);
        if let Some(element) = of_element {
            inputs.add_element(element, *last_tangents, answers, demands);
        }
        let has_data = inputs.decided.is_some();
        let element = element(answers, [&dq[0], &dq[1]], demands, is_closed, has_data);
        if element.as_ref().is_some_and(|of| of.stiffness.is_some())
            && let Some(penalty) = demands.conventions.penalty
        {
            inputs.add_penalty(penalty, is_closed);
        }
        let sharp = |v: Vector3<RunningError2>| v.map(|n| RunningError { value: n.value, bound: n.bound[0] });
        let geometry = partial.each_ref().map(|of: &PartialVariations<RunningError2>| {
            let g = &of.geometry;
            [g.x, g.t, g.t_xi, g.t_xixi].map(sharp)
        });
        let by_side = |read: fn(&PartialVariations<RunningError2>) -> [Vector3<RunningError2>; 3]| {
            partial.each_ref().map(|of| read(of).map(sharp))
        };
        Some(Sample {
            case,
            xi: xi.map(|xi| RunningError { value: xi.value, bound: xi.bound[0] }),
            held,
            contact,
            geometry,
            moved: [by_side(|of| of.delta_u), by_side(|of| of.linear_u)],
            mixed: partial.each_ref().map(|of| of.second_u.map(sharp)),
            own,
            exact,
            element,
            inputs,
            nodes: std::array::from_fn(|i| {
                if has_shapes[i] {
                    nodes(&*beams[i], xi[i].value, [&along[0][i], &along[1][i]])
                } else {
                    Vec::new()
                }
            }),
        })
    }
}
