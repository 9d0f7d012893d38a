//! How far the work is, on stderr, if someone is watching.

use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::time::Duration;

/// A line on stderr that is gone in the end; nothing if stderr is no terminal.
pub(super) struct Progress(ProgressBar);

impl Progress {
    /// What is being done, with the time since its start.
    pub(super) fn of(what: &'static str) -> Self {
        let bar = Self::shown(ProgressBar::new_spinner(), "{spinner} {msg}, {elapsed}");
        bar.set_message(what);
        bar.enable_steady_tick(Duration::from_millis(120));
        Self(bar)
    }

    /// How many of so many things are done.
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

    /// Something else is being done now.
    pub(super) fn now(&self, what: &'static str) {
        self.0.set_message(what);
    }

    /// One more is done.
    pub(super) fn step(&self) {
        self.0.inc(1);
    }

    /// The work is done.
    pub(super) fn end(self) {
        self.0.finish_and_clear();
    }
}
