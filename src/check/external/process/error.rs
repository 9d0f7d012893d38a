//! The reasons why a program could not be checked to the end.

use crate::check::external::conventions::Conventions;
use crate::check::external::error::ExternalError;
use crate::check::external::report::Report;
use std::process::ExitStatus;
use thiserror::Error;

/// The reason why a program could not be checked to the end.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ProcessError {
    /// The command line has an open quote, or is empty.
    #[error("a program, with its arguments, expected, found {0:?}")]
    Command(String),
    /// The program cannot be started.
    #[error("cannot start {program}")]
    Start {
        /// The program.
        program: String,
        /// The reason.
        source: std::io::Error,
    },
    /// The program did not answer in time.
    #[error(
        "{program}: no answer within {seconds} s, after {answered} answers to {sent} cases; a program must write each \
         answer out (flush) before it waits for more than {look_ahead} further cases{stderr}"
    )]
    TimeOut {
        /// The program.
        program: String,
        /// The time limit.
        seconds: f64,
        /// The number of cases that it had answered.
        answered: u64,
        /// The number of cases that it had been sent.
        sent: u64,
        /// The number of cases that may be sent ahead of the answers.
        look_ahead: usize,
        /// The end of its standard error.
        stderr: String,
    },
    /// The program ended with an error.
    #[error("{program}: {status}, after {answered} answers{stderr}")]
    Failed {
        /// The program.
        program: String,
        /// Its exit status.
        status: ExitStatus,
        /// The number of cases that it had answered.
        answered: u64,
        /// The end of its standard error.
        stderr: String,
        /// The result of its answers.
        report: Box<Report>,
        /// The conventions that it states.
        conventions: Box<Conventions>,
    },
    /// Its output is not a valid answer, or the cases cannot be read.
    #[error("{error}{stderr}")]
    Text {
        /// The place and the error.
        error: ExternalError,
        /// The end of its standard error.
        stderr: String,
    },
}

impl From<ExternalError> for ProcessError {
    fn from(error: ExternalError) -> Self {
        Self::Text { error, stderr: String::new() }
    }
}
