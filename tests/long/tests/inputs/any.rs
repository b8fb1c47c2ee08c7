//! No public function panics, whatever its input.

#[path = "../../../support/any_input.rs"]
mod any_input;

use any_input::outcome;
use proptest::{prelude::*, test_runner::RngSeed};
use std::env;

/// Sets the number of cases to `count`, or to the variable `PROPTEST_CASES`. The cases are always the same, so a build
/// fails only because of its own changes. The fuzz target tries new cases.
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
