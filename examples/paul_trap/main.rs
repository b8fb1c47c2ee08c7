//! Integrates ions in a Paul trap, with a time-dependent Hamiltonian, and compares with Mathieu's equation.
//!
//! A constant voltage cannot confine an ion. An alternating voltage can, if its parameters `(a, q)` are in the stable region.
//! The picture `paul_trap.png` shows the region where both directions are stable, from the map of one period of each of 1.2
//! million traps. It also shows a stable orbit, slow with a fast micromotion, and an unstable one, which grows.
//!
//! The program prints where the region ends on the axis `a = 0` (0.9080463337 by Mathieu's equation) and the largest distances
//! of the two orbits.

mod picture;
#[path = "../support/mod.rs"]
mod support;
mod trap;

use integrator_plot::write;
use picture::{Orbit, picture};
use std::error::Error;
use support::{Watch, folder};
use trap::{PaulTrap, edge, orbit, traces};

const ROWS: u32 = 1000;
const COLUMNS: u32 = 1200;
/// Periods of the voltage for each orbit.
const PERIODS: u64 = 60;

fn main() -> Result<(), Box<dyn Error>> {
    let watch = Watch::new(u64::from(ROWS), "rows of traps");
    let mut all = Vec::new();
    for row in 0..ROWS {
        let a = 0.5 * (f64::from(row) + 0.5) / f64::from(ROWS) - 0.25;
        let traps = (0..COLUMNS).map(|column| PaulTrap { a, q: 1.2 * (f64::from(column) + 0.5) / f64::from(COLUMNS) });
        all.extend(traps.clone().zip(traces(traps)?));
        if !watch.done(u64::from(row)) {
            break;
        }
    }
    drop(watch);

    let (inside, outside, edge) = (PaulTrap { a: 0.0, q: 0.3 }, PaulTrap { a: 0.0, q: 0.91 }, edge()?);
    let orbits = [
        Orbit { name: "Inside", trap: inside, points: orbit(inside, PERIODS)? },
        Orbit { name: "Outside", trap: outside, points: orbit(outside, PERIODS)? },
    ];
    let file = folder().join("paul_trap");
    write(&file, &picture(&all, &orbits, edge))?;
    println!("the picture is {}", file.with_extension("png").display());
    println!("edge={edge}");
    for Orbit { name, points, .. } in &orbits {
        let greatest = points.iter().map(|(_, x)| x.abs()).fold(0.0, f64::max);
        println!("greatest_distance_{}={greatest}", name.to_lowercase());
    }
    Ok(())
}
