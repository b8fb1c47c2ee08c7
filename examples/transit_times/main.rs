//! Fits the masses and orbits of four planets to noisy times of their transits, by gradients of runs.
//!
//! The planets pull at each other, so that transits come early or late by up to an hour. These variations tell the masses. A run of
//! 400 days depends on 20 numbers; one run there and one back have all derivatives.
//!
//! `cargo run --release --example transit_times --features study`

mod fit;
mod planets;

use fit::{fitted, of_linear_times, time_of_differences};
use planets::{Orbit, PLANETS, Transit, misses, start, transits};
use std::{error::Error, f64::consts::TAU, time::Instant};

/// The number of steps of a run: 400 days.
const STEPS: u64 = 20_000;
/// The standard deviation of measured times: one minute, in days.
const ERROR: f64 = 1.0 / 1440.0;

fn main() -> Result<(), Box<dyn Error>> {
    // Neighbours with ratios of periods not far from 3:2, where variations are large.
    let truth = [
        (10.0, 1.1, [0.004, -0.002], 2.4e-5),
        (15.7, 3.0, [-0.003, 0.004], 3.6e-5),
        (24.9, 5.2, [0.002, 0.005], 1.8e-5),
        (38.9, 0.4, [-0.004, -0.002], 4.5e-5),
    ]
    .map(|(period, longitude, eccentricity, mass): (f64, f64, _, f64)| Orbit {
        longitude,
        period,
        eccentricity,
        mass: mass.ln(),
    });
    let (system, point) = start(&truth);
    let mut random = fastrand::Rng::with_seed(3);
    let mut normal = || (-2.0 * random.f64().ln()).sqrt() * (TAU * random.f64()).cos();
    let exact = transits(&system, point, STEPS)?;
    let measured: Vec<Transit> =
        exact.iter().map(|transit| Transit { time: transit.time + ERROR * normal(), ..*transit }).collect();
    println!("{} transits in 400 days, measured to one minute", measured.len());

    let guess = of_linear_times(&measured);
    let (system, point) = start(&guess);
    let clock = Instant::now();
    let (gradient, _) = misses(&system, point, &measured, ERROR)?;
    let taken = clock.elapsed();
    println!("circular orbits with equal masses miss them by chi² = {:.0}", gradient.value);
    let differences = time_of_differences(&guess)?;
    println!("a gradient takes {taken:.1?}, by differences in 20 numbers {differences:.1?}");

    let (orbits, chi_square, evaluations) = fitted(guess, &measured, ERROR)?;
    println!("after {evaluations} gradients: chi² = {chi_square:.1}, for {} times and 20 numbers", measured.len());
    println!("planet   mass / 1e-5   fitted      period     fitted");
    for planet in 0..PLANETS {
        let (truth, orbit) = (truth[planet], orbits[planet]);
        println!(
            "{}        {:10.3} {:9.3} {:11.4} {:11.4}",
            ["b", "c", "d", "e"][planet],
            1e5 * truth.mass.exp(),
            1e5 * orbit.mass.exp(),
            truth.period,
            orbit.period
        );
    }
    Ok(())
}
