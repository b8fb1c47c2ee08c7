//! Order and chaos in a galaxy: Poincaré sections of Hénon and Heiles at three energies.
//!
//! An orbit that has a third integral beside energy and angular momentum meets the section on a curve; one that has none
//! fills an area. Look at the picture, `henon_heiles_section.png`: curves alone at the lowest energy, islands in a sea at
//! the second, hardly an island at the energy of escape. Each point is reached by a shortened step of the same
//! composition, so that curves are as thin as the run is accurate. Printed: the share of the section that is regular
//! at each energy, by the growth of the distance from an orbit nearby, and the energy error of all orbits.

mod section;
#[path = "../support/mod.rs"]
mod support;

use integrator_plot::{Axis, Chart, Panels, colour, write};
use section::{border, orbit, starts};
use std::error::Error;
use support::{Watch, folder};

/// Hénon and Heiles' own energies: 1/12, 1/8 and that of escape.
const ENERGIES: [(&str, f64); 3] = [("1/12", 1.0 / 12.0), ("1/8", 0.125), ("1/6", 1.0 / 6.0)];
const SIDE: u32 = 11;
const PASSAGES: usize = 1000;

fn main() -> Result<(), Box<dyn Error>> {
    let total: usize = ENERGIES.iter().map(|(_, energy)| starts(*energy, SIDE).len()).sum();
    let watch = Watch::new(total as u64, "orbits");
    let (mut done, mut worst, mut lines) = (0, 0.0_f64, Vec::new());
    let mut panels =
        Panels::new("Sections of Hénon and Heiles", "Blue: regular orbits, on curves. Orange: chaotic ones, all over.")
            .panel(520, 520);
    for (name, energy) in ENERGIES {
        let mut orbits = Vec::new();
        for start in starts(energy, SIDE) {
            if !watch.done(done) {
                break;
            }
            orbits.push(orbit(energy, start, PASSAGES)?);
            done += 1;
        }
        let share = orbits.iter().filter(|orbit| orbit.regular).count() as f64 / orbits.len().max(1) as f64;
        worst = orbits.iter().map(|orbit| orbit.energy_error).fold(worst, f64::max);
        lines.push(format!("regular_share_at_{name}={share}"));
        let points = |regular: bool| {
            orbits.iter().filter(move |orbit| orbit.regular == regular).flat_map(|orbit| orbit.points.clone())
        };
        let chart = Chart::new(format!("Energy {name}"))
            .measured(format!("{:.0} % of the section is regular", 100.0 * share))
            .along(Axis::linear("y"))
            .up(Axis::linear("p_y"))
            .line("", border(energy))
            .coloured(colour::GREY)
            .cloud("", points(false))
            .coloured(colour::COLOURS[3])
            .cloud("", points(true))
            .coloured(colour::COLOURS[6]);
        panels = panels.chart(chart);
    }
    drop(watch);
    write(&folder().join("henon_heiles_section"), &panels)?;
    println!("{done} orbits; the picture is {}", folder().join("henon_heiles_section.png").display());
    println!("{}", lines.join("\n"));
    println!("energy_error_max={worst:e}");
    Ok(())
}
