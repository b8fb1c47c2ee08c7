//! A body orbiting a centre, for Taylor's method, with equal steps and with a rate of its own.

use integrator_core::prelude::*;

pub(crate) struct Comet;

#[hamiltonian(taylor)]
impl Comet {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -1.0 / q[0].hypot(q[1])
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        q[0].hypot(q[1]).powf(-1.5)
    }
}
