//! A star near the centre of a galaxy (Hénon and Heiles 1964), by two splittings.

use integrator_core::prelude::*;

/// The star, split into kinetic and potential energy.
pub(crate) struct Star;

#[hamiltonian(compose = Verlet)]
impl Star {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) + 0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

/// The star, split into two oscillators, solved exactly, and their coupling.
pub(crate) struct Oscillators;

#[hamiltonian(split = quadratic + rest, compose = Verlet)]
impl Oscillators {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) + 0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

/// Returns the largest relative energy change over a time of 1,000, for an orbit of this size.
pub(crate) fn energy_change<H, X>(system: &H, composition: X, size: f64, h: f64) -> Result<f64, Error>
where
    H: Hamiltonian<Coords = [f64; 2]>,
    X: Composition<H>,
{
    let run = system.run_with(composition, Phase::new([0.6 * size, 0.0], [0.0, 0.8 * size]), h)?;
    let energy = run.energy();
    let mut change = 0.0_f64;
    for sample in run.samples(1).take((1000.0 / h) as usize) {
        change = change.max(((sample?.energy() - energy) / energy).abs());
    }
    Ok(change)
}
