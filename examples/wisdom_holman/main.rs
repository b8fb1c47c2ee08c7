//! The outer solar system by the splitting of Wisdom and Holman (1991), beside `T + V`.
//!
//! The same two functions, once with `coordinates = jacobi(self.masses)`: the stepper then moves each planet on its exact
//! Kepler orbit and kicks it by what is left of the forces, which is as small as the planets are. Printed: for steps of
//! two years and less, the distance from a reference that was computed in 113-bit arithmetic, 999,999 days later, and the
//! time, beside a composition for `T + V` that computes as many forces.

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
