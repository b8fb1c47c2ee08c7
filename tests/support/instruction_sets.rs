//! What holds on the best instruction set of this machine holds on all others that it has, where `TEST_EVERY_ISA` asks for
//! them, as `.ci/run` does.

use integrator_core::InstructionSet;
use std::{env, process::Command};

/// What tells a process which instruction set to use.
const VARIABLE: &str = "INTEGRATOR_ISA";

/// What asks for the others.
const EVERY: &str = "TEST_EVERY_ISA";

/// Parts of the names of tests that are not run again: certificates and orders are measured in plain `f64` but for a few
/// runs, whatever the set, and threads share work that is not theirs to change.
const ONCE: [&str; 4] = ["certified", "order", "symplectic", "threads"];

/// Runs the other tests again, in a process for each instruction set that this one does not use.
#[test]
fn all_tests_pass_on_other_instruction_sets() {
    if env::var_os(VARIABLE).is_some() || env::var_os(EVERY).is_none() {
        // This is such a process, or somebody chose the instruction set; or one set is enough.
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
