//! Samples a logistic regression of 23 launches of the space shuttle by Hamiltonian Monte Carlo.
//!
//! The model is the distress of O-rings against the temperature. The negative logarithm of the posterior density of its two
//! coefficients is the potential. Trajectories with random momenta propose points, which are nearly always accepted because a
//! symplectic step conserves the energy well.
//!
//! The picture `hmc.png` shows the draws on the left, and the probability of distress with its middle 90 % on the right. On the
//! morning of the Challenger launch it was 31 °F. The program prints the acceptance rate, effective sample sizes, the
//! probability at 31 °F, and the deviation of the mean coefficients from a sum over a grid, in standard errors.
//!
//! Steps are those of Blanes, Casas and Sanz-Serna (2014), which have the smallest mean energy error on normal distributions. A table
//! compares them with the leapfrog, and with a hand-written leapfrog loop, on 256 normal numbers of different widths. All trajectories
//! have the same longest duration. If kicks are farther apart, a trajectory needs fewer of them, but it is rejected more often.

mod by_hand;
mod normal_density;
mod picture;
mod posterior;
mod sampler;
mod statistics;
#[path = "../support/mod.rs"]
mod support;

use by_hand::ByHand;
use integrator_core::prelude::*;
use integrator_plot::write;
use normal_density::{COUNT, Normal};
use picture::{MORNING, picture, probabilities};
use posterior::Posterior;
use sampler::{MinimumError2, MinimumError3, Sampler};
use statistics::{effective_size, moments};
use std::{error::Error, time::Instant};
use support::{Watch, folder};

const DRAWS: usize = 50_000;
/// Draws of each method in the table.
const COMPARED: usize = 20_000;

fn main() -> Result<(), Box<dyn Error>> {
    let posterior = Posterior::measured(3.0)?;
    let mut sampler = Sampler::new(&posterior, MinimumError3, 1.2, 4, 1986)?;
    let watch = Watch::new(DRAWS as u64, "draws");
    let mut draws = Vec::with_capacity(DRAWS);
    while draws.len() < DRAWS && watch.done(draws.len() as u64) {
        draws.push(sampler.draw()?);
    }
    drop(watch);
    if draws.len() < 100 {
        return Err("stopped after less than a hundred draws".into());
    }

    let file = folder().join("hmc");
    let reference = posterior.mean_on_grid(200, |b| b);
    write(&file, &picture(&posterior, &draws, reference, sampler.acceptance()))?;
    println!("the picture is {}", file.with_extension("png").display());
    println!("acceptance_rate={}", sampler.acceptance());
    for (axis, name) in ["intercept", "slope"].into_iter().enumerate() {
        let series: Vec<f64> = draws.iter().map(|b| b[axis]).collect();
        let ((mean, variance), size) = (moments(&series), effective_size(&series));
        println!("effective_sample_size_{name}={size:.0}");
        println!("posterior_mean_{name}={mean}");
        println!("off_by_standard_errors_{name}={}", (mean - reference[axis]) / (variance / size).sqrt());
    }
    println!("probability_at_{MORNING}_F={}", moments(&probabilities(&posterior, &draws, MORNING)).0);

    println!("time between kicks   method             acceptance   effective draws per 1000 kicks   per second");
    for between in [0.075, 0.1, 0.15] {
        let (wide, kicks) = (Normal::wide(), (2.4 / between) as u64);
        let mut leapfrog = Sampler::new(&wide, VelocityVerlet, between, kicks, 1986)?;
        compare((between, kicks, 1), "leapfrog", || leapfrog.draw())?;
        let mut two = Sampler::new(&wide, MinimumError2, 2.0 * between, kicks / 2, 1986)?;
        compare((between, kicks, 2), "two kicks", || two.draw())?;
        let mut three = Sampler::new(&wide, MinimumError3, 3.0 * between, kicks / 3, 1986)?;
        compare((between, kicks, 3), "three kicks", || three.draw())?;
        let mut by_hand = ByHand::new(wide, between, kicks, 1986);
        compare((between, kicks, 1), "leapfrog by hand", || Ok(by_hand.draw()))?;
    }
    Ok(())
}

/// Prints the share of accepted trajectories and the effective number of draws: that of the squares of the widest or the narrowest
/// coordinate, whichever is smaller. A trajectory has up to `kicks / of_step` steps.
fn compare(
    (between, kicks, of_step): (f64, u64, u64),
    name: &str,
    mut draw: impl FnMut() -> Result<[f64; COUNT], integrator_core::Error>,
) -> Result<(), Box<dyn Error>> {
    let clock = Instant::now();
    let draws: Vec<_> = (0..COMPARED).map(|_| draw()).collect::<Result<_, _>>()?;
    let seconds = clock.elapsed().as_secs_f64();
    let accepted = draws.windows(2).filter(|pair| pair[0] != pair[1]).count() as f64 / (COMPARED - 1) as f64;
    let size = |i: usize| effective_size(&draws.iter().map(|q| q[i] * q[i]).collect::<Vec<_>>());
    let size = size(0).min(size(COUNT - 1));
    let thousands = 5e-4 * ((1 + kicks / of_step) * of_step) as f64 * COMPARED as f64;
    println!("{between:18}   {name:18} {accepted:10.3} {:32.1} {:12.0}", size / thousands, size / seconds);
    Ok(())
}
