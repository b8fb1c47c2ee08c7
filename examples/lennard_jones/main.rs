//! Integrates 32,000 argon atoms at 94.4 K and measures the structure and diffusion of the liquid.
//!
//! A hot crystal melts, is cooled to the temperature of Rahman (Physical Review 136, A405, 1964), and then evolves without
//! thermostat, in steps of a hundredth of a picosecond. The library recognises the cutoff of the potential: the time per atom
//! and step is that of a thousand atoms.
//!
//! The picture `lennard_jones.png` shows:
//!
//! - the radial distribution function, with neighbours at 3.7 Å and shells at 7.0 and 10.4 Å, as in his liquid of 864 atoms. It
//!   has no gaps, unlike that of a crystal.
//! - the mean square displacement: a parabola of free flight, then a line. A sixth of its slope is the diffusion coefficient;
//!   he found 2.43e-5 cm²/s.
//! - the energy, which does not drift, and the temperature, which fluctuates.
//!
//! The program prints the position and height of the first peak, diffusion, temperature, energy change, total momentum, and the
//! time per step.

mod liquid;
mod observables;
mod picture;
#[path = "../support/mod.rs"]
mod support;

use integrator_plot::write;
use liquid::{Liquid, STEP};
use observables::{Distances, diffusion, mean_square, peak};
use picture::{Measurement, picture};
use std::{error::Error, time::Instant};
use support::{Watch, folder};

/// Cells of the crystal along each axis, with four atoms per cell.
const CELLS: usize = 20;
const TEMPERATURE: f64 = 94.4;
/// Temperature in K at which the crystal melts immediately.
const HOT: f64 = 300.0;
/// Steps between samples; number of rescalings to each of the two temperatures; number of samples without thermostat.
const INTERVAL: u64 = 20;
const HEATED: u64 = 6;
const COOLED: u64 = 24;
const SAMPLES: u64 = 30;
/// Largest distance and number of classes of the radial distribution.
const RADIUS: f64 = 18.0;
const CLASSES: usize = 180;

fn main() -> Result<(), Box<dyn Error>> {
    let mut liquid = Liquid::crystal(CELLS, 2.0 * HOT, &mut fastrand::Rng::with_seed(1964))?;
    let atoms = liquid.state().q.len();
    let total = HEATED + COOLED + SAMPLES;
    let (watch, clock) = (Watch::new(total * INTERVAL, "steps"), Instant::now());
    for setting in 0..HEATED + COOLED {
        liquid.advance(INTERVAL)?;
        liquid.heat_to(if setting < HEATED { HOT } else { TEMPERATURE })?;
        if !watch.done((setting + 1) * INTERVAL) {
            return Err("stopped before there was a liquid".into());
        }
    }
    let (start, energy) = (liquid.state(), liquid.energy());
    let mut distances = Distances::new(&liquid.argon, RADIUS, CLASSES);
    let mut measurements = vec![Measurement { time: 0.0, square: 0.0, change: 0.0, temperature: liquid.temperature() }];
    for sample in 1..=SAMPLES {
        liquid.advance(INTERVAL)?;
        let state = liquid.state();
        distances.add(&state);
        measurements.push(Measurement {
            time: (sample * INTERVAL) as f64 * STEP,
            square: mean_square(&start, &state),
            change: liquid.energy() - energy,
            temperature: liquid.temperature(),
        });
        if !watch.done((HEATED + COOLED + sample) * INTERVAL) {
            break;
        }
    }
    let seconds = clock.elapsed().as_secs_f64();
    drop(watch);

    let distribution = distances.distribution();
    let (place, height) = peak(&distribution).ok_or("no distances")?;
    // In the first picosecond the motion is still ballistic.
    let squares: Vec<_> = measurements
        .iter()
        .map(|measurement| (measurement.time, measurement.square))
        .filter(|(time, _)| *time > 1.0)
        .collect();
    let diffusion = diffusion(&squares);
    let mean = measurements.iter().map(|measurement| measurement.temperature).sum::<f64>() / measurements.len() as f64;
    let change = measurements.iter().map(|measurement| measurement.change.abs()).fold(0.0, f64::max);
    let file = folder().join("lennard_jones");
    write(&file, &picture(&distribution, (place, height), diffusion, &measurements))?;
    println!("the picture is {}", file.with_extension("png").display());
    let state = liquid.state();
    let momentum = [0, 1, 2].map(|axis| state.p.iter().map(|p| p[axis]).sum::<f64>().abs());
    println!("atoms={atoms}");
    println!("first_peak_at_angstrom={place}");
    println!("first_peak_height={height}");
    println!("diffusion_cm2_per_s={:e}", diffusion * 1e-4);
    println!("temperature_kelvin={mean}");
    println!("energy_change_per_atom_max_kelvin={change:e}");
    println!("total_momentum={:e}", momentum.into_iter().fold(0.0, f64::max));
    println!("milliseconds_per_step_looks_included={}", seconds * 1e3 / (total * INTERVAL) as f64);
    Ok(())
}
