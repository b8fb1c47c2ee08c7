//! Integrates a pendulum from two plain functions, without equations of motion.
//!
//! The program prints angle, angular momentum and energy change along a swing of large amplitude, then the certificate of the
//! stepper. The energy change in the last column oscillates. After a million steps, in the last row, it is as small as in the
//! first swing.

use integrator_core::prelude::*;

struct Pendulum {
    mass: f64,
    length: f64,
    gravity: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.mass * self.gravity * self.length * q[0].cos()
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let pendulum = Pendulum { mass: 0.5, length: 1.0, gravity: 9.81 };
    let start = Phase::new([2.0], [0.0]);
    let h = 0.01;

    println!("{:>10} {:>10} {:>10} {:>12}", "time", "angle", "momentum", "energy - E0");
    let mut run = pendulum.run(start, h)?;
    let energy = run.energy();
    let print = |time: f64, state: Phase<[f64; 1]>, change: f64| {
        println!("{time:10.2} {:10.6} {:10.6} {change:12.1e}", state.q[0], state.p[0]);
    };
    for sample in run.clone().samples(25).take(12) {
        let sample = sample?;
        print(sample.time, sample.state, sample.energy() - energy);
    }
    run.advance(1_000_000)?;
    print(run.time(), run.state(), run.energy() - energy);

    println!("\n{}", certify(&pendulum, Yoshida4, start, h)?);
    Ok(())
}
