//! Integrates a particle in a Penning trap: a magnetic field, a quadrupole and an octupole.
//!
//! The magnetic field and the quadrupole are a quadratic form in `q` and `p`, whose flow is solved exactly. The octupole of
//! real electrodes is the rest.
//!
//! The program prints the distance from the closed form in an ideal trap, after a million steps of more than half a cyclotron
//! period each. It also prints the shift of the axial frequency by the octupole for growing amplitudes, beside first-order
//! perturbation theory, 3/4 C₄ times the square of the amplitude.

mod trap;

use integrator_core::prelude::*;
use trap::{Trap, axial_frequency};

/// A trap for protons in a field of 5 T, in units of the cyclotron frequency (76 MHz cyclotron, 1 MHz axial).
const TRAP: Trap = Trap { cyclotron: 1.0, axial: 0.0137, octupole: 0.0 };

fn main() -> Result<(), Error> {
    let (radii, h, steps) = ([0.02, 0.05], 4.0, 1_000_000);
    let mut run = TRAP.run(TRAP.start(radii, 0.1), h)?;
    run.advance(steps)?;
    let (q, exact) = (run.state().q, TRAP.orbit(radii, run.time()));
    let distance = (q[0] - exact[0]).hypot(q[1] - exact[1]);
    println!("ideal trap, {steps} steps of {h:.1}: {distance:.1e} from the closed form");

    println!("{:>10} {:>14} {:>14}", "amplitude", "shift", "first order");
    let real = Trap { octupole: 1e-3, ..TRAP };
    for amplitude in [0.1, 0.2, 0.4, 0.8] {
        let frequency = axial_frequency(&real, real.start([0.0, 0.0], amplitude), h, 100_000)?;
        let first_order = 0.75 * real.octupole * amplitude * amplitude;
        println!("{amplitude:>10} {:>14.6e} {first_order:>14.6e}", frequency / real.axial - 1.0);
    }
    Ok(())
}
