//! Systems of the corpus with mistakes in them: `#[hamiltonian]` returns the item, and code or messages.
#![no_main]

#[allow(dead_code, reason = "each target uses one generator")]
#[path = "../../integrator-symbolic/tests/mutate/mod.rs"]
mod mutate;

use libfuzzer_sys::fuzz_target;
use std::{path::Path, sync::LazyLock};

static SAMPLES: LazyLock<Vec<mutate::Sample>> =
    LazyLock::new(|| mutate::annotated(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/long/tests/corpus")));

fuzz_target!(|bytes: &[u8]| {
    let case = mutate::mutated(bytes, &SAMPLES);
    mutate::expanded(&case).unwrap_or_else(|wrong| panic!("{case:?}: {wrong}"));
});
