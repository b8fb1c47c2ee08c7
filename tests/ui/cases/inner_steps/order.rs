//! A claimed order that the inner steps do not have, and one that the composition does not have.

use integrator_core::prelude::*;

struct Stiff;

#[hamiltonian(split = well + 8 * (spring + kinetic), compose = BlanesMoan4, order = 4)]
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

struct Pendulum;

#[hamiltonian(order = 4)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

/// This claim holds.
struct Moon;

#[hamiltonian(split = tide + 8 * BlanesMoan4(planet + kinetic), compose = Aba864, order = 4)]
impl Moon {
    fn tide(&self, q: [f64; 2]) -> f64 {
        1e-3 * (q[0] * q[0] - 2.0 * q[1] * q[1])
    }
    fn planet(&self, q: [f64; 2]) -> f64 {
        -1.0 / q[0].hypot(q[1])
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0] * p[0] / 2.0 + p[1] * p[1] / 2.0
    }
}

fn main() {}
