//! An asteroid of Jupiter's, ahead of it by 60 degrees: the restricted problem of three bodies in a frame that turns.
//!
//! The frame adds `y p_x - x p_y` to H, which mixes q and p. `split = quadratic + rest` puts it with the kinetic energy in
//! one part, whose flow is a matrix, and attraction in the other one.
//!
//! Printed: how far the asteroid goes to and fro over 3,000 years for three starts, the change of its energy, and how
//! long it takes there and back, beside the period of very small motions. Look at the last start: motions that are not
//! small take longer.

mod asteroid;

use asteroid::{Asteroid, YEAR, ahead, slow_frequency, start, strongest};
use integrator_core::prelude::*;

const STEP: f64 = 0.1;
/// Steps between looks, and looks.
const LOOK: u64 = 10;
const LOOKS: usize = 1600;

fn main() -> Result<(), Error> {
    println!("small motions take {:.1} years", YEAR / slow_frequency());
    println!("{:>8} {:>8} {:>8} {:>14} {:>8}", "start", "least", "most", "energy change", "years");
    for degrees in [0.1, 5.0, 15.0] {
        let run = Asteroid.run(start(degrees), STEP)?;
        let (energy, mut change) = (run.energy(), 0.0_f64);
        let mut looks = Vec::new();
        for sample in run.samples(LOOK).take(LOOKS) {
            let sample = sample?;
            change = change.max(((sample.energy() - energy) / energy).abs());
            looks.push(ahead(sample.state.q));
        }
        let (least, most) = looks.iter().fold((0.0_f64, 0.0_f64), |(a, b), look| (a.min(*look), b.max(*look)));
        let mean = looks.iter().sum::<f64>() / looks.len() as f64;
        looks.iter_mut().for_each(|look| *look -= mean);
        let frequency = strongest(&looks, STEP * LOOK as f64, slow_frequency());
        let years = YEAR / frequency;
        println!("{degrees:>8} {least:>8.2} {most:>8.2} {change:>14.1e} {years:>8.1}");
    }
    Ok(())
}
