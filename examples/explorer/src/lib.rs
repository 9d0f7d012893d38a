//! The explorer: the input is a state, the output is everything that the page shows for it.
//!
//! [`answer`] is an ordinary function. The page calls it in WebAssembly. The tests call it natively and compare the two
//! answers byte by byte. A state is JSON: both beams, the view, the fault. The answer is JSON of parts of the page.
//!
//! [`learn`] is the same for the scenes of `learn.html`.
//!
//! Data flow: state -> case -> closest points -> numbers, prediction, equations -> parts of the page.

mod answer;
mod checks;
mod draw;
mod equations;
mod handles;
mod html;
mod learn;
mod numbers;
mod plot;
mod points;
mod prediction;
mod presets;
mod scene;
#[cfg(target_arch = "wasm32")]
mod shim;
mod situation;
mod state;
mod view;

pub use answer::{Answer, answer};
pub use equations::{EquationCells, cells};
pub use learn::{Frame, Hidden, SCENES, hidden, learn, opening};
pub use presets::preset;
pub use state::{BeamState, ContactState, Dragged, State, ViewState};
