//! Integrates Jupiter's moons Io, Europa, Ganymede and Callisto with the Sun and the outer planets.
//!
//! The forces of the Sun and the planets are most of the work, and change slowly: they take outer steps of a quarter of a day. Jupiter
//! and its moons take inner steps of a sixteenth of a day, by a composition of the fourth order.
//!
//! The program prints:
//!
//! - for several methods over 875 days: how often the forces of the Sun and the planets were evaluated, the energy error, the
//!   error of Io's longitude in degrees, and the milliseconds. The energy error of inner steps is that of Jupiter's orbit around the
//!   Sun, which does not reach the moons. Outer steps of 0.875 days are close to half the period of Io, with which they resonate.
//! - the mean periods of the moons over 4,000 days, and the observed ones.
//! - the range of Laplace's angle `λ₁ - 3 λ₂ + 2 λ₃`, which stays at 180 degrees: the three inner moons are never in line on one side
//!   of Jupiter. Errors of the step that change Io's period by 1 part in 100,000 show up here, as a libration by some degrees.

mod moons;
#[path = "../outer_solar_system/system.rs"]
#[allow(dead_code, reason = "the example of that name reads more of it")]
mod system;

use integrator_core::{Method, prelude::*};
use moons::{Bodies, Course, Masses, Moons, PERIODS, Together, course, longitudes, start};
use std::{error::Error, time::Instant};

/// Time over which methods are compared.
const DAYS: f64 = 875.0;
/// Days between samples of the energy.
const INTERVAL: f64 = 7.0;

/// Result of a run over [`DAYS`].
struct Found {
    /// Largest relative energy error.
    error: f64,
    /// Longitude of Io at the end.
    io: f64,
    seconds: f64,
}

/// Integrates over [`DAYS`].
fn find<H: Hamiltonian<Coords = Bodies>>(
    system: &H,
    masses: &Masses,
    method: impl Method<H>,
    start: Phase<Bodies>,
    h: f64,
) -> Result<Found, Box<dyn Error>> {
    let mut run = system.run_with(method, start, h)?;
    let (energy, mut error, mut seconds) = (run.energy(), 0.0_f64, 0.0);
    for _ in 0..(DAYS / INTERVAL) as u64 {
        let begin = Instant::now();
        run.advance((INTERVAL / h).round() as u64)?;
        seconds += begin.elapsed().as_secs_f64();
        error = error.max((run.energy() / energy - 1.0).abs());
    }
    Ok(Found { error, io: longitudes(masses, &run.state())?[0], seconds })
}

fn main() -> Result<(), Box<dyn Error>> {
    let (masses, start) = start()?;
    let (moons, together) = (Moons(masses), Together(masses));
    let exact = find(&together, &masses, BlanesMoan4, start, 1.0 / 128.0)?.io;
    println!("method                      step   far forces   energy error   Io's error in degrees   milliseconds");
    let row = |name: &str, h: f64, per_step: f64, Found { error, io, seconds }: Found| {
        let (far, off) = (per_step * DAYS / h, (io - exact + 180.0).rem_euclid(360.0) - 180.0);
        println!("{name:22} {h:9.5} {far:12.0} {error:14.1e} {off:23.5} {:14.1}", 1e3 * seconds);
    };
    for h in [1.0 / 256.0, 1.0 / 1024.0] {
        row("Verlet", h, 1.0, find(&together, &masses, Verlet, start, h)?);
    }
    row("BlanesMoan4", 0.0625, 6.0, find(&together, &masses, BlanesMoan4, start, 0.0625)?);
    for inner_steps in [1, 4, 8, 14] {
        let h = 0.0625 * f64::from(inner_steps);
        let found = find(&moons, &masses, Verlet.nested(inner_steps), start, h)?;
        row(&format!("{inner_steps} inner steps"), h, 1.0, found);
    }
    let Course { periods, laplace: [least, mean, largest] } = course(&moons, start, 0.25, 4000.0)?;
    println!("\nmoon         period   observed");
    for ((name, period), observed) in ["Io", "Europa", "Ganymede", "Callisto"].iter().zip(periods).zip(PERIODS) {
        println!("{name:8} {period:10.5} {observed:10.5}");
    }
    println!("Laplace's angle: {least:.2} to {largest:.2} degrees, {mean:.3} on average");
    Ok(())
}
