//! Integrates a million pendulums across the separatrix between oscillation and rotation.
//!
//! They begin in a disc. The picture `ensemble_separatrix.png` shows how the flow stretches it into two spirals: pendulums that
//! oscillate (blue) and pendulums that rotate (orange). The spirals become ever thinner, never mix, and the area is preserved.
//!
//! The program prints the area of the disc at the fourth output relative to the start, from the 200,000 pendulums on its
//! border. It also prints the largest energy change, the number of pendulums that crossed the separatrix, and the rate.

mod picture;
#[path = "../support/mod.rs"]
mod support;
mod swarm;

use integrator_core::prelude::*;
use integrator_plot::write;
use picture::{chart, picture};
use std::{error::Error, time::Instant};
use support::{Watch, folder};
use swarm::{Pendulum, State, area, changed_sides, disc, energy};

const BORDER: usize = 200_000;
const INSIDE: usize = 800_000;
const STEP: f64 = 0.125;
/// Output times, and the index of the last output whose border is resolved well enough to measure the area.
const OUTPUT_TIMES: [f64; 6] = [0.0, 2.0, 4.0, 8.0, 16.0, 64.0];
const AREA_AT: usize = 3;

fn main() -> Result<(), Box<dyn Error>> {
    let starts: Vec<State> = disc(BORDER, INSIDE).collect();
    let mut swarm = Ensemble::new(BlanesMoanSrkn6, starts.iter().map(|start| (Pendulum, *start)), STEP)?;
    let mut charts = Vec::new();
    let (mut states, mut area_error) = (starts.clone(), None);
    let members = starts.len() as u64;
    let watch = Watch::new((OUTPUT_TIMES[OUTPUT_TIMES.len() - 1] / STEP) as u64 * members, "steps");
    let clock = Instant::now();
    for (output, time) in OUTPUT_TIMES.into_iter().enumerate() {
        let mut wanted = true;
        while wanted && swarm.time() < time {
            swarm.advance(8)?;
            wanted = watch.done(swarm.steps() * members);
        }
        states = swarm.states().collect();
        charts.push(chart(swarm.time(), &starts, &states));
        if output == AREA_AT && wanted {
            area_error = Some(area(&states[..BORDER]) / area(&starts[..BORDER]) - 1.0);
        }
        if !wanted {
            break;
        }
    }
    let rate = (swarm.steps() * members) as f64 / clock.elapsed().as_secs_f64();
    drop(watch);

    let change = |(start, state): (&State, &State)| (energy(state) - energy(start)).abs();
    let energy_error = starts.iter().zip(&states).map(change).fold(0.0, f64::max);
    let file = folder().join("ensemble_separatrix");
    let measured =
        area_error.map(|error| format!("relative change of the area at t = {}: {error:.0e}", OUTPUT_TIMES[AREA_AT]));
    write(&file, &picture(charts, &measured.unwrap_or_default()))?;
    println!("the picture is {}", file.with_extension("png").display());
    if let Some(error) = area_error {
        println!("area_error={error:e}");
    }
    println!("energy_error_max={energy_error:e}");
    println!("changed_sides={}", changed_sides(&starts, &states, energy_error));
    println!("pendulum_steps_per_second={rate:e}");
    Ok(())
}
