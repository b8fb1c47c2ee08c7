//! Jacobi coordinates without masses, with other parts, or of what are no bodies.

use integrator_core::prelude::*;

struct Massless;

#[hamiltonian(coordinates = jacobi, split = kepler + interaction, compose = Aba1064)]
impl Massless {
    fn kinetic(&self, p: [[f64; 2]; 2]) -> f64 {
        0.5 * (p[0][0] * p[0][0] + p[0][1] * p[0][1] + p[1][0] * p[1][0] + p[1][1] * p[1][1])
    }
    fn potential(&self, q: [[f64; 2]; 2]) -> f64 {
        -1.0 / (q[0][0] - q[1][0]).hypot(q[0][1] - q[1][1])
    }
}

struct Other {
    mass: [f64; 2],
}

#[hamiltonian(coordinates = jacobi(self.mass), split = kepler + tides, compose = Aba1064)]
impl Other {
    fn kinetic(&self, p: [[f64; 2]; 2]) -> f64 {
        (0..2).map(|i| (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: [[f64; 2]; 2]) -> f64 {
        -self.mass[0] * self.mass[1] / (q[0][0] - q[1][0]).hypot(q[0][1] - q[1][1])
    }
}

struct Line {
    mass: [f64; 2],
}

#[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction, compose = Aba1064)]
impl Line {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (0..2).map(|i| p[i] * p[i] / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -self.mass[0] * self.mass[1] / (q[0] - q[1]).abs()
    }
}

fn main() {}
