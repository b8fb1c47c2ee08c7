//! What holds on the best instruction set of this machine holds on all others that it has.

use integrator_core::InstructionSet;
use std::{env, process::Command};

/// What tells a process which instruction set to use.
const VARIABLE: &str = "INTEGRATOR_ISA";

/// Whether this process runs tests again: certificates compute in plain `f64` but for a few runs, whatever the set, and are
/// not taken anew.
#[allow(dead_code, reason = "not all who include this take certificates")]
pub(crate) fn are_repeated() -> bool {
    env::var_os(VARIABLE).is_some()
}

/// Runs all other tests again, in a process for each instruction set that this one does not use.
#[test]
fn all_tests_pass_on_every_instruction_set() {
    if are_repeated() {
        // This is such a process, or somebody chose the instruction set.
        return;
    }
    for set in InstructionSet::available().iter().filter(|set| **set != InstructionSet::chosen()) {
        let output = Command::new(env::current_exe().expect("the path of this test"))
            .env(VARIABLE, set.to_string())
            .output()
            .expect("this test can be started again");
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success(), "on {set}:\n{text}");
        let ran = "instruction_sets::all_tests_pass_on_every_instruction_set ... ok";
        assert!(text.contains(ran), "no tests were run on {set}:\n{text}");
    }
}
