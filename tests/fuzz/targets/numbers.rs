//! Fuzz target: numbers in the notations of all languages.

#![no_main]

#[path = "../readers.rs"]
#[allow(dead_code, reason = "each target uses one of them")]
mod readers;

libfuzzer_sys::fuzz_target!(|text: &str| readers::number(text));
