//! What holds on the best instruction set of this machine holds on the least that it has, and where that is asked for on
//! all others: the gate asks for it.

use integrator_core::InstructionSet;
use std::{env, process::Command};

/// What tells a process which instruction set to use.
const VARIABLE: &str = "INTEGRATOR_ISA";

/// What asks for all of them.
const EVERY: &str = "TEST_EVERY_ISA";

/// Parts of the names of tests that are not run again: certificates and orders are measured in plain `f64` but for a few
/// runs, whatever the set, and threads share work that is not theirs to change.
const ONCE: [&str; 4] = ["certified", "order", "symplectic", "threads"];

/// Runs the other tests again, in a process for the least instruction set or for each that this one does not use.
#[test]
fn all_tests_pass_on_other_instruction_sets() {
    if env::var_os(VARIABLE).is_some() {
        // This is such a process, or somebody chose the instruction set.
        return;
    }
    let most = if env::var_os(EVERY).is_some() { usize::MAX } else { 1 };
    for set in InstructionSet::available().iter().filter(|set| **set != InstructionSet::chosen()).take(most) {
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
