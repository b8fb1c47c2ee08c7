//! A function of a coordinate whose derivative nobody knows.

use integrator_core::prelude::*;

fn bessel(x: f64) -> f64 {
    x
}

struct System {
    mass: f64,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        bessel(q[0]) + q[1].div_euclid(2.0)
    }
}

fn main() {
    let system = System { mass: 1.0 };
    let _ = (system.mass, system.run(Phase::new([0.1, 0.2], [0.0; 2]), 0.1));
}
