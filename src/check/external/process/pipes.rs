//! The three pipes of a program, each with a thread: cases in, answers out, and its standard error.

use crate::check::external::answers::{AnswerReader, Answers, Program};
use crate::check::external::conventions::Conventions;
use crate::check::external::error::ExternalError;
use crate::check::external::only::Only;
use crate::check::external::vectors::{Vector, VectorReader};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::Child;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::mpsc::{self, Receiver, SyncSender, TrySendError};
use std::thread;

/// The number of bytes of standard error that are kept, from its end.
const STDERR: usize = 4096;
/// What the thread that writes cases does.
#[derive(Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Feed {
    /// It waits for the next case, or for an answer if many cases are open.
    Waits,
    /// It writes.
    Writes,
    /// It has written all cases.
    Ended,
    /// The program has closed its input.
    Closed,
}

/// The state of the thread that writes cases, for the thread that waits for answers.
#[derive(Clone, Default)]
pub(super) struct Feeding(Arc<AtomicU8>);

impl Feeding {
    fn set(&self, feed: Feed) {
        self.0.store(feed as u8, Ordering::Relaxed);
    }

    pub(super) fn is(&self, feed: Feed) -> bool {
        self.0.load(Ordering::Relaxed) == feed as u8
    }
}

/// The messages of the thread that reads answers.
pub(super) enum Told {
    /// The output ended before a head.
    Nothing,
    Head(Box<(Conventions, Program, Only)>),
    Answers(Box<Answers>),
    /// An error, and whether it is in a last line that has no end.
    Error(ExternalError, bool),
}

/// Writes the cases to the program. Each case is announced before it is written.
pub(super) fn feed<R: BufRead + Send + 'static>(
    child: &mut Child,
    mut vectors: VectorReader<R>,
    look_ahead: usize,
) -> (Receiver<Result<Vector, ExternalError>>, Feeding) {
    let (tell, sent) = mpsc::sync_channel(look_ahead);
    let mut stdin = child.stdin.take();
    let state = Feeding::default();
    let feeding = state.clone();
    thread::spawn(move || {
        let mut write = |line: &str| {
            let Some(to) = &mut stdin else { return };
            state.set(Feed::Writes);
            // A program may close its input early. The remaining cases are then not answered.
            let written = to.write_all(line.as_bytes()).and_then(|()| to.write_all(b"\n"));
            state.set(if written.is_ok() { Feed::Waits } else { Feed::Closed });
            if written.is_err() {
                stdin = None;
            }
        };
        write(vectors.line());
        loop {
            match vectors.next_vector() {
                Ok(Some(vector)) => {
                    if tell.send(Ok(vector)).is_err() {
                        return;
                    }
                    write(vectors.line());
                }
                Ok(None) => {
                    if stdin.take().is_some() {
                        state.set(Feed::Ended);
                    }
                    return;
                }
                Err(error) => return drop(tell.send(Err(error))),
            }
        }
    });
    (sent, feeding)
}

/// Reads the answers of the program.
pub(super) fn listen(child: &mut Child, program: &str) -> Receiver<Told> {
    let (tell, told): (SyncSender<Told>, _) = mpsc::sync_channel(64);
    let name = format!("standard output of {program}");
    if let Some(stdout) = child.stdout.take() {
        thread::spawn(move || {
            let mut stdout = BufReader::with_capacity(1 << 16, stdout);
            if stdout.fill_buf().is_ok_and(<[u8]>::is_empty) {
                return drop(tell.send(Told::Nothing));
            }
            let mut output = Output { from: stdout, last: None };
            let end = |tell: &SyncSender<Told>, error, output: &mut Output<_>| {
                // The rest is read too, so that the program sees no closed pipe and fails for no other reason.
                let is_cut = output.is_cut();
                let _ = tell.send(Told::Error(error, is_cut));
                let _ = io::copy(&mut output.from, &mut io::sink());
            };
            let mut answers = match AnswerReader::new(&mut output, &name) {
                Ok(answers) => answers,
                Err(error) => return end(&tell, error, &mut output),
            };
            let head = (*answers.conventions(), answers.program().clone(), answers.only().clone());
            if tell.send(Told::Head(Box::new(head))).is_err() {
                return;
            }
            loop {
                let next = match answers.next_answers() {
                    Ok(Some(answers)) => Told::Answers(Box::new(answers)),
                    Ok(None) => return,
                    Err(error) => {
                        drop(answers);
                        return end(&tell, error, &mut output);
                    }
                };
                if tell.send(next).is_err() {
                    return;
                }
            }
        });
    }
    told
}

/// Output with the last byte that was read of it.
struct Output<R> {
    from: R,
    last: Option<u8>,
}

impl<R: BufRead> Output<R> {
    /// Whether the output ended in the middle of a line.
    fn is_cut(&mut self) -> bool {
        self.last != Some(b'\n') && self.from.fill_buf().is_ok_and(<[u8]>::is_empty)
    }
}

impl<R: BufRead> Read for Output<R> {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        let read = self.from.read(to)?;
        self.last = to[..read].last().copied().or(self.last);
        Ok(read)
    }
}

impl<R: BufRead> BufRead for Output<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.from.fill_buf()
    }

    fn consume(&mut self, count: usize) {
        // An empty buffer would be filled.
        if let Some(Ok(buffer)) = (count > 0).then(|| self.from.fill_buf()) {
            self.last = buffer.get(..count).and_then(|read| read.last()).copied().or(self.last);
        }
        self.from.consume(count);
    }
}

/// The end of the program's standard error, after the program has closed it.
pub(super) fn overhear(child: &mut Child) -> Receiver<String> {
    let (tell, told) = mpsc::sync_channel(1);
    if let Some(mut stderr) = child.stderr.take() {
        thread::spawn(move || {
            let (mut end, mut part) = (Vec::new(), [0; STDERR]);
            while let Ok(read @ 1..) = stderr.read(&mut part) {
                end.extend_from_slice(&part[..read]);
                end.drain(..end.len().saturating_sub(STDERR));
            }
            let text = String::from_utf8_lossy(&end);
            let text = text.trim_end();
            let told =
                if text.is_empty() { String::new() } else { format!("\nIts standard error ends:\n{text}") };
            // The receiver may no longer exist.
            if let Err(TrySendError::Full(_) | TrySendError::Disconnected(_)) = tell.try_send(told) {}
        });
    }
    told
}
