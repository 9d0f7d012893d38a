//! The explorer: a state in, all that the page shows of it out.
//!
//! [`answer`] is an ordinary function. The page calls it in WebAssembly; the tests call it natively and compare the two
//! byte by byte. A state is JSON: both beams, the view, the fault. The answer is JSON of pieces of the page.
//!
//! Data flow: state -> case -> closest points -> numbers, prediction, equations -> pieces of the page.

mod answer;
mod checks;
mod draw;
mod equations;
mod handles;
mod html;
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
pub use presets::preset;
pub use state::{BeamState, ContactState, Dragged, State, ViewState};
