//! The environment in which numbers are computed.

use super::ReportError;
use super::page::Block;
use serde::{Deserialize, Serialize};
use std::fs;
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

/// The environment in which numbers are computed. An entry that cannot be determined is `unknown`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Environment {
    /// The processor.
    pub cpu: String,
    /// The number of threads that the processor runs at once.
    pub cores: usize,
    /// The system and its kernel.
    pub kernel: String,
    /// The compiler.
    pub rustc: String,
    /// The profile and RUSTFLAGS.
    pub flags: String,
    /// The commit, with `-dirty` if it has uncommitted changes outside the reports.
    pub commit: String,
    /// The day, in UTC.
    pub date: String,
    /// The command.
    pub command: String,
}

impl Environment {
    /// Queries the system, git and rustc.
    pub fn here(command: &str) -> Self {
        let unknown = || "unknown".to_owned();
        let run = |program: &str, arguments: &[&str]| {
            let output = Command::new(program).args(arguments).output().ok()?;
            output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
        };
        let commit = || {
            let commit = run("git", &["rev-parse", "--short", "HEAD"])?;
            let changes =
                ["status", "--porcelain", "--untracked-files=no", "--", ":/", ":(top,exclude)reports"];
            let dirty = if run("git", &changes)?.is_empty() { "" } else { "-dirty" };
            Some(commit + dirty)
        };
        let cpu = || {
            let info = fs::read_to_string("/proc/cpuinfo").ok()?;
            let line = info.lines().find(|line| line.starts_with("model name"))?;
            Some(line.split_once(':')?.1.trim().to_owned())
        };
        let flags = std::env::var("RUSTFLAGS").unwrap_or_default();
        let profile = if cfg!(debug_assertions) { "dev" } else { "release" };
        Self {
            cpu: cpu().unwrap_or_else(unknown),
            cores: std::thread::available_parallelism().map_or(0, usize::from),
            kernel: run("uname", &["-sr"]).unwrap_or_else(unknown),
            rustc: run("rustc", &["--version"]).unwrap_or_else(unknown),
            flags: format!(
                "{profile} profile, RUSTFLAGS {}",
                if flags.is_empty() { "empty" } else { &flags }
            ),
            commit: commit().unwrap_or_else(unknown),
            date: today(),
            command: command.to_owned(),
        }
    }

    /// Rejects a report of uncommitted source, unless that is allowed.
    ///
    /// # Errors
    /// [`ReportError::Dirty`]. Without a repository there is no error.
    pub fn is_clean(allow_dirty: bool) -> Result<(), ReportError> {
        let is_dirty = !allow_dirty && Self::here("").commit.ends_with("-dirty");
        if is_dirty { Err(ReportError::Dirty) } else { Ok(()) }
    }

    /// A table of the environment, with additional rows.
    #[doc(hidden)]
    pub fn table(&self, more: Vec<(&str, String)>) -> Block {
        let pairs = [
            ("CPU", format!("{}, {} cores", self.cpu, self.cores)),
            ("kernel", self.kernel.clone()),
            ("compiler", self.rustc.clone()),
            ("flags", self.flags.clone()),
            ("commit", self.commit.clone()),
            ("date", self.date.clone()),
            ("command", format!("`{}`", self.command)),
        ];
        let rows = pairs.into_iter().chain(more).map(|(name, value)| vec![name.to_owned(), value]);
        Block::table(&["", ""], rows.collect())
    }
}

/// The day in UTC, as year-month-day.
///
/// Source: H. Hinnant, "chrono-Compatible Low-Level Date Algorithms", 2013, `civil_from_days`.
fn today() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs());
    // Days since 0000-03-01, in eras of 400 years.
    let days = seconds / 86_400 + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = 400 * era + year_of_era + u64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}
