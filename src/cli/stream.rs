//! Files and standard streams, line by line.

use anyhow::Context;
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, ErrorKind, Write};
use std::path::Path;

/// A file, or standard input for `-`, with its name for messages.
pub(super) fn source(path: &Path) -> anyhow::Result<(Box<dyn BufRead + Send>, String)> {
    if path == Path::new("-") {
        return Ok((Box::new(BufReader::new(io::stdin())), "standard input".into()));
    }
    let name = path.display().to_string();
    let file = File::open(path).with_context(|| format!("cannot read {name}"))?;
    Ok((Box::new(BufReader::with_capacity(1 << 16, file)), name))
}

/// Standard output or a file, line by line. A reader that closes the pipe early is not an error.
pub(super) struct Sink {
    to: Box<dyn Write>,
    name: String,
    pub(super) is_closed: bool,
}

impl Sink {
    pub(super) fn open(path: Option<&Path>) -> anyhow::Result<Self> {
        let (to, name): (Box<dyn Write>, _) = match path {
            None => (Box::new(BufWriter::new(io::stdout())), "standard output".into()),
            Some(path) => {
                let name = path.display().to_string();
                let file = File::create(path).with_context(|| format!("cannot write {name}"))?;
                (Box::new(BufWriter::new(file)), name)
            }
        };
        Ok(Self { to, name, is_closed: false })
    }

    pub(super) fn line(&mut self, line: &str) -> anyhow::Result<()> {
        let written = self.to.write_all(line.as_bytes()).and_then(|()| self.to.write_all(b"\n"));
        self.told(written)
    }

    pub(super) fn flush(&mut self) -> anyhow::Result<()> {
        let written = self.to.flush();
        self.told(written)
    }

    pub(super) fn finish(mut self) -> anyhow::Result<()> {
        self.flush()
    }

    fn told(&mut self, written: io::Result<()>) -> anyhow::Result<()> {
        match written {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => {
                self.is_closed = true;
                Ok(())
            }
            Err(error) => Err(error).with_context(|| format!("cannot write {}", self.name)),
            Ok(()) => Ok(()),
        }
    }
}
