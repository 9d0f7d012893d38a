//! One request and its answer.

use crate::checks::checks;
use crate::equations::{EquationCells, cells};
use crate::html::{escaped, number, short, table};
use crate::numbers::{is_ad, numbers};
use crate::plot::plot;
use crate::points::{Found, find, points};
use crate::prediction::{Prediction, alike, predict, varied};
use crate::situation::words;
use crate::state::State;
use beamgap::check::{CaseData, CheckConfig, Comparison, Order, Verdict, test_source};
use beamgap::closest_point::ClosestPoint;
use beamgap::linearization::Quantity;
use beamgap::variant::{Variant, with_faults};
use serde::Serialize;
use std::cell::RefCell;
use std::fmt::Write;

/// Parts of the page, as HTML or SVG unless the field says otherwise.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Answer {
    /// The error in the request, as text. All other fields are then empty.
    pub error: Option<String>,
    /// The description of the configuration.
    pub words: String,
    /// The table of the closest points.
    pub points: String,
    /// The table of the checks.
    pub checks: String,
    /// What the checks say together.
    pub lesson: String,
    /// The table of the predictions.
    pub prediction: String,
    /// The plot of the errors of the predictions against the step.
    pub plot: String,
    /// The table of the quantities.
    pub numbers: String,
    /// The equations of the paper, as text; nothing if they were not requested.
    pub equations: Option<Vec<EquationCells>>,
    /// This case as a Rust test, as text.
    pub test: String,
    /// The command that checks this case, as text.
    pub command: String,
    /// This case as a file for `beamgap check --case-file`, as text.
    pub case: String,
    /// This case as a file for `beamgap verify`, as text.
    pub vectors: String,
}

/// Answers a request. Both are JSON; the request is a state.
pub fn answer(request: &str) -> String {
    let answer = State::read(request).and_then(|state| Answer::of(&state));
    let answer = answer.unwrap_or_else(|error| Answer { error: Some(error), ..Answer::default() });
    serde_json::to_string(&answer).unwrap_or_default()
}

impl Answer {
    /// Everything that the page shows for a state.
    ///
    /// # Errors
    /// The error in the state.
    pub fn of(state: &State) -> Result<Self, String> {
        let case = state.case()?;
        let variant = variant(state.fault.as_deref())?;
        let beams =
            case.test_beams.each_ref().map(|test_beam| test_beam.centroid().map_err(|e| e.to_string()));
        let [beam, bar] = beams;
        let (beam, bar) = (beam?, bar?);
        let centroids = [&*beam, &*bar];
        let (closest, found) = find(centroids, state.minimum)?;
        let found = found.as_ref();
        let mut answer = Self {
            points: points(&case, centroids, &closest, found.map(|found| found.minimum)),
            command: state.command(),
            case: state.case_file(),
            vectors: state.vectors(found.map(|found| &found.point)),
            ..Self::default()
        };
        let Some(found) = found else {
            answer.words = words(&case, centroids, &closest, None, None);
            answer.equations = state.equations.then(Vec::new);
            return Ok(answer);
        };
        let varied = varied(&case, state, found);
        let second = alike(&case, state).vary(&Variant::Unmodified, &found.point).ok().and_then(Result::ok);
        let second = second.map(|all| all[Quantity::GN.component()].second);
        answer.words = words(&case, centroids, &closest, Some(found), second);
        answer.equations = state.equations.then(|| cells(&case, &found.point));
        let prediction = predict(&case, state, &variant, found, varied.as_ref());
        if let Some(prediction) = &prediction {
            answer.predicted(prediction, state);
        }
        if let Some(verdict) = verdict(&case, variant, found)? {
            answer.compared(&case, found, &verdict, prediction.as_ref(), state);
        }
        Ok(answer)
    }

    fn predicted(&mut self, prediction: &Prediction, state: &State) {
        let direction = if state.along_linear { "Δq" } else { "δq" };
        self.plot = plot(prediction, direction);
        let mut rows = String::new();
        let [gap, first, second] = prediction.derivatives;
        let mut row = |name: &str, value: f64, error: Option<f64>| {
            let error = error.map(short).unwrap_or_default();
            let _ = writeln!(
                rows,
                "<tr><th scope=\"row\">{name}</th><td>{}</td><td>{error}</td></tr>",
                number(value)
            );
        };
        row("g<sub>N</sub>", gap, None);
        row("first variation along the direction", first, None);
        row("second variation along the direction", second, None);
        if let Some(sample) = &prediction.here {
            let [of_first, of_second] = sample.errors();
            row(&format!("true gap at step {}", sample.step), sample.gap, None);
            row("first-order prediction", sample.predicted[0], Some(of_first));
            row("second-order prediction", sample.predicted[1], Some(of_second));
        }
        self.prediction = table("prediction", &["gap", "value", "error"], &rows);
    }

    fn compared(
        &mut self,
        case: &CaseData,
        found: &Found,
        verdict: &Verdict,
        prediction: Option<&Prediction>,
        state: &State,
    ) {
        let entries = verdict.entries();
        (self.checks, self.lesson) = checks(&found.point, verdict, prediction, state.fault.as_deref());
        if entries.is_empty() {
            return;
        }
        self.numbers = numbers(entries);
        if let Some(entry) = to_test(entries) {
            self.test = test_source(case, found.minimum, entry, None);
        }
    }
}

/// The number that the test checks: the first that differs from AD, or the second variation of d.
fn to_test(entries: &[Comparison]) -> Option<&Comparison> {
    let wrong = entries.iter().filter(|entry| is_ad(entry)).find(|entry| entry.is_wrong());
    let second =
        |entry: &&Comparison| is_ad(entry) && entry.quantity == Quantity::D && entry.order == Order::Second;
    wrong.or_else(|| entries.iter().find(second))
}

/// The comparison of the closed form with its references at the closest point.
fn verdict(case: &CaseData, variant: Variant, found: &Found) -> Result<Option<Verdict>, String> {
    let config = CheckConfig { variant, ..CheckConfig::default() };
    let compared = case.compare(&config).map_err(|error| error.to_string())?;
    let near = |point: &ClosestPoint| point == &found.point;
    Ok(compared.into_iter().find(|(point, _)| point.as_ref().is_some_and(near)).map(|(_, verdict)| verdict))
}

/// The closed form with the fault of this name. The last one is cached, because the lookup is slow.
pub(crate) fn variant(fault: Option<&str>) -> Result<Variant, String> {
    thread_local! {
        static LAST: RefCell<Option<(String, Variant)>> = const { RefCell::new(None) };
    }
    let Some(fault) = fault else { return Ok(Variant::Unmodified) };
    let known = LAST.with_borrow(|last| {
        last.as_ref().filter(|(name, _)| name == fault).map(|(_, variant)| variant.clone())
    });
    if let Some(variant) = known {
        return Ok(variant);
    }
    let found = with_faults(&[fault.to_owned()]).map_err(|error| escaped(&error.to_string()))?;
    LAST.with_borrow_mut(|last| *last = Some((fault.to_owned(), found.clone())));
    Ok(found)
}
