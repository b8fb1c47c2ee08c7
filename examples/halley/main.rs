//! Halley's comet among the giant planets, in steps that shorten by themselves near the Sun.
//!
//! The comet's pull on anything is nothing, so that the pace of `Logarithmic`, which follows the whole potential, would not
//! notice it; `fn rate` says what the steps follow instead: the comet's distance from the Sun, and how fast it goes round
//! there. Printed: the days of its perihelia from 1759 to 2061 beside the observed or predicted ones. The jets of the comet
//! delay it by about four days a revolution, which no Hamiltonian knows, and the Earth is missing here: in 1910 it came within
//! 0.15 AU of the comet, so that perihelia before are weeks off. Look at the pictures, `halley_orbit.png` and
//! `halley_elements.png`.

mod comet;
mod pictures;
#[path = "../support/mod.rs"]
#[allow(dead_code, reason = "other examples show how far they are")]
mod support;
#[path = "../outer_solar_system/system.rs"]
#[allow(dead_code, reason = "the example of that name reads more of it")]
mod system;

use comet::{KNOWN, Solar, perihelia, start};
use std::error::Error;
use support::folder;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = folder();
    let (system, begin): (Solar, _) = start()?;
    let found = perihelia(&system, begin, [2_360_000.0, 2_477_500.0])?;
    println!("perihelion    Julian day    known    days apart");
    for (year, known) in KNOWN {
        let nearest = found.iter().copied().min_by(|a, b| (a - known).abs().total_cmp(&(b - known).abs()));
        let day = nearest.ok_or("no perihelion")?;
        println!("{year:10} {day:13.2} {known:12.2} {:10.2}", day - known);
    }
    pictures::orbit(&system, begin, &folder)?;
    pictures::elements(&system, begin, &folder)?;
    println!("the pictures are {} and halley_elements.png", folder.join("halley_orbit.png").display());
    Ok(())
}
