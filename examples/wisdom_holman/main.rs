//! Integrates the outer solar system by the splitting of Wisdom and Holman (1991) and by `T + V`.
//!
//! With `coordinates = jacobi(self.masses)` on the same two functions, each planet moves on its exact Kepler orbit. Kicks apply
//! the remaining forces, which are smaller by the ratio of the masses.
//!
//! For steps of two years and less, the program prints the time and the distance from a reference in 113-bit arithmetic, 999,999
//! days later. It prints the same for a composition of `T + V` with as many forces.

mod planets;

use integrator_core::prelude::*;
use planets::{Planets, end, system::measured};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let (separable, start) = measured()?;
    let (planets, _) = measured()?;
    let planets = Planets(planets);
    println!("days per step  Kepler + interaction   microseconds   T + V, as many forces   microseconds");
    for power in 10..14 {
        let steps = 1 << power;
        let [error, seconds] = end(&planets, Aba1064, start, steps)?;
        let forces = steps * Aba1064::FORCE_EVALUATIONS as u64;
        let [of_separable, time] = end(&separable, BlanesMoanSrkn14, start, forces / 14)?;
        let days = 999_999.0 / steps as f64;
        println!("{days:13.0} {error:21.1e} {:14.0} {of_separable:23.1e} {:14.0}", 1e6 * seconds, 1e6 * time);
    }
    Ok(())
}
