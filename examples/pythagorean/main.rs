//! Three bodies of masses 3, 4 and 5 that fall from rest at the corners of a triangle with sides 3, 4 and 5 (Burrau 1913):
//! close encounters, the closest of 4e-4, until one of them leaves the others for good (Szebehely and Peters 1967, Astron. J.
//! 72, 876).
//!
//! Fixed steps fail at the first encounter; those of the logarithmic Hamiltonian shorten there. Printed: where the bodies are
//! at t = 70 for ever shorter steps, the change of the energy, and the closest approach. Look at the picture, `pythagorean.png`.

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
