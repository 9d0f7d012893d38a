//! What the public functions return, as components of the quantities.

/// Components of the quantities, each with value, first variations and second variation, as far as they are computed.
pub(crate) type Answers = Vec<(usize, [Option<f64>; 4])>;

/// What a public function returns.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Returned {
    /// The function, with what it is compiled for.
    pub(crate) function: &'static str,
    pub(crate) answers: Answers,
}

impl Returned {
    pub(super) fn new(function: &'static str, answers: Answers) -> Self {
        Self { function, answers }
    }
}
