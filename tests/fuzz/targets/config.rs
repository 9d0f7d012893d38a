//! Fuzz target: the file `beamgap.toml`.

#![no_main]

#[path = "../../../src/cli/config.rs"]
#[allow(dead_code, reason = "the command line uses the rest")]
mod config;

use clap::{Arg, ArgAction, Command, value_parser};

/// The function of the command line that the module uses.
fn one_line(message: &str) -> String {
    message.lines().collect::<Vec<_>>().join(" ")
}

/// Options of each kind that occurs on the command line.
fn command() -> Command {
    let options = || {
        [
            Arg::new("cases").long("cases").value_parser(value_parser!(u64).range(1..=1_000_000)),
            Arg::new("regime").long("regime").action(ArgAction::Append).value_parser(["metres", "slender"]),
            Arg::new("digits").long("digits").value_parser(value_parser!(u8).range(1..=15)),
            Arg::new("reason").long("reason"),
            Arg::new("no-explanation").long("no-explanation").action(ArgAction::SetTrue),
        ]
    };
    let of = |name| Command::new(name).args(options());
    let verify = of("verify").arg(Arg::new("vectors").required(true));
    Command::new("beamgap").subcommands([of("check"), verify, of("prove"), of("faults")])
}

libfuzzer_sys::fuzz_target!(|text: &str| {
    // A default that was accepted must be accepted when the command is parsed.
    if let Ok(command) = config::with_file(command(), "beamgap.toml", text, config::Settings::new()) {
        command.try_get_matches_from(["beamgap", "check"]).expect("the defaults are taken");
    }
});
