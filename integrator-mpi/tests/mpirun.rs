//! Programs on several ranks, and what they print.

use std::{
    path::Path,
    process::{Command, Output},
};

/// The command of a package, beside which are the examples.
pub(crate) const JOIN: &str = env!("CARGO_BIN_EXE_join");

/// A program that ranks run, and the instruction set that it is to use.
pub(crate) struct Program(pub(crate) &'static str, pub(crate) Option<&'static str>);

impl Program {
    /// Starts a case on so many ranks; nothing where there is no `mpirun`.
    pub(crate) fn start(&self, ranks: usize, arguments: &[&str]) -> Option<Output> {
        let program = Path::new(JOIN).with_file_name("examples").join(self.0);
        let output = Command::new("mpirun")
            .args(["--oversubscribe", "-n", &ranks.to_string()])
            .arg(program)
            .args(arguments)
            .envs(self.1.map(|set| ("INTEGRATOR_ISA", set)))
            // In containers, tests are root's.
            .env("OMPI_ALLOW_RUN_AS_ROOT", "1")
            .env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
            .output();
        match output {
            Ok(output) => Some(output),
            Err(fault) => {
                println!("SKIPPED: mpirun cannot be started ({fault})");
                None
            }
        }
    }

    /// What rank 0 prints of a case, which has to end well.
    pub(crate) fn printed(&self, ranks: usize, arguments: &[&str]) -> Option<String> {
        let output = self.start(ranks, arguments)?;
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{arguments:?} on {ranks} ranks: {errors}");
        Some(String::from_utf8_lossy(&output.stdout).into_owned())
    }

    /// What is printed on one rank, if the same is on 2, 3 and 4.
    pub(crate) fn on_any_number(&self, arguments: &[&str]) -> Option<String> {
        let alone = self.printed(1, arguments)?;
        for ranks in 2..=4 {
            assert!(self.printed(ranks, arguments)? == alone, "{arguments:?} on {ranks} ranks");
        }
        Some(alone)
    }
}
