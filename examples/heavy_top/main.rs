//! Integrates a heavy symmetric top in Euler angles, and compares its nutation with elliptic functions.
//!
//! H is in one piece: the kinetic energy depends on the tilt. The program prints:
//!
//! - for the three kinds of motion over 10,000 nutations (the axis draws loops, cusps or waves on a sphere): the nutation period and
//!   the precession per nutation, each with its relative difference from the closed form in parentheses. The last columns are the
//!   largest errors of cos θ and of H, where θ is the tilt.
//! - for several spins: the largest tilt of a top that is released at rest one degree from the vertical, the closed form, and the
//!   closed form of an upright top. An upright top is stable (sleeps) if `(I₃ ω₃)² > 4 I₁ m g l`, here if the spin exceeds two.

mod elliptic;
mod top;

use integrator_core::prelude::*;
use std::time::Instant;
use top::{Release, Top, largest_tilt, motion};

const STEP: f64 = 0.25;
const NUTATIONS: usize = 10_000;

fn main() -> Result<(), Error> {
    let top = Top { axial: 0.5 };
    let clock = Instant::now();
    println!("motion   period of nutation           precession per nutation     error of cos θ   of H");
    for (name, precession) in [("loops", -0.4), ("cusps", 0.0), ("waves", 0.2)] {
        let release = Release { height: 0.5, spin: 3.0, precession };
        let exact = release.nutation();
        let found = motion(&top, &release, STEP, NUTATIONS)?;
        let [period, angle] = [found.period / exact.period(), found.precession / exact.precession()].map(|r| r - 1.0);
        println!(
            "{name:5} {:18.12} ({period:8.1e}) {:18.12} ({angle:8.1e}) {:13.1e} {:9.1e}",
            found.period, found.precession, found.height_error, found.energy_error
        );
    }
    println!("{:.2} s", clock.elapsed().as_secs_f64());

    println!("\nspin   largest tilt in degrees   closed form   upright top");
    for spin in [0.5_f64, 1.0, 1.5, 1.9, 1.99, 2.01, 2.1, 2.5] {
        let release = Release { height: 1.0_f64.to_radians().cos(), spin, precession: 0.0 };
        let found = largest_tilt(&top, &release, 0.05, 1_000)?.to_degrees();
        let upright = (0.5 * spin * spin - 1.0).min(1.0).acos().to_degrees();
        println!("{spin:<6} {found:22.10} {:16.10} {upright:10.4}", release.nutation().lowest.acos().to_degrees());
    }
    Ok(())
}
