//! The options that a file or the environment may set.

use clap::{Arg, ArgAction, Command};
use std::collections::BTreeMap;

/// Options that apply to one run.
const OF_ONE_RUN: [&str; 9] =
    ["allow-dirty", "case", "case-file", "color", "config", "help", "list", "only-wrong", "to"];

/// The commands that can be configured.
pub(super) const COMMANDS: [&str; 4] = ["check", "verify", "prove", "faults"];

/// The values by command and option.
pub(in crate::cli) type Settings = BTreeMap<(String, String), Vec<String>>;

/// The option of a command that a file or the environment may set.
pub(super) fn option_of<'a>(command: &'a Command, of: &str, option: &str) -> Option<&'a Arg> {
    let options = command.find_subcommand(of)?.get_arguments();
    options.into_iter().find(|arg| arg.get_long() == Some(option) && !OF_ONE_RUN.contains(&option))
}

/// The names of these options.
pub(super) fn options_of(command: &Command, of: &str) -> Vec<String> {
    let options = command.find_subcommand(of).into_iter().flat_map(Command::get_arguments);
    let names = options.filter_map(Arg::get_long).filter(|name| !OF_ONE_RUN.contains(name));
    names.map(str::to_owned).collect()
}

/// The nearest known name if it is near, or else all known names, as the end of a message.
pub(super) fn expected(name: &str, names: &[String], shown: impl Fn(&str) -> String) -> String {
    let near = names.iter().map(|other| (strsim::damerau_levenshtein(name, other), other)).min();
    match near {
        Some((edits, nearest)) if edits <= (name.len() / 3).max(2) => {
            format!("the nearest is `{}`", shown(nearest))
        }
        _ => {
            let names: Vec<_> = names.iter().map(|name| shown(name)).collect();
            format!("one of {} expected", names.join(", "))
        }
    }
}

/// Checks that the option accepts this value, by parsing a command line.
pub(super) fn taken(command: &Command, of: &str, option: &str, value: &str) -> Result<(), String> {
    let Some(sub) = command.find_subcommand(of) else { return Ok(()) };
    let is_flag =
        option_of(command, of, option).is_some_and(|arg| matches!(arg.get_action(), ArgAction::SetTrue));
    let required = sub.get_positionals().filter(|arg| arg.is_required_set()).map(|_| "-".to_owned());
    let value = (!is_flag).then(|| format!("--{option}={value}"));
    let words = std::iter::once(of.to_owned()).chain(required).chain(value);
    let parsed = sub.clone().try_get_matches_from(words);
    parsed.map(drop).map_err(|wrong| {
        let line = crate::cli::one_line(&wrong.render().to_string());
        line.trim_start_matches("error: ").to_owned()
    })
}
