//! The meaning of the exit code.

/// The exit codes of all subcommands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum Exit {
    /// All compared points agree; points that could not be compared were reported.
    Agree = 0,
    /// At least one closest point does not agree.
    Disagree = 1,
    /// The arguments are invalid.
    Usage = 2,
    /// An input is invalid, or an output cannot be written.
    Input = 3,
    /// Nothing could be compared; this is not a success.
    Nothing = 4,
    /// The check itself cannot be trusted: an injected fault was not detected, an error bound was exceeded, or the
    /// oracles (AD's routes and the differences) disagree among themselves. The closed form is not rejected.
    Untrusted = 5,
    /// An internal error of the program.
    Internal = 70,
}

impl Exit {
    const ALL: [Self; 7] = [
        Self::Agree,
        Self::Disagree,
        Self::Usage,
        Self::Input,
        Self::Nothing,
        Self::Untrusted,
        Self::Internal,
    ];

    /// The meaning of the code.
    pub(crate) fn meaning(self) -> &'static str {
        match self {
            Self::Agree => "all compared numbers agree",
            Self::Disagree => "some numbers disagree",
            Self::Usage => "wrong arguments",
            Self::Input => "bad input, or an output that cannot be written",
            Self::Nothing => "nothing could be compared",
            Self::Untrusted => "the check itself cannot be trusted",
            Self::Internal => "an internal error",
        }
    }

    /// The codes, as the help prints them.
    pub(crate) fn help() -> String {
        let rows = Self::ALL.map(|exit| format!("  {:>2}  {}", exit as u8, exit.meaning()));
        format!("Exit codes:\n{}", rows.join("\n"))
    }
}
