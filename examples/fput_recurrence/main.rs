//! Shows the recurrence of Fermi, Pasta, Ulam and Tsingou: energy that does not spread over all modes.
//!
//! A chain of 32 segments with slightly nonlinear springs starts in its lowest mode. The energy moves to the next few modes and
//! then returns. In the picture `fput_recurrence.png`, the lowest mode has nearly all of the energy again after 146 periods.
//! The literature gives 157: this is the result of the original leapfrog with its step, the dashed curve.
//!
//! The program prints when and how much of the energy returns, how well the total is conserved, and the recurrence time with
//! the original step.

mod chain;
mod picture;
#[path = "../support/mod.rs"]
mod support;

use chain::{ALPHA, Chain, THEIR_STEP, mode_shares, recurrence, start};
use integrator_core::prelude::*;
use integrator_plot::write;
use picture::picture;
use std::error::Error;
use support::{Watch, folder};

const PERIODS: f64 = 200.0;
const MODES: usize = 5;

fn main() -> Result<(), Box<dyn Error>> {
    let chain = Chain { alpha: ALPHA };
    let watch = Watch::new(2 * PERIODS as u64, "periods");
    let exact = chain.run(start(), 0.5)?;
    let (exact, energy_error) = mode_shares::<MODES>(exact, 16, PERIODS, |time| watch.done(time as u64))?;
    let theirs = chain.run_with(VelocityVerlet, start(), THEIR_STEP)?;
    let (theirs, _) = mode_shares::<1>(theirs, 16, PERIODS, |time| watch.done((PERIODS + time) as u64))?;
    drop(watch);

    let (periods, share) = recurrence(&exact).ok_or("stopped before the energy came back")?;
    let file = folder().join("fput_recurrence");
    write(&file, &picture(&exact, &theirs, (periods, share)))?;
    println!("the picture is {}", file.with_extension("png").display());
    println!("recurrence_periods={periods}");
    println!("share_that_came_back={share}");
    println!("energy_error_max={energy_error:e}");
    if let Some((periods, _)) = recurrence(&theirs) {
        println!("recurrence_periods_with_their_step={periods}");
    }
    Ok(())
}
