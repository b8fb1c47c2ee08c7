//! Draws the strange attractor of Duffing's oscillator, `x'' + 0.3 x' - x + x³ = 0.5 cos(1.2 t)`, and measures its Lyapunov exponents.
//!
//! The picture `duffing.png` shows a million states, each at the beginning of a period of the drive, and an enlarged part.
//!
//! Friction is solved exactly by the splitting, so each step multiplies areas by `exp(-0.3 h)` up to rounding. The program prints
//!
//! - the contraction in one period, divided by `exp(-0.3 t)`
//! - both Lyapunov exponents, and their sum, which is -0.3
//! - the dimension of the attractor by the exponents (Kaplan and Yorke 1979)
//! - the exponents at a drive of 0.1: a stable oscillation in one well, whose exponents are both -0.15

mod oscillator;
mod picture;
#[path = "../support/mod.rs"]
#[allow(dead_code, reason = "other examples show how far they are")]
mod support;

use integrator_plot::write;
use oscillator::{DELTA, Duffing, PERIOD, contraction, dimension, exponents, section, settled};
use picture::picture;
use std::error::Error;
use support::folder;

fn main() -> Result<(), Box<dyn Error>> {
    let [chaotic, weak] = [0.5, 0.1].map(|drive| Duffing { drive });
    let state = settled(chaotic, 1.0, 100)?;
    let found = exponents(chaotic, state, 10_000)?;
    let [positive, negative] = [found.exponents[0], found.exponents[1]];
    let points = section(chaotic, 2_000, 50, 500)?;
    let file = folder().join("duffing");
    let dimension = dimension([positive, negative]);
    write(&file, &picture(&points, positive, dimension))?;
    println!("the picture is {}", file.with_extension("png").display());
    println!("contraction_over_exact={:.12}", contraction(chaotic, state, 1)? / (-DELTA * PERIOD).exp());
    println!("exponents={positive:.4} ± {:.4} and {negative:.4}", found.uncertainties[0]);
    println!("sum_of_exponents={:.12}", found.sum());
    println!("dimension={dimension:.3}");
    let found = exponents(weak, settled(weak, 1.0, 100)?, 1_000)?;
    println!("exponents_at_a_weak_drive={:.4} and {:.4}", found.exponents[0], found.exponents[1]);
    Ok(())
}
