//! Tests: options are read, and what is wrong is told with its place.

use super::{Settings, of_environment, of_file, overridden, with_file, with_settings};
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
    let values = |of: &str, key: &str| found.get(&(of.to_owned(), key.to_owned())).map(|of| of.join(" "));
    assert_eq!(values("check", "cases").as_deref(), Some("5"));
    assert_eq!(values("check", "regime").as_deref(), Some("metres slender"));
    assert_eq!(values("verify", "digits").as_deref(), Some("6"));
    assert_eq!(values("verify", "reason").as_deref(), Some("single precision"));
    assert_eq!(values("verify", "no-explanation"), None);
}

#[test]
fn what_is_wrong_is_said_with_its_place() {
    for (text, told) in [
        ("[chekc]", "beamgap.toml:1:2: no key `chekc`, the nearest is `check`"),
        ("[export]", "beamgap.toml:1:2: no key `export`, one of check, verify, prove, faults expected"),
        ("[check]\ncsaes = 5", "beamgap.toml:2:1: check: no key `csaes`, the nearest is `cases`"),
        ("[check]\ncase = 5", "beamgap.toml:2:1: check: no key `case`, the nearest is `cases`"),
        (
            "[prove]\nx-axis = 5",
            "beamgap.toml:2:1: prove: no key `x-axis`, one of seed, draws, family, plant, ",
        ),
        ("[check]\ncases = 5\ncases = 6", "beamgap.toml:3:1: duplicate key"),
        ("[check]\ncases = [", "beamgap.toml:2:"),
        ("check = 5", "beamgap.toml:1:9: check: a table expected, found 5"),
        ("[check]\ncases = true", "beamgap.toml:2:9: check.cases: a string or a number expected, found true"),
        (
            "[check]\ncases = 0",
            "beamgap.toml:2:9: check.cases: invalid value '0' for '--cases <N>': 0 is not in 1..=1000000",
        ),
        (
            "[check]\nregime = [\n  \"metres\",\n  \"meters\"]",
            "beamgap.toml:4:3: check.regime: invalid value 'meters' for '--regime <REGIME>'",
        ),
        (
            "[check]\nplant = [\"a: d.t,xi = dropped\", \"a: d.t,xi = lost\"]",
            "beamgap.toml:2:33: check.plant: invalid value 'a: d.t,xi = lost' for '--plant <FAULT>': a term and a kind",
        ),
        (
            "[verify]\nno-explanation = 1",
            "beamgap.toml:2:18: verify.no-explanation: true or false expected, found 1",
        ),
        ("[verify]\ndigits = 6", "beamgap.toml:2:10: verify.digits: a number with its reason expected"),
        (
            "[verify]\ndigits = { value = 6, reason = \" \" }",
            "beamgap.toml:2:10: verify.digits: a number with its reason",
        ),
        (
            "[verify]\ndigits = { value = 6, raeson = \"\" }",
            "beamgap.toml:2:23: verify.digits: no key `raeson`, the nearest is `reason`",
        ),
        (
            "[verify]\ndigits = { value = 60, reason = \"a\" }",
            "beamgap.toml:2:20: verify.digits: invalid value '60' for '--digits <N>': 60 is not in 1..=15",
        ),
        ("[verify]\nreason = \"a\"", "beamgap.toml:2:1: verify: no key `reason`, one of "),
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
    assert_eq!(found[&("check".to_owned(), "cases".to_owned())], ["7"]);
    assert!(read("BEAMGAP_BLESS", "1").unwrap().is_empty());
    for (name, told) in [
        (
            "BEAMGAP_CHECK_CSAES",
            "BEAMGAP_CHECK_CSAES: check has no option --csaes that the environment may set, the nearest is \
             `BEAMGAP_CHECK_CASES`",
        ),
        (
            "BEAMGAP_PROVE_XYZXYZ",
            "BEAMGAP_PROVE_XYZXYZ: prove has no option --xyzxyz that the environment may set, one of BEAMGAP_PROVE_SEED, ",
        ),
        (
            "BEAMGAP_EXPORT_CASES",
            "BEAMGAP_EXPORT_CASES: the environment sets options of check, verify, prove, faults, but none of export",
        ),
        ("BEAMGAP_VERIFY_DIGITS", "BEAMGAP_VERIFY_DIGITS: invalid value '70' for '--digits <N>'"),
    ] {
        let Err(error) = read(name, "70") else { panic!("{name} is taken") };
        assert!(error.to_string().starts_with(told), "{error}");
    }
}

#[test]
fn a_reason_belongs_to_its_digits() {
    let file = "[verify]\ndigits = { value = 6, reason = \"single precision\" }";
    let reason = |environment: &[(&str, &str)], flags: &[&str]| {
        let command = Arguments::command();
        let environment = environment.iter().map(|(name, value)| (name.into(), value.into()));
        let by_environment = of_environment(&command, environment).unwrap();
        let settings = overridden(read(file).unwrap(), by_environment);
        let words = [&["beamgap", "verify", "vectors"], flags].concat();
        let found = with_settings(command, &settings).unwrap().try_get_matches_from(words).unwrap();
        found.subcommand_matches("verify").unwrap().get_one::<String>("reason").cloned()
    };
    let (own, digits, given) =
        (Some("single precision".to_owned()), "BEAMGAP_VERIFY_DIGITS", "BEAMGAP_VERIFY_REASON");
    assert_eq!(reason(&[], &[]), own);
    assert_eq!(reason(&[], &["--digits", "6"]), own);
    assert_eq!(reason(&[], &["--digits", "8"]), None);
    assert_eq!(reason(&[], &["--digits", "8", "--reason", "mine"]).as_deref(), Some("mine"));
    assert_eq!(reason(&[], &["--reason", "mine"]).as_deref(), Some("mine"));
    assert_eq!(reason(&[(digits, "8")], &[]), None);
    assert_eq!(reason(&[(digits, "8"), (given, "other")], &[]).as_deref(), Some("other"));
    assert_eq!(reason(&[(digits, "8"), (given, "other")], &["--digits", "6"]), None);
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
                match with_file(Arguments::command(), "beamgap.toml", text, Settings::new()) {
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
