//! The search for what is wrong: each fault of the catalogue, then factors, then pairs.

use super::hypothesis::Change;
use super::site::{By, Datum, Known, Site};
use crate::check::evaluation_point::Structure;
use crate::check::verdict::Order;
use crate::linearization::Quantity;
use crate::number::Label;
use crate::variant::{Fault, Kind, Variant, terms};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::BTreeSet;

/// Cases that every fault is tried at.
const SCREENED: usize = 4;
/// Changes that explain the first case best, which are tried at more.
const NEAREST: usize = 120;
/// First faults of a pair, to each of which all second faults are tried.
const FIRST_OF_PAIR: usize = 6;

/// How well a change explains the answers.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    pub(super) change: Change,
    /// The largest deviation over its scale.
    pub(super) worst: f64,
    /// The largest deviation over what rounding explains.
    pub(super) over: f64,
    /// The place in the order of evaluation.
    pub(super) order: usize,
}

impl Fit {
    pub(super) fn explains(&self) -> bool {
        self.over <= 1.0
    }

    /// Whether it leaves next to nothing of a deviation: answers of few digits.
    fn is_close(&self, before: f64) -> bool {
        before.is_finite() && self.worst <= CLOSE * before
    }

    /// The same at other cases.
    fn fit_again(&mut self, sites: &[&Site], by: By) {
        *self = Self { order: self.order, ..fit(sites, self.change.clone(), by, &every) };
    }
}

/// The deviations of the data that are asked for, after a change; at each case made in the way that fits best.
pub(super) fn fit(
    sites: &[&Site],
    change: Change,
    by: By,
    is_asked: &(dyn Fn(&Datum) -> bool + Sync),
) -> Fit {
    let mut all = [0.0_f64; 2];
    for site in sites {
        let misfit = |predicted: &super::site::Predicted| {
            let asked = site.data.iter().filter(|datum| is_asked(datum));
            asked.fold([0.0_f64; 2], |[worst, over], datum| {
                let [own, own_over] = datum.misfit(Site::number(predicted, datum));
                [worst.max(own), over.max(own_over)]
            })
        };
        let predicted = site.predicted(&change, by);
        let best = predicted.iter().map(misfit);
        let best = best.min_by(|one, two| one[1].total_cmp(&two[1])).unwrap_or([f64::INFINITY; 2]);
        all = [all[0].max(best[0]), all[1].max(best[1])];
    }
    Fit { change, worst: all[0], over: all[1], order: 0 }
}

/// The names of all terms, in the order of evaluation.
fn labels() -> Vec<Label> {
    let [varied, expanded] = terms();
    varied.iter().chain(expanded.iter().filter(|label| !varied.contains(label))).copied().collect()
}

fn singles() -> Vec<Fault> {
    labels().into_iter().flat_map(|label| Kind::ALL.map(|kind| Fault { label, kind })).collect()
}

fn of_faults(faults: &[Fault]) -> Change {
    Change::Variant(Variant::Faulty(faults.to_vec()))
}

/// The predictions at a case that every search asks for.
pub(super) fn memo(site: &Site) -> Known {
    let all: Vec<_> = singles().iter().map(|&fault| of_faults(&[fault])).collect();
    all.into_par_iter().map(|change| (change.name(), site.computed(&change, By::All))).collect()
}

/// All that is tried first: one fault of the catalogue, a simplification, a factor.
fn candidates(sites: &[&Site]) -> Vec<Change> {
    let mut all: Vec<_> = singles().iter().map(|&fault| of_faults(&[fault])).collect();
    all.extend(Structure::ALL.map(Change::Structure));
    all.extend([true, false].map(|is_geometric| Change::Tangent { is_geometric }));
    all.push(Change::BeamsExchanged);
    let wrong: BTreeSet<_> = of(sites).filter(|datum| datum.is_wrong).map(|datum| datum.quantity).collect();
    for quantity in wrong {
        all.extend(
            [Order::Value, Order::First, Order::Second, Order::Matrix]
                .into_iter()
                .filter_map(|order| Some(Change::Factor(quantity, order, factor(sites, quantity, order)?))),
        );
    }
    all
}

fn of<'a>(sites: &'a [&Site]) -> impl Iterator<Item = &'a Datum> {
    sites.iter().flat_map(|site| &site.data)
}

/// The factor that fits best; first and second variations together for the order [`Order::Matrix`].
fn factor(sites: &[&Site], quantity: Quantity, order: Order) -> Option<f64> {
    let is_of = |datum: &&Datum| {
        let is_order = datum.order == order || (order == Order::Matrix && datum.order != Order::Value);
        datum.quantity == quantity && is_order && datum.scale > 0.0 && datum.answer.is_finite()
    };
    let sums = of(sites).filter(is_of).fold([0.0, 0.0], |[one, two], datum| {
        let (answer, reference) = (datum.answer / datum.scale, datum.reference / datum.scale);
        [one + answer * reference, two + reference * reference]
    });
    (sums[1] > 0.0).then_some(sums[0] / sums[1]).filter(|factor| (factor - 1.0).abs() > 1e-9)
}

/// What the search came to.
pub(super) struct Found {
    /// The deviation of the answers as they are.
    pub(super) before: f64,
    /// The explanations, none of which can be told from the first by these answers.
    pub(super) equal: Vec<Fit>,
    /// The best of the others.
    pub(super) runner_up: Option<Fit>,
}

/// Looks for what explains the answers.
pub(super) fn search(sites: &[Site]) -> Found {
    let all: Vec<&Site> = sites.iter().collect();
    let before = fit(&all, Change::Variant(Variant::Unmodified), By::All, &every).worst;
    // Most programs evaluate the paper's formulas.
    let mut fits = Vec::new();
    for by in [By::Paper, By::All] {
        fits = one_change(&all, by);
        if fits.iter().any(|of| of.explains() || of.is_close(before)) {
            return ranked(fits, before, &all);
        }
    }
    let screened = &all[..all.len().min(SCREENED)];
    let weighted = |label: Label| {
        let factor = weight(screened, label)?;
        Some(fit(screened, Change::Variant(Variant::Weighted(label, factor)), By::All, &every))
    };
    fits.extend(labels().into_par_iter().filter_map(weighted).collect::<Vec<_>>());
    confirm(&mut fits, &all, By::All);
    if !fits.iter().any(|of| of.explains() || of.is_close(before)) {
        fits.extend(pairs(screened));
        confirm(&mut fits, &all, By::All);
    }
    ranked(fits, before, &all)
}

fn every(_: &Datum) -> bool {
    true
}

/// How well each single change explains the answers.
fn one_change(all: &[&Site], by: By) -> Vec<Fit> {
    // What explains all explains the first case.
    let mut fits: Vec<Fit> = candidates(all)
        .into_par_iter()
        .enumerate()
        .map(|(order, change)| Fit { order, ..fit(&all[..1], change, by, &every) })
        .collect();
    fits.sort_by(|one, two| one.over.total_cmp(&two.over));
    // What was tried at one case only is no runner-up.
    fits.truncate(NEAREST);
    let screened = &all[..all.len().min(SCREENED)];
    fits.par_iter_mut().for_each(|of| of.fit_again(screened, by));
    confirm(&mut fits, all, by);
    fits
}

/// Tries those that explain some cases at all of them; if none does, those that are nearest to it.
fn confirm(fits: &mut [Fit], all: &[&Site], by: By) {
    fits.par_iter_mut().filter(|of| of.explains()).for_each(|of| of.fit_again(all, by));
    if !fits.iter().any(Fit::explains) {
        let best = fits.iter().map(|of| of.worst).fold(f64::INFINITY, f64::min);
        fits.par_iter_mut().filter(|of| of.worst <= 10.0 * best).for_each(|of| of.fit_again(all, by));
    }
}

/// The part of the deviation that may be left where answers have few digits.
const CLOSE: f64 = 1e-3;

fn ranked(mut fits: Vec<Fit>, before: f64, sites: &[&Site]) -> Found {
    let is_found = fits.iter().any(Fit::explains);
    let best = fits.iter().map(|of| of.worst).fold(f64::INFINITY, f64::min);
    let explains = |of: &Fit| {
        if is_found { of.explains() } else { of.worst <= 4.0 * best && of.is_close(before) }
    };
    let (mut equal, mut others): (Vec<_>, Vec<_>) = fits.drain(..).partition(explains);
    equal.sort_by_key(|of| (of.change.class(), of.order));
    if let Some(simplest) = equal.first().map(|of| of.change.class()) {
        equal.retain(|of| of.change.class() == simplest);
    }
    without_twins(&mut equal, sites);
    others.sort_by(|one, two| one.worst.total_cmp(&two.worst));
    // What changes nothing is no runner-up.
    let runner_up = others.into_iter().next().filter(|of| of.worst < before);
    Found { before, equal, runner_up }
}

/// Leaves out further kinds of faults of one term that predict the same numbers.
fn without_twins(equal: &mut Vec<Fit>, sites: &[&Site]) {
    let label = |of: &Fit| match &of.change {
        Change::Variant(Variant::Faulty(faults)) => faults.iter().map(|fault| fault.label).collect(),
        _ => Vec::new(),
    };
    let mut kept: Vec<Fit> = Vec::new();
    for of in equal.drain(..) {
        let is_twin = |known: &Fit| {
            let (one, two) = (label(known), label(&of));
            !one.is_empty() && one == two && predict_the_same(&known.change, &of.change, sites)
        };
        if !kept.iter().any(is_twin) {
            kept.push(of);
        }
    }
    *equal = kept;
}

fn predict_the_same(one: &Change, two: &Change, sites: &[&Site]) -> bool {
    sites.iter().all(|site| {
        let (one, two) = (site.predicted(one, By::All), site.predicted(two, By::All));
        site.data.iter().all(|datum| {
            one.iter().zip(two.iter()).all(|(one, two)| {
                let (one, two) = (Site::number(one, datum), Site::number(two, datum));
                (one - two).abs() <= 1e-9 * datum.scale.max(one.abs()) || one.to_bits() == two.to_bits()
            })
        })
    })
}

/// The factor of a term that fits best, by Gauss-Newton iterations; nothing if the term changes nothing.
fn weight(sites: &[&Site], label: Label) -> Option<f64> {
    const STEP: f64 = 1e-4;
    let (start, next) = (misfits(sites, label, 1.0), misfits(sites, label, 1.0 + STEP));
    let sums = |own: &[f64], next: &[f64]| {
        own.iter().zip(next).fold([0.0; 3], |[gr, gg, rr], (own, next)| {
            let slope = (next - own) / STEP;
            [gr + slope * own, gg + slope * slope, rr + own * own]
        })
    };
    // The way of making that the first step explains most of.
    let gain = |way: usize| {
        let [gr, gg, _] = sums(&start[way], &next[way]);
        if gg > 0.0 { gr * gr / gg } else { 0.0 }
    };
    let way = (0..start.len()).max_by(|&one, &two| gain(one).total_cmp(&gain(two)))?;
    if gain(way) == 0.0 {
        return None;
    }
    let mut factor = 1.0;
    for _ in 0..8 {
        let of = |factor| misfits(sites, label, factor).swap_remove(way);
        let [gr, gg, _] = sums(&of(factor), &of(factor + STEP));
        let step = gr / gg;
        factor -= step;
        if !step.is_finite() || step.abs() < 1e-11 {
            break;
        }
    }
    factor.is_finite().then_some(factor)
}

/// The misfits of all data over their scales, with a term multiplied; in each way of making, the same at all cases.
fn misfits(sites: &[&Site], label: Label, factor: f64) -> Vec<Vec<f64>> {
    let change = Change::Variant(Variant::Weighted(label, factor));
    let per_site = sites.iter().map(|site| {
        let of = |predicted: &super::site::Predicted| {
            let misfit = |datum: &Datum| {
                let off = (Site::number(predicted, datum) - datum.answer) / datum.scale;
                if off.is_finite() { off } else { 0.0 }
            };
            site.data.iter().map(misfit).collect::<Vec<f64>>()
        };
        site.predicted(&change, By::All).iter().map(of).collect::<Vec<_>>()
    });
    let per_site: Vec<_> = per_site.collect();
    let ways = per_site.iter().map(Vec::len).max().unwrap_or(0);
    (0..ways).map(|way| per_site.iter().flat_map(|of| of[way.min(of.len() - 1)].clone()).collect()).collect()
}

/// The factor that a term seems to have had, near that of a fault: 0 if it is missing, -1 if its sign is wrong.
pub(super) fn measured_factor(sites: &[Site], fault: Fault) -> Option<f64> {
    let all: Vec<&Site> = sites.iter().take(SCREENED).collect();
    matches!(fault.kind, Kind::Sign | Kind::Dropped | Kind::Doubled | Kind::Halved).then_some(())?;
    let factor = weight(&all, fault.label)?;
    let nominal = match fault.kind {
        Kind::Sign => -1.0,
        Kind::Dropped => 0.0,
        Kind::Doubled => 2.0,
        _ => 0.5,
    };
    ((factor - nominal).abs() < 0.05).then_some(factor)
}

/// Pairs of faults: the first explains all numbers up to the first wrong ones, the second what is left.
fn pairs(sites: &[&Site]) -> Vec<Fit> {
    let key = |datum: &Datum| (datum.rank.0, datum.rank.1);
    let first_wrong = |change: &Change| {
        let of_site = |site: &&Site| {
            let predicted = site.predicted(change, By::All);
            let per_way = predicted.iter().map(|predicted| {
                let wrong =
                    site.data.iter().filter(|datum| datum.misfit(Site::number(predicted, datum))[1] > 1.0);
                wrong.map(key).min()
            });
            // The way that goes farthest; one without a wrong number goes to the end.
            per_way.max_by_key(|wrong| (wrong.is_none(), *wrong)).flatten()
        };
        sites.iter().filter_map(of_site).min()
    };
    let Some(start) = first_wrong(&Change::Variant(Variant::Unmodified)) else { return Vec::new() };
    let singles = singles();
    let up_to = |end: (Order, usize)| move |datum: &Datum| key(datum) <= end;
    let firsts: Vec<Fault> = singles
        .par_iter()
        .filter(|fault| fit(sites, of_faults(&[**fault]), By::All, &up_to(start)).explains())
        .copied()
        .collect();
    let mut farthest: Vec<_> =
        firsts.iter().filter_map(|&fault| Some((first_wrong(&of_faults(&[fault]))?, fault))).collect();
    farthest.sort_by_key(|(end, _)| Reverse(*end));
    farthest.truncate(FIRST_OF_PAIR);
    let seconds = |&(end, first): &((Order, usize), Fault)| {
        let both = |&second: &Fault| {
            let change = of_faults(&[first, second]);
            let is_first = fit(&sites[..1], change.clone(), By::All, &up_to(end)).explains();
            (second.label != first.label && is_first).then(|| fit(sites, change, By::All, &|_| true))
        };
        singles.par_iter().filter_map(both).collect::<Vec<_>>()
    };
    farthest.iter().flat_map(seconds).collect()
}
