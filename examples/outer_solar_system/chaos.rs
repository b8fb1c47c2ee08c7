//! Measures chaos in the outer solar system over a given number of million years, 20 by default.
//!
//! The program prints the indicators of chaos with their verdict, then the mean MEGNO, the exponent and the elapsed time, one
//! per line. A positive exponent appears after some 200 million years.

#[allow(dead_code, reason = "the run of this system reads more of it")]
mod system;

use integrator_core::{BlanesMoanSrkn11, chaos};
use std::{error::Error, time::Instant};
use system::measured;

/// Length of a year in days.
const YEAR: f64 = 365.25;

/// Step in days: a tenth of Jupiter's period, with eleven force evaluations.
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
    // On a chaotic orbit the mean MEGNO is half the exponent times the time. Linear growth of deviations does not contribute.
    println!("exponent_per_year={:e}", 2.0 * report.mean_megno / (report.time / YEAR));
    println!("seconds={}", clock.elapsed().as_secs_f64());
    Ok(())
}
