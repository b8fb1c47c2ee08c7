//! CPU time against error, beside other crates: `cargo bench -p integrator --bench work_precision`.
//!
//! The other crates belong to a workspace member of their own, `benches/peers`, and there to a feature that is off: nobody
//! compiles them who only builds or tests. This program asks cargo for that member.

use std::process::{Command, ExitCode};

fn main() -> std::io::Result<ExitCode> {
    let arguments = ["bench", "--package", "integrator-peers", "--features", "peers", "--bench", "work_precision"];
    let status = Command::new(env!("CARGO")).args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).status()?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
