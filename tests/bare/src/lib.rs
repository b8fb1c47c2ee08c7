//! Uses the library in a program without an operating system: `cargo build -p integrator-bare --target
//! thumbv7em-none-eabihf`.
#![no_std]
#![forbid(unsafe_code)]

extern crate alloc;

use alloc::{vec, vec::Vec};
#[allow(unused_imports, reason = "where others in the workspace ask for `std`, methods of `f64` are its own")]
use integrator_core::prelude::*;

/// Elementary functions of parameters and of coordinates, which `core` does not provide.
pub struct Pendulum {
    /// Distance from the pivot to the bob.
    pub length: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.length.cbrt().powi(3) * q[0].cos()
    }
}

/// A state with a size known at run time.
pub struct Chain;

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 1..q.len() {
            sum += (q[i] - q[i - 1]).powi(2) / 2.0;
        }
        sum
    }
}

/// Returns the state of a pendulum after `steps` steps, resumed from a checkpoint half way.
///
/// # Errors
/// If the library returns one.
pub fn swing(steps: u64) -> Result<[f64; 2], Error> {
    let pendulum = Pendulum { length: 0.5 };
    let mut run = pendulum.run(Phase::compensated([1.0], [0.0]), 0.01)?;
    run.advance(steps / 2)?;
    let bytes = run.checkpoint();
    if let Ok(resumed) = Run::resume(&pendulum, &bytes) {
        run = resumed;
    }
    run.advance(steps - steps / 2)?;
    let Phase { q: [q], p: [p] } = run.state();
    Ok([q.value, p.value])
}

/// Returns the energy change of a chain of `sites` sites over `steps` steps.
///
/// # Errors
/// If the library returns one.
pub fn drift(sites: usize, steps: u64) -> Result<f64, Error> {
    let q: Vec<f64> = (0..sites).map(|site| (site as f64).sin()).collect();
    let samples = Chain.run(Phase::new(q, vec![0.0; sites]), 0.01)?.samples(steps);
    let energies: Vec<f64> = samples.take(2).map(|sample| Ok(sample?.energy())).collect::<Result<_, Error>>()?;
    Ok(energies[1] - energies[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn systems_move_without_std_as_they_do_with_it() {
        let [q, p] = swing(1_000).expect("a pendulum");
        let energy = p * p / (2.0 * 0.25) - 9.81 * 0.5 * q.cos();
        // The step is 1/140 of the period, so the relative energy error of Yoshida4 is of the order (2π/140)^4.
        assert!((energy + 9.81 * 0.5 * 1.0_f64.cos()).abs() < 1e-4, "{q} {p}: {energy}");
        // With 6e4 sites the run uses tiles. The energy is of this size, and the relative error of Verlet is (h/2)².
        assert!(drift(60_000, 100).expect("a chain").abs() < 60_000.0 * 2.5e-5);
    }
}
