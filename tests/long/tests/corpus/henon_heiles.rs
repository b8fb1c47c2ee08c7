//! A star in the meridional plane of a galaxy (Hénon and Heiles 1964).

use crate::member::{Member, Number};
use integrator_core::prelude::*;

pub(crate) struct HenonHeiles;

#[hamiltonian(compose = Yoshida4)]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

impl Member for HenonHeiles {
    const STEP: f64 = 0.1;

    fn example() -> Self {
        Self
    }
    fn energies(&self, at: &Phase<[f64; 2]>, _: f64) -> [f64; 2] {
        [self.kinetic(at.p), self.potential(at.q)]
    }
    fn kinetic_formula<D: Number>(&self, p: &[D], _: f64) -> D {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential_formula<D: Number>(&self, q: &[D], _: f64) -> D {
        let (x, y) = (q[0], q[1]);
        (x * x + y * y) / 2.0 + (x * x - y * y / 3.0) * y
    }
}
