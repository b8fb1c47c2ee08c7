//! The outer solar system, split into the motion of each planet around the Sun and what is left.

#[path = "../outer_solar_system/system.rs"]
#[allow(dead_code, reason = "the example of that name reads more of it")]
pub(crate) mod system;

use integrator_core::prelude::*;
use std::{error::Error, time::Instant};
use system::{Bodies, GRAVITY, OuterSolarSystem, reference, relative};

/// Time from the initial state to the reference.
const DAYS: f64 = 999_999.0;

/// The outer solar system in Jacobi coordinates: each body relative to the centre of mass of those before it.
pub(crate) struct Planets(pub(crate) OuterSolarSystem);

#[hamiltonian(coordinates = jacobi(self.0.masses), split = kepler + interaction, compose = Aba1064)]
impl Planets {
    /// `Σ |pᵢ|² / 2mᵢ`
    fn kinetic(&self, p: &[[f64; 3]; 6]) -> f64 {
        (0..6).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.0.masses[i])).sum()
    }

    /// `-Σ G mᵢ mⱼ / |qᵢ - qⱼ|` over all pairs
    fn potential(&self, q: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let square = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                energy -= GRAVITY * self.0.masses[i] * self.0.masses[j] / square.sqrt();
            }
        }
        energy
    }
}

/// Returns the distance from the reference after some steps, relative to the norm of all positions, and the elapsed
/// seconds.
pub(crate) fn end<H, X>(
    system: &H,
    composition: X,
    start: Phase<Bodies>,
    steps: u64,
) -> Result<[f64; 2], Box<dyn Error>>
where
    H: Hamiltonian<Coords = Bodies>,
    X: Composition<H>,
{
    let mut run = system.run_with::<f64, X>(composition, start, DAYS / steps as f64)?;
    let clock = Instant::now();
    run.advance(steps)?;
    let seconds = clock.elapsed().as_secs_f64();
    Ok([relative(run.state().q.as_flattened(), &reference()?), seconds])
}
