//! Hamiltonian Monte Carlo: what 23 launches of the space shuttle said of the 24th.
//!
//! A logistic regression of the distress of O-rings on the temperature, with the posterior density of its two coefficients
//! as a potential: trajectories with random momenta lead to points that are accepted nearly always, because a symplectic step
//! keeps the energy. Look at the picture, `hmc.png`: on the left the draws, on the right how likely distress is, with the
//! middle 90 % of what the posterior allows; it was 31 °F on the morning of Challenger. Printed: the share of accepted
//! trajectories, effective sample sizes, the mean of both coefficients against a sum over a grid, in standard errors,
//! and the probability at 31 °F.

mod posterior;
mod sampler;
#[path = "../support/mod.rs"]
mod support;

use integrator_plot::{Axis, Chart, Panels, colour, write};
use posterior::Posterior;
use sampler::{Sampler, effective_size, moments};
use std::error::Error;
use support::{Watch, folder};

const DRAWS: usize = 50_000;
const MORNING: f64 = 31.0;

/// What lies at a share of a series, from the least on.
fn quantile(mut series: Vec<f64>, share: f64) -> f64 {
    series.sort_by(f64::total_cmp);
    series[(share * (series.len() - 1) as f64) as usize]
}

fn main() -> Result<(), Box<dyn Error>> {
    let posterior = Posterior::measured(3.0)?;
    let mut sampler = Sampler::new(&posterior, 0.4, 12, 1986);
    let watch = Watch::new(DRAWS as u64, "draws");
    let mut draws = Vec::with_capacity(DRAWS);
    while draws.len() < DRAWS && watch.done(draws.len() as u64) {
        draws.push(sampler.draw()?);
    }
    drop(watch);
    if draws.len() < 100 {
        return Err("stopped after less than a hundred draws".into());
    }

    let at = |temperature: f64| draws.iter().map(|b| posterior.probability(*b, temperature)).collect::<Vec<_>>();
    let curve =
        |of: &dyn Fn(Vec<f64>) -> f64| (30..=85).map(|t| (f64::from(t), of(at(f64::from(t))))).collect::<Vec<_>>();
    let coefficients = posterior.per_degree(posterior.mean_on_grid(200, |b| b));
    let scatter = Chart::new("Draws from the posterior")
        .measured(format!("{:.0} % of the trajectories are accepted", 100.0 * sampler.acceptance()))
        .along(Axis::linear("intercept"))
        .up(Axis::linear("slope per degree"))
        .cloud("", draws.iter().map(|b| posterior.per_degree(*b).into()))
        .coloured(colour::COLOURS[6])
        .dots("", [coefficients.into()])
        .coloured(colour::COLOURS[3]);
    let risk = Chart::new("Probability of distress")
        .claim("Black: mean. Grey: middle 90 %. Dots: launches, with distress above and without below")
        .along(Axis::linear("temperature in °F"))
        .up(Axis::linear("probability"))
        .line("", curve(&|series| moments(&series).0))
        .line("", curve(&|series| quantile(series, 0.05)))
        .coloured(colour::GREY)
        .line("", curve(&|series| quantile(series, 0.95)))
        .coloured(colour::GREY)
        .dots("", posterior.launches())
        .coloured(colour::COLOURS[3]);
    let picture = Panels::new("O-rings", "What 23 launches said of the next one").columns(2).panel(620, 520);
    let file = folder().join("hmc");
    let morning = moments(&at(MORNING)).0;
    let measured = format!("at {MORNING} °F: {:.0} %", 100.0 * morning);
    write(&file, &picture.measured(measured).chart(scatter).chart(risk))?;

    println!("the picture is {}", file.with_extension("png").display());
    println!("acceptance_rate={}", sampler.acceptance());
    let reference = posterior.mean_on_grid(200, |b| b);
    for (axis, name) in ["intercept", "slope"].into_iter().enumerate() {
        let series: Vec<f64> = draws.iter().map(|b| b[axis]).collect();
        let ((mean, variance), size) = (moments(&series), effective_size(&series));
        println!("effective_sample_size_{name}={size:.0}");
        println!("posterior_mean_{name}={mean}");
        println!("off_by_standard_errors_{name}={}", (mean - reference[axis]) / (variance / size).sqrt());
    }
    println!("probability_at_31_F={morning}");
    Ok(())
}
