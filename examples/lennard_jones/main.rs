//! Liquid argon: 864 atoms, from a crystal to the radial distribution function of the liquid (Rahman 1964).
//!
//! A crystal near the triple point melts while its atoms are slowed down or sped up now and then, and is then left alone.
//! Look at the picture, `lennard_jones.png`: neighbours sit at 1.1 diameters, the next shells are where those of a liquid
//! are, and between them there is no gap as in a crystal; beside it the energy, which does not drift, and the
//! temperature, which fluctuates. Printed: place and height of the first peak, temperature, drift of the energy, total momentum, and
//! the rate in pairs of atoms.

mod liquid;
mod picture;
#[path = "../support/mod.rs"]
mod support;

use integrator_plot::write;
use liquid::{Distances, Liquid, peak};
use picture::{Look, picture};
use std::{error::Error, time::Instant};
use support::{Watch, folder};

const CELLS: usize = 6;
const DENSITY: f64 = 0.8442;
const TEMPERATURE: f64 = 0.722;
const STEP: f64 = 0.004;
/// Steps between looks; how often the temperature is set; how many looks there are in the liquid that is left alone.
const INTERVAL: u64 = 20;
const SETTINGS: u64 = 75;
const LOOKS: u64 = 150;

fn main() -> Result<(), Box<dyn Error>> {
    let mut liquid = Liquid::crystal(CELLS, DENSITY, TEMPERATURE, STEP, &mut fastrand::Rng::with_seed(1964))?;
    let atoms = liquid.state().q.len() as f64;
    let pairs = atoms * (atoms - 1.0) / 2.0;
    let (watch, clock) = (Watch::new((SETTINGS + LOOKS) * INTERVAL, "steps"), Instant::now());
    let mut steps = 0;
    while steps < SETTINGS * INTERVAL && watch.done(steps) {
        liquid.heat_to(TEMPERATURE)?;
        liquid.advance(INTERVAL)?;
        steps += INTERVAL;
    }
    let (energy, begin) = (liquid.energy(), steps);
    let (mut distances, mut looks) = (Distances::new(&liquid.argon, 200), Vec::new());
    while steps < begin + LOOKS * INTERVAL && watch.done(steps) {
        liquid.advance(INTERVAL)?;
        steps += INTERVAL;
        distances.look(&liquid);
        let time = (steps - begin) as f64 * STEP;
        let change = (liquid.energy() - energy) / atoms;
        looks.push(Look { time, change, temperature: liquid.temperature() });
    }
    let rate = steps as f64 * pairs / clock.elapsed().as_secs_f64();
    drop(watch);

    if looks.is_empty() {
        return Err("stopped before there was a liquid".into());
    }
    let distribution = distances.distribution(&liquid);
    let (place, height) = peak(&distribution).ok_or("no distances")?;
    let mean = looks.iter().map(|look| look.temperature).sum::<f64>() / looks.len() as f64;
    let drift = looks.iter().map(|look| look.change.abs()).fold(0.0, f64::max);
    let file = folder().join("lennard_jones");
    write(&file, &picture(&distribution, (place, height), &looks))?;
    println!("the picture is {}", file.with_extension("png").display());
    let state = liquid.state();
    let momentum = [0, 1, 2].map(|axis| state.p.iter().map(|p| p[axis]).sum::<f64>().abs());
    println!("first_peak_at={place}");
    println!("first_peak_height={height}");
    println!("temperature={mean}");
    println!("energy_change_per_atom_max={drift:e}");
    println!("total_momentum={:e}", momentum.into_iter().fold(0.0, f64::max));
    println!("pairs_per_second={rate:e}");
    Ok(())
}
