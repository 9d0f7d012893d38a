//! Shell completions, and manual pages for `man`.

use super::exit::Exit;
use super::output::to_stdout;
use clap::error::ErrorKind;
use clap::{Args, Command};
use clap_complete::Shell;
use clap_mangen::Man;

/// The arguments of `completions`.
#[derive(Args)]
pub(crate) struct Completions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

/// The arguments of `man`.
#[derive(Args)]
pub(crate) struct ManPage {
    /// The command to describe; the program as a whole if none is given
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

impl Completions {
    /// Prints the script.
    pub(super) fn run(self, mut command: Command) -> anyhow::Result<Exit> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut command, "beamgap", &mut script);
        to_stdout(&String::from_utf8(script)?)?;
        Ok(Exit::Agree)
    }
}

impl ManPage {
    /// Prints the page.
    pub(super) fn run(self, mut command: Command) -> anyhow::Result<Exit> {
        command.build();
        let page = match &self.command {
            None => command,
            Some(name) => {
                let names =
                    || command.get_subcommands().map(Command::get_name).collect::<Vec<_>>().join(", ");
                let found = command.find_subcommand(name).cloned();
                found.ok_or_else(|| {
                    let words = format!("no command {name:?}, one of {} expected\n", names());
                    clap::Error::raw(ErrorKind::InvalidValue, words)
                })?
            }
        };
        let mut text = Vec::new();
        Man::new(page).render(&mut text)?;
        to_stdout(&String::from_utf8(text)?)?;
        Ok(Exit::Agree)
    }
}
