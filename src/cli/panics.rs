//! Converts a panic, in any thread, to one line and an exit code.

use std::panic::{AssertUnwindSafe, catch_unwind, set_hook};
use std::sync::{Arc, OnceLock};

/// An internal error of the program.
#[derive(Debug, thiserror::Error)]
#[error("internal error, please report it: {0}")]
pub(crate) struct Panic(String);

/// Runs `work` and converts panics to errors.
pub(crate) fn caught<T>(work: impl FnOnce() -> anyhow::Result<T>) -> anyhow::Result<T> {
    // The hook knows the source location, the payload does not. If several threads panic, the first panic is reported.
    let first = Arc::new(OnceLock::new());
    let seen = Arc::clone(&first);
    set_hook(Box::new(move |panic| {
        let place = panic.location().map(|at| format!(" ({}:{})", at.file(), at.line()));
        let payload = panic.payload();
        let message = payload.downcast_ref::<String>().map(String::as_str);
        let message = message.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("panic");
        let message = message.replace('\n', " ");
        let _ = seen.set(message + &place.unwrap_or_default());
    }));
    let result = catch_unwind(AssertUnwindSafe(work));
    let _ = std::panic::take_hook();
    result.unwrap_or_else(|_| Err(Panic(first.get().cloned().unwrap_or_default()).into()))
}

#[cfg(test)]
mod tests {
    use super::caught;
    use crate::cli::{exit::Exit, tell};
    use rayon::prelude::*;

    #[test]
    fn a_panic_of_a_worker_is_one_line_and_an_exit_code() {
        let work = || {
            (0..100).into_par_iter().for_each(|i| assert!(i != 17, "no\nluck"));
            Ok(())
        };
        let error = caught(work).unwrap_err();
        let line = error.to_string();
        assert!(line.contains("no luck (src/cli/panics.rs:") && !line.contains('\n'), "{line}");
        assert_eq!(tell(&error), Exit::Internal);
    }
}
