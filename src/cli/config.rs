//! Options from a file and from the environment. Flags override the environment; the environment overrides the file.
//!
//! They become defaults of the command line, so that they are parsed, checked and shown like flags. A tolerance that is
//! loosened in the file needs a reason; the result contains the reason.

mod environment;
mod options;

use anyhow::{Context, anyhow, bail};
use clap::builder::ArgPredicate;
use clap::{Arg, ArgAction, Command};
use environment::of_environment;
use options::{COMMANDS, Settings, expected, option_of, options_of, taken};
use std::ops::Range;
use std::path::PathBuf;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The file that is read without `--config`.
const FILE: &str = "beamgap.toml";

/// The command line with the defaults of the file and of the environment.
///
/// # Errors
/// If the file cannot be read, or has a key or a value that no option accepts.
pub(super) fn configured(command: Command) -> anyhow::Result<Command> {
    let by_environment = of_environment(&command, std::env::vars_os())?;
    let Some(path) = file() else { return with_settings(command, &by_environment) };
    let name = path.display().to_string();
    let text = std::fs::read_to_string(&path).with_context(|| format!("cannot read {name}"))?;
    with_file(command, &name, &text, by_environment)
}

/// The command line with the defaults from a file of this name, and those of the environment.
///
/// # Errors
/// If the file has a key or a value that no option accepts.
pub(super) fn with_file(
    command: Command,
    name: &str,
    text: &str,
    by_environment: Settings,
) -> anyhow::Result<Command> {
    let by_file = of_file(&command, name, text)?;
    with_settings(command, &overridden(by_file, by_environment))
}

/// The settings of the environment, and those of the file that it does not override. A reason belongs to its digits, so
/// other digits override it too.
fn overridden(mut by_file: Settings, by_environment: Settings) -> Settings {
    let [digits, reason] = ["digits", "reason"].map(|option| ("verify".to_owned(), option.to_owned()));
    if by_environment.contains_key(&digits) && by_environment.get(&digits) != by_file.get(&digits) {
        by_file.remove(&reason);
    }
    by_file.extend(by_environment);
    by_file
}

fn with_settings(mut command: Command, settings: &Settings) -> anyhow::Result<Command> {
    for ((of, option), values) in settings {
        let id = option_of(&command, of, option).map(|arg| arg.get_id().clone()).context("no such option")?;
        let digits = settings.get(&(of.clone(), "digits".to_owned())).and_then(|values| values.first());
        let with_values = |arg: Arg| match (option.as_str(), digits, values.as_slice()) {
            // A flag may ask for other digits. The reason is not theirs.
            ("reason", Some(digits), [reason]) => {
                arg.default_value_if("digits", ArgPredicate::from(digits.clone()), reason.clone())
            }
            _ => arg.default_values(values.clone()),
        };
        command = command.mut_subcommand(of, |sub| sub.mut_arg(id, with_values));
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

/// A text with its place: a value as an option has it, or what was expected.
type At = (Range<usize>, String);

/// A file, for messages with a place in it.
#[derive(Clone, Copy)]
struct Text<'a> {
    name: &'a str,
    text: &'a str,
}

impl Text<'_> {
    /// The file, the line, and the column in bytes.
    fn place(self, span: &Range<usize>) -> String {
        let before = self.text.get(..span.start).unwrap_or_default();
        let line = 1 + before.matches('\n').count();
        let column = 1 + before.len() - before.rfind('\n').map_or(0, |end| end + 1);
        format!("{}:{line}:{column}", self.name)
    }

    /// A value as it is written.
    fn found(self, value: &Spanned<DeValue>) -> String {
        match value.get_ref() {
            DeValue::Table(_) => "a table".to_owned(),
            _ => self.text[value.span()].split_whitespace().collect::<Vec<_>>().join(" "),
        }
    }
}

fn of_file(command: &Command, name: &str, text: &str) -> anyhow::Result<Settings> {
    let file = Text { name, text };
    let tables = DeTable::parse(text)
        .map_err(|error| anyhow!("{}: {}", file.place(&error.span().unwrap_or(0..0)), error.message()))?;
    let mut settings = Settings::new();
    for (of, table) in tables.get_ref() {
        let (at, of) = (file.place(&of.span()), of.get_ref().as_ref());
        if !COMMANDS.contains(&of) {
            bail!("{at}: no key `{of}`, {}", expected(of, &COMMANDS.map(str::to_owned), str::to_owned));
        }
        let Some(options) = table.get_ref().as_table() else {
            bail!("{}: {of}: a table expected, found {}", file.place(&table.span()), file.found(table));
        };
        for (key, value) in options {
            let (at, key) = (file.place(&key.span()), key.get_ref().as_ref());
            // The reason is an entry of the digits.
            let Some(arg) = option_of(command, of, key).filter(|_| key != "reason") else {
                let names: Vec<_> = options_of(command, of).into_iter().filter(|of| of != "reason").collect();
                bail!("{at}: {of}: no key `{key}`, {}", expected(key, &names, str::to_owned));
            };
            let found = of_option(command, file, of, arg, value);
            let found =
                found.map_err(|(span, wrong)| anyhow!("{}: {of}.{key}: {wrong}", file.place(&span)))?;
            settings.extend(found.into_iter().map(|(option, values)| ((of.to_owned(), option), values)));
        }
    }
    Ok(settings)
}

/// The accepted values of an option that the file sets. The digits come with their reason.
fn of_option(
    command: &Command,
    file: Text,
    of: &str,
    arg: &Arg,
    value: &Spanned<DeValue>,
) -> Result<Vec<(String, Vec<String>)>, At> {
    let option = arg.get_long().unwrap_or_default();
    let found = if option == "digits" {
        let [digits, reason] = digits_and_reason(file, value)?;
        vec![("digits", vec![digits]), ("reason", vec![reason])]
    } else {
        vec![(option, values(file, arg, value)?)]
    };
    let mut accepted = Vec::new();
    for (option, values) in found.into_iter().filter(|(_, values)| !values.is_empty()) {
        for (span, value) in &values {
            taken(command, of, option, value).map_err(|wrong| (span.clone(), wrong))?;
        }
        accepted.push((option.to_owned(), values.into_iter().map(|(_, value)| value).collect()));
    }
    Ok(accepted)
}

/// The digits and the reason of a tolerance that differs from the derived one.
fn digits_and_reason(file: Text, value: &Spanned<DeValue>) -> Result<[At; 2], At> {
    let wrong = || {
        let expected = "a number with its reason expected, as { value = 6, reason = \"single precision\" }";
        (value.span(), format!("{expected}, found {}", file.text[value.span()].trim()))
    };
    let table = value.get_ref().as_table().ok_or_else(wrong)?;
    let names = ["value", "reason"];
    if let Some(key) = table.keys().find(|key| !names.contains(&key.get_ref().as_ref())) {
        let (span, key) = (key.span(), key.get_ref());
        let expected = expected(key, &names.map(str::to_owned), str::to_owned);
        return Err((span, format!("no key `{key}`, {expected}")));
    }
    let [digits, reason] = names.map(|name| table.get(name));
    let digits = digits.filter(|digits| digits.get_ref().is_integer()).ok_or_else(wrong)?;
    let told = |reason: &&Spanned<DeValue>| reason.get_ref().as_str().is_some_and(|of| !of.trim().is_empty());
    let reason = reason.filter(told).ok_or_else(wrong)?;
    Ok([scalar(file, digits)?, scalar(file, reason)?])
}

/// A value as strings, as flags have it.
fn values(file: Text, arg: &Arg, value: &Spanned<DeValue>) -> Result<Vec<At>, At> {
    match (arg.get_action(), value.get_ref()) {
        (ArgAction::SetTrue, DeValue::Boolean(true)) => Ok(vec![(value.span(), "true".to_owned())]),
        (ArgAction::SetTrue, DeValue::Boolean(false)) => Ok(Vec::new()),
        (ArgAction::SetTrue, _) => {
            Err((value.span(), format!("true or false expected, found {}", file.found(value))))
        }
        (ArgAction::Append, DeValue::Array(all)) => all.iter().map(|value| scalar(file, value)).collect(),
        _ => Ok(vec![scalar(file, value)?]),
    }
}

fn scalar(file: Text, value: &Spanned<DeValue>) -> Result<At, At> {
    let text = match value.get_ref() {
        DeValue::String(text) => text.clone().into_owned(),
        DeValue::Integer(number) => i128::from_str_radix(number.as_str(), number.radix())
            .map_or_else(|_| number.to_string(), |number| number.to_string()),
        DeValue::Float(number) => number.to_string(),
        _ => {
            return Err((
                value.span(),
                format!("a string or a number expected, found {}", file.found(value)),
            ));
        }
    };
    Ok((value.span(), text))
}

#[cfg(test)]
mod tests;
