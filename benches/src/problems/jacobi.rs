//! Kepler parts and interaction in Jacobi coordinates.

use super::GRAVITY;
use integrator_core::prelude::*;

/// The outer solar system in Jacobi coordinates.
#[derive(Clone, Copy)]
pub struct Jacobi {
    /// Masses in solar masses.
    pub masses: [f64; 6],
}

#[hamiltonian(coordinates = jacobi(self.masses), split = kepler + interaction, compose = Aba1064)]
impl Jacobi {
    fn kinetic(&self, p: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= GRAVITY * self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        energy
    }
}
