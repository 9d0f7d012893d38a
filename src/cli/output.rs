//! Where a document goes: standard output, or a file that is opened before the work starts.

use anyhow::Context;
use std::fs::{File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// A place to write one document to.
pub(crate) enum Output {
    /// Standard output.
    Standard,
    /// A file; what it held stays until the document is ready.
    File(File, PathBuf),
}

impl Output {
    /// Opens the file, if one is given, so that a wrong path is noticed first and not last.
    pub(crate) fn open(path: Option<&Path>) -> anyhow::Result<Self> {
        let Some(path) = path else { return Ok(Self::Standard) };
        let file = OpenOptions::new().write(true).create(true).truncate(false).open(path);
        let file = file.with_context(|| format!("cannot write {}", path.display()))?;
        Ok(Self::File(file, path.to_path_buf()))
    }

    /// Writes the document; a file's also gets `remark` on standard output.
    ///
    /// If the file fails now, the document goes to standard output, so that the work is not lost.
    pub(crate) fn write(self, document: &str, remark: &str) -> anyhow::Result<()> {
        match self {
            Self::Standard => to_stdout(document),
            Self::File(mut file, path) => match replace(&mut file, document) {
                Ok(()) => to_stdout(remark),
                Err(error) => {
                    to_stdout(document)?;
                    let told = format!("cannot write {}, wrote to standard output instead", path.display());
                    Err(anyhow::Error::new(error).context(told))
                }
            },
        }
    }
}

fn replace(file: &mut File, document: &str) -> io::Result<()> {
    file.write_all(document.as_bytes())?;
    if file.metadata()?.is_file() {
        file.set_len(document.len() as u64)?;
    }
    file.flush()
}

/// A reader that has seen enough closes the pipe: no error.
fn to_stdout(text: &str) -> anyhow::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(error).context("cannot write to standard output")
        }
        _ => Ok(()),
    }
}
