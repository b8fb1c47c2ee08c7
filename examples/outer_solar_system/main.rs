//! Integrates the outer solar system over 2,700 years by a stepper generated from two plain functions.
//!
//! The program prints the distances from the Sun and the errors of conserved quantities over time. Both columns of errors
//! oscillate and do not grow. The certificate of the stepper follows. The last lines are the largest errors, the distance from
//! a reference in 113-bit arithmetic, and the elapsed time.
//!
//! With `--features pictures` it saves two pictures to `target/pictures`, or to the folder after `--out`:
//!
//! - `outer_solar_system_orbits.png`: one revolution of each planet.
//! - `outer_solar_system_energy.png`: the energy error over 1,000 years, for compositions with equal numbers of forces. None of
//!   them grows.

#[cfg(feature = "pictures")]
mod pictures;
#[path = "../support/mod.rs"]
mod support;
mod system;

use integrator_core::prelude::*;
use std::{error::Error, time::Instant};
use support::Watch;
use system::{Bodies, angular_momentum, measured, norm, reference, relative};

const DAYS: f64 = 999_999.0;
const STEPS: u64 = 1 << 18;
/// Step in days.
const YEAR: f64 = 365.25;
/// Steps between samples of the conserved quantities, and samples per row of the table.
const INTERVAL: u64 = 64;
const ROW: u64 = 256;

/// Returns the distances of the five planets from the Sun.
fn distances(q: &Bodies) -> String {
    q[1..].iter().map(|planet| format!("{:9.3}", norm(&[0, 1, 2].map(|axis| planet[axis] - q[0][axis])))).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let clock = Instant::now();
    let (system, start) = measured()?;
    let h = DAYS / STEPS as f64;
    let run = system.run(start, h)?;
    let (energy, momentum) = (run.energy(), angular_momentum(&start));
    let (mut energy_error, mut momentum_error, mut end) = (0.0_f64, 0.0_f64, start);

    println!("distances from the Sun in AU, relative errors of energy and angular momentum");
    println!("    year  Jupiter   Saturn   Uranus  Neptune    Pluto   energy  momentum");
    let watch = Watch::new(STEPS, "steps");
    for sample in run.samples(INTERVAL).take((STEPS / INTERVAL + 1) as usize) {
        let sample = sample?;
        let of_energy = ((sample.energy() - energy) / energy).abs();
        let of_momentum = relative(&angular_momentum(&sample.state), &momentum);
        (energy_error, momentum_error) = (energy_error.max(of_energy), momentum_error.max(of_momentum));
        if sample.step % (INTERVAL * ROW) == 0 {
            let year = 1994.68 + sample.time / YEAR;
            watch.line(&format!("{year:8.1}{} {of_energy:8.1e}  {of_momentum:8.1e}", distances(&sample.state.q)));
        }
        end = sample.state;
        if !watch.done(sample.step) {
            println!("stopped after {} of {STEPS} steps; the results below are for these", sample.step);
            break;
        }
    }
    drop(watch);
    #[cfg(feature = "pictures")]
    {
        pictures::orbits(&system, start, &support::folder())?;
        pictures::energies(&system, start, &support::folder())?;
    }

    let certificate = certify(&system, Yoshida4, start, h)?;
    println!("\n{certificate}\n");
    println!("energy_error_max={energy_error:e}");
    println!("angular_momentum_error_max={momentum_error:e}");
    println!("position_error={:e}", relative(end.q.as_flattened(), &reference()?));
    println!("symplectic_defect={:e}", certificate.symplectic_defect);
    println!("observed_order={}", certificate.observed_order);
    println!("seconds={}", clock.elapsed().as_secs_f64());
    Ok(())
}
