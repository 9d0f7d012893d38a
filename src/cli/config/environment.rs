//! Options from variables of the environment.

use super::options::{COMMANDS, Settings, expected, option_of, options_of, taken};
use anyhow::{Context, anyhow, bail};
use clap::{ArgAction, Command};
use std::ffi::OsString;

/// `BEAMGAP_CHECK_CASES` sets `--cases` of `check`. A variable of a command that sets no option is an error, so that a
/// misspelt name is not ignored.
pub(super) fn of_environment(
    command: &Command,
    variables: impl Iterator<Item = (OsString, OsString)>,
) -> anyhow::Result<Settings> {
    let mut settings = Settings::new();
    for (name, value) in variables {
        let Some(name) = name.to_str() else { continue };
        let of_command = command.get_subcommands().map(Command::get_name).find_map(|of| {
            let rest = name.strip_prefix("BEAMGAP_")?.strip_prefix(&of.to_uppercase())?.strip_prefix('_')?;
            Some((of, rest.to_lowercase().replace('_', "-")))
        });
        let Some((of, option)) = of_command else { continue };
        if !COMMANDS.contains(&of) {
            bail!("{name}: the environment sets options of {}, but none of {of}", COMMANDS.join(", "));
        }
        let Some(arg) = option_of(command, of, &option) else {
            let variable = |option: &str| format!("BEAMGAP_{of}_{option}").to_uppercase().replace('-', "_");
            let expected = expected(&option, &options_of(command, of), variable);
            bail!("{name}: {of} has no option --{option} that the environment may set, {expected}");
        };
        let value = value.to_str().with_context(|| format!("{name}: text expected"))?;
        let value = match arg.get_action() {
            ArgAction::SetTrue if ["", "0", "false"].contains(&value) => continue,
            ArgAction::SetTrue => "true",
            _ => value,
        };
        taken(command, of, &option, value).map_err(|wrong| anyhow!("{name}: {wrong}"))?;
        settings.insert((of.to_owned(), option), vec![value.to_owned()]);
    }
    Ok(settings)
}
