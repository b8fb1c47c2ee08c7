//! Integrates an asteroid 60 degrees ahead of Jupiter: the restricted three-body problem in a rotating frame.
//!
//! The frame adds `y p_x - x p_y` to H, which mixes `q` and `p`. `split = quadratic + rest` puts this term and the kinetic
//! energy into one part, whose flow is a matrix. The attraction is the other part.
//!
//! The program prints the range of the libration over 3,000 years for three initial states, the energy change, and the period,
//! beside that of infinitesimal librations. Large librations, in the last row, take longer.

mod asteroid;

use asteroid::{Asteroid, YEAR, ahead, slow_frequency, start, strongest};
use integrator_core::prelude::*;

const STEP: f64 = 0.1;
/// Steps between samples, and number of samples.
const INTERVAL: u64 = 10;
const SAMPLES: usize = 1600;

fn main() -> Result<(), Error> {
    println!("period of infinitesimal librations: {:.1} years", YEAR / slow_frequency());
    println!("{:>8} {:>8} {:>8} {:>14} {:>8}", "start", "least", "most", "energy change", "years");
    for degrees in [0.1, 5.0, 15.0] {
        let run = Asteroid.run(start(degrees), STEP)?;
        let (energy, mut change) = (run.energy(), 0.0_f64);
        let mut angles = Vec::new();
        for sample in run.samples(INTERVAL).take(SAMPLES) {
            let sample = sample?;
            change = change.max(((sample.energy() - energy) / energy).abs());
            angles.push(ahead(sample.state.q));
        }
        let (least, most) = angles.iter().fold((0.0_f64, 0.0_f64), |(a, b), angle| (a.min(*angle), b.max(*angle)));
        let mean = angles.iter().sum::<f64>() / angles.len() as f64;
        angles.iter_mut().for_each(|angle| *angle -= mean);
        let frequency = strongest(&angles, STEP * INTERVAL as f64, slow_frequency());
        let years = YEAR / frequency;
        println!("{degrees:>8} {least:>8.2} {most:>8.2} {change:>14.1e} {years:>8.1}");
    }
    Ok(())
}
