//! The lines of a text from another program: streamed, with their numbers.

use super::error::{ExternalError, Place};
use std::io::{BufRead, Read};
use std::sync::Arc;

/// The maximum length of a line. A full Hessian of 1000 dofs has a million numbers.
const LONGEST: u64 = 1 << 28;

/// The lines of a text.
///
/// A byte-order mark and carriage returns at line ends are dropped.
pub(super) struct Lines<R> {
    from: R,
    name: Arc<str>,
    number: usize,
    buffer: Vec<u8>,
}

impl<R> std::fmt::Debug for Lines<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Lines")
            .field("name", &self.name)
            .field("number", &self.number)
            .finish_non_exhaustive()
    }
}

impl<R: BufRead> Lines<R> {
    /// The lines of a text; `name` is that of the file, for messages.
    pub(super) fn new(from: R, name: &str) -> Self {
        Self { from, name: name.into(), number: 0, buffer: Vec::new() }
    }

    /// The place of the line read last.
    pub(super) fn place(&self) -> Place {
        Place { file: self.name.to_string(), line: self.number, column: 0 }
    }

    /// The next line that is not blank; nothing at the end of the text.
    ///
    /// # Errors
    /// If the text cannot be read, is not UTF-8, or has a line that is too long.
    pub(super) fn next_line(&mut self) -> Result<Option<&str>, ExternalError> {
        loop {
            self.buffer.clear();
            let read = self.from.by_ref().take(LONGEST).read_until(b'\n', &mut self.buffer);
            let read = read.map_err(|error| {
                let place = Place { line: self.number + 1, ..self.place() };
                place.error(format!("cannot be read: {error}"))
            })?;
            if read == 0 {
                return Ok(None);
            }
            self.number += 1;
            if read as u64 == LONGEST && self.buffer.last() != Some(&b'\n') {
                return Err(self.place().error(format!("a line of at most {LONGEST} bytes expected")));
            }
            while matches!(self.buffer.last(), Some(b'\n' | b'\r')) {
                self.buffer.pop();
            }
            if self.number == 1 && self.buffer.starts_with(b"\xef\xbb\xbf") {
                self.buffer.drain(..3);
            }
            if self.buffer.iter().any(|byte| !byte.is_ascii_whitespace()) {
                break;
            }
        }
        let place = self.place();
        std::str::from_utf8(&self.buffer).map(Some).map_err(|error| {
            Place { column: error.valid_up_to() + 1, ..place }.error("text in UTF-8 expected")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Lines;

    #[test]
    fn marks_of_other_systems_are_dropped() {
        let mut lines = Lines::new(&b"\xef\xbb\xbfone\r\n\r\n  \ntwo"[..], "f");
        assert_eq!(lines.next_line().unwrap(), Some("one"));
        assert_eq!(lines.next_line().unwrap(), Some("two"));
        assert_eq!(lines.place().line, 4);
        assert_eq!(lines.next_line().unwrap(), None);
    }

    #[test]
    fn what_is_no_text_is_an_error_with_its_place() {
        let mut lines = Lines::new(&b"one\nab\xff\n"[..], "f");
        lines.next_line().unwrap();
        let error = lines.next_line().unwrap_err();
        assert_eq!(error.to_string(), "f:2:3: text in UTF-8 expected");
    }
}
