//! Neighbour lists for a potential without a cutoff.

use integrator_core::prelude::*;

struct Charges {
    charge: Vec<f64>,
}

#[hamiltonian(layout = lists)]
impl Charges {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let square: f64 = (0..3).map(|k| (q[i][k] - q[j][k]).powi(2)).sum();
                energy += self.charge[i] * self.charge[j] / square.sqrt();
            }
        }
        energy
    }
}

fn main() {}
