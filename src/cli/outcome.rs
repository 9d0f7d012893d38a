//! A result for continuous integration: a verdict, and one entry for each quantity or equation.

use super::exit::Exit;
use beamgap::check::external::{ExternalError, Place, ProcessError};
use beamgap::check::{Order, look_at};
use beamgap::equations::{named, places};
use beamgap::linearization::Quantity;

/// The verdict of a result.
#[derive(Clone, Debug)]
pub(super) struct Verdict {
    /// The exit code.
    pub(super) exit: Exit,
    /// One word for programs.
    pub(super) name: &'static str,
    /// One or more lines for people; the first begins with the verdict and a colon.
    pub(super) words: String,
    /// Whether the result is a success to look at: the first line says what was left out.
    pub(super) is_warning: bool,
}

impl Verdict {
    /// A verdict without a warning.
    pub(super) fn new(exit: Exit, name: &'static str, words: String) -> Self {
        Self { exit, name, words, is_warning: false }
    }

    /// The verdict with a warning as its first line, if it is a success.
    pub(super) fn warned(self, warning: Option<String>) -> Self {
        match warning {
            Some(warning) if self.exit == Exit::Agree => {
                let words = self.words.replacen("AGREE: ", "", 1);
                let mut letters = words.chars();
                let first: String = letters.next().into_iter().flat_map(char::to_uppercase).collect();
                let words = format!("AGREE, WITH A WARNING: {warning}\n{first}{}", letters.as_str());
                Self { words, is_warning: true, ..self }
            }
            _ => self,
        }
    }

    /// How a result is announced: a notice, a warning or an error.
    pub(super) fn level(&self) -> &'static str {
        match (self.exit, self.is_warning) {
            (Exit::Agree, false) => "notice",
            (Exit::Agree, true) => "warning",
            _ => "error",
        }
    }
}

/// A verdict with its entries.
#[derive(Debug)]
pub(super) struct Outcome {
    /// The command that was run.
    pub(super) command: &'static str,
    /// The verdict.
    pub(super) verdict: Verdict,
    /// One entry for each quantity or equation.
    pub(super) entries: Vec<Entry>,
}

/// The result for a quantity or an equation.
#[derive(Debug)]
pub(super) struct Entry {
    /// The group of the entry: an order, a layer.
    pub(super) group: String,
    /// The quantity or the equation.
    pub(super) name: String,
    /// Whether it agrees.
    pub(super) state: State,
    /// The result in a sentence.
    pub(super) message: String,
    /// The related line of the source.
    pub(super) source: Option<Source>,
}

/// Whether an entry agrees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum State {
    /// All that was compared agrees.
    Agrees,
    /// Something differs.
    Differs,
    /// Nothing was compared.
    NotCompared,
}

impl State {
    /// Differs if a number is wrong, and is not compared if there are no numbers.
    pub(super) fn of(numbers: u64, wrong: u64) -> Self {
        match (numbers, wrong) {
            (_, 1..) => Self::Differs,
            (0, _) => Self::NotCompared,
            _ => Self::Agrees,
        }
    }

    /// The name of the state.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Differs => "differs",
            Self::NotCompared => "not compared",
        }
    }
}

/// A line of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Source {
    /// The file.
    pub(super) file: String,
    /// The line, from 1.
    pub(super) line: usize,
}

impl Source {
    /// The line of an answer, if it is in a file.
    pub(super) fn of_answer(place: &Place) -> Option<Self> {
        let is_file = std::path::Path::new(&place.file).is_file();
        is_file.then(|| Self { file: place.file.clone(), line: place.line.max(1) })
    }

    /// The line that computes a part of a quantity in closed form.
    pub(super) fn of_formula(order: Order, quantity: Quantity) -> Self {
        let fallback = match order {
            Order::Matrix => "linearization/closed_form/matrices.rs",
            Order::Function => "linearization/closed_form/kernel.rs",
            _ => "linearization/quantities.rs",
        };
        // A formula of symmetry is that of the second variation.
        let of = if order == Order::Symmetry { Order::Second } else { order };
        let number = named(&look_at(of, quantity).replace("eq. ", "Eq. ")).first().copied();
        Self::of_equation(number).unwrap_or(Self { file: format!("src/{fallback}"), line: 1 })
    }

    /// The first line that computes an equation.
    pub(super) fn of_equation(number: Option<u8>) -> Option<Self> {
        let place = places().remove(&number?)?.into_iter().next()?;
        Some(Self { file: format!("src/{}", place.file), line: place.line })
    }
}

impl Verdict {
    /// This verdict and that on the search for closest points, if it differs from the independent search.
    pub(super) fn and_search(mut self, differs: Option<String>) -> Self {
        match (differs, self.exit) {
            (None, _) => self,
            (Some(words), Exit::Agree | Exit::Nothing) => {
                Self::new(Exit::Disagree, "disagree", format!("{words}\n{}", self.words))
            }
            (Some(words), _) => {
                self.words = format!("{}\n{words}", self.words);
                self
            }
        }
    }
}

impl Outcome {
    /// The entries in which something differs.
    pub(super) fn wrong(&self) -> impl Iterator<Item = &Entry> {
        self.entries.iter().filter(|entry| entry.state == State::Differs)
    }

    /// The outcome of a command that ended with an error, with the line of the text that has it.
    pub(super) fn failed(command: &'static str, error: &anyhow::Error) -> Self {
        let text = error.downcast_ref::<ProcessError>().and_then(|error| match error {
            ProcessError::Text { error, .. } => Some(error),
            _ => None,
        });
        let place = text.or_else(|| error.downcast_ref::<ExternalError>()).map(|error| &error.place);
        let message = format!("{error:#}");
        let entry = |place: &Place| Entry {
            group: "input".to_owned(),
            name: "text".to_owned(),
            state: State::Differs,
            message: message.clone(),
            source: Source::of_answer(place),
        };
        let entries = place.map(entry).into_iter().collect();
        let verdict = Verdict::new(Exit::Input, "error", format!("ERROR: {message}"));
        Self { command, verdict, entries }
    }

    /// Whether the exit code reports an error that no entry contains.
    pub(super) fn is_wrong_as_a_whole(&self) -> bool {
        self.verdict.exit != Exit::Agree && self.wrong().next().is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::{Source, State};
    use beamgap::check::Order;
    use beamgap::linearization::Quantity;
    use std::path::Path;

    #[test]
    fn a_formula_points_to_the_line_of_its_equation() {
        let line = |order, quantity| {
            let Source { file, line } = Source::of_formula(order, quantity);
            let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
            text.lines().nth(line - 1).unwrap().to_owned()
        };
        for (order, quantity, number) in [
            (Order::Second, Quantity::D, "(40)"),
            (Order::Symmetry, Quantity::D, "(40)"),
            (Order::First, Quantity::D, "(37)"),
            (Order::First, Quantity::Xi, "(50)"),
            (Order::Second, Quantity::T, "(42)"),
            (Order::Second, Quantity::GT, "(21)"),
        ] {
            let line = line(order, quantity);
            assert!(line.contains("Eq. ") && line.contains(number), "{order:?} {quantity:?}: {line}");
        }
        for order in Order::ALL {
            for quantity in Quantity::ALL {
                line(order, quantity);
            }
        }
    }

    #[test]
    fn what_is_not_compared_does_not_agree() {
        assert_eq!(State::of(0, 0), State::NotCompared);
        assert_eq!(State::of(3, 0), State::Agrees);
        assert_eq!((State::of(3, 1), State::of(0, 1)), (State::Differs, State::Differs));
    }
}
