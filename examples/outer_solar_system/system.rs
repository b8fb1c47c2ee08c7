//! Six bodies that attract each other, their initial state, and a reference state 999,999 days later.

#[path = "../support/table.rs"]
mod table;

use integrator_core::prelude::*;
use std::num::ParseFloatError;
use table::{numbers, rows};

/// Gravitational constant in astronomical units, solar masses and days.
pub(crate) const GRAVITY: f64 = 2.95912208286e-4;

/// A position or a momentum of each body, `[body][axis]`.
pub(crate) type Bodies = [[f64; 3]; 6];

/// The Sun with the inner planets, Jupiter, Saturn, Uranus, Neptune and Pluto.
pub(crate) struct OuterSolarSystem {
    /// Masses in solar masses.
    pub(crate) masses: [f64; 6],
}

#[hamiltonian(compose = Yoshida4)]
impl OuterSolarSystem {
    /// `Σ |pᵢ|² / 2mᵢ`
    fn kinetic(&self, p: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }

    /// `-Σ G mᵢ mⱼ / |qᵢ - qⱼ|` over all pairs
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

/// Returns the system and its state on 5 September 1994. The table has velocities, which are multiplied by the masses.
pub(crate) fn measured() -> Result<(OuterSolarSystem, Phase<Bodies>), ParseFloatError> {
    let table = include_str!("../data/outer_solar_system.csv");
    let mut system = OuterSolarSystem { masses: [0.0; 6] };
    let mut start = Phase::new([[0.0; 3]; 6], [[0.0; 3]; 6]);
    for (i, row) in rows(table).enumerate() {
        let [mass] = numbers(&row, 1)?;
        system.masses[i] = mass;
        start.q[i] = numbers(&row, 2)?;
        start.p[i] = numbers(&row, 5)?.map(|v| mass * v);
    }
    Ok((system, start))
}

/// Returns the reference positions 999,999 days later, flattened, from 113-bit arithmetic.
pub(crate) fn reference() -> Result<Vec<f64>, serde_json::Error> {
    let problems: serde_json::Value = serde_json::from_str(include_str!("../data/problems.json"))?;
    let state: Vec<f64> = serde_json::from_value(problems["problems"]["solar"]["reference"]["z"].clone())?;
    Ok(state[..18].to_vec())
}

/// Returns the angular momentum, `Σ qᵢ × pᵢ`.
pub(crate) fn angular_momentum(state: &Phase<Bodies>) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for ([x, y, z], [px, py, pz]) in state.q.iter().zip(&state.p) {
        sum[0] += y * pz - z * py;
        sum[1] += z * px - x * pz;
        sum[2] += x * py - y * px;
    }
    sum
}

/// Returns the distance of `x` from `reference`, relative to the norm of `reference`.
pub(crate) fn relative(x: &[f64], reference: &[f64]) -> f64 {
    let difference: Vec<f64> = x.iter().zip(reference).map(|(x, reference)| x - reference).collect();
    norm(&difference) / norm(reference)
}

pub(crate) fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}
