//! A program that answers cases: cases on its standard input, answers on its standard output, as a stream.

mod error;
mod pipes;

use super::compare::Demands;
use super::conventions::Conventions;
use super::error::ExternalError;
use super::matching::Matching;
use super::report::Report;
use super::vectors::{Vector, VectorReader};
pub use error::{InputState, ProcessError};
use pipes::{Feed, Feeding, Told, feed, listen, overhear};
use std::io::BufRead;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// The maximum time that a program may take to end after its last answer.
const GRACE: Duration = Duration::from_secs(5);
/// The maximum time until a case that was sent is known.
const AT_ONCE: Duration = Duration::from_millis(500);
/// The maximum time for the end of a program after an answer that is cut off, so that the exit status is known.
const LAST_WORDS: Duration = Duration::from_secs(1);

/// The settings of the run of a program.
#[derive(Clone, Debug)]
pub struct Runner {
    /// The program with its arguments, separated by blanks. Quotes keep blanks. It is not run in a shell.
    pub command: String,
    /// The maximum time for an answer.
    pub time_out: Duration,
    /// The number of cases that are sent ahead of the answers.
    pub look_ahead: usize,
    /// The required digits.
    pub digits: Option<u8>,
}

impl Runner {
    /// Runs the program on all cases, and compares its answers; `progress` is called after each answer.
    ///
    /// # Errors
    /// [`ProcessError`].
    pub fn run<R: BufRead + Send + 'static>(
        &self,
        vectors: VectorReader<R>,
        mut progress: impl FnMut(&Report),
    ) -> Result<(Report, Conventions), ProcessError> {
        let words = words(&self.command).filter(|words| !words.is_empty());
        let words = words.ok_or_else(|| ProcessError::Command(self.command.clone()))?;
        let program = words[0].clone();
        let mut child = Command::new(&program)
            .args(&words[1..])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|source| ProcessError::Start { program: program.clone(), source })?;
        let (sent, feeding) = feed(&mut child, vectors, self.look_ahead);
        let told = listen(&mut child, &program);
        let stderr = overhear(&mut child);
        let end =
            |stderr: &Receiver<String>| stderr.recv_timeout(Duration::from_millis(200)).unwrap_or_default();
        match self.matched(&program, &sent, &told, &mut progress) {
            Ok((report, conventions, answered)) => {
                let status = wait(&mut child, GRACE);
                match status {
                    Some(status) if status.success() => Ok((report, conventions)),
                    Some(status) => {
                        let (stderr, report) = (end(&stderr), Box::new(report));
                        {
                            let conventions = Box::new(conventions);
                            Err(ProcessError::Failed {
                                program,
                                status,
                                answered,
                                stderr,
                                report,
                                conventions,
                            })
                        }
                    }
                    None => {
                        let seconds = GRACE.as_secs_f64();
                        Err(ProcessError::Running { program, seconds, stderr: end(&stderr) })
                    }
                }
            }
            Err(Stop { fault, answered, is_cut }) => {
                let input = self.input(&feeding);
                // The first fault is the message. If the last answer is cut off, the program ended before. If a line is
                // wrong, the program is ended here, and what it does after that line is not its first fault.
                let grace = if is_cut { LAST_WORDS } else { Duration::ZERO };
                let status = wait(&mut child, grace).filter(|status| is_cut && !status.success());
                let stderr = end(&stderr);
                Err(match (fault, status) {
                    (None, _) => {
                        let seconds = self.time_out.as_secs_f64();
                        ProcessError::TimeOut { program, seconds, answered, input, stderr }
                    }
                    (Some(ProcessError::Text { .. } | ProcessError::Silent { .. }), Some(status)) => {
                        let (report, conventions) = (Box::default(), Box::default());
                        ProcessError::Failed { program, status, answered, stderr, report, conventions }
                    }
                    (Some(ProcessError::Text { error, .. }), _) => ProcessError::Text { error, stderr },
                    (Some(ProcessError::Silent { .. }), _) => ProcessError::Silent { program, stderr },
                    (Some(other), _) => other,
                })
            }
        }
    }

    /// What the program did with its input, at a time-out.
    fn input(&self, feeding: &Feeding) -> InputState {
        let states = [
            (Feed::Writes, InputState::Unread),
            (Feed::Ended, InputState::Ended),
            (Feed::Closed, InputState::Closed),
        ];
        let of = states.into_iter().find(|(state, _)| feeding.is(*state));
        of.map_or(InputState::Read(self.look_ahead), |(_, input)| input)
    }

    /// Matches answers with the cases sent.
    fn matched(
        &self,
        program: &str,
        sent: &Receiver<Result<Vector, ExternalError>>,
        told: &Receiver<Told>,
        progress: &mut impl FnMut(&Report),
    ) -> Result<(Report, Conventions, u64), Stop> {
        let (mut answered, mut is_cut) = (0, false);
        let mut matching: Option<(Matching, Conventions)> = None;
        loop {
            let result = match told.recv_timeout(self.time_out) {
                Ok(Told::Head(head)) => {
                    let (conventions, program, only) = *head;
                    let demands = Demands { conventions, digits: self.digits };
                    let new = Matching::new(demands, self.look_ahead).of_program(&program, &only);
                    matching = Some((new, conventions));
                    Ok(())
                }
                Ok(Told::Answers(answers)) => {
                    answered += 1;
                    let (matching, _) = matching.as_mut().expect("the head comes before the answers");
                    // Each case is announced before it is written, so a case that does not come at once was not sent.
                    let next = || match sent.recv_timeout(self.time_out.min(AT_ONCE)) {
                        Ok(vector) => vector.map(Some).map_err(|error| Some(ProcessError::from(error))),
                        Err(_) => Ok(None),
                    };
                    let taken = matching.take(*answers, OptionalError::wrap(next));
                    progress(matching.report());
                    taken.map_err(|OptionalError(error)| error)
                }
                Ok(Told::Error(error, is_last)) => {
                    is_cut = is_last;
                    Err(Some(error.into()))
                }
                Err(RecvTimeoutError::Timeout) => Err(None),
                Ok(Told::Nothing) | Err(RecvTimeoutError::Disconnected) => break,
            };
            result.map_err(|fault| Stop { fault, answered, is_cut })?;
        }
        let Some((matching, conventions)) = matching else {
            let program = program.to_owned();
            let fault = Some(ProcessError::Silent { program, stderr: String::new() });
            return Err(Stop { fault, answered, is_cut: true });
        };
        let next = || match sent.recv_timeout(self.time_out) {
            Ok(vector) => vector.map(Some).map_err(|error| Some(ProcessError::from(error))),
            Err(_) => Ok(None),
        };
        let report = matching.finish(OptionalError::wrap(next));
        let report = report.map_err(|OptionalError(fault)| Stop { fault, answered, is_cut })?;
        Ok((report, conventions, answered))
    }
}

/// The end of a comparison before all cases are answered.
struct Stop {
    /// The first fault; none for a time-out.
    fault: Option<ProcessError>,
    /// The number of answers before it.
    answered: u64,
    /// Whether the fault is that the program ended, before its last line did.
    is_cut: bool,
}

/// An error, or none for a time-out.
struct OptionalError(Option<ProcessError>);

impl OptionalError {
    fn wrap<T>(mut next: impl FnMut() -> Result<T, Option<ProcessError>>) -> impl FnMut() -> Result<T, Self> {
        move || next().map_err(Self)
    }
}

impl From<ExternalError> for OptionalError {
    fn from(error: ExternalError) -> Self {
        Self(Some(error.into()))
    }
}

/// The status of a program that has closed its output; nothing if it does not end.
fn wait(child: &mut Child, grace: Duration) -> Option<ExitStatus> {
    let start = Instant::now();
    loop {
        if let Ok(Some(status)) = child.try_wait() {
            return Some(status);
        }
        if start.elapsed() >= grace {
            let _ = child.kill();
            let _ = child.wait();
            return None;
        }
        thread::sleep(Duration::from_millis(2));
    }
}

/// A command line split into words; nothing if a quote is open.
fn words(command: &str) -> Option<Vec<String>> {
    let (mut words, mut word, mut quote) = (Vec::new(), None::<String>, None);
    for c in command.chars() {
        match (quote, c) {
            (Some(open), c) if c == open => quote = None,
            (None, '"' | '\'') => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            (None, c) if c.is_whitespace() => words.extend(word.take()),
            (_, c) => word.get_or_insert_default().push(c),
        }
    }
    words.extend(word);
    quote.is_none().then_some(words)
}

#[cfg(test)]
mod tests {
    use super::words;

    #[test]
    fn quotes_keep_blanks() {
        assert_eq!(words("a  'b c' d\"e f\"g ''").unwrap(), ["a", "b c", "de fg", ""]);
        assert_eq!(words("a 'b"), None);
        assert_eq!(words("  ").unwrap(), Vec::<String>::new());
    }
}
