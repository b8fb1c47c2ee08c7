//! What holds with fused multiply-add holds without it.

use std::{env, process::Command};

/// Runs all other tests in a process that does without what this machine has beyond the baseline.
#[test]
fn all_tests_pass_on_the_baseline() {
    const VARIABLE: &str = "INTEGRATOR_ISA";
    if env::var_os(VARIABLE).is_some() {
        // This is that process, or somebody chose the instruction set.
        return;
    }
    let output = Command::new(env::current_exe().expect("the path of this test"))
        .env(VARIABLE, "baseline")
        .output()
        .expect("this test can be started again");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "on the baseline:\n{text}");
    assert!(text.contains("instruction_sets::all_tests_pass_on_the_baseline ... ok"), "no tests were run:\n{text}");
}
