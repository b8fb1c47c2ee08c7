//! Whatever it is given, no public function panics.

#[path = "../../../support/any_input.rs"]
mod any_input;

use any_input::outcome;
use proptest::{prelude::*, test_runner::RngSeed};
use std::env;

/// So many cases, or as many as the variable `PROPTEST_CASES` says. They are the same every time: a build does not fail for
/// what it did not change. New cases are for the fuzz target.
fn cases(count: u32) -> ProptestConfig {
    let default = ProptestConfig::default();
    let cases = if env::var_os("PROPTEST_CASES").is_some() { default.cases } else { count };
    ProptestConfig { failure_persistence: None, rng_seed: RngSeed::Fixed(2027), cases, ..default }
}

proptest! {
    #![proptest_config(cases(1_500))]

    #[test]
    fn any_input_is_refused_or_run(bytes in prop::collection::vec(any::<u8>(), 0..120)) {
        outcome(&bytes).map_err(|wrong| TestCaseError::fail(format!("{bytes:?}: {wrong}")))?;
    }
}
