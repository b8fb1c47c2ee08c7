//! Integrates Halley's comet among the giant planets, in steps that shorten near the Sun.
//!
//! The mass of the comet is negligible. `Logarithmic`, whose steps follow the whole potential, would hence not adapt to it. `fn
//! rate` makes the steps follow the distance of the comet from the Sun and its angular velocity.
//!
//! The program prints the dates of its perihelia from 1759 to 2061, beside observed or predicted ones. The jets of the comet
//! delay it by about four days per revolution; they are not part of the Hamiltonian. The Earth is missing too. In 1910 it came
//! within 0.15 AU of the comet, so earlier perihelia are off by weeks. The pictures are `halley_orbit.png` and
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
