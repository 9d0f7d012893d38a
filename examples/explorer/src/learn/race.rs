//! Scene 6: Newton's method with the exact tangent and with a wrong one.

use super::camera::Camera;
use super::{Scene, rounded};
use crate::frame::{Frame, line, number};
use beamgap::curve::{Curve, Hermite};
use beamgap::number::{Formula, Label};
use beamgap::pair::DofVector;
use beamgap::teaching::{Equilibrium, Problem, Tangent};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;

/// The frame of the plot, the iterations that it shows, and its powers of ten.
const PLOT: [f64; 4] = [52.0, 344.0, 16.0, 270.0];
const SHOWN: u8 = 30;
const POWERS: [f64; 2] = [-13.0, 2.0];
/// The maximum number of iterations: a slow method is told from one that is ruined.
const ITERATIONS: usize = 100;
/// The pieces of a drawn beam.
const PIECES: u32 = 24;

type Q = DofVector<f64, 12, 12>;

/// The tangent, how far the beams are pushed, and the iteration that is shown.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Race {
    tangent: String,
    push: f64,
    iteration: usize,
}

impl Default for Race {
    fn default() -> Self {
        Self { tangent: "no_curvature".to_owned(), push: 0.8, iteration: 3 }
    }
}

/// The tangents, by the names of their buttons.
fn tangent(name: &str) -> Option<Tangent> {
    Some(match name {
        "exact" => Tangent::Exact,
        "no_curvature" => Tangent::NoCurvature,
        "frozen" => Tangent::FrozenProjection,
        "sign_b" => Tangent::WrongSign,
        "sign_right" => Tangent::Term(Label::of_beam(Formula::Xi, "b R_bar"), -1.0),
        "sign_a" => Tangent::Term(Label::of_beam(Formula::HessianD, "a gg'"), -1.0),
        "no_normal" => Tangent::Term(Label::of_beam(Formula::HessianD, "G'nn'G"), 0.0),
        "sign_curvature" => Tangent::Term(Label::of_beam(Formula::A, "d.t,xi"), -1.0),
        _ => return None,
    })
}

/// A run and its states, one for each iterate.
#[derive(Clone, Debug)]
struct Run {
    tangent: String,
    push: f64,
    found: Equilibrium,
    states: Vec<Q>,
}

impl Run {
    fn new(name: &str, push: f64) -> Option<Self> {
        let tangent = tangent(name)?;
        let problem = Problem { push, iterations: ITERATIONS, ..Problem::default() };
        let mut q = problem.start();
        for _ in 1..problem.steps {
            q = problem.step(q, Tangent::Exact).q;
        }
        let found = problem.step(q, tangent);
        // The states between, each by one iteration from the state before.
        q.bar[2] -= push / 8.0;
        let one = Problem { push: 0.0, iterations: 1, ..problem };
        let mut states = vec![q];
        for _ in 0..found.iterations() {
            q = one.step(q, tangent).q;
            states.push(q);
        }
        Some(Self { tangent: name.to_owned(), push, found, states })
    }

    /// The run, computed once for each tangent and push.
    fn cached(name: &str, push: f64) -> Option<Self> {
        thread_local! {
            static RUNS: RefCell<Vec<Run>> = const { RefCell::new(Vec::new()) };
        }
        RUNS.with_borrow_mut(|runs| {
            if let Some(run) =
                runs.iter().find(|run| run.tangent == name && run.push.to_bits() == push.to_bits())
            {
                return Some(run.clone());
            }
            let run = Self::new(name, push)?;
            if runs.len() > 20 {
                runs.clear();
            }
            runs.push(run.clone());
            Some(run)
        })
    }

    fn words(&self) -> String {
        let count = self.found.iterations();
        match &self.found.stopped {
            None => format!("{count} iterations"),
            Some(reason) => {
                let limit = format!(" after {count} iterations");
                format!("stops after {count} iterations: {}", reason.trim_end_matches(&limit))
            }
        }
    }
}

fn across(iteration: f64) -> f64 {
    PLOT[0] + (PLOT[1] - PLOT[0]) * iteration / f64::from(SHOWN)
}

fn up(residual: f64) -> f64 {
    let power = residual.max(1e-30).log10().clamp(POWERS[0], POWERS[1]);
    PLOT[3] - (PLOT[3] - PLOT[2]) * (power - POWERS[0]) / (POWERS[1] - POWERS[0])
}

fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

impl Scene for Race {
    fn drag(&mut self, handle: &str, to: [f64; 2]) {
        if handle == "iteration" {
            let iteration = (to[0] - PLOT[0]) / (PLOT[1] - PLOT[0]) * f64::from(SHOWN);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 30")]
            let iteration = iteration.round().clamp(0.0, f64::from(SHOWN)) as usize;
            self.iteration = iteration;
        }
    }

    fn choose(&mut self, name: &str, value: &str) {
        match name {
            "tangent" if tangent(value).is_some() => value.clone_into(&mut self.tangent),
            "push" => {
                if let Ok(push) = value.parse::<f64>() {
                    self.push = rounded(push.clamp(0.1, 1.2));
                }
            }
            _ => {}
        }
    }

    fn frame(&self) -> Result<Frame, String> {
        let push = if self.push.is_finite() { self.push.clamp(0.1, 1.2) } else { 0.8 };
        let exact = Run::cached("exact", push).ok_or("no run")?;
        let wrong = Run::cached(&self.tangent, push).ok_or("no tangent has this name")?;
        let mut frame = Frame::default();
        for (curve, dots, run) in [("exact", "exact_dots", &exact), ("wrong", "wrong_dots", &wrong)] {
            let residuals = run.found.iterates.iter().map(|iterate| iterate.residual);
            let places: Vec<[f64; 2]> = residuals
                .enumerate()
                .take(usize::from(SHOWN) + 1)
                .map(|(i, residual)| [across(count(i)), up(residual)])
                .collect();
            // A dot is a line of length zero with round ends.
            let data: String = places.iter().map(|&place| line([place, place])).collect();
            frame.line(curve, places);
            frame.paths.insert(dots.into(), data);
        }
        let shown = self.iteration.min(usize::from(SHOWN));
        frame.place("iteration", [across(count(shown)), PLOT[3]]);
        frame.line("here", [[across(count(shown)), PLOT[2]], [across(count(shown)), PLOT[3]]]);
        let camera = Camera::new([-0.2, 1.0, -1.1], 96.0, [170.0, 175.0]);
        for (run, names) in [(&exact, ["exact_beam", "exact_bar"]), (&wrong, ["wrong_beam", "wrong_bar"])] {
            let q = &run.states[shown.min(run.states.len().saturating_sub(1))];
            let drawn = |q| {
                let at = |i: u32| {
                    let xi = 2.0 * f64::from(i) / f64::from(PIECES) - 1.0;
                    camera.at(&Hermite::new().jet::<f64>(q, xi).geometry.x).map(|x| x.clamp(-999.0, 999.0))
                };
                (0..=PIECES).map(at).collect::<Vec<_>>()
            };
            let lines = [drawn(&q.beam), drawn(&q.bar)];
            if names[0] == "exact_beam" {
                frame.place("clamp", lines[0][0]);
                frame.place("clamp_bar", lines[1][0]);
            }
            for (name, points) in names.into_iter().zip(lines) {
                frame.line(name, points);
            }
        }
        let residual = |run: &Run| {
            run.found.iterates.get(shown).map_or_else(|| "–".to_owned(), |iterate| power(iterate.residual))
        };
        frame.text("exact_residual", residual(&exact));
        frame.text("wrong_residual", residual(&wrong));
        frame.text("exact_words", exact.words());
        frame.text("wrong_words", wrong.words());
        frame.text("shown", shown.to_string());
        frame.number("push", push);
        let gap = wrong.found.iterates.get(shown).or(wrong.found.iterates.last());
        frame.text("gap", gap.map_or_else(|| "–".to_owned(), |iterate| number(iterate.gap)));
        frame.controls.insert("iteration".into(), shown.to_string());
        frame.controls.insert("push".into(), push.to_string());
        frame.controls.insert("tangent".into(), self.tangent.clone());
        Ok(frame)
    }
}

/// A residual as a power of ten.
fn power(x: f64) -> String {
    format!("{x:.1e}").replace('-', "−")
}
