//! Scene 7: a hidden error in the closed form, and what each check sees of it.

use super::camera::Camera;
use super::{Scene, rounded};
use crate::frame::Frame;
use crate::html::{Outcome, number};
use crate::numbers::{is_ad, outcome};
use crate::state::BeamState;
use beamgap::check::{CaseData, CheckConfig, Comparison, Oracles, Order, Verdict, likely_cause};
use beamgap::closest_point::{Held, refine};
use beamgap::linearization::{Quantity, Varied};
use beamgap::nalgebra::Vector3;
use beamgap::variant::{Variant, with_faults};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The hidden errors: their names in the catalogue. The suspects of the page are in the same order.
const ERRORS: [&str; 6] = [
    "a: d.t,xi = dropped",
    "R: du,xi.d = dropped",
    "xi: b R_bar = sign",
    "Dd|t|: Dt.dt = dropped",
    "R2: Dd.dt = dropped",
    "Ddg_T: dt Dxi = dropped",
];
/// The order in which the page hides them.
const HIDDEN: [usize; 6] = [4, 0, 3, 1, 5, 2];
const VERDICTS: [&str; 6] = ["explain0", "explain1", "explain2", "explain3", "explain4", "explain5"];
/// Cases for the explanation, of the seed of the check.
const SEED: u64 = 0x5eed;
const CASES: u64 = 121;

const QUANTITIES: [Quantity; 5] = [Quantity::D, Quantity::Xi, Quantity::XiBar, Quantity::T, Quantity::GT];
const CHECKS: usize = 4;

/// Which error is hidden, what the reader has asked for, and how much the beam is bent.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Detective {
    case: usize,
    /// The checks that the reader has run.
    asked: [bool; CHECKS],
    suspect: Option<usize>,
    /// The height of the middle of the beam.
    bend: f64,
    /// Whether the handle is at rest; the checks run only then.
    rests: bool,
}

impl Default for Detective {
    fn default() -> Self {
        Self { case: 0, asked: [false; CHECKS], suspect: None, bend: -0.25, rests: true }
    }
}

/// An error of the page, with what `explain` says of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Hidden {
    /// The name in the catalogue.
    pub name: &'static str,
    /// The sentence of the explanation.
    pub explanation: String,
}

/// The hidden errors in the order of the suspects. Each is explained from the answers of the closed form with this error.
pub fn hidden() -> Vec<Hidden> {
    let explained = |name: &'static str| {
        let cause = with_faults(&[name.to_owned()])
            .ok()
            .and_then(|variant| likely_cause(&variant, SEED, &(0..CASES).collect::<Vec<_>>()))
            .and_then(|cause| cause.explanation.causes.into_iter().next());
        let explanation = cause.map_or_else(|| "no cause is named".to_owned(), |cause| cause.words);
        Hidden { name, explanation }
    };
    ERRORS.into_iter().map(explained).collect()
}

fn camera() -> Camera {
    Camera::usual(112.0, [172.0, 160.0])
}

impl Detective {
    fn error(&self) -> usize {
        HIDDEN[self.case % HIDDEN.len()]
    }

    fn case(&self) -> Result<CaseData, String> {
        let beam = |q: [f64; 9], dq: [f64; 9], linear_dq: [f64; 9]| BeamState {
            family: "quadratic".to_owned(),
            curve: BTreeMap::new(),
            q: q.to_vec(),
            dq: dq.to_vec(),
            linear_dq: linear_dq.to_vec(),
        };
        let z = 0.3 + self.bend.clamp(-0.5, 0.5);
        let beam_above = beam(
            [-1.15, -0.1, 0.3, 0.0, -0.1, z, 1.15, -0.1, 0.3],
            [0.2, -0.3, 0.1, 0.1, 0.4, -0.2, -0.3, 0.2, 0.3],
            [-0.1, 0.2, 0.3, 0.2, -0.3, 0.1, 0.3, 0.1, -0.2],
        );
        let beam_below = beam(
            [-0.5, -1.0, -0.75, 0.0, 0.05, -0.6, 0.45, 1.05, -0.7],
            [0.1, 0.2, -0.1, -0.2, 0.1, 0.3, 0.2, -0.1, 0.1],
            [0.3, -0.1, 0.2, 0.1, 0.2, -0.2, -0.2, 0.3, 0.1],
        );
        let test_beams = [beam_above.test_beam("beam")?, beam_below.test_beam("bar beam")?];
        Ok(CaseData {
            test_beams,
            contact: beamgap::pair::Contact { xi_0: -0.2, xi_bar_0: 0.1, ..Default::default() },
        })
    }
}

impl Scene for Detective {
    fn drag(&mut self, handle: &str, to: [f64; 2]) {
        if handle == "bend" {
            let camera = camera();
            let [_, zero] = camera.at(&Vector3::new(0.0, -0.1, 0.3));
            let [_, one] = camera.at(&Vector3::new(0.0, -0.1, 1.3));
            let bend = (to[1] - zero) / (one - zero);
            // A straight beam is easily found.
            self.bend = if bend.abs() < 0.06 { 0.0 } else { rounded(bend.clamp(-0.5, 0.5)) };
            self.rests = false;
        }
    }

    fn choose(&mut self, name: &str, value: &str) {
        let index = value.parse::<usize>().ok();
        match (name, index) {
            ("check", Some(check)) if check < CHECKS => self.asked[check] = true,
            ("suspect", Some(suspect)) if suspect < ERRORS.len() => self.suspect = Some(suspect),
            ("rest", _) => self.rests = true,
            ("next", _) => {
                *self = Self { case: (self.case + 1) % HIDDEN.len(), bend: self.bend, ..Self::default() };
            }
            _ => {}
        }
    }

    fn frame(&self) -> Result<Frame, String> {
        let case = self.case()?;
        let camera = camera();
        let mut frame = Frame::default();
        let [beam, bar] = case.test_beams.each_ref().map(|beam| beam.centroid().map_err(|e| e.to_string()));
        let (beam, bar) = (beam?, bar?);
        for (name, beam) in [("beam", &beam), ("bar", &bar)] {
            frame.line(name, super::pair::drawn(&camera, |xi| beam.geometry(xi)));
        }
        frame.place("bend", camera.at(&beam.geometry(0.0).x));
        let point = refine(&*beam, &*bar, (0.0, 0.0), Held::default()).map_err(|error| error.to_string())?;
        let [x, y] = [beam.geometry(point.xi).x, bar.geometry(point.xi_bar).x].map(|x| camera.at(&x));
        frame.line("d", [y, x]);
        frame.place("point", x);
        frame.place("point_bar", y);
        frame.number("bend_now", self.bend);
        frame.text("case", (self.case % HIDDEN.len() + 1).to_string());
        self.evidence(&mut frame, &case)?;
        self.judgement(&mut frame);
        Ok(frame)
    }
}

impl Detective {
    /// What the checks that were run say of each quantity. While the handle moves the table is empty.
    fn evidence(&self, frame: &mut Frame, case: &CaseData) -> Result<(), String> {
        let variant = with_faults(&[ERRORS[self.error()].to_owned()]).map_err(|error| error.to_string())?;
        let verdict = if self.rests && self.asked.contains(&true) { verdict(case, variant) } else { None };
        let entries = verdict.as_ref().map(Verdict::entries).unwrap_or_default();
        for (row, quantity) in QUANTITIES.into_iter().enumerate() {
            let of = |check: usize| {
                let pick = move |entry: &&Comparison| entry.quantity == quantity && is_of(check, entry);
                outcome(entries.iter().filter(pick))
            };
            for check in 0..CHECKS {
                let says = match (self.asked[check], self.rests) {
                    (false, _) => "?",
                    (true, false) => "…",
                    (true, true) => match of(check) {
                        Outcome::Agrees => "✓",
                        Outcome::Wrong => "✗",
                        Outcome::Unclear => "unclear",
                        Outcome::NotCompared => "–",
                    },
                };
                frame.text(format!("cell{row}{check}"), says);
            }
        }
        let by_ad = [self.asked[1], self.asked[2]];
        let first = verdict.as_ref().and_then(|verdict| first_wrong(verdict, by_ad));
        frame.text(
            "first",
            match (by_ad, first) {
                ([false, false], _) => {
                    "Run automatic differentiation to see the first wrong number.".to_owned()
                }
                _ if !self.rests => "The checks run when the handle rests.".to_owned(),
                (_, None) => "No number is wrong in the columns of AD that were run.".to_owned(),
                (_, Some((words, closed, other))) => {
                    format!("The first wrong number is {words}: {closed} instead of {other}.")
                }
            },
        );
        Ok(())
    }

    /// What the page says of the suspect.
    fn judgement(&self, frame: &mut Frame) {
        let is_right = self.suspect == Some(self.error());
        frame.text(
            "judgement",
            match self.suspect {
                None => "No term is named yet.",
                Some(_) if is_right => "This is the term.",
                Some(_) => "It is another term. The checks still say the same.",
            },
        );
        for (i, name) in VERDICTS.into_iter().enumerate() {
            frame.shown.insert(name.into(), is_right && self.error() == i);
        }
        frame.controls.insert("suspect".into(), self.suspect.map(|i| i.to_string()).unwrap_or_default());
    }
}

/// Whether an entry belongs to a check: symmetry, AD of first order, AD of second order, differences.
fn is_of(check: usize, entry: &Comparison) -> bool {
    match check {
        0 => entry.order == Order::Symmetry,
        1 => is_ad(entry) && entry.order == Order::First,
        2 => is_ad(entry) && entry.order == Order::Second,
        _ => entry.against.starts_with("differences"),
    }
}

/// The comparison at the closest point. The last one is kept, since several checks ask for it.
fn verdict(case: &CaseData, variant: Variant) -> Option<Verdict> {
    thread_local! {
        static LAST: RefCell<Option<(CaseData, Variant, Verdict)>> = const { RefCell::new(None) };
    }
    let known = LAST.with_borrow(|last| {
        last.as_ref()
            .filter(|(of, with, _)| of == case && *with == variant)
            .map(|(.., verdict)| verdict.clone())
    });
    if known.is_some() {
        return known;
    }
    let config = CheckConfig { variant: variant.clone(), oracles: Oracles::All };
    let compared = case.compare(&config).ok()?;
    let verdict = compared.into_iter().find(|(point, _)| point.is_some()).map(|(_, verdict)| verdict)?;
    LAST.with_borrow_mut(|last| *last = Some((case.clone(), variant, verdict.clone())));
    Some(verdict)
}

/// The first wrong number of first or second order by AD, in the order of evaluation: its name, its value and the right one.
fn first_wrong(verdict: &Verdict, by_ad: [bool; 2]) -> Option<(String, String, String)> {
    let Verdict::Mismatch(entries) = verdict else { return None };
    let rank = |entry: &Comparison| {
        let order = Order::ALL.into_iter().position(|order| order == entry.order);
        let quantity = [Quantity::Xi, Quantity::XiBar].contains(&entry.quantity);
        (order, !quantity)
    };
    let wrong = entries.iter().filter(|entry| {
        let is_run = (by_ad[0] && is_of(1, entry)) || (by_ad[1] && is_of(2, entry));
        entry.is_wrong() && is_run
    });
    let first = wrong.min_by_key(|entry| rank(entry))?;
    let part = Varied::<f64>::PARTS.iter().position(|part| *part == first.part)?;
    let letters = ["", "δ", "Δ", "Δδ"][part];
    let name = format!("{letters}{}", quantity(first.quantity));
    let [closed, other] = [first.closed, first.other].map(number);
    Some((name, closed, other))
}

fn quantity(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::D | Quantity::DVector => "d",
        Quantity::Xi => "ξ",
        Quantity::XiBar => "ξ̄",
        Quantity::T | Quantity::TVector => "t",
        Quantity::TBar | Quantity::TBarVector => "t̄",
        Quantity::GN => "g_N",
        Quantity::GT => "g_T",
        Quantity::GTBar => "ḡ_T",
        Quantity::X => "x",
        Quantity::XBar => "x̄",
        _ => "a quantity",
    }
}
