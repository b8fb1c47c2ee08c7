//! Parts that have no flow, that are named twice or nowhere, or that depend on nothing; methods that are of no part.

use integrator_core::prelude::*;

struct Softened;

#[hamiltonian(split = kepler + rest, compose = Verlet)]
impl Softened {
    fn kepler(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) - 1.0 / (x * x + y * y + 0.01).sqrt()
    }
    fn rest(&self, q: [f64; 2]) -> f64 {
        0.1 * q[0]
    }
}

struct Twice;

#[hamiltonian(split = flight + field + flight, compose = Verlet)]
impl Twice {
    fn flight(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0]
    }
    fn field(&self, q: [f64; 1]) -> f64 {
        q[0].cos()
    }
}

struct Unnamed;

#[hamiltonian(split = flight + feild, compose = Verlet)]
impl Unnamed {
    fn flight(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0]
    }
    fn field(&self, q: [f64; 1]) -> f64 {
        q[0].cos()
    }
}

struct Constant {
    offset: f64,
}

#[hamiltonian(split = flight + field + ground, compose = Verlet)]
impl Constant {
    fn flight(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0]
    }
    fn field(&self, q: [f64; 1]) -> f64 {
        q[0].cos()
    }
    fn ground(&self, q: [f64; 1]) -> f64 {
        self.offset
    }
}

struct Foreign;

#[hamiltonian(split = flight + field, compose = Verlet)]
impl Foreign {
    fn flight(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0]
    }
    fn field(&self, q: [f64; 1]) -> f64 {
        q[0].cos()
    }
    #[flow(turn)]
    fn turned(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
        q[0] += duration * p[0];
    }
}

fn main() {}
