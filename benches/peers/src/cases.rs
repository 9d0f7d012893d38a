//! The pairs that every peer gets.

use beamgap::closest_point::{Held, ClosestPoint, Kind};
use beamgap::curve::{Curve, Hermite};
use beamgap::nalgebra::SVector;
use beamgap::pair::{Contact, DofVector, Pair};

/// The compared pair: two cubic Hermite curves.
pub(crate) type Hermites = Pair<Hermite, Hermite, 12, 12>;

/// The curves of every pair.
pub(crate) const PAIR: Hermites = Pair {
    curve: Hermite::new(),
    curve_bar: Hermite::new(),
    contact: Contact { radius: 0.1, radius_bar: 0.05, xi_0: -0.2, xi_bar_0: 0.3 },
};

/// A pair at its closest point: first the input of a peer, then the input of the crate.
#[derive(Clone)]
#[repr(C)]
pub(crate) struct Case {
    plain: [f64; 24],
    xi: f64,
    xi_bar: f64,
    pub(crate) q: DofVector<f64, 12, 12>,
    pub(crate) point: ClosestPoint,
}

impl Case {
    /// The case whose dofs a peer gets.
    ///
    /// # Safety
    /// `q` points to a case of [`draw_cases`].
    pub(crate) unsafe fn of<'a>(q: *const f64) -> &'a Self {
        // SAFETY: the dofs are a case's first field.
        unsafe { &*q.cast() }
    }
}

/// SplitMix64, uniform in [-1, 1).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        ((z >> 11) as f64) / ((1_u64 << 52) as f64) - 1.0
    }
}

/// Two beams that cross, bent at random; nothing unless their closest point is unique, interior and well conditioned.
fn draw(random: &mut Random) -> Option<Case> {
    const BEAM: [f64; 12] = [-1.0, 0.0, 0.3, 1.0, 0.0, 0.0, 1.0, 0.0, 0.3, 1.0, 0.0, 0.0];
    const BAR: [f64; 12] = [0.0, -1.0, -0.3, 0.0, 1.0, 0.0, 0.0, 1.0, -0.3, 0.0, 1.0, 0.0];
    let mut bent = |of: [f64; 12]| of.map(|straight| straight + 0.3 * random.next());
    let (beam, bar) = (bent(BEAM), bent(BAR));
    let q = DofVector { beam: SVector::from(beam), bar: SVector::from(bar) };
    let found = PAIR.closest_points(&q).ok()?;
    let point = *found.interior().ok()?;
    let is_inside = point.xi.abs() < 0.95 && point.xi_bar.abs() < 0.95;
    if !is_inside || found.minima.len() > 1 || point.distance < 0.25 || point.conditioning < 0.1 {
        return None;
    }
    let mut plain = [0.0; 24];
    plain[..12].copy_from_slice(&beam);
    plain[12..].copy_from_slice(&bar);
    Some(Case { plain, xi: point.xi, xi_bar: point.xi_bar, q, point })
}

/// The same pair with another gap; nothing if the closest point then changes.
///
/// A negative gap moves the bar beam to the other side of the beam.
fn moved(case: &Case, gap: f64) -> Option<Case> {
    let mut case = case.clone();
    let (x, x_bar) = (PAIR.curve.jet(&case.q.beam, case.xi).geometry, PAIR.curve_bar.jet(&case.q.bar, case.xi_bar).geometry);
    let d = x.x - x_bar.x;
    let by = d * (1.0 - gap * x.t.norm() / d.norm());
    for (i, dof) in case.q.bar.iter_mut().enumerate() {
        // The points move, and the tangents stay.
        if i % 6 < 3 {
            *dof += by[i % 3];
        }
    }
    let point = PAIR.refine(&case.q, (case.xi, case.xi_bar), Held::default()).ok()?;
    let near = (point.xi - case.xi).abs().max((point.xi_bar - case.xi_bar).abs()) < 1e-6;
    if !near || point.kind != Kind::Minimum || point.degeneracy().is_some() {
        return None;
    }
    case.plain[12..].copy_from_slice(case.q.bar.as_slice());
    (case.xi, case.xi_bar, case.point) = (point.xi, point.xi_bar, point);
    Some(case)
}

/// Draws `count` pairs, which are never freed, and sets `stride` to their distance in bytes.
///
/// Without `gaps` the drawn gaps are kept. Otherwise each pair is moved to one of the `gaps`, in lengths of a tangent:
/// to the gap with index `which`, or to a random one if there is no such index. Only pairs that can be moved to every
/// gap are used, so the choice of the pairs and of their sides does not depend on `which`.
///
/// # Safety
/// `stride` can be written to, and `gaps` points to `gap_count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn draw_cases(
    seed: u64,
    count: usize,
    gaps: *const f64,
    gap_count: usize,
    which: usize,
    stride: *mut usize,
) -> *const f64 {
    // the caller guarantees this.
    let gaps = unsafe { std::slice::from_raw_parts(gaps, gap_count) };
    // Gaps have their own random numbers, so the pairs do not depend on the gaps.
    let (mut random, mut of_gaps) = (Random(seed), Random(!seed));
    let cases: Vec<Case> = std::iter::repeat_with(|| {
        let case = draw(&mut random)?;
        if gaps.is_empty() {
            return Some(case);
        }
        let side = 1.0_f64.copysign(of_gaps.next());
        let any = ((of_gaps.next() + 1.0) * 0.5 * gaps.len() as f64) as usize;
        let at_all: Option<Vec<Case>> = gaps.iter().map(|gap| moved(&case, side * gap)).collect();
        Some(at_all?.swap_remove(if which < gaps.len() { which } else { any }))
    })
    .flatten()
    .take(count)
    .collect();
    // the caller guarantees this.
    unsafe { *stride = size_of::<Case>() };
    cases.leak().as_ptr().cast()
}
