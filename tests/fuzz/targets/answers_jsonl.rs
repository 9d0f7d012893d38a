//! Fuzz target: answers as JSON Lines.

#![no_main]

#[path = "../readers.rs"]
#[allow(dead_code, reason = "each target uses one of them")]
mod readers;

libfuzzer_sys::fuzz_target!(|text: &[u8]| readers::answers(text));
