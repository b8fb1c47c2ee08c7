//! Integrates the Pythagorean problem: three bodies that fall from rest, through close encounters, until one is ejected.
//!
//! Bodies of masses 3, 4 and 5 start at the corners of a triangle with sides 3, 4 and 5 (Burrau 1913). The closest encounter is
//! at 4e-4, and one body leaves the others (Szebehely and Peters 1967, Astron. J. 72, 876). Fixed steps fail at the first
//! encounter; those of the logarithmic Hamiltonian shorten there.
//!
//! The program prints the positions at t = 70 for shorter and shorter steps, the energy change, and the closest approach. The
//! picture is `pythagorean.png`.

mod bodies;
mod picture;
#[path = "../support/mod.rs"]
#[allow(dead_code, reason = "other examples show how far they are")]
mod support;

use bodies::{closest_approach, end};
use std::error::Error;
use support::folder;

fn main() -> Result<(), Box<dyn Error>> {
    println!("step   steps  change of the energy   body of mass 3 at t = 70");
    for h in [0.4, 0.2, 0.1, 0.05] {
        let (run, change) = end(h)?;
        let [x, y] = run.state().q[0].map(|leaf| leaf.value);
        println!("{h:4} {:7} {change:21.1e}   ({x:.6}, {y:.6})", run.steps());
    }
    let (distance, time) = closest_approach(0.05)?;
    println!("closest approach: {distance:.2e} at t = {time:.4}");
    let file = folder().join("pythagorean");
    picture::paths(&file)?;
    println!("the picture is {}", file.with_extension("png").display());
    Ok(())
}
