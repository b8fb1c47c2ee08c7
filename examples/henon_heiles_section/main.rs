//! Draws Poincaré sections of the Hénon–Heiles system at three energies.
//!
//! An orbit with a third integral, besides energy and angular momentum, meets the section on a curve; without one it fills an
//! area. The picture `henon_heiles_section.png` shows only curves at the lowest energy, islands in a chaotic sea at the second,
//! and hardly an island at the escape energy. A shortened step of the same composition reaches each point, so curves are as
//! thin as the run is accurate.
//!
//! The program prints the regular share of the section at each energy, from the distance of neighbouring orbits, and the energy
//! error of all orbits.

mod picture;
mod section;
#[path = "../support/mod.rs"]
mod support;

use integrator_plot::write;
use picture::{Section, picture};
use section::{orbit, starts};
use std::error::Error;
use support::{Watch, folder};

/// Energies of the original article: 1/12, 1/8 and the escape energy.
const ENERGIES: [(&str, f64); 3] = [("1/12", 1.0 / 12.0), ("1/8", 0.125), ("1/6", 1.0 / 6.0)];
const SIDE: u32 = 11;
const PASSAGES: usize = 1000;

fn main() -> Result<(), Box<dyn Error>> {
    let total: usize = ENERGIES.iter().map(|(_, energy)| starts(*energy, SIDE).len()).sum();
    let watch = Watch::new(total as u64, "orbits");
    let (mut done, mut sections) = (0, Vec::new());
    for (name, energy) in ENERGIES {
        let mut orbits = Vec::new();
        for start in starts(energy, SIDE) {
            if !watch.done(done) {
                break;
            }
            orbits.push(orbit(energy, start, PASSAGES)?);
            done += 1;
        }
        if !orbits.is_empty() {
            sections.push(Section { name, energy, orbits });
        }
    }
    drop(watch);
    let file = folder().join("henon_heiles_section");
    write(&file, &picture(&sections))?;
    println!("{done} orbits; the picture is {}", file.with_extension("png").display());
    for section in &sections {
        println!("regular_share_at_{}={}", section.name, section.regular());
    }
    let errors = sections.iter().flat_map(|section| &section.orbits).map(|orbit| orbit.energy_error);
    println!("energy_error_max={:e}", errors.fold(0.0, f64::max));
    Ok(())
}
