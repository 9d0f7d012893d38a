//! The destinations of a result: standard output, and files that are opened before the work starts.

use super::exit::Exit;
use super::formats::{github, junit, markdown, sarif, write_step_summary};
use super::json;
use super::outcome::{Outcome, Verdict};
use anstream::{AutoStream, ColorChoice};
use anyhow::{Context, anyhow};
use clap::error::ErrorKind as Usage;
use clap::{Args, ValueEnum};
use serde::Serialize;
use std::fs::{File, OpenOptions};
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};

/// How a result is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Tables for people
    Human,
    /// One document with all numbers
    Json,
    /// JUnit XML: a test case for each quantity or equation
    Junit,
    /// SARIF 2.1.0: a result for each quantity or equation that differs
    Sarif,
    /// Annotations of GitHub Actions
    Github,
    /// Markdown, as for the summary of a job
    Markdown,
}

/// The options that say what is written, and where.
#[derive(Args, Clone, Debug)]
pub(crate) struct OutputOptions {
    /// How the result is written
    #[arg(long, value_enum, default_value_t = Format::Human, hide_possible_values = true)]
    #[arg(help = "How the result is written: human, json, junit, sarif, github or markdown")]
    format: Format,
    /// Write the result to this file, as FORMAT or as --format says; may be repeated. If a file gets the format of --format,
    /// standard output gets only the verdict
    #[arg(long, value_name = "[FORMAT=]PATH", value_parser = destination)]
    output: Vec<(Option<Format>, PathBuf)>,
}

/// A file, preceded by its format if that differs from `--format`.
fn destination(text: &str) -> Result<(Option<Format>, PathBuf), String> {
    let Some((name, path)) = text.split_once('=') else { return Ok((None, text.into())) };
    if let Ok(format) = Format::from_str(name, false) {
        return Ok((Some(format), path.into()));
    }
    if !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_alphabetic()) {
        let names = Format::value_variants()
            .iter()
            .filter_map(|format| Some(format.to_possible_value()?.get_name().to_owned()));
        let names = names.collect::<Vec<_>>().join(", ");
        return Err(format!("no format {name:?}, one of {names} expected; a file of this name is ./{text}"));
    }
    Ok((None, text.into()))
}

/// The destinations of a result.
pub(crate) struct Outputs {
    format: Format,
    files: Vec<(Format, OutputFile)>,
    /// The beginning of the tables that is already on standard output.
    head: String,
    /// Whether standard error has the first line of the tables.
    is_begun: bool,
}

impl OutputOptions {
    /// Opens all files, so that a wrong path is reported before the work starts.
    pub(crate) fn open(&self) -> anyhow::Result<Outputs> {
        let open = |(format, path): &(Option<Format>, PathBuf)| {
            Ok((format.unwrap_or(self.format), OutputFile::open(path)?))
        };
        let paths: Vec<&Path> = self.output.iter().map(|(_, path)| path.as_path()).collect();
        for (i, path) in paths.iter().enumerate() {
            distinct(path, &paths[..i])?;
        }
        let files = self.output.iter().map(open).collect::<anyhow::Result<_>>()?;
        Ok(Outputs { format: self.format, files, head: String::new(), is_begun: false })
    }
}

/// Refuses to write a file that is read, or that has another document.
pub(crate) fn distinct(output: &Path, others: &[&Path]) -> anyhow::Result<()> {
    let is_same = |other: &&Path| match (output.canonicalize(), other.canonicalize()) {
        (Ok(one), Ok(two)) => one == two && one.is_file(),
        _ => output == *other,
    };
    if others.iter().any(is_same) {
        let words = format!("an output of its own expected, found {} twice\n", output.display());
        return Err(clap::Error::raw(Usage::ArgumentConflict, words).into());
    }
    Ok(())
}

impl OutputOptions {
    /// Refuses outputs that are inputs.
    pub(crate) fn distinct_from(&self, inputs: &[&Path]) -> anyhow::Result<()> {
        self.output.iter().try_for_each(|(_, path)| distinct(path, inputs))
    }
}

impl Outputs {
    /// Whether the tables are written to standard output.
    fn is_shown(&self) -> bool {
        self.format == Format::Human && self.files.iter().all(|(format, _)| *format != Format::Human)
    }

    /// Writes the beginning of the tables, so that the reader sees the request at once: to standard output if the tables
    /// go there, and else its first line to standard error, unless this shows the progress. A longer beginning continues
    /// a shorter one.
    pub(crate) fn begin(&mut self, head: &str) -> anyhow::Result<()> {
        if !self.is_shown() {
            if !std::mem::replace(&mut self.is_begun, true) && !io::stderr().is_terminal() {
                eprintln!("{}", head.lines().next().unwrap_or_default());
            }
        } else if let Some(more) = head.strip_prefix(&self.head) {
            to_stdout(more)?;
            head.clone_into(&mut self.head);
        }
        Ok(())
    }

    /// Writes an error to all destinations but the tables, so that no document is empty.
    pub(crate) fn fail(mut self, command: &'static str, error: &anyhow::Error) -> anyhow::Result<()> {
        #[derive(Serialize)]
        struct Document<'a> {
            schema: &'static str,
            version: &'static str,
            command: &'a str,
            verdict: &'a str,
            words: &'a str,
        }
        let outcome = Outcome::failed(command, error);
        let Verdict { name, words, .. } = &outcome.verdict;
        let (schema, version) = ("beamgap-error/1", env!("CARGO_PKG_VERSION"));
        let document = Document { schema, version, command, verdict: name, words };
        let is_table = self.format == Format::Human;
        self.head.clear();
        if is_table {
            // Standard error has the error.
            for (format, file) in self.files {
                file.replace(&written(format, &outcome, &|| words.clone() + "\n", &|| {
                    json::text(&document)
                })?)?;
            }
            write_step_summary(&outcome);
            return Ok(());
        }
        self.write(&outcome, || words.clone() + "\n", || json::text(&document))
    }

    /// Writes the result to all destinations, each in its format.
    ///
    /// If a file cannot be written now, its document is written to standard output, so that the result is not lost.
    pub(crate) fn write(
        self,
        outcome: &Outcome,
        human: impl Fn() -> String,
        json: impl Fn() -> anyhow::Result<String>,
    ) -> anyhow::Result<()> {
        let written = |format| written(format, outcome, &human, &json);
        write_step_summary(outcome);
        let mut text = String::new();
        let (mut failed, mut is_own_shown) = (None, true);
        for (format, file) in self.files {
            let document = written(format)?;
            let is_own = format == self.format;
            if let Err(error) = file.replace(&document) {
                text += &document;
                failed.get_or_insert(error);
                is_own_shown &= !is_own;
            } else if is_own && is_own_shown {
                text.insert_str(0, &format!("{}\n", outcome.verdict.words));
                is_own_shown = false;
            }
        }
        if is_own_shown {
            let own = written(self.format)?;
            text.insert_str(0, own.strip_prefix(&self.head).unwrap_or(&own));
        }
        if self.format == Format::Human {
            text = coloured(text, outcome);
        }
        to_stdout(&text)?;
        failed.map_or(Ok(()), Err)
    }
}

fn written(
    format: Format,
    outcome: &Outcome,
    human: &impl Fn() -> String,
    json: &impl Fn() -> anyhow::Result<String>,
) -> anyhow::Result<String> {
    match format {
        Format::Human => Ok(human()),
        Format::Json => json(),
        Format::Junit => Ok(junit(outcome)),
        Format::Sarif => sarif(outcome),
        Format::Github => Ok(github(outcome)),
        Format::Markdown => Ok(markdown(outcome)),
    }
}

/// The text with its verdict in colour, if standard output supports colours.
fn coloured(mut text: String, outcome: &Outcome) -> String {
    if AutoStream::choice(&io::stdout()) == ColorChoice::Never {
        return text;
    }
    let words = &outcome.verdict.words;
    let end = words.find(':').unwrap_or(0);
    if let Some(start) = text.rfind(words.as_str()) {
        // Green: all agrees. Yellow: something was not compared, or is to look at. Red: something is wrong.
        let colour = match (outcome.verdict.exit, outcome.verdict.is_warning) {
            (Exit::Agree, false) => "\u{1b}[1;32m",
            (Exit::Agree, true) | (Exit::Nothing, _) => "\u{1b}[1;33m",
            _ => "\u{1b}[1;31m",
        };
        text.insert_str(start + end, "\u{1b}[0m");
        text.insert_str(start, colour);
    }
    text
}

/// A file for one document. The old content stays until the document is ready.
struct OutputFile {
    file: File,
    path: PathBuf,
}

impl OutputFile {
    fn open(path: &Path) -> anyhow::Result<Self> {
        let file = OpenOptions::new().write(true).create(true).truncate(false).open(path);
        let file = file.with_context(|| format!("cannot write {}", path.display()))?;
        Ok(Self { file, path: path.to_path_buf() })
    }

    fn replace(mut self, document: &str) -> anyhow::Result<()> {
        let mut write = || {
            self.file.write_all(document.as_bytes())?;
            if self.file.metadata()?.is_file() {
                self.file.set_len(document.len() as u64)?;
            }
            self.file.flush()
        };
        write().map_err(|error: io::Error| {
            let told = format!("cannot write {}, wrote to standard output instead", self.path.display());
            anyhow!(error).context(told)
        })
    }
}

/// Writes to standard output. A reader that closes the pipe early is not an error.
pub(crate) fn to_stdout(text: &str) -> anyhow::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(error).context("cannot write to standard output")
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::{Format, destination};
    use std::path::PathBuf;

    #[test]
    fn a_format_stands_before_the_path() {
        let of = |text: &str| destination(text).unwrap();
        assert_eq!(of("a.txt"), (None, PathBuf::from("a.txt")));
        assert_eq!(of("junit=a=b.xml"), (Some(Format::Junit), PathBuf::from("a=b.xml")));
        assert_eq!(of("./x=y"), (None, PathBuf::from("./x=y")));
        let error = destination("jnuit=a.xml").unwrap_err();
        assert!(error.starts_with("no format \"jnuit\", one of human, json, junit, "), "{error}");
    }
}
