//! How chaotic the outer solar system is: deviations over the million years that are given, 20 where none are.
//!
//! Printed: the indicators of chaos with their verdict, and one per line, the mean of MEGNO, the exponent, and the time that all of
//! it took. A positive exponent shows from some 200 million years on.

#[allow(dead_code, reason = "the run of this system reads more of it")]
mod system;

use integrator_core::{BlanesMoanSrkn11, chaos};
use std::{error::Error, time::Instant};
use system::measured;

/// Days.
const YEAR: f64 = 365.25;

/// In days: a tenth of Jupiter's revolution, in which eleven forces are computed.
const STEP: f64 = 400.0;

fn main() -> Result<(), Box<dyn Error>> {
    let millions: f64 = match std::env::args().nth(1) {
        Some(text) => text.parse().map_err(|_| format!("`{text}` is no number of million years"))?,
        None => 20.0,
    };
    let clock = Instant::now();
    let (system, start) = measured()?;
    let steps = (millions * 1e6 * YEAR / STEP) as u64;
    let report = chaos::indicators(&system, BlanesMoanSrkn11, start, STEP, steps)?;
    println!("{report}\n");
    println!("million_years={}", report.time / YEAR / 1e6);
    println!("mean_megno={}", report.mean_megno);
    // On a chaotic orbit the mean of MEGNO is half of the exponent times the time; what grows like the time alone is not in it.
    println!("exponent_per_year={:e}", 2.0 * report.mean_megno / (report.time / YEAR));
    println!("seconds={}", clock.elapsed().as_secs_f64());
    Ok(())
}
