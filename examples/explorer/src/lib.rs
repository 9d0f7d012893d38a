//! The explorer: the input is a state, the output is everything that the page shows for it.
//!
//! [`learn`] answers at every frame: a state and an action in, a [`Frame`] of texts and paths out. It serves the picture of the
//! explorer and the scenes of `learn.html`. [`answer`] returns the tables of the explorer; the page asks for them at rest.
//!
//! Both are ordinary functions. The page calls them in WebAssembly. The tests call them natively and compare the answers byte
//! by byte. A state is JSON: both beams, the view, the fault.
//!
//! Data flow: state -> case -> closest points -> numbers, prediction, equations -> parts of the page.

mod answer;
mod checks;
mod draw;
mod equations;
mod explorer;
mod formulas;
mod frame;
mod handles;
mod html;
mod learn;
mod map;
mod numbers;
mod plot;
mod points;
mod prediction;
mod presets;
#[cfg(target_arch = "wasm32")]
mod shim;
mod situation;
mod state;
mod view;

pub use answer::{Answer, answer};
pub use equations::{EquationCells, cells};
pub use explorer::{Label, hull, placed};
pub use formulas::{Formula, Piece, Term, formulas};
pub use frame::Frame;
pub use learn::{Hidden, SCENES, asymmetry, frozen_part, hidden, learn, opening, spectral_radius};
pub use presets::preset;
pub use state::{BeamState, ContactState, Dragged, Shown, State, ViewState};
