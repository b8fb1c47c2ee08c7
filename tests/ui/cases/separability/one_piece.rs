//! A Hamiltonian in one piece has no flows to compose.

use integrator_core::prelude::*;

struct Mixed;

#[hamiltonian(split = none, compose = Yoshida4)]
impl Mixed {
    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        (q[0] * q[0] + 1.0) * (p[0] * p[0] + 1.0)
    }
}

fn main() {}
