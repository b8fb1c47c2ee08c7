//! The secular frequencies of the outer planets from an integration of ten million years.
//!
//! The orbits of the planets precess. Their perihelia and nodes turn with the fundamental frequencies `g5` to `g8` and `s6` to `s8`
//! (`s5` is zero). A frequency analysis finds them in samples of `e exp(iϖ)` and `sin(i/2) exp(iΩ)`, relative to the invariable
//! plane. The integration uses Kepler orbits in Jacobi coordinates with a tenth of Jupiter's period as its step.
//!
//! The program prints the frequencies in arc seconds per year, and those of the whole solar system. The missing inner planets and
//! relativity change them by about a percent. Give a number of million years as an argument: `-- 20`.

#[path = "../wisdom_holman/planets.rs"]
#[allow(dead_code, reason = "the example of that name reads more of it")]
mod planets;
mod secular;

use secular::{PUBLISHED, fundamental};
use std::{error::Error, time::Instant};

/// Samples in a million years.
const SAMPLES: f64 = 3295.0;

fn main() -> Result<(), Box<dyn Error>> {
    let millions: f64 = match std::env::args().nth(1) {
        Some(text) => text.parse().map_err(|_| format!("`{text}` is no number of million years"))?,
        None => 10.0,
    };
    let clock = Instant::now();
    let (found, years) = fundamental((millions * SAMPLES) as usize)?;
    println!("arc seconds per year, from {:.2} million years", years / 1e6);
    println!("       outer planets   solar system   period in years   difference");
    for ((name, frequency), (_, published)) in found.iter().zip(PUBLISHED) {
        let (period, difference) = (1_296_000.0 / frequency.abs(), 100.0 * (frequency / published - 1.0));
        println!("{name:>4} {frequency:15.6} {published:14.3} {period:17.0} {difference:11.2}%");
    }
    println!("seconds={}", clock.elapsed().as_secs_f64());
    Ok(())
}
