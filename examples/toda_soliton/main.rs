//! Integrates a soliton on the Toda lattice, a wave that travels around a ring and keeps its shape.
//!
//! The picture `toda_soliton.png` shows the momenta of all sites at several times in the first period, one above the other,
//! with the closed form as dots. On the right it shows the distance from the closed form over a hundred periods. The distance
//! grows linearly with time, because the step changes the speed slightly; the shape stays. Positions grow by 2κ per period and
//! lose digits, so the run compensates rounding errors.
//!
//! The program prints the speed, `sinh κ / κ`, and the distances after the first and the last period, in units of the height of
//! the wave.

mod picture;
mod ring;
#[path = "../support/mod.rs"]
mod support;

use integrator_core::prelude::*;
use integrator_plot::write;
use picture::picture;
use ring::{Soliton, values};
use std::error::Error;
use support::{Watch, folder};

const SOLITON: Soliton = Soliton { sites: 64, kappa: 1.0 };
/// Steps per period, of 0.053 each.
const STEPS: u64 = 1020;
const PERIODS: u64 = 100;
/// Samples in the first period.
const SAMPLES: u64 = 6;

fn main() -> Result<(), Box<dyn Error>> {
    let h = SOLITON.period() / STEPS as f64;
    let start = SOLITON.state(0.0);
    let run = SOLITON.ring().run(Phase::compensated(start.q, start.p), h)?;
    let samples: Vec<_> = run
        .clone()
        .samples(STEPS / SAMPLES)
        .take(SAMPLES as usize + 1)
        .map(|sample| sample.map(|sample| (sample.time, values(&sample.state))))
        .collect::<Result<_, _>>()?;

    let watch = Watch::new(STEPS * PERIODS, "steps");
    let mut distances = Vec::new();
    for sample in run.samples(STEPS).skip(1).take(PERIODS as usize) {
        let sample = sample?;
        distances.push((sample.step as f64 / STEPS as f64, SOLITON.distance(&values(&sample.state), sample.time)));
        if !watch.done(sample.step) {
            break;
        }
    }
    drop(watch);

    let [(_, first), .., (periods, last)] = distances[..] else { return Err("stopped in the first period".into()) };
    let file = folder().join("toda_soliton");
    write(&file, &picture(&SOLITON, &samples, &distances))?;
    println!("the picture is {}", file.with_extension("png").display());
    println!("speed={}", SOLITON.speed());
    println!("distance_after_one_turn={:e}", first[0]);
    println!("distance_after_{periods}_periods={:e}", last[0]);
    Ok(())
}
