//! The scenes of `reports/learn.html`: a state and an action of the reader in, the frame to draw out.
//!
//! Every number and every place in a picture is computed here. The script of the page sets attributes and texts of existing
//! elements. A frame depends on the state alone, so a test can ask for the same frame natively.

mod camera;
mod detective;
mod envelope;
mod friction;
mod lines;
mod normal;
mod pair;
mod race;
mod slide;
mod valley;

pub use detective::{Hidden, hidden};
pub use envelope::frozen_part;
pub use friction::asymmetry;
pub use race::spectral_radius;

use crate::frame::Frame;
use crate::state::State;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The names of the scenes in the order of the page.
pub const SCENES: [&str; 8] =
    ["valley", "normal", "slide", "lines", "envelope", "race", "detective", "friction"];

/// What the reader does.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum Action {
    /// A handle is moved to a place of its picture.
    Drag { handle: String, to: [f64; 2] },
    /// A handle is moved away from the eye, by this part of the unit of length.
    Push { handle: String, by: f64 },
    /// A control gets a value.
    Choose { name: String, value: String },
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    scene: String,
    #[serde(default)]
    state: Option<Value>,
    #[serde(default)]
    action: Option<Action>,
    #[serde(default)]
    part: Option<Part>,
}

/// What a frame has beside the picture, if it does not have all: frames in a row take turns, so that each takes less time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Part {
    /// The map.
    Map,
    /// Formulas and numbers.
    Texts,
}

/// A scene: its state, and the picture of it.
pub(crate) trait Scene: Default + Serialize + DeserializeOwned {
    /// Moves a handle. A handle that does not exist is ignored.
    fn drag(&mut self, handle: &str, to: [f64; 2]);

    /// Moves a handle away from the eye.
    fn push(&mut self, _handle: &str, _by: f64) {}

    /// Sets a control. A value that does not exist is ignored.
    fn choose(&mut self, _name: &str, _value: &str) {}

    /// Reads a state.
    fn read(state: Value) -> Result<Self, String> {
        serde_json::from_value(state).map_err(|error| error.to_string())
    }

    /// The state as JSON.
    fn written(&self) -> Result<Value, String> {
        serde_json::to_value(self).map_err(|error| error.to_string())
    }

    /// The frame.
    fn frame(&self) -> Result<Frame, String>;

    /// A part of the frame.
    fn part(&self, _part: Part) -> Result<Frame, String> {
        self.frame()
    }
}

/// Answers a request of a scene, or of the explorer. Both are JSON; without a state it is the state in which the page opens.
pub fn learn(request: &str) -> String {
    let frame = serde_json::from_str(request).map_err(|error| error.to_string()).and_then(answer);
    let frame = frame.unwrap_or_else(|error| Frame { error: Some(error), ..Frame::default() });
    serde_json::to_string(&frame).unwrap_or_default()
}

/// The frame of a scene as the page opens.
///
/// # Errors
/// If there is no such scene.
pub fn opening(scene: &str) -> Result<Frame, String> {
    answer(Request { scene: scene.to_owned(), state: None, action: None, part: None })
}

fn answer(request: Request) -> Result<Frame, String> {
    match request.scene.as_str() {
        "valley" => run::<valley::Valley>(request),
        "normal" => run::<normal::Normal>(request),
        "slide" => run::<slide::Slide>(request),
        "lines" => run::<lines::Lines>(request),
        "envelope" => run::<envelope::Envelope>(request),
        "race" => run::<race::Race>(request),
        "detective" => run::<detective::Detective>(request),
        "friction" => run::<friction::Friction>(request),
        "explorer" => run::<State>(request),
        unknown => Err(format!("no scene is called {unknown:?}")),
    }
}

fn run<S: Scene>(request: Request) -> Result<Frame, String> {
    let mut state = match request.state {
        Some(state) => S::read(state)?,
        None => S::default(),
    };
    match request.action {
        Some(Action::Drag { handle, to }) => state.drag(&handle, to),
        Some(Action::Push { handle, by }) => state.push(&handle, by),
        Some(Action::Choose { name, value }) => state.choose(&name, &value),
        None => {}
    }
    let mut frame = request.part.map_or_else(|| state.frame(), |part| state.part(part))?;
    frame.state = state.written()?;
    Ok(frame)
}

/// A number of a state, rounded, so that a state is short and the same on every machine.
fn rounded(x: f64) -> f64 {
    (x * 1e4).round() / 1e4
}
