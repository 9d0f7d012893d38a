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
const SHOWN: [usize; 3] = [30, 100, ITERATIONS];
const POWERS: [f64; 2] = [-13.0, 2.0];
/// The maximum number of iterations: a slow method is told from one that is ruined.
const ITERATIONS: usize = 300;
/// The pieces of a drawn beam.
const PIECES: u32 = 24;

type Q = DofVector<f64, 12, 12>;

/// The squarings of a matrix that give its spectral radius.
const SQUARINGS: u8 = 12;

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
        let one = Problem { push: 0.0, iterations: 1, ..problem.clone() };
        let mut states = vec![q];
        for _ in 0..found.iterations() {
            q = one.step(q, tangent).q;
            states.push(q);
        }
        Some(Self { tangent: name.to_owned(), push, found, states })
    }

    /// The factor of the residual in one iteration, in the mean of the second half of a run that converges.
    fn factor(&self) -> Option<f64> {
        let all = &self.found.iterates;
        let (half, last) = (all.get(all.len() / 2)?, all.last()?);
        let count = count(all.len() - 1 - all.len() / 2);
        (count > 1.0 && self.found.converged()).then(|| (last.residual / half.residual).powf(1.0 / count))
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

/// The largest absolute value of the eigenvalues of B^-1 (B - A) at the solution with this push, where A is the exact tangent and
/// B is the tangent with this name. The page states it, and its module does not contain it.
///
/// It is the limit of the n-th root of the size of the n-th power.
pub fn spectral_radius(name: &str, push: f64) -> Option<f64> {
    let problem = Problem { push, ..Problem::default() };
    let q = problem.solve(Tangent::Exact).q;
    let pair = problem.pair();
    let point = *pair.closest_points(&q).ok()?.interior().ok()?;
    let system = |of: Tangent| problem.system(&pair, &q, &point, of).1;
    let (exact, wrong) = (system(Tangent::Exact), system(tangent(name)?));
    let mut power = wrong.lu().solve(&(wrong - exact))?;
    let (mut radius, mut exponent) = (1.0, 1.0);
    for _ in 0..SQUARINGS {
        let size = power.norm();
        if size < 1e-200 {
            return Some(0.0);
        }
        radius *= size.powf(exponent);
        power /= size;
        power *= power;
        exponent *= 0.5;
    }
    Some(radius * power.norm().powf(exponent))
}

/// The last iteration of the plot: all iterations of both runs are in it.
fn last(exact: &Run, wrong: &Run) -> usize {
    let count = exact.found.iterations().max(wrong.found.iterations());
    SHOWN.into_iter().find(|shown| count <= *shown).unwrap_or(ITERATIONS)
}

/// The pixels between two iterations.
fn way(last: usize) -> f64 {
    (PLOT[1] - PLOT[0]) / count(last)
}

fn up(residual: f64) -> f64 {
    let power = residual.max(1e-30).log10().clamp(POWERS[0], POWERS[1]);
    PLOT[3] - (PLOT[3] - PLOT[2]) * (power - POWERS[0]) / (POWERS[1] - POWERS[0])
}

fn count(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

impl Race {
    /// The runs with the exact tangent and with the chosen one.
    fn runs(&self) -> Result<[Run; 2], String> {
        let push = if self.push.is_finite() { self.push.clamp(0.1, 1.2) } else { 0.8 };
        let exact = Run::cached("exact", push).ok_or("no run")?;
        let wrong = Run::cached(&self.tangent, push).ok_or("no tangent has this name")?;
        Ok([exact, wrong])
    }
}

impl Scene for Race {
    fn drag(&mut self, handle: &str, to: [f64; 2]) {
        if handle == "iteration" {
            let Ok([exact, wrong]) = self.runs() else { return };
            let last = last(&exact, &wrong);
            let iteration = ((to[0] - PLOT[0]) / way(last)).round();
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 300")]
            let iteration = iteration.clamp(0.0, count(last)) as usize;
            self.iteration = iteration;
        }
    }

    fn choose(&mut self, name: &str, value: &str) {
        match name {
            "tangent" if tangent(value).is_some() => value.clone_into(&mut self.tangent),
            "iteration" => self.iteration = value.parse().unwrap_or(self.iteration),
            "push" => {
                if let Ok(push) = value.parse::<f64>() {
                    self.push = rounded(push.clamp(0.1, 1.2));
                }
            }
            _ => {}
        }
    }

    fn frame(&self) -> Result<Frame, String> {
        let [exact, wrong] = self.runs()?;
        let last = last(&exact, &wrong);
        let across = |iteration: usize| PLOT[0] + way(last) * count(iteration);
        let mut frame = Frame::default();
        for (curve, dots, run) in [("exact", "exact_dots", &exact), ("wrong", "wrong_dots", &wrong)] {
            let residuals = run.found.iterates.iter().map(|iterate| iterate.residual);
            let places: Vec<[f64; 2]> =
                residuals.enumerate().map(|(i, residual)| [across(i), up(residual)]).collect();
            // A dot is a line of length zero with round ends.
            let data: String = places.iter().map(|&place| line([place, place])).collect();
            frame.line(curve, places);
            frame.paths.insert(dots.into(), data);
        }
        let shown = self.iteration.min(last);
        frame.place("iteration", [across(shown), PLOT[3]]);
        frame.line("here", [[across(shown), PLOT[2]], [across(shown), PLOT[3]]]);
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
        let count = wrong.found.iterations().to_string();
        frame.text("wrong_count", if wrong.found.converged() { count } else { "stops".to_owned() });
        frame.text("shown", shown.to_string());
        frame.text("push", exact.push.to_string());
        for (name, run) in [("gap_exact", &exact), ("gap", &wrong)] {
            let gap = run.found.iterates.get(shown).or(run.found.iterates.last());
            frame.text(name, gap.map_or_else(|| "–".to_owned(), |iterate| number(iterate.gap)));
        }
        frame.text("factor", wrong.factor().map_or_else(|| "–".to_owned(), |factor| format!("{factor:.2}")));
        frame.text("last", last.to_string());
        frame.controls.insert("iteration_max".into(), last.to_string());
        frame.controls.insert("iteration_way".into(), way(last).to_string());
        frame.controls.insert("iteration".into(), shown.to_string());
        frame.controls.insert("push".into(), exact.push.to_string());
        frame.controls.insert("tangent".into(), self.tangent.clone());
        Ok(frame)
    }
}

/// A residual as a power of ten.
fn power(x: f64) -> String {
    format!("{x:.1e}").replace('-', "−")
}
