//! Why a program could not be checked to the end.

use crate::check::external::conventions::Conventions;
use crate::check::external::error::ExternalError;
use crate::check::external::report::Report;
use std::process::ExitStatus;
use thiserror::Error;

/// Why a program could not be checked to the end.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ProcessError {
    /// The command line has an open quote, or is empty.
    #[error("a program, with its arguments, expected, found {0:?}")]
    Command(String),
    /// It cannot be started.
    #[error("cannot start {program}")]
    Start {
        /// The program.
        program: String,
        /// Why.
        source: std::io::Error,
    },
    /// It did not answer in time.
    #[error(
        "{program}: no answer within {seconds} s, after {answered} answers to {sent} cases; a program must write each \
         answer out (flush) before it waits for more than {look_ahead} further cases{stderr}"
    )]
    TimeOut {
        /// The program.
        program: String,
        /// The time that it had.
        seconds: f64,
        /// How many cases it had answered.
        answered: u64,
        /// How many it had been sent.
        sent: u64,
        /// How many it may be sent ahead of its answers.
        look_ahead: usize,
        /// The end of what it wrote to standard error.
        stderr: String,
    },
    /// It ended with an error.
    #[error("{program}: {status}, after {answered} answers{stderr}")]
    Failed {
        /// The program.
        program: String,
        /// Its exit status.
        status: ExitStatus,
        /// How many cases it had answered.
        answered: u64,
        /// The end of what it wrote to standard error.
        stderr: String,
        /// What was found of its answers.
        report: Box<Report>,
        /// The conventions that it states.
        conventions: Box<Conventions>,
    },
    /// What it writes is no answer, or the cases cannot be read.
    #[error("{error}{stderr}")]
    Text {
        /// Where and what.
        error: ExternalError,
        /// The end of what it wrote to standard error.
        stderr: String,
    },
}

impl From<ExternalError> for ProcessError {
    fn from(error: ExternalError) -> Self {
        Self::Text { error, stderr: String::new() }
    }
}
