//! Inner steps by a composition for a quadratic T.

use integrator_core::prelude::*;

struct Stiff;

#[hamiltonian(split = well + 8 * BlanesMoanSrkn11(spring + kinetic))]
impl Stiff {
    fn well(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
    fn spring(&self, q: [f64; 1]) -> f64 {
        5000.0 * q[0] * q[0]
    }
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
}

fn main() {}
