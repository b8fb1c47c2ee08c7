//! What holds on the best instruction set of this machine holds on all others that it has.

use integrator_core::InstructionSet;
use std::{env, process::Command};

/// What tells a process which instruction set to use.
const VARIABLE: &str = "INTEGRATOR_ISA";

/// Parts of the names of tests that are not run again: certificates and orders are measured in plain `f64` but for a few
/// runs, whatever the set, and threads share work that is not theirs to change.
const ONCE: [&str; 4] = ["certified", "order", "symplectic", "threads"];

/// Runs the other tests again, in a process for each instruction set that this one does not use.
#[test]
fn all_tests_pass_on_every_instruction_set() {
    if env::var_os(VARIABLE).is_some() {
        // This is such a process, or somebody chose the instruction set.
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
        let ran = "instruction_sets::all_tests_pass_on_every_instruction_set ... ok";
        assert!(text.contains(ran), "no tests were run on {set}:\n{text}");
    }
}
