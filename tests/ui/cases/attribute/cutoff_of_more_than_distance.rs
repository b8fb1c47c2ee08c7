//! Neighbour lists for a cutoff that reads more than the distance.

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
                if square + q[i][2] * q[j][2] < 9.0 {
                    energy += self.charge[i] * self.charge[j] * (9.0 - square).powi(2);
                }
            }
        }
        energy
    }
}

fn main() {}
