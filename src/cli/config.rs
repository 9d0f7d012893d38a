//! Options from a file and from the environment. Flags override the environment; the environment overrides the file.
//!
//! They become defaults of the command line, so that they are parsed, checked and shown like flags. A tolerance that is
//! loosened in the file needs a reason; the result contains the reason.

use anyhow::{Context, anyhow, bail, ensure};
use clap::{Arg, ArgAction, Command};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::PathBuf;
use toml::Value;

/// The file that is read without `--config`.
const FILE: &str = "beamgap.toml";
/// The commands that can be configured.
const COMMANDS: [&str; 4] = ["check", "verify", "prove", "faults"];
/// Options that apply to one run.
const OF_ONE_RUN: [&str; 9] =
    ["allow-dirty", "case", "case-file", "color", "config", "help", "list", "only-wrong", "to"];

/// The values of an option, and their source.
struct Setting {
    from: String,
    values: Vec<String>,
}

/// The settings by command and option.
type Settings = BTreeMap<(String, String), Setting>;

/// The command line with the defaults of the file and of the environment.
///
/// # Errors
/// If the file cannot be read, or has a key or a value that no option accepts.
pub(super) fn configured(mut command: Command) -> anyhow::Result<Command> {
    if let Some(path) = file() {
        let name = path.display().to_string();
        let text = std::fs::read_to_string(&path).with_context(|| format!("cannot read {name}"))?;
        command = with_file(command, &name, &text)?;
    }
    let settings = of_environment(&command, std::env::vars_os())?;
    with_settings(command, settings)
}

/// The command line with the defaults from a file of this name.
///
/// # Errors
/// If the file has a key or a value that no option accepts.
pub(super) fn with_file(command: Command, name: &str, text: &str) -> anyhow::Result<Command> {
    let settings = of_file(&command, name, text)?;
    with_settings(command, settings)
}

fn with_settings(mut command: Command, settings: Settings) -> anyhow::Result<Command> {
    for ((of, option), Setting { from, values }) in settings {
        let is_taken = taken(&command, &of, &option, &values);
        is_taken.map_err(|wrong| {
            let line = super::one_line(&wrong.render().to_string());
            anyhow!("{from}: {}", line.trim_start_matches("error: "))
        })?;
        let id =
            option_of(&command, &of, &option).map(|arg| arg.get_id().clone()).context("no such option")?;
        command = command.mut_subcommand(of, |sub| sub.mut_arg(id, |arg| arg.default_values(values)));
    }
    Ok(command)
}

/// The file of `--config`, else of `BEAMGAP_CONFIG`, else the usual one if it exists.
fn file() -> Option<PathBuf> {
    let mut arguments = std::env::args_os().skip(1).take_while(|argument| argument != "--");
    while let Some(argument) = arguments.next() {
        let text = argument.to_string_lossy();
        if text == "--config" {
            return arguments.next().map(PathBuf::from);
        }
        if let Some(path) = text.strip_prefix("--config=") {
            return Some(path.into());
        }
    }
    let named = std::env::var_os("BEAMGAP_CONFIG").filter(|path| !path.is_empty()).map(PathBuf::from);
    named.or_else(|| Some(PathBuf::from(FILE)).filter(|path| path.exists()))
}

/// The option of a command that a file or the environment may set.
fn option_of<'a>(command: &'a Command, of: &str, option: &str) -> Option<&'a Arg> {
    let options = command.find_subcommand(of)?.get_arguments();
    options.into_iter().find(|arg| arg.get_long() == Some(option) && !OF_ONE_RUN.contains(&option))
}

/// The message for an unknown name, with the nearest known name.
fn unknown<'a>(name: &str, names: impl Iterator<Item = &'a str>) -> String {
    let near = |other: &&str| strsim::damerau_levenshtein(name, other);
    let nearest =
        names.min_by_key(near).map_or_else(String::new, |name| format!(", the nearest is `{name}`"));
    format!("no key `{name}`{nearest}")
}

fn of_file(command: &Command, name: &str, text: &str) -> anyhow::Result<Settings> {
    let mut settings = Settings::new();
    let tables: toml::Table = toml::from_str(text).map_err(|error| {
        let line = error.span().map_or(1, |span| 1 + text[..span.start].matches('\n').count());
        anyhow!("{name}:{line}: {}", error.message())
    })?;
    for (of, table) in &tables {
        let at = format!("{name}: {of}");
        ensure!(COMMANDS.contains(&of.as_str()), "{name}: {}", unknown(of, COMMANDS.into_iter()));
        let table = table.as_table().ok_or_else(|| anyhow!("{at}: a table expected, found {table}"))?;
        for (key, value) in table {
            let at = format!("{at}.{key}");
            let Some(arg) = option_of(command, of, key) else {
                let options = command.find_subcommand(of).into_iter().flat_map(Command::get_arguments);
                let longs = options.filter_map(Arg::get_long).filter(|long| !OF_ONE_RUN.contains(long));
                bail!("{name}: {of}: {}", unknown(key, longs));
            };
            let mut set = |key: &str, values| {
                settings.insert((of.clone(), key.to_owned()), Setting { from: at.clone(), values });
            };
            if key == "digits" {
                let [digits, reason] = digits_and_reason(value).with_context(|| at.clone())?;
                set("digits", vec![digits]);
                set("reason", vec![reason]);
            } else {
                let values = values(arg, value).with_context(|| at.clone())?;
                if !values.is_empty() {
                    set(key, values);
                }
            }
        }
    }
    Ok(settings)
}

/// The digits and the reason of a tolerance that differs from the derived one.
fn digits_and_reason(value: &Value) -> anyhow::Result<[String; 2]> {
    let expected = "a number with its reason expected, as { value = 6, reason = \"single precision\" }";
    let table = value.as_table().ok_or_else(|| anyhow!("{expected}, found {value}"))?;
    for key in table.keys() {
        ensure!(
            ["value", "reason"].contains(&key.as_str()),
            "{}",
            unknown(key, ["value", "reason"].into_iter())
        );
    }
    let digits = table.get("value").and_then(Value::as_integer);
    let reason = table.get("reason").and_then(Value::as_str).filter(|reason| !reason.trim().is_empty());
    match (digits, reason) {
        (Some(digits), Some(reason)) => Ok([digits.to_string(), reason.to_owned()]),
        _ => bail!("{expected}, found {value}"),
    }
}

/// A value as strings, as flags have it.
fn values(arg: &Arg, value: &Value) -> anyhow::Result<Vec<String>> {
    let scalar = |value: &Value| match value {
        Value::String(text) => Ok(text.clone()),
        Value::Integer(number) => Ok(number.to_string()),
        Value::Float(number) => Ok(number.to_string()),
        other => Err(anyhow!("a string or a number expected, found {other}")),
    };
    match (arg.get_action(), value) {
        (ArgAction::SetTrue, Value::Boolean(true)) => Ok(vec!["true".to_owned()]),
        (ArgAction::SetTrue, Value::Boolean(false)) => Ok(Vec::new()),
        (ArgAction::SetTrue, other) => Err(anyhow!("true or false expected, found {other}")),
        (ArgAction::Append, Value::Array(all)) => all.iter().map(scalar).collect(),
        (_, value) => Ok(vec![scalar(value)?]),
    }
}

/// `BEAMGAP_CHECK_CASES` sets `--cases` of `check`.
fn of_environment(
    command: &Command,
    variables: impl Iterator<Item = (OsString, OsString)>,
) -> anyhow::Result<Settings> {
    let mut settings = Settings::new();
    for (name, value) in variables {
        let Some(name) = name.to_str() else { continue };
        let of_command = COMMANDS.into_iter().find_map(|of| {
            let rest = name.strip_prefix("BEAMGAP_")?.strip_prefix(&of.to_uppercase())?.strip_prefix('_')?;
            Some((of, rest.to_lowercase().replace('_', "-")))
        });
        let Some((of, option)) = of_command else { continue };
        let Some(arg) = option_of(command, of, &option) else {
            bail!("{name}: {of} has no option --{option} that the environment may set");
        };
        let value = value.to_str().with_context(|| format!("{name}: text expected"))?;
        let values = match arg.get_action() {
            ArgAction::SetTrue if ["", "0", "false"].contains(&value) => continue,
            ArgAction::SetTrue => vec!["true".to_owned()],
            _ => vec![value.to_owned()],
        };
        settings.insert((of.to_owned(), option), Setting { from: name.to_owned(), values });
    }
    Ok(settings)
}

/// Checks that the option accepts these values, by parsing a command line.
fn taken(command: &Command, of: &str, option: &str, values: &[String]) -> Result<(), clap::Error> {
    let Some(sub) = command.find_subcommand(of) else { return Ok(()) };
    let is_flag =
        option_of(command, of, option).is_some_and(|arg| matches!(arg.get_action(), ArgAction::SetTrue));
    let required = sub.get_positionals().filter(|arg| arg.is_required_set()).map(|_| "-".to_owned());
    let options = values.iter().filter(|_| !is_flag).map(|value| format!("--{option}={value}"));
    let words = std::iter::once(of.to_owned()).chain(required).chain(options);
    sub.clone().try_get_matches_from(words).map(drop)
}

#[cfg(test)]
mod tests {
    use super::{Settings, of_environment, of_file, with_file};
    use crate::cli::Arguments;
    use clap::CommandFactory;

    fn read(text: &str) -> anyhow::Result<Settings> {
        of_file(&Arguments::command(), "beamgap.toml", text)
    }

    #[test]
    fn keys_are_options() {
        let found = read(
            "[check]\ncases = 5\nregime = [\"metres\", \"slender\"]\n[verify]\nno-explanation = false\n\
             digits = { value = 6, reason = \"single precision\" }",
        )
        .unwrap();
        let values =
            |of: &str, key: &str| found.get(&(of.to_owned(), key.to_owned())).map(|of| of.values.join(" "));
        assert_eq!(values("check", "cases").as_deref(), Some("5"));
        assert_eq!(values("check", "regime").as_deref(), Some("metres slender"));
        assert_eq!(values("verify", "digits").as_deref(), Some("6"));
        assert_eq!(values("verify", "reason").as_deref(), Some("single precision"));
        assert_eq!(values("verify", "no-explanation"), None);
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        for (text, told) in [
            ("[chekc]", "beamgap.toml: no key `chekc`, the nearest is `check`"),
            ("[check]\ncsaes = 5", "beamgap.toml: check: no key `csaes`, the nearest is `cases`"),
            ("[check]\ncase = 5", "beamgap.toml: check: no key `case`, the nearest is `cases`"),
            ("[check]\ncases = 5\ncases = 6", "beamgap.toml:3: duplicate key"),
            ("[check]\ncases = [", "beamgap.toml:2: "),
            ("check = 5", "beamgap.toml: check: a table expected, found 5"),
            ("[check]\ncases = true", "beamgap.toml: check.cases: a string or a number expected, found true"),
            (
                "[verify]\nno-explanation = 1",
                "beamgap.toml: verify.no-explanation: true or false expected, found 1",
            ),
            ("[verify]\ndigits = 6", "beamgap.toml: verify.digits: a number with its reason expected"),
            (
                "[verify]\ndigits = { value = 6, reason = \" \" }",
                "beamgap.toml: verify.digits: a number with its reason",
            ),
            (
                "[verify]\ndigits = { value = 6, raeson = \"\" }",
                "beamgap.toml: verify.digits: no key `raeson`, the nearest is `reason`",
            ),
        ] {
            let Err(error) = read(text) else { panic!("{text} is taken") };
            let error = format!("{error:#}");
            assert!(error.starts_with(told), "{error}");
        }
    }

    #[test]
    fn the_environment_names_command_and_option() {
        let read = |name: &str, value: &str| {
            of_environment(&Arguments::command(), [(name.into(), value.into())].into_iter())
        };
        let found = read("BEAMGAP_CHECK_CASES", "7").unwrap();
        assert_eq!(found[&("check".to_owned(), "cases".to_owned())].values, ["7"]);
        assert!(read("BEAMGAP_BLESS", "1").unwrap().is_empty());
        let Err(error) = read("BEAMGAP_CHECK_CSAES", "7") else { panic!("it is taken") };
        assert!(error.to_string().starts_with("BEAMGAP_CHECK_CSAES: check has no option --csaes"), "{error}");
    }

    /// The texts of the fuzz target, and parts of them: truncated at any place, and with a byte changed.
    #[test]
    fn a_file_of_the_corpus_is_taken_or_rejected() {
        let folder = format!("{}/tests/fuzz/seeds/config", env!("CARGO_MANIFEST_DIR"));
        let (mut taken, mut rejected) = (0, 0);
        for file in std::fs::read_dir(folder).unwrap() {
            let text = std::fs::read_to_string(file.unwrap().path()).unwrap();
            for at in 0..=text.len() {
                let mut changed = text.clone().into_bytes();
                changed.get_mut(at).into_iter().for_each(|byte| *byte ^= 1 << (at % 7));
                for text in [&text[..at], &String::from_utf8(changed).unwrap()] {
                    match with_file(Arguments::command(), "beamgap.toml", text) {
                        Ok(command) => {
                            command.try_get_matches_from(["beamgap", "check"]).unwrap();
                            taken += 1;
                        }
                        Err(error) => {
                            assert!(error.to_string().starts_with("beamgap.toml"), "{error:#}");
                            rejected += 1;
                        }
                    }
                }
            }
        }
        assert!(taken > 50 && rejected > 200, "{taken} taken, {rejected} rejected");
    }
}
