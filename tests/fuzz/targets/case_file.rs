//! Fuzz target: the file of `check --case-file`.

#![no_main]

#[path = "../case.rs"]
mod case;
#[path = "../../../src/cli/case_file.rs"]
#[allow(dead_code, reason = "the command line uses the rest")]
mod case_file;

/// The items of the command line that the module uses.
mod arguments {
    pub(crate) fn program() -> &'static str {
        "beamgap"
    }
}

libfuzzer_sys::fuzz_target!(|text: &str| case::case(text));
