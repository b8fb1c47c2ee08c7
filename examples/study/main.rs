//! Runs a parameter study: parameters from TOML, initial states from CSV, a sweep, NPZ files for Python.
//!
//! Run `cargo run --release --features study --example study -- [FROM] [TO]`. If it is stopped or killed, the next start
//! resumes in the middle of an orbit and writes bitwise identical files. In Python, `np.load("orbit_0.6_0_0.npz")["q"]` are the
//! positions.

mod sweep;

use std::sync::atomic::{AtomicBool, Ordering};
use std::{error::Error, ops::ControlFlow, path::PathBuf};
use sweep::sweep;

static STOP: AtomicBool = AtomicBool::new(false);

fn main() -> Result<(), Box<dyn Error>> {
    ctrlc::set_handler(|| STOP.store(true, Ordering::Relaxed))?;
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/data/study");
    let mut folders = std::env::args().skip(1).map(PathBuf::from);
    let (from, to) = (folders.next().unwrap_or(data.into()), folders.next().unwrap_or("target/study".into()));
    let told = |line: &str| {
        println!("{line}");
        if STOP.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let outcomes = sweep(&from, &to, told)?;
    if outcomes.is_none() {
        println!("stopped; run it again to resume");
    }
    for outcome in outcomes.into_iter().flatten() {
        println!("flattening {}, start {}: energy {:+.1e}", outcome.flattening, outcome.start, outcome.error);
    }
    Ok(())
}
