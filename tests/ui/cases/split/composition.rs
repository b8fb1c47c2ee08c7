//! A composition for a `T` that is quadratic in the momenta, and parts that are not of that kind.

use integrator_core::prelude::*;

struct Moon;

#[hamiltonian(split = flight + turn, compose = BlanesMoanSrkn11)]
impl Moon {
    fn flight(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn turn(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        x * py - y * px
    }
}

fn main() {}
