//! Runs of a code: counted, recorded, or with a fault in one operation or in some terms.

use super::Bits;
use crate::number::Label;
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// The change of the result of an operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Change {
    /// It is multiplied.
    Times(f64),
    /// One is added, so that a result of zero changes too.
    PlusOne,
    /// It is replaced by another result, given by its bits.
    Instead(u64),
    /// It keeps its value, and is marked.
    Marked,
}

impl Change {
    /// The changed result.
    pub(crate) fn of<T: Bits>(self, result: T) -> T {
        match self {
            Self::Times(factor) => result * T::from(factor),
            Self::PlusOne => result + T::one(),
            Self::Instead(bits) => T::from_bits(bits),
            Self::Marked => result.marked(),
        }
    }
}

/// The change of the terms of one name.
#[derive(Clone, Debug)]
pub(crate) enum TermChange {
    /// They are multiplied.
    Times(f64),
    /// They are replaced by those of a recorded run.
    Instead(Rc<[u64]>),
    /// The orders of the two Jacobians are exchanged.
    Orders,
}

/// The purpose of a run.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Mode {
    /// Operations are counted, and one of them may have a fault.
    Count,
    /// Their results are recorded.
    RecordOperations,
    /// The values of terms are recorded.
    RecordTerms,
    /// The callers of the operation with the fault are recorded.
    Locate,
}

/// What every operation reads, in one place: it is found once per operation.
pub(super) struct State {
    pub(super) count: Cell<usize>,
    /// The index of the operation with the fault.
    pub(super) wrong: Cell<usize>,
    pub(super) mode: Cell<Mode>,
}

/// What happens to the result of an operation.
pub(super) enum Next {
    Unchanged,
    Recorded,
    Wrong,
}

impl State {
    /// Counts an operation.
    #[inline(always)]
    pub(super) fn next(&self) -> Next {
        let count = self.count.get();
        self.count.set(count + 1);
        if count == self.wrong.get() {
            Next::Wrong
        } else if self.mode.get() == Mode::RecordOperations {
            Next::Recorded
        } else {
            Next::Unchanged
        }
    }
}

thread_local! {
    pub(super) static STATE: State =
        const { State { count: Cell::new(0), wrong: Cell::new(usize::MAX), mode: Cell::new(Mode::Count) } };
    pub(super) static CHANGE: Cell<Change> = const { Cell::new(Change::PlusOne) };
    pub(super) static RECORD: RefCell<Vec<u64>> = const { RefCell::new(Vec::new()) };
    pub(super) static TRACE: RefCell<String> = const { RefCell::new(String::new()) };
    pub(super) static LABELS: RefCell<Vec<Label>> = const { RefCell::new(Vec::new()) };
    /// The number of terms so far.
    pub(super) static TERMS: Cell<usize> = const { Cell::new(0) };
    pub(super) static CHANGES: RefCell<Vec<(Label, TermChange)>> = const { RefCell::new(Vec::new()) };
}

/// Ends a run, even if it panics.
struct Run;

impl Run {
    fn start() -> Self {
        STATE.with(|state| state.count.set(0));
        TERMS.set(0);
        Self
    }
}

impl Drop for Run {
    fn drop(&mut self) {
        STATE.with(|state| {
            state.wrong.set(usize::MAX);
            state.mode.set(Mode::Count);
        });
        CHANGES.take();
    }
}

/// The result of a run and the number of its operations.
pub(crate) fn counted<R>(run: impl FnOnce() -> R) -> (R, usize) {
    let _run = Run::start();
    let result = run();
    (result, STATE.with(|state| state.count.get()))
}

/// The results of all operations of a run.
pub(crate) fn operations<R>(run: impl FnOnce() -> R) -> Vec<u64> {
    recorded(Mode::RecordOperations, Vec::new(), run).2
}

/// The names and the values of all terms of a run.
pub(crate) fn terms<R>(run: impl FnOnce() -> R) -> (Vec<Label>, Vec<u64>) {
    let (_, labels, values) = terms_with(Vec::new(), run);
    (labels, values)
}

/// A run with faults in some terms: its result, and the names and the values of all terms, with their faults.
pub(crate) fn terms_with<R>(
    changes: Vec<(Label, TermChange)>,
    run: impl FnOnce() -> R,
) -> (R, Vec<Label>, Vec<u64>) {
    recorded(Mode::RecordTerms, changes, run)
}

fn recorded<R>(
    mode: Mode,
    changes: Vec<(Label, TermChange)>,
    run: impl FnOnce() -> R,
) -> (R, Vec<Label>, Vec<u64>) {
    let _run = Run::start();
    drop((RECORD.take(), LABELS.take()));
    CHANGES.set(changes);
    STATE.with(|state| state.mode.set(mode));
    (run(), LABELS.take(), RECORD.take())
}

/// A run with a fault in one operation.
pub(crate) fn with_operation<R>(wrong: usize, change: Change, run: impl FnOnce() -> R) -> R {
    let _run = Run::start();
    STATE.with(|state| state.wrong.set(wrong));
    CHANGE.set(change);
    run()
}

/// A run with faults in some terms.
pub(crate) fn with_terms<R>(changes: Vec<(Label, TermChange)>, run: impl FnOnce() -> R) -> R {
    let _run = Run::start();
    CHANGES.set(changes);
    run()
}

/// The source lines that an operation belongs to, innermost first, as far as the debug information has them, and the
/// first named term that follows it. Paths start at `src` for this library and at the working directory for others.
pub(crate) fn locate<R>(operation: usize, run: impl FnOnce() -> R) -> (Vec<String>, Option<Label>) {
    let _run = Run::start();
    STATE.with(|state| {
        state.wrong.set(operation);
        state.mode.set(Mode::Locate);
    });
    CHANGE.set(Change::PlusOne);
    LABELS.take();
    drop(run());
    let (trace, labels) = (TRACE.take(), LABELS.take());
    let lines = trace.lines().filter_map(|line| line.trim().strip_prefix("at ./"));
    let lines = lines.map(|line| line.strip_prefix("src/").unwrap_or(line));
    let outside = |line: &&str| !line.starts_with("number/") && !line.starts_with("faults/");
    let lines = lines
        .filter(outside)
        .map(|line| line.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches(':').to_owned());
    (lines.collect(), labels.first().copied())
}
