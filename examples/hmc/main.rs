//! Samples a logistic regression of 23 launches of the space shuttle by Hamiltonian Monte Carlo.
//!
//! The model is the distress of O-rings against the temperature. The negative logarithm of the posterior density of its two
//! coefficients is the potential. Trajectories with random momenta propose points, which are nearly always accepted because a
//! symplectic step conserves the energy well.
//!
//! The picture `hmc.png` shows the draws on the left, and the probability of distress with its middle 90 % on the right. On the
//! morning of the Challenger launch it was 31 °F. The program prints the acceptance rate, effective sample sizes, the
//! probability at 31 °F, and the deviation of the mean coefficients from a sum over a grid, in standard errors.

mod picture;
mod posterior;
mod sampler;
#[path = "../support/mod.rs"]
mod support;

use integrator_plot::write;
use picture::{MORNING, picture, probabilities};
use posterior::Posterior;
use sampler::{Sampler, effective_size, moments};
use std::error::Error;
use support::{Watch, folder};

const DRAWS: usize = 50_000;

fn main() -> Result<(), Box<dyn Error>> {
    let posterior = Posterior::measured(3.0)?;
    let mut sampler = Sampler::new(&posterior, 0.4, 12, 1986)?;
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
    Ok(())
}
