//! `beamgap verify`: the answers of a program in any language, from a file or from the program itself.

use super::answered::{self, Diagnosed, Verified};
use super::arguments::work_with;
use super::exit::Exit;
use super::outcome::Verdict;
use super::output::{OutputOptions, Outputs};
use super::stream::source;
use anyhow::anyhow;
use beamgap::check::external::{
    AnswerReader, Conventions, Demands, Matching, ProcessError, Report, Runner, VectorReader,
};
use clap::error::ErrorKind;
use clap::{Args, value_parser};
use std::io::{IsTerminal, Write};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// The answers as CSV, for the help.
const CSV: &str = "\
Answers as CSV, one number a row; the rows of a case follow one another:
  # schema = beamgap-answers/1
  # only = d, xi:first
  case,quantity,value
  0,d,0.25
  0,d:gradient:3,-0.5
  0,d:hessian:3:4,0.125
  0,residual:3,-0.5
Comments before the titles state conventions, as the head of JSON Lines does.
";

/// The arguments.
#[derive(Args)]
#[command(after_help = format!("{CSV}\n{}", Exit::help()))]
pub(crate) struct Verify {
    /// The cases that `beamgap export` wrote, or - for standard input
    #[arg(value_name = "VECTORS")]
    vectors: PathBuf,
    /// The answers, as JSON Lines or CSV, or - for standard input
    #[arg(value_name = "ANSWERS", conflicts_with = "run")]
    answers: Option<PathBuf>,
    /// Run this program with its arguments: it gets the cases on standard input and answers on standard output
    #[arg(long, value_name = "COMMAND")]
    run: Option<String>,
    /// How long the program may take for an answer
    #[arg(long, value_name = "SECONDS", default_value = "60", value_parser = value_parser!(u32).range(1..))]
    time_out: u32,
    /// How many cases may be open: sent and not yet answered, or answered out of order
    #[arg(long, value_name = "N", default_value = "4096", value_parser = value_parser!(u32).range(1..=1_000_000))]
    look_ahead: u32,
    /// Ask for N significant digits, wherever they are attainable [default: those that a careful evaluation of the
    /// textbook formulas keeps]
    #[arg(long, value_name = "N", value_parser = value_parser!(u8).range(1..=15))]
    digits: Option<u8>,
    /// Accept answers to some of the cases and quantities. Without it, everything must be answered that the head of the
    /// answers does not exclude
    #[arg(long)]
    allow_missing: bool,
    /// The reason why N digits are enough; the result shows it
    #[arg(long, value_name = "TEXT")]
    reason: Option<String>,
    #[command(flatten)]
    output: OutputOptions,
    /// Do not look for the wrong term
    #[arg(long)]
    no_explanation: bool,
    /// How many threads compare; the result is the same [default: all cores]
    #[arg(long, value_name = "N", value_parser = value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

impl Verify {
    /// Compares and writes the result.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        if self.answers.as_ref().is_some_and(|answers| answers.as_os_str() == "-" && self.vectors == *answers)
        {
            let words = "a file for the cases or for the answers expected, found standard input for both\n";
            return Err(clap::Error::raw(ErrorKind::ArgumentConflict, words).into());
        }
        if self.reason.is_some() && self.digits.is_none() {
            let words = "--digits expected: a reason is that of the digits, which are not given\n";
            return Err(clap::Error::raw(ErrorKind::MissingRequiredArgument, words).into());
        }
        let inputs = [Some(&self.vectors), self.answers.as_ref()];
        self.output.distinct_from(&inputs.into_iter().flatten().map(PathBuf::as_path).collect::<Vec<_>>())?;
        let mut outputs = self.output.open()?;
        work_with(self.threads)?;
        match self.compared(&mut outputs) {
            Ok((verified, failed)) => self.write(outputs, &verified, failed),
            Err(error) => {
                if !error.is::<clap::Error>() {
                    outputs.fail("verify", &error)?;
                }
                Err(error)
            }
        }
    }

    /// The comparison, and the error after which the program answered no more.
    fn compared(&self, outputs: &mut Outputs) -> anyhow::Result<(Verified, Option<anyhow::Error>)> {
        let mut failed = None;
        let verified = match self.verified(outputs) {
            Ok(verified) => verified,
            // The answers before the failure are shown first.
            Err(error) => match error.downcast::<ProcessError>()? {
                ProcessError::Failed { program, status, answered, stderr, mut report, conventions }
                    if report.compared > 0 =>
                {
                    let (found, stated) = (std::mem::take(&mut *report), *conventions);
                    failed = Some(anyhow!(ProcessError::Failed {
                        program,
                        status,
                        answered,
                        stderr,
                        report,
                        conventions
                    }));
                    self.of(found, stated)
                }
                other => return Err(other.into()),
            },
        };
        Ok((verified, failed))
    }

    fn write(
        &self,
        mut outputs: Outputs,
        verified: &Verified,
        failed: Option<anyhow::Error>,
    ) -> anyhow::Result<Exit> {
        let mut outcome = answered::outcome(verified);
        let exit = outcome.verdict.exit;
        let explain = !self.no_explanation && exit == Exit::Disagree;
        // The tables are printed first, because an explanation takes seconds.
        let mut human = answered::human(verified);
        outputs.begin(&human)?;
        let diagnosed = Diagnosed::of(verified, explain);
        if explain {
            human += &answered::first_wrong(verified);
            outcome.verdict.words += &diagnosed.words();
        }
        // The answers before the failure are no success, and those that are missing follow from it.
        let is_failure = matches!(exit, Exit::Agree | Exit::Nothing);
        if let Some(error) = failed.as_ref().filter(|_| is_failure) {
            let words = format!("ERROR: {error:#}\nThe answers before: {}", outcome.verdict.words);
            outcome.verdict = Verdict::new(Exit::Input, "error", words);
        }
        let human = || format!("{human}{}\n", outcome.verdict.words);
        outputs.write(&outcome, human, || answered::json(verified, &diagnosed, &outcome.verdict))?;
        match failed {
            Some(error) if is_failure => Err(error),
            Some(error) => {
                super::terminal::tell(&format!("error: {error:#}"));
                Ok(exit)
            }
            None => Ok(exit),
        }
    }

    fn of(&self, report: Report, conventions: Conventions) -> Verified {
        let demands = Demands { conventions, digits: self.digits };
        Verified {
            report,
            demands,
            command: self.from(),
            reason: self.reason.clone(),
            allow_missing: self.allow_missing,
        }
    }

    /// The source of the answers.
    fn from(&self) -> String {
        let path = self.answers.as_ref().map(|path| path.display().to_string());
        path.or_else(|| self.run.clone()).unwrap_or_default()
    }

    fn verified(&self, outputs: &mut Outputs) -> anyhow::Result<Verified> {
        let (from, name) = source(&self.vectors)?;
        let mut vectors = VectorReader::new(from, &name)?;
        let look_ahead = usize::try_from(self.look_ahead)?;
        let mut progress = Progress::new();
        let head = answered::head(&self.from(), self.digits, self.reason.as_deref());
        let Some(path) = &self.answers else {
            let expected = "the answers or --run expected\n";
            let command = self
                .run
                .as_ref()
                .ok_or_else(|| clap::Error::raw(ErrorKind::MissingRequiredArgument, expected))?;
            outputs.begin(&head)?;
            let time_out = Duration::from_secs(self.time_out.into());
            let runner = Runner { command: command.clone(), time_out, look_ahead, digits: self.digits };
            let (report, conventions) = runner.run(vectors, |report| progress.show(report))?;
            progress.end();
            return Ok(self.of(report, conventions));
        };
        let (from, name) = source(path)?;
        let mut answers = AnswerReader::new(from, &name)?;
        let conventions = *answers.conventions();
        outputs.begin(&head)?;
        let mut matching = Matching::new(Demands { conventions, digits: self.digits }, look_ahead)
            .of_program(answers.program(), answers.only());
        while let Some(answers) = answers.next_answers()? {
            matching.take(answers, || vectors.next_vector())?;
            progress.show(matching.report());
        }
        let report = matching.finish(|| vectors.next_vector())?;
        progress.end();
        Ok(self.of(report, conventions))
    }
}

/// Prints the number of compared cases on a terminal, ten times a second.
struct Progress {
    last: Instant,
    is_shown: bool,
}

impl Progress {
    fn new() -> Self {
        Self { last: Instant::now(), is_shown: false }
    }

    fn show(&mut self, report: &Report) {
        if self.last.elapsed() < Duration::from_millis(100) || !std::io::stderr().is_terminal() {
            return;
        }
        (self.last, self.is_shown) = (Instant::now(), true);
        // A closed stderr does not stop the comparison.
        let _ = write!(std::io::stderr(), "\r{} cases compared, {} wrong", report.compared, report.wrong);
    }

    fn end(&self) {
        if self.is_shown {
            let _ = writeln!(std::io::stderr());
        }
    }
}
