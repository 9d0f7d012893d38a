//! The pairs of beams that are timed: fixed pairs, each at its closest point.

use beamgap::check::{Case, Regime, Selection};
use beamgap::closest_point::ClosestPoint;
use beamgap::curve::{
    Arc, BSpline, Bezier, Cubic, Curve, Helix, Hermite, Nurbs, NurbsWeighted, Quadratic, Segment,
};
use beamgap::linearization::closed_form::jets;
use beamgap::pair::{Contact, DofVector, Pair};
use beamgap::test_beam::{Family, TestBeam};
use nalgebra::{SVector, Vector3};

/// The seed of the drawn pairs.
const SEED: u64 = 0x5eed;
/// The number of cases that are searched for pairs. One in 21 of the cases with a family has it twice.
const CASES: u64 = 10_000;
/// The minimum conditioning. Pairs that are nearly singular are left to the check, because they are rare in practice.
const CONDITIONED: f64 = 0.2;

/// A pair with its dofs, two directions of variation and its closest point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Input<A, B, const N: usize, const M: usize> {
    pub(super) family: &'static str,
    pub(super) pair: Pair<A, B, N, M>,
    pub(super) q: DofVector<f64, N, M>,
    pub(super) dq: DofVector<f64, N, M>,
    pub(super) linear_dq: DofVector<f64, N, M>,
    pub(super) point: ClosestPoint,
}

/// A curve that can be sent to any thread.
pub(super) trait TimedCurve<const N: usize>: Curve<N> + Copy + Send + Sync + 'static {}
impl<C: Curve<N> + Copy + Send + Sync + 'static, const N: usize> TimedCurve<N> for C {}

/// A pair of two beams of one family.
pub(super) type Twins<C, const N: usize> = Input<C, C, N, N>;

/// The standard pair.
pub(super) fn hermites() -> Twins<Hermite, 12> {
    drawn(Family::Hermite, 1, |_| Hermite::new())[0]
}

/// A pair of the standard family at a small gap or angle.
pub(super) fn near() -> Twins<Hermite, 12> {
    let near = pairs(Family::Hermite, |_| Hermite::new()).find(|input| !input.is_wide());
    Input { family: "hermite, near", ..near.expect("some of the pairs are") }
}

/// A pair of each other family.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inputs {
    pub(super) segment: Twins<Segment, 6>,
    pub(super) quadratic: Twins<Quadratic, 9>,
    pub(super) cubic: Twins<Cubic, 12>,
    pub(super) hermite_scaled: Twins<Hermite, 12>,
    pub(super) bezier: Twins<Bezier<6>, 18>,
    pub(super) spline: Twins<BSpline<4>, 12>,
    pub(super) nurbs: Twins<Nurbs<3>, 9>,
    pub(super) nurbs_weighted: Twins<NurbsWeighted<4>, 16>,
    pub(super) arc: Twins<Arc, 9>,
    pub(super) helix: Twins<Helix, 10>,
}

impl Inputs {
    pub(super) fn drawn() -> Self {
        let nurbs = |of: &TestBeam| {
            let weights = std::array::from_fn(|i| of.parameter("weights")[i]);
            Nurbs::new(of.parameter("knots"), weights).expect(VALID)
        };
        let weighted = |of: &TestBeam| NurbsWeighted::new(of.parameter("knots")).expect(VALID);
        Self {
            segment: drawn(Family::Segment, 1, |_| Segment::new())[0],
            quadratic: drawn(Family::Quadratic, 1, |_| Quadratic::new())[0],
            cubic: drawn(Family::Cubic, 1, |_| Cubic::new())[0],
            hermite_scaled: drawn(Family::HermiteScaled, 1, |of| Hermite::scaled_by(of.parameters[0]))[0],
            bezier: drawn(Family::Bezier, 1, |_| Bezier::new())[0],
            spline: drawn(Family::BSpline, 1, |of| BSpline::new(&of.parameters).expect(VALID))[0],
            nurbs: drawn(Family::Nurbs, 1, nurbs)[0],
            nurbs_weighted: drawn(Family::NurbsWeighted, 1, weighted)[0],
            arc: drawn(Family::Arc, 1, |of| Arc::new(of.parameters[0]))[0],
            helix: drawn(Family::Helix, 1, |of| Helix::new(of.parameters[0]))[0],
        }
    }
}

const VALID: &str = "what is drawn is a curve";

/// The first `count` pairs of a family with wide gaps and angles.
pub(super) fn drawn<C: TimedCurve<N>, const N: usize>(
    family: Family,
    count: usize,
    curve: impl Fn(&TestBeam) -> C,
) -> Vec<Twins<C, N>> {
    pairs(family, curve).filter(Input::is_wide).take(count).collect()
}

/// The well-conditioned pairs of two beams of a family among the cases of the check.
fn pairs<C: TimedCurve<N>, const N: usize>(
    family: Family,
    curve: impl Fn(&TestBeam) -> C,
) -> impl Iterator<Item = Twins<C, N>> {
    let selection = Selection { regimes: vec![Regime::Generic], family: Some(family), cases: CASES };
    let cases = selection.numbers().into_iter().map(|number| Case::draw(SEED, number));
    let twins = cases.filter(move |case| case.families == [family; 2]);
    twins.filter_map(move |case| Input::of_case(&case, &curve))
}

impl<C: TimedCurve<N>, const N: usize> Input<C, C, N, N> {
    fn of_case(case: &Case, curve: impl Fn(&TestBeam) -> C) -> Option<Self> {
        let [beam, bar] = &case.test_beams;
        let vector = |of: fn(&TestBeam) -> &Vec<f64>| DofVector {
            beam: SVector::from_column_slice(of(beam)),
            bar: SVector::from_column_slice(of(bar)),
        };
        let pair = Pair { curve: curve(beam), curve_bar: curve(bar), contact: case.contact };
        let q = vector(|of| &of.q);
        let point = closest(&pair, &q)?;
        let (dq, linear_dq) = (vector(|of| &of.dq), vector(|of| &of.linear_dq));
        Some(Self { family: case.families[0].name(), pair, q, dq, linear_dq, point })
    }

    /// Whether the gap is at least an eighth of a tangent, and the sine of the angle is more than a quarter.
    fn is_wide(&self) -> bool {
        let Self { pair, q, point, .. } = self;
        let (jet, jet_bar) = jets(pair, q, (point.xi, point.xi_bar));
        let (x, x_bar) = (jet.geometry, jet_bar.geometry);
        let [t2, t_bar2] = [x.t, x_bar.t].map(|t| t.norm_squared());
        let b = x.t.dot(&x_bar.t);
        t2 * t_bar2 - b * b > 1.01 / 16.0 * t2 * t_bar2
            && (x.x - x_bar.x).norm_squared() >= t2.min(t_bar2) / 64.0
    }

    /// Two slightly bent beams that cross; the points are at the parameters `nodes`, one for each point of the family.
    pub(super) fn of_nodes(family: &'static str, curve: C, nodes: &[f64]) -> Self {
        let parabola = |middle: Vector3<f64>, half: Vector3<f64>, sag: Vector3<f64>| {
            let points = nodes.iter().flat_map(|&s| (middle + half * s + sag * (s * s)).data.0[0]);
            SVector::from_iterator(points)
        };
        let beam = [[0.1, 0.0, 0.5], [1.1, 0.15, 0.05], [0.01, 0.02, 0.03]].map(Vector3::from);
        let bar = [[0.05, -0.1, 0.0], [0.35, 1.0, 0.05], [0.02, -0.01, -0.02]].map(Vector3::from);
        let q =
            DofVector { beam: parabola(beam[0], beam[1], beam[2]), bar: parabola(bar[0], bar[1], bar[2]) };
        let contact = Contact { radius: 0.1, radius_bar: 0.05, xi_0: -0.2, xi_bar_0: 0.3 };
        let pair = Pair { curve, curve_bar: curve, contact };
        let point = closest(&pair, &q).expect("they cross in their middles, at a wide angle");
        let [dq, linear_dq] = [1.0, 2.0].map(wave);
        Self { family, pair, q, dq, linear_dq, point }
    }
}

/// The closest point, if it is interior to both beams and regular.
fn closest<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
    pair: &Pair<A, B, N, M>,
    q: &DofVector<f64, N, M>,
) -> Option<ClosestPoint> {
    let point = *pair.closest_points(q).ok()?.interior().ok()?;
    (point.degeneracy().is_none() && point.conditioning > CONDITIONED).then_some(point)
}

/// A direction in which all dofs vary, and all by different amounts.
#[expect(clippy::cast_precision_loss, reason = "counts dofs")]
fn wave<const N: usize, const M: usize>(frequency: f64) -> DofVector<f64, N, M> {
    let wave = |i: usize| (frequency * (i + 1) as f64).sin();
    DofVector { beam: SVector::from_fn(|i, _| wave(i)), bar: SVector::from_fn(|i, _| wave(N + i)) }
}
