//! Progress on stderr, if it is a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::time::Duration;

/// A progress line on stderr, cleared at the end; nothing if stderr is not a terminal.
pub(super) struct Progress(ProgressBar);

impl Progress {
    /// Shows the current task, with the time since its start.
    pub(super) fn of(what: &'static str) -> Self {
        let bar = Self::shown(ProgressBar::new_spinner(), "{spinner} {msg}, {elapsed}");
        bar.set_message(what);
        bar.enable_steady_tick(Duration::from_millis(120));
        Self(bar)
    }

    /// Shows the number of finished items out of `count`.
    pub(super) fn bar(what: &'static str, count: u64) -> Self {
        let bar = Self::shown(ProgressBar::new(count), "{wide_bar} {pos}/{len} {msg}, {eta} left");
        bar.set_message(what);
        Self(bar)
    }

    fn shown(bar: ProgressBar, template: &str) -> ProgressBar {
        if !std::io::stderr().is_terminal() {
            return ProgressBar::hidden();
        }
        match ProgressStyle::with_template(template) {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        }
    }

    /// Shows the current stage of `count` stages, with the time since the start.
    pub(super) fn stages(count: usize) -> Self {
        let bar = Self::shown(ProgressBar::new(count as u64), "{wide_bar} {pos}/{len} {msg}, {elapsed}");
        bar.enable_steady_tick(Duration::from_millis(120));
        Self(bar)
    }

    /// Runs a stage of this name.
    pub(super) fn stage<R>(&self, what: &'static str, run: impl FnOnce() -> R) -> R {
        self.0.set_message(what);
        let result = run();
        self.0.inc(1);
        result
    }

    /// Counts one finished item.
    pub(super) fn step(&self) {
        self.0.inc(1);
    }

    /// Clears the line.
    pub(super) fn end(self) {
        self.0.finish_and_clear();
    }
}
