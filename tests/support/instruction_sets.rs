//! Runs the tests on the other instruction sets of this machine if `TEST_EVERY_ISA` is set, as `.ci/run` does.

use integrator_core::InstructionSet;
use std::{env, process::Command};

/// Variable that selects the instruction set of a process.
const VARIABLE: &str = "INTEGRATOR_ISA";

/// Variable that requests the other instruction sets.
const EVERY: &str = "TEST_EVERY_ISA";

/// Parts of the names of tests that run once. Certificates and orders are measured in plain `f64` on any set, except
/// for a few runs, and threads do not change the results of the work that they share.
const ONCE: [&str; 4] = ["certified", "order", "symplectic", "threads"];

/// Runs the other tests again, in a process for each instruction set that this process does not use.
#[test]
fn all_tests_pass_on_other_instruction_sets() {
    if env::var_os(VARIABLE).is_some() || env::var_os(EVERY).is_none() {
        // This is such a process, or the user selected the instruction set, or no other sets are requested.
        return;
    }
    for set in InstructionSet::available().iter().filter(|set| **set != InstructionSet::chosen()) {
        let output = Command::new(env::current_exe().expect("the path of this test"))
            .env(VARIABLE, set.to_string())
            .args(ONCE.iter().flat_map(|part| ["--skip", part]))
            .output()
            .expect("this test can be started again");
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success(), "on {set}:\n{text}");
        let ran = "instruction_sets::all_tests_pass_on_other_instruction_sets ... ok";
        assert!(text.contains(ran), "no tests were run on {set}:\n{text}");
    }
}
