//! The reasons why a program could not be checked to the end.

use crate::check::external::conventions::Conventions;
use crate::check::external::error::ExternalError;
use crate::check::external::report::Report;
use std::fmt;
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
    #[error("{program}: no answer within {seconds} s, after {answered} answers; {input}{stderr}")]
    TimeOut {
        /// The program.
        program: String,
        /// The time limit.
        seconds: f64,
        /// The number of cases that it had answered.
        answered: u64,
        /// What it did with its input.
        input: InputState,
        /// The end of its standard error.
        stderr: String,
    },
    /// The program closed its output, and did not end.
    #[error(
        "{program}: still running {seconds} s after the end of its answers; a program must end then{stderr}"
    )]
    Running {
        /// The program.
        program: String,
        /// The time limit.
        seconds: f64,
        /// The end of its standard error.
        stderr: String,
    },
    /// The program closed its output without a word.
    #[error(
        "{program}: no output; a program must read the cases on standard input and write a head and its \
         answers to standard output{stderr}"
    )]
    Silent {
        /// The program.
        program: String,
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

/// What a program that does not answer has done with its input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum InputState {
    /// It has read what it was sent. It is sent this many cases ahead of its answers.
    Read(usize),
    /// It does not read what it is sent.
    Unread,
    /// All cases were sent, and the input ended.
    Ended,
    /// It has closed its input.
    Closed,
}

impl fmt::Display for InputState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read(look_ahead) => write!(
                f,
                "a program must write each answer out (flush): it is sent at most {look_ahead} cases ahead of its answers"
            ),
            Self::Unread => f.write_str("it does not read its standard input, where the next cases wait"),
            Self::Ended => f.write_str(
                "all cases are on its standard input, which is closed; a program must read it to its end, answer, and end",
            ),
            Self::Closed => f.write_str("it has closed its standard input, and neither answers nor ends"),
        }
    }
}

impl From<ExternalError> for ProcessError {
    fn from(error: ExternalError) -> Self {
        Self::Text { error, stderr: String::new() }
    }
}
