//! Benchmarks CPU time against error, compared with other crates: `cargo bench -p integrator-bench --bench work_precision`.
//!
//! The other crates belong to the workspace member `benches/peers` and to a feature that is off by default, so tests and builds
//! do not compile them. This program calls cargo for that member.

use std::process::{Command, ExitCode};

fn main() -> std::io::Result<ExitCode> {
    let arguments = ["bench", "--package", "integrator-peers", "--features", "peers", "--bench", "work_precision"];
    let status = Command::new(env!("CARGO")).args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).status()?;
    Ok(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
