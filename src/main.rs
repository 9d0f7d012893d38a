//! The command line.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    match cli::run() {
        Ok(exit) => exit,
        Err(error) => cli::tell(&error),
    }
    .into()
}
