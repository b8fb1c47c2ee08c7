//! Integrates two weakly coupled oscillators by `T + V` and by `quadratic + rest`.
//!
//! The program prints the largest relative energy change over a time of 1,000 in steps of 0.2, for orbits of three sizes. For
//! smaller orbits the error of `T + V` stays the same. That of `quadratic + rest` falls, because only the cubic terms are
//! composed.

mod star;

use integrator_core::prelude::*;
use star::{Oscillators, Star, energy_change};

fn main() -> Result<(), Error> {
    let sizes = [0.3, 0.03, 0.003];
    println!("{:<26} {:>10} {:>10} {:>10}", "size of the orbit", sizes[0], sizes[1], sizes[2]);
    let row = |name: &str, change: &dyn Fn(f64) -> Result<f64, Error>| -> Result<(), Error> {
        let [first, second, third] = sizes.map(change);
        println!("{name:<26} {:>10.1e} {:>10.1e} {:>10.1e}", first?, second?, third?);
        Ok(())
    };
    row("T + V, Verlet", &|size| energy_change(&Star, Verlet, size, 0.2))?;
    row("quadratic + rest, Verlet", &|size| energy_change(&Oscillators, Verlet, size, 0.2))?;
    row("T + V, Yoshida4", &|size| energy_change(&Star, Yoshida4, size, 0.2))?;
    row("quadratic + rest, Aba864", &|size| energy_change(&Oscillators, Aba864, size, 0.2))
}
