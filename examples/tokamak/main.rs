//! Follows a charged particle in a tokamak, including its gyration, and compares its orbits with the limit of a small gyroradius.
//!
//! H is in one piece, since the vector potential depends on positions. The guiding centre starts on the outer side of a flux surface
//! whose radius is a fifth of the major radius. The program prints:
//!
//! - the largest errors of H and of the toroidal momentum of a trapped particle over a million steps.
//! - for several gyroradii: the pitch that separates trapped from passing particles, for both directions and as their mean, and the
//!   width of a banana orbit divided by that of the theory, as the mean of both directions. The errors of both means decrease with
//!   the square of the gyroradius.
//!
//! The pitch is the velocity along the field divided by the speed.

mod particle;

use integrator_core::prelude::*;
use particle::{Tokamak, boundary_of_theory};
use std::time::Instant;

const MINOR: f64 = 0.2;
/// About five steps for each gyration.
const STEP: f64 = 1.5;

fn main() -> Result<(), Error> {
    let tokamak = Tokamak { safety: 2.0 };
    let start = tokamak.start(MINOR, 1e-3, 0.3);
    let (mut run, clock) = (tokamak.run(start, STEP)?, Instant::now());
    let (energy, mut errors) = (run.energy(), [0.0_f64; 2]);
    for _ in 0..10_000 {
        run.advance(100)?;
        let found = [run.energy() / energy, run.state().p[1] / start.p[1]];
        errors = std::array::from_fn(|i| errors[i].max((found[i] - 1.0).abs()));
    }
    println!("{} steps in {:.2} s", run.steps(), clock.elapsed().as_secs_f64());
    // H is the half square of differences of momenta and potentials, which are 200 times as large and rounded.
    println!("H {:.1e}, toroidal momentum {:.1e}", errors[0], errors[1]);
    let clock = Instant::now();
    println!("\ngyroradius           boundary along   against the field   mean         banana width / theory");
    for speed in [8e-3, 4e-3, 2e-3, 1e-3] {
        let [along, against] = [1.0, -1.0].map(|sign| tokamak.boundary(MINOR, speed, sign, STEP));
        let (along, against) = (along?, against?);
        let mut width = 0.0;
        for pitch in [0.3, -0.3] {
            width += 0.5 * tokamak.banana(MINOR, speed, pitch, STEP)? / tokamak.banana_of_theory(MINOR, speed, pitch);
        }
        println!("{speed:<20} {along:14.5} {against:19.5} {:10.5} {width:18.5}", 0.5 * (along + against));
    }
    println!("theory {:59.5}", boundary_of_theory(MINOR));
    println!("{:.2} s", clock.elapsed().as_secs_f64());
    Ok(())
}
