//! Bodies that nobody would write: `#[hamiltonian]` returns the item, and code or messages.
#![no_main]

#[allow(dead_code, reason = "each target uses one generator")]
#[path = "../../integrator-symbolic/tests/mutate/mod.rs"]
mod mutate;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let case = mutate::arbitrary(bytes);
    mutate::expanded(&case).unwrap_or_else(|wrong| panic!("{case:?}: {wrong}"));
});
