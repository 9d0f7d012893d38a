//! The meaning of the exit code.

use clap::ValueEnum;

/// The exit codes of all subcommands. Clap lists them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
#[repr(u8)]
pub(crate) enum Exit {
    /// All that was asked is compared and agrees. Points that could not be compared are reported, with a warning if they
    /// are more than 2 % of those of a regime.
    Agree = 0,
    /// A number differs, or an answer denies a regular closest point. Answers that are missing are reported too.
    Disagree = 1,
    /// The arguments are invalid.
    Usage = 2,
    /// An input is invalid, or an output cannot be written.
    Input = 3,
    /// Nothing differs, but not everything was compared: a case or a quantity is not answered that was asked for, or
    /// nothing could be compared. This is not a success.
    Nothing = 4,
    /// The check itself cannot be trusted: an injected fault was not detected, an error bound was exceeded, or the
    /// oracles (AD's routes and the differences) disagree among themselves. The closed form is not rejected.
    Untrusted = 5,
    /// An internal error of the program.
    Internal = 70,
}

impl Exit {
    /// The meaning of the code.
    pub(crate) fn meaning(self) -> &'static str {
        match self {
            Self::Agree => "all that was asked is compared and agrees",
            Self::Disagree => "some numbers disagree",
            Self::Usage => "wrong arguments",
            Self::Input => "bad input, or an output that cannot be written",
            Self::Nothing => "nothing differs, but answers are missing, or nothing was compared",
            Self::Untrusted => "the check itself cannot be trusted",
            Self::Internal => "an internal error",
        }
    }

    /// The codes, as the help prints them.
    pub(crate) fn help() -> String {
        let row = |exit: &Self| format!("  {:>2}  {}", *exit as u8, exit.meaning());
        let rows: Vec<String> = Self::value_variants().iter().map(row).collect();
        format!("Exit codes:\n{}", rows.join("\n"))
    }
}
