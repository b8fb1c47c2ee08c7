//! Systems, starts and steps that nobody would choose: they are refused or run, and nothing panics.
#![no_main]

#[path = "../../tests/support/any_input.rs"]
mod any_input;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    any_input::outcome(bytes).unwrap_or_else(|wrong| panic!("{bytes:?}: {wrong}"));
});
