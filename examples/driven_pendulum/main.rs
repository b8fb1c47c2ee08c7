//! Follows a damped pendulum with a periodic torque through doublings of its period into chaos.
//!
//! Friction is the third part of the splitting, and the torque depends on the time. The picture `driven_pendulum.png` shows on the
//! left the angular velocity once per period of the drive, for 1000 torques in an ensemble: one value, then two, four and eight. On
//! the right it shows the strange attractor at a torque of 1.5.
//!
//! Where a period doubles, a multiplier of the periodic orbit is -1. Newton's method finds the orbit, and the secant method the torque.
//! The program prints the first seven of these torques and the ratios of successive intervals. J. R. Taylor, Classical Mechanics
//! (2005), table 12.1, gives 1.0663, 1.0793, 1.0821 and 1.0827 for the first four; steps of a hundredth of the period move all by
//! 6e-6. The ratios tend to Feigenbaum's number 4.669201609, whatever the step.

mod pendulum;
mod picture;
#[path = "../support/mod.rs"]
#[allow(dead_code, reason = "other examples show how far they are")]
mod support;

use integrator_plot::write;
use pendulum::{diagram, doublings, ratios, section};
use picture::picture;
use std::error::Error;
use support::folder;

/// Torque of the strange attractor.
const CHAOTIC: f64 = 1.5;

fn main() -> Result<(), Box<dyn Error>> {
    let doublings = doublings(7)?;
    let ratios = ratios(&doublings);
    let torques: Vec<f64> = (0..1000).map(|i| 1.06 + 2.7e-5 * f64::from(i)).collect();
    let diagram = diagram(&torques, 300, 150)?;
    let attractor = section(CHAOTIC, 100, 20_000)?;
    let file = folder().join("driven_pendulum");
    let last = ratios.last().copied().ok_or("too few doublings")?;
    write(&file, &picture(&diagram, &doublings, last, CHAOTIC, &attractor))?;
    println!("the picture is {}", file.with_extension("png").display());
    for (number, torque) in doublings.iter().enumerate() {
        println!("torque_of_doubling_{}={torque:.7}", number + 1);
    }
    for (number, ratio) in ratios.iter().enumerate() {
        println!("ratio_{}={ratio:.6}", number + 1);
    }
    Ok(())
}
